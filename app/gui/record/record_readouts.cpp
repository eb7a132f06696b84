#include "app/gui/record/record_readouts.h"

#include "app/gui/record/live_run.h"
#include "engine/base/axes.h"
#include "widgets/controls/panel.h"
#include "widgets/live/live_trace_view.h"
#include "widgets/live/msd_trend_view.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/number_text.h"
#include "widgets/style/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QVBoxLayout>

#include <cmath>

namespace driftbench {

static constexpr int kWidth = 280;
static constexpr int kTrendHeight = 240;

enum ProgressRow
{
    kElapsed,
    kRemaining,
    kTemperature,
    kPlan
};
enum CursorRow
{
    kTime,
    kCursorTemperature,
    kFirstRate // raw, compensated of x, y, z
};

RecordReadouts::RecordReadouts(const LiveRun &run, const LiveTraceView &view, QWidget *parent)
    : QWidget(parent)
    , m_run(run)
    , m_view(view)
    , m_progressHead(new SectionHead)
    , m_scoreHead(new SectionHead)
    , m_cursorHead(new SectionHead)
    , m_linkHead(new SectionHead)
    , m_trendHead(new SectionHead)
    , m_bar(new QProgressBar)
    , m_percent(new TextLabel(TextRole::StrongNote))
    , m_progress(new ReadoutGrid)
    , m_scores(new ReadoutGrid(3))
    , m_cursors(new ReadoutGrid(3))
    , m_link(new ReadoutGrid)
    , m_trendPanel(new Panel)
    , m_trend(new MsdTrendView)
{
    setFixedWidth(kWidth);
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    auto *barRow = new QWidget;
    auto *bar = new QHBoxLayout(barRow);
    bar->setContentsMargins(0, 0, 0, 0);
    bar->setSpacing(kWideGap);
    m_bar->setTextVisible(false);
    m_bar->setRange(0, 1000);
    m_percent->setMinimumWidth(m_percent->fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
    m_percent->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    bar->addWidget(m_bar, 1);
    bar->addWidget(m_percent);
    auto *progress = new QWidget;
    auto *progressRows = new QVBoxLayout(progress);
    progressRows->setContentsMargins(0, 0, 0, 0);
    progressRows->setSpacing(2);
    progressRows->addWidget(barRow);
    progressRows->addWidget(m_progress);
    for (int row = 0; row < 4; ++row)
        m_progress->addRow({});
    m_scores->setNameRole(TextRole::StrongNote);
    for (const std::string_view axis : kAxisNames)
        m_scores->addRow(QString::fromUtf8(axis.data(), static_cast<qsizetype>(axis.size())));
    m_cursors->setNameRole(TextRole::NoteText);
    for (int row = 0; row < kFirstRate + 2 * kAxisCount; ++row)
        m_cursors->addRow({});
    for (int row = 0; row < 3; ++row)
        m_link->addRow({});
    m_trendPanel->setFlush();
    m_trendPanel->rows()->addWidget(m_trend);
    m_trend->followTheme();
    m_trendPanel->setMinimumHeight(kTrendHeight);

    addBlock(m_progressHead, progress, false);
    addBlock(m_scoreHead, m_scores, true);
    addBlock(m_cursorHead, m_cursors, true);
    addBlock(m_linkHead, m_link, true);
    addBlock(m_trendHead, m_trendPanel, false);
    rows->addStretch(1);
    showTrend();
}

void RecordReadouts::addBlock(SectionHead *head, QWidget *body, bool rule)
{
    auto *rows = static_cast<QVBoxLayout *>(layout());
    if (rule) {
        rows->addStretch(2);
        rows->addWidget(new Rule);
        rows->addStretch(1);
    }
    if (body == m_trendPanel)
        rows->addSpacing(kGap);
    rows->addWidget(head);
    rows->addWidget(body, body == m_trendPanel ? 40 : 0);
}

void RecordReadouts::retranslate()
{
    m_progressHead->setTitle(tr("Progress"));
    m_bar->setAccessibleName(tr("Progress of the run"));
    m_scoreHead->setTitle(tr("Running MSD"));
    m_scoreHead->setNote(tr("dps², since 0:00:00"));
    m_cursorHead->setTitle(tr("Cursors"));
    m_cursorHead->setNote(tr("10 s means, dps"));
    m_linkHead->setTitle(tr("Link"));
    m_trendHead->setTitle(tr("MSD so far"));
    m_trendHead->setNote(tr("dps², amber before, blue after"));
    m_progress->setName(kElapsed, tr("Elapsed"));
    m_progress->setName(kRemaining, tr("Remaining"));
    m_progress->setName(kTemperature, tr("Temperature"));
    m_progress->setName(kPlan, tr("Plan"));
    m_scores->setHeads({tr("before"), tr("after"), tr("Q = after/before")});
    m_cursors->setHeads({QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("B − A")});
    m_cursors->setName(kTime, tr("Time"));
    m_cursors->setName(kCursorTemperature, tr("T (°C)"));
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const QString name = QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data());
        m_cursors->setName(kFirstRate + 2 * axis, tr("%1 raw").arg(name));
        m_cursors->setName(kFirstRate + 2 * axis + 1, tr("%1 comp.").arg(name));
    }
    m_link->setName(0, tr("Sample rate, samples"));
    m_link->setName(1, tr("Dropped"));
    m_link->setName(2, tr("Overruns, saturated"));
    showAll();
}

