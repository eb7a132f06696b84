#include "widgets/views/profile_view.h"

#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/plot/tickers.h"
#include "widgets/style/fonts.h"
#include "widgets/style/number_text.h"

#include <qcustomplot.h>

#include <cmath>

namespace driftbench {

// Beyond this many segments the parts of a run are too narrow to be named.
static constexpr std::size_t kMostNamed = 5;
static constexpr double kRoom = 0.08; // of the span of temperatures, below and above

ProfileView::ProfileView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("Set points of one run over time"); }, look, parent)
{
    rebuild();
}

void ProfileView::setPlan(const std::optional<TestPlan> &plan)
{
    m_plan = plan;
    rebuild();
}

static QString segmentText(const PlanSegment &segment, const TestPlan &plan)
{
    if (segment.isHold())
        return ProfileView::tr("hold %1").arg(hourMinuteText(segment.durationS / 3600.0));
    const auto steps = std::llround(std::ceil(std::abs(segment.toC - segment.fromC) / plan.stepC - 1e-9));
    return ProfileView::tr("%n steps of %1 °C, %2 °C/min", nullptr, static_cast<int>(steps))
        .arg(numberText(plan.stepC, 2), numberText(segment.rateCPerMin(), 2));
}

// Beside the middle of its stretch, on the side where the line is not.
static void nameSegment(QCustomPlot &plot, QCPAxisRect &rect, const PlanSegment &segment,
                        const TestPlan &plan, const TimeScale &scale, const QColor &color)
{
    const double middleC = 0.5 * (segment.fromC + segment.toC);
    const bool below = segment.isHold() ? middleC > 0.5 * (plan.lowestC + plan.highestC) : true;
    auto *text = new QCPItemText(&plot);
    text->setClipAxisRect(&rect);
    text->setClipToAxisRect(false);
    text->position->setAxisRect(&rect);
    text->position->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    text->position->setCoords((segment.startS + 0.5 * segment.durationS) / scale.secondsPerUnit, middleC);
    const bool rises = segment.toC > segment.fromC;
    if (segment.isHold())
        text->setPositionAlignment(Qt::AlignHCenter | (below ? Qt::AlignTop : Qt::AlignBottom));
    else
        text->setPositionAlignment(Qt::AlignTop | (rises ? Qt::AlignLeft : Qt::AlignRight));
    text->setPadding(segment.isHold() ? QMargins(2, 5, 2, 3) : QMargins(16, 6, 16, 0));
    text->setFont(noteFont());
    text->setColor(color);
    text->setText(segmentText(segment, plan));
}

void ProfileView::build()
{
    if (!m_plan || m_plan->segments().empty()) {
        showEmpty(tr("No profile"), tr("Put the fields right that are marked."));
        return;
    }
    const std::vector<PlanSegment> segments = m_plan->segments();
    const double durationS = m_plan->runDurationS();
    const TimeScale scale = timeScaleFor(durationS);
    QCPAxisRect &rect = addPanel(addPanels(), 0, 0);
    QVector<double> times, setPoints;
    for (const PlanSegment &segment : segments) {
        times << segment.startS / scale.secondsPerUnit
              << (segment.startS + segment.durationS) / scale.secondsPerUnit;
        setPoints << segment.fromC << segment.toC;
    }
    QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
    QCPAxis &left = *rect.axis(QCPAxis::atLeft);
    left.setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(6)));
    applyTimeScale(bottom, scale, tr("Time since start"));
    bottom.setRange(0.0, durationS / scale.secondsPerUnit);
    left.setLabel(tr("Set point (°C)"));
    const double span = m_plan->highestC - m_plan->lowestC;
    left.setRange(m_plan->lowestC - kRoom * span, m_plan->highestC + kRoom * span);
    // A ramp is drawn as one line: its steps are finer than what a screen shows.
    addLine(rect, times, setPoints, zeroPen(look()));
    if (segments.size() > kMostNamed)
        return;
    for (const PlanSegment &segment : segments)
        nameSegment(plot(), rect, segment, *m_plan, scale, look().mutedText);
}

} // namespace driftbench
