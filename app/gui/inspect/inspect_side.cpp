#include "app/gui/inspect/inspect_side.h"

#include "engine/base/axes.h"
#include "widgets/controls/action_button.h"
#include "widgets/controls/panel.h"
#include "widgets/plot/plot_style.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/number_text.h"
#include "widgets/tables/table_paint.h"

#include <QHeaderView>
#include <QTableView>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <cmath>

namespace driftbench {

static constexpr int kWidth = 232;
static constexpr int kRowHeight = 20;
static constexpr Eigen::Index kPictureDots = 300; // of each run
static constexpr double kManyTimesTheNoise = 3.0;

QString axisLetter(int axis)
{
    const std::string_view name = kAxisNames[static_cast<std::size_t>(axis)];
    return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

InspectSide::InspectSide(QAction *showFindings, QWidget *parent)
    : QWidget(parent)
    , m_axisHead(new SectionHead)
    , m_figureHead(new SectionHead)
    , m_coverageHead(new SectionHead)
    , m_excludedHead(new SectionHead)
    , m_axes(new AxisList)
    , m_figures(new ReadoutGrid)
    , m_coverage(new ReadoutGrid)
    , m_excluded(new ExcludedModel(this))
    , m_table(new QTableView)
{
    setFixedWidth(kWidth);
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kGap);
    const auto inPanel = [](QWidget *content) {
        auto *panel = new Panel;
        panel->setFlush();
        panel->rows()->addWidget(content);
        return panel;
    };
    rows->addWidget(m_axisHead);
    rows->addWidget(inPanel(m_axes));
    rows->addWidget(m_figureHead);
    rows->addWidget(m_figures);
    m_coverageHead->addControl(new ActionButton(showFindings, ButtonSize::Small));
    rows->addWidget(m_coverageHead);
    rows->addWidget(m_coverage);
    rows->addWidget(m_excludedHead);
    rows->addWidget(inPanel(m_table), 1);
    for (int row = 0; row < 4; ++row)
        m_figures->addRow({});
    for (int row = 0; row < 2; ++row)
        m_coverage->addRow({});
    dressTable(*m_table, kRowHeight);
    m_table->setModel(m_excluded);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(ExcludedModel::kWhy, QHeaderView::Stretch);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setMinimumHeight(3 * kRowHeight);
}

void InspectSide::retranslate()
{
    m_axisHead->setTitle(tr("Axis"));
    m_axes->setAccessibleName(tr("Axis"));
    m_coverageHead->setTitle(tr("Coverage"));
    m_excludedHead->setTitle(tr("Excluded"));
    m_table->setAccessibleName(tr("Excluded stretches"));
    m_figures->setName(0, tr("Swing of TDE"));
    m_figures->setName(1, tr("Noise within 0.5 °C"));
    m_figures->setName(2, tr("Left by the curve"));
    m_figures->setName(3, tr("That is"));
    m_coverage->setName(0, tr("Temperature"));
    m_coverage->setName(1, tr("Heated and cooled"));
    m_excluded->retranslate();
    showSeen(m_seen, m_axis);
}

void InspectSide::showSeen(const std::shared_ptr<const InspectionData> &seen, int axis)
{
    if (seen != m_seen || !seen) {
        m_seen = seen;
        m_excluded->setData(seen);
    }
    m_axis = axis;
    m_axes->setCurrentAxis(axis);
    showAxes();
    showFigures();
    showCoverage();
    m_excludedHead->setNote(
        seen ? tr("%1 of %2")
                   .arg(numberText(double(seen->excludedSamples), 0), numberText(double(seen->samples), 0))
             : QString());
}

static QString wordsOf(CurveKind kind)
{
    switch (kind) {
    case CurveKind::Curve:
        return InspectSide::tr("A curve of T");
    case CurveKind::Nearly:
        return InspectSide::tr("Nearly a curve of T");
    case CurveKind::Not:
        break;
    }
    return InspectSide::tr("Not a curve of T");
}

// Dots of one axis, 0..1 both ways.
static void addPicture(AxisEntry &entry, const InspectionData &seen, int axis)
{
    Extent deltaT, values;
    for (const InspectedRun &run : seen.runs) {
        for (Eigen::Index i = 0; i < run.dots->timeS.size(); ++i) {
            deltaT.include(run.dots->deltaT[i]);
            values.include(run.dots->tdeDps(i, axis));
        }
    }
    const QCPRange x = deltaT.padded(0.0);
    const QCPRange y = values.padded(0.0);
    for (const InspectedRun &run : seen.runs) {
        const auto heating = heatingFlags(run.dots->timeS, run.dots->deltaT);
        const Eigen::Index step = std::max<Eigen::Index>(1, run.dots->timeS.size() / kPictureDots);
        for (Eigen::Index i = 0; i < run.dots->timeS.size(); i += step) {
            const QPointF dot((run.dots->deltaT[i] - x.lower) / x.size(),
                              (run.dots->tdeDps(i, axis) - y.lower) / y.size());
            (heating[static_cast<std::size_t>(i)] != 0 ? entry.heating : entry.cooling).append(dot);
        }
    }
}

void InspectSide::showAxes()
{
    std::array<AxisEntry, 3> entries;
    const bool known = m_seen && m_seen->inspection;
    for (int axis = 0; axis < kAxisCount; ++axis) {
        AxisEntry &entry = entries[static_cast<std::size_t>(axis)];
        entry.name = axisLetter(axis);
        if (m_seen)
            addPicture(entry, *m_seen, axis);
        if (!known)
            continue;
        const AxisInspection &seen = m_seen->inspection->axes[static_cast<std::size_t>(axis)];
        const double figure = std::isfinite(seen.spreadDps) ? seen.spreadDps : seen.swingDps;
        entry.figure = tr("%1 dps").arg(numberText(figure, 2));
        entry.words = wordsOf(seen.kind);
        entry.tone = seen.kind == CurveKind::Not ? Tone::Caution : Tone::Plain;
    }
    m_axes->setEntries(entries);
    const double meetingC = known ? m_seen->inspection->hysteresis.meetingTemperatureC : NAN;
    m_axisHead->setNote(!known                    ? QString()
                        : std::isfinite(meetingC) ? tr("spread at %1 °C").arg(numberText(meetingC, 0))
                                                  : tr("swing"));
}

void InspectSide::showFigures()
{
    m_figureHead->setTitle(tr("%1 in figures").arg(axisLetter(m_axis)));
    const QString none(QChar(0x2013));
    if (!m_seen || !m_seen->inspection) {
        for (int row = 0; row < 4; ++row)
            m_figures->setValue(row, none);
        return;
    }
    const AxisInspection &seen = m_seen->inspection->axes[static_cast<std::size_t>(m_axis)];
    const double times = seen.leftDps / seen.noiseDps;
    m_figures->setValue(0, tr("%1 dps").arg(numberText(seen.swingDps, 2)));
    m_figures->setValue(1, tr("%1 dps rms").arg(numberText(seen.noiseDps, 3)));
    m_figures->setValue(2, tr("%1 dps rms").arg(numberText(seen.leftDps, 3)), Tone::Plain, true);
    m_figures->setValue(3, tr("%1 × the noise").arg(numberText(times, times < 10.0 ? 1 : 0)),
                        times > kManyTimesTheNoise ? Tone::Caution : Tone::Plain, true);
}

void InspectSide::showCoverage()
{
    const QString none(QChar(0x2013));
    if (!m_seen || !m_seen->inspection) {
        m_coverage->setValue(0, none);
        m_coverage->setValue(1, none);
        return;
    }
    const TemperatureCoverage &coverage = m_seen->inspection->coverage;
    m_coverage->setValue(
        0, tr("%1 to %2 °C").arg(numberText(coverage.lowestC, 1), numberText(coverage.highestC, 1)));
    m_coverage->setValue(1, tr("%1 % of it").arg(numberText(100.0 * coverage.bothShare, 0)));
}

} // namespace driftbench