void RecordReadouts::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    showTrend();
}

void RecordReadouts::showTrend()
{
    const bool tall = window()->height() > kTallWindow;
    m_trendHead->setVisible(tall);
    m_trendPanel->setVisible(tall);
}

void RecordReadouts::showAll()
{
    showProgress();
    showScores();
    showCursors();
    showLink();
}

static QString phaseText(const RunProgress &progress)
{
    switch (progress.phase) {
    case RunPhase::Rise:
        return RecordReadouts::tr("rise, step %1 of %2").arg(progress.step).arg(progress.steps);
    case RunPhase::Fall:
        return RecordReadouts::tr("fall, step %1 of %2").arg(progress.step).arg(progress.steps);
    case RunPhase::Hold:
        break;
    }
    return RecordReadouts::tr("hold, step %1 of %2").arg(progress.step).arg(progress.steps);
}

// "74.00 °C, 1.08 °C ahead": on the way the plan is ahead where the chamber lags.
static QString planText(const RunProgress &progress, const std::optional<double> &temperatureC)
{
    QString setpoint = RecordReadouts::tr("%1 °C").arg(numberText(progress.setpointC, 2));
    if (!temperatureC)
        return setpoint;
    const double difference = progress.setpointC - *temperatureC;
    const QString size = RecordReadouts::tr("%1 °C").arg(numberText(std::abs(difference), 2));
    if (progress.phase == RunPhase::Hold)
        return RecordReadouts::tr("%1, %2 off").arg(setpoint, size);
    const bool ahead = (difference > 0.0) == (progress.phase == RunPhase::Rise);
    return ahead ? RecordReadouts::tr("%1, %2 ahead").arg(setpoint, size)
                 : RecordReadouts::tr("%1, %2 behind").arg(setpoint, size);
}

void RecordReadouts::showProgress()
{
    const auto progress = m_run.hasSamples() || m_run.isRecording() ? m_run.progress() : std::nullopt;
    const auto temperature = m_run.temperatureC();
    const QString none(QChar(0x2013));
    m_bar->setEnabled(progress.has_value());
    m_bar->setValue(progress ? static_cast<int>(1000.0 * progress->fraction) : 0);
    m_percent->setText(progress ? tr("%1 %").arg(numberText(std::floor(100.0 * progress->fraction), 0))
                                : none);
    QString note = progress ? phaseText(*progress) : QString();
    if (!progress && m_run.isHolding())
        note = tr("plateau");
    m_progressHead->setNote(note);
    m_progress->setValue(kElapsed, m_run.hasSamples() ? clockText(m_run.elapsedS()) : none);
    m_progress->setValue(kRemaining, progress ? clockText(progress->remainingS) : none, Tone::Plain, true);
    m_progress->setValue(kTemperature, temperature ? tr("%1 °C").arg(numberText(*temperature, 2)) : none);
    m_progress->setValue(kPlan, progress ? planText(*progress, temperature) : none);
}

