#include "widgets/views/transient_view.h"

#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/style/fonts.h"
#include "widgets/style/number_text.h"

#include <qcustomplot.h>

#include <cmath>

namespace driftbench {

static constexpr int kPoints = 240;
static constexpr double kShownBeyond = 1.7; // of the time of settling

TransientView::TransientView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("What is left of a step at the centre of the chamber, over time"); }, look,
               parent)
{
    rebuild();
}

void TransientView::setData(const std::optional<TransientData> &shown)
{
    m_data = shown;
    rebuild();
}

static QString settlingText(double settlingS, double accuracyC)
{
    const TimeScale scale = timeScaleFor(settlingS * kShownBeyond);
    const QString time =
        scale.secondsPerUnit == 3600.0
            ? hourMinuteText(settlingS / 3600.0)
            : TransientView::tr("%1 %2").arg(numberText(settlingS / scale.secondsPerUnit, 0), scale.unit);
    return TransientView::tr("%1 to ±%2 °C").arg(time, numberText(accuracyC, 2));
}

static void addNote(QCustomPlot &plot, QCPAxisRect &rect, double time, double valueC, const QString &words,
                    const QColor &color)
{
    auto *text = new QCPItemText(&plot);
    text->setClipAxisRect(&rect);
    text->setClipToAxisRect(false);
    text->position->setAxisRect(&rect);
    text->position->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    text->position->setCoords(time, valueC);
    text->setPositionAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    text->setPadding(QMargins(6, 0, 0, 0));
    text->setFont(noteFont());
    text->setColor(color);
    text->setText(words);
}

void TransientView::build()
{
    if (!m_data || !(m_data->stepC > m_data->accuracyC)) {
        showEmpty(tr("Nothing to settle"), tr("The step is within what the thermometer can tell."));
        return;
    }
    const double settlingS = m_data->transient.settlingTimeS(m_data->stepC, m_data->accuracyC);
    const double shownS = kShownBeyond * settlingS;
    const TimeScale scale = timeScaleFor(shownS);
    plot().plotLayout()->setMargins(QMargins(0, 4, 12, 6)); // stands in a panel under read-outs
    QCPAxisRect &rect = addPanel(addPanels(), 0, 0);
    QVector<double> times, left;
    for (int i = 0; i <= kPoints; ++i) {
        const double timeS = shownS * i / kPoints;
        times << timeS / scale.secondsPerUnit;
        left << m_data->stepC * m_data->transient.remainingAtCentre(timeS);
    }
    QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
    QCPAxis &value = *rect.axis(QCPAxis::atLeft);
    applyTimeScale(bottom, scale, tr("Time after a step of %1 °C").arg(numberText(m_data->stepC, 2)));
    bottom.setRange(0.0, shownS / scale.secondsPerUnit);
    value.setLabel(tr("Still to go (°C)"));
    applyLogScale(value, m_data->accuracyC / 1.5, m_data->stepC);
    const QPen dashed = referencePen(look());
    addVertical(rect, settlingS / scale.secondsPerUnit, dashed);
    addHorizontal(rect, m_data->accuracyC, dashed);
    addLine(rect, times, left, zeroPen(look()));
    const double noteAtC = std::sqrt(value.range().upper * m_data->stepC * 0.6);
    addNote(plot(), rect, settlingS / scale.secondsPerUnit, noteAtC,
            settlingText(settlingS, m_data->accuracyC), look().text);
}

} // namespace driftbench