void RecordReadouts::showScores()
{
    const Eigen::Vector3d before = m_run.scores().before.msdDps2();
    const Eigen::Vector3d after = m_run.scores().after.msdDps2();
    for (int axis = 0; axis < kAxisCount; ++axis) {
        m_scores->setValue(axis, 0, numberText(before[axis], 3));
        m_scores->setValue(axis, 1, numberText(after[axis], 4), Tone::Accent, true);
        m_scores->setValue(axis, 2, numberText(after[axis] / before[axis], 4));
    }
    const Eigen::Vector3d rmsBefore = m_run.scores().before.rms10sDps();
    const Eigen::Vector3d rmsAfter = m_run.scores().after.rms10sDps();
    QStringList lines{tr("rms of 10 s means, before and after:")};
    for (int axis = 0; axis < kAxisCount; ++axis)
        lines.append(tr("%1: %2 and %3 dps")
                         .arg(QString::fromUtf8(kAxisNames[static_cast<std::size_t>(axis)].data()),
                              numberText(rmsBefore[axis], 4), numberText(rmsAfter[axis], 4)));
    m_scores->setToolTip(lines.join(QLatin1Char('\n')));
}

static QString signedText(double value, int decimals)
{
    const QString text = numberText(value, decimals);
    return value > 0.0 ? QLatin1Char('+') + text : text;
}

void RecordReadouts::showCursors()
{
    const auto a = m_view.reading(Cursor::A);
    const auto b = m_view.reading(Cursor::B);
    const auto keyA = m_view.cursors().key(Cursor::A);
    const auto keyB = m_view.cursors().key(Cursor::B);
    const QString none(QChar(0x2013));
    m_cursors->setValue(kTime, 0, keyA ? clockText(*keyA) : none);
    m_cursors->setValue(kTime, 1, keyB ? clockText(*keyB) : none);
    m_cursors->setValue(kTime, 2, keyA && keyB ? clockText(*keyB - *keyA) : none, Tone::Plain, true);
    const auto row = [&](int at, std::size_t trace, Tone tone) {
        const double valueA = a ? a->means[trace] : NAN;
        const double valueB = b ? b->means[trace] : NAN;
        m_cursors->setValue(at, 0, numberText(valueA, 2));
        m_cursors->setValue(at, 1, numberText(valueB, 2));
        m_cursors->setValue(at, 2, signedText(valueB - valueA, 2), tone, true);
    };
    row(kCursorTemperature, TracePyramid::kTemperature, Tone::Plain);
    for (int axis = 0; axis < kAxisCount; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        row(kFirstRate + 2 * axis, TracePyramid::kRaw + at, Tone::Plain);
        row(kFirstRate + 2 * axis + 1, TracePyramid::kCompensated + at, Tone::Accent);
        m_cursors->setRowVisible(kFirstRate + 2 * axis + 1, m_run.model() != nullptr);
    }
}

void RecordReadouts::showLink()
{
    const LinkFigures &link = m_run.link();
    const QString none(QChar(0x2013));
    m_linkHead->setNote(link.lastGapS ? tr("last gap %1").arg(clockText(*link.lastGapS)) : QString());
    const QString rate = link.rateHz > 0.0 ? tr("%1 Hz").arg(samplingRateText(link.rateHz)) : none;
    m_link->setValue(0, tr("%1, %2").arg(rate, numberText(static_cast<double>(link.samples), 0)));
    const double share =
        link.samples > 0 ? 100.0 * double(link.lost) / double(link.samples + link.lost) : 0.0;
    m_link->setValue(1,
                     link.lost > 0
                         ? tr("%1 (%2 %)").arg(numberText(double(link.lost), 0), numberText(share, 3))
                         : numberText(0.0, 0),
                     link.lost > 0 ? Tone::Caution : Tone::Plain);
    m_link->setValue(
        2, tr("%1, %2").arg(numberText(double(link.overruns), 0), numberText(double(link.saturated), 0)),
        link.overruns + link.saturated > 0 ? Tone::Caution : Tone::Plain);
}

void RecordReadouts::clearTrend()
{
    m_trend->clear();
}

void RecordReadouts::addTrendPoint()
{
    m_trend->append(m_run.elapsedS(), m_run.scores().before.msdDps2(), m_run.scores().after.msdDps2());
    if (m_trend->isVisible())
        m_trend->showTrend();
}

QString RecordReadouts::text(const QString &section, int row, int column) const
{
    if (section == QLatin1String("progress"))
        return m_progress->value(row, column);
    if (section == QLatin1String("scores"))
        return m_scores->value(row, column);
    if (section == QLatin1String("cursors"))
        return m_cursors->value(row, column);
    return m_link->value(row, column);
}

} // namespace driftbench
