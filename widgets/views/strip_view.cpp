#include "widgets/views/strip_view.h"

#include "engine/base/axes.h"
#include "widgets/plot/panel_notes.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/series.h"
#include "widgets/plot/tickers.h"
#include "widgets/style/fonts.h"
#include "widgets/style/number_text.h"
#include "widgets/style/role_pens.h"

#include <cmath>

namespace driftbench {

static constexpr double kStretchS = 0.25;
static constexpr int kRepaintMs = 100;
static constexpr double kRateOverS = 2.0;
static constexpr int kTemperature = kAxisCount;

StripView::StripView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("The last minute of the source"); }, look, parent)
{
    m_repaint.setSingleShot(true);
    m_repaint.setInterval(kRepaintMs);
    connect(&m_repaint, &QTimer::timeout, this, [this] { rebuild(); });
    rebuild();
}

void StripView::clear()
{
    m_stretches.clear();
    m_rateHz = 0.0;
    m_rateCount = 0;
    rebuild();
}

std::optional<double> StripView::latest(int strip) const
{
    if (m_stretches.empty())
        return std::nullopt;
    return m_latest[static_cast<std::size_t>(strip)];
}

void StripView::append(const SampleBlock &block)
{
    if (block.size() == 0)
        return;
    // A source that was started again counts its time from 0.
    if (!m_stretches.empty() && block.timeS[0] < m_latestS - kStretchS) {
        m_stretches.clear();
        m_rateCount = 0;
    }
    for (Eigen::Index i = 0; i < block.size(); ++i) {
        put(block.timeS[i],
            {block.rateDps(i, 0), block.rateDps(i, 1), block.rateDps(i, 2), block.temperatureC[i]});
    }
    measureRate(block);
    if (!m_repaint.isActive() && isVisible())
        m_repaint.start();
}

void StripView::put(double timeS, const std::array<double, kStrips> &values)
{
    const auto number = static_cast<std::int64_t>(std::floor(timeS / kStretchS));
    if (m_stretches.empty() || m_stretches.back().number != number) {
        m_stretches.push_back({number, values, values});
        const auto oldest = number - static_cast<std::int64_t>(kShownS / kStretchS) - 1;
        while (m_stretches.front().number < oldest)
            m_stretches.pop_front();
    }
    Stretch &now = m_stretches.back();
    for (std::size_t strip = 0; strip < kStrips; ++strip) {
        now.low[strip] = std::fmin(now.low[strip], values[strip]);
        now.high[strip] = std::fmax(now.high[strip], values[strip]);
    }
    m_latest = values;
    m_latestS = timeS;
}

void StripView::measureRate(const SampleBlock &block)
{
    if (m_rateCount == 0) {
        m_rateFromS = block.timeS[0];
        m_rateCount = -1; // the first sample opens the interval, it does not lie in it
    }
    m_rateCount += block.size();
    const double spanS = m_latestS - m_rateFromS;
    if (spanS >= kRateOverS || (m_rateHz == 0.0 && spanS > 0.3)) {
        m_rateHz = static_cast<double>(m_rateCount) / spanS;
        m_rateCount = 0;
    }
}

// The strip's line: down and up through lowest and highest of each stretch.
void StripView::drawStrip(QCPAxisRect &rect, int strip)
{
    const auto at = static_cast<std::size_t>(strip);
    QVector<double> keys, values;
    Extent extent;
    for (const Stretch &stretch : m_stretches) {
        const double key = static_cast<double>(stretch.number) * kStretchS - m_latestS;
        keys << key << key + 0.5 * kStretchS;
        values << stretch.low[at] << stretch.high[at];
        extent.include(stretch.low[at]);
        extent.include(stretch.high[at]);
    }
    const bool isTemperature = strip == kTemperature;
    QCPAxis &left = *rect.axis(QCPAxis::atLeft);
    QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
    const double middle = 0.5 * (extent.low() + extent.high());
    const double half = std::max(0.5 * (extent.high() - extent.low()), isTemperature ? 0.05 : 0.02) * 1.25;
    left.setRange(middle - half, middle + half);
    bottom.setRange(-kShownS, 0.0);
    // One number on each strip: the value about which it moves, as far as it can be told.
    const double round = half > 5.0 ? 5.0 : half > 0.02 ? 1.0 : 0.1;
    double tick = std::round(middle / round) * round;
    if (tick < left.range().lower || tick > left.range().upper)
        tick = std::round(middle * 100.0) / 100.0;
    const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
    ticker->addTick(tick, numberText(tick, tick == std::round(tick) ? 0 : 2));
    left.setTicker(ticker);
    const QPen pen = isTemperature ? QPen(look().mutedText, 1.0) : rolePen(Role::Raw, look());
    addLine(rect, keys, values, pen);
    auto *notes = new PanelNotes(&rect, look());
    const QString unit = isTemperature ? tr("%1 °C") : tr("%1 dps");
    notes->setMarginLabels(
        {{m_latest[at], QPen(look().axisLine, 1.0), unit.arg(numberText(m_latest[at], 2)), false}});
    auto *name = new QCPItemText(&plot());
    name->setClipToAxisRect(false);
    name->position->setAxisRect(&rect);
    name->position->setTypeX(QCPItemPosition::ptAbsolute);
    name->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    name->position->setCoords(17.0, 0.5);
    name->setPositionAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    name->setFont(strongNoteFont());
    name->setColor(look().text);
    name->setText(isTemperature ? QStringLiteral("T") : QString::fromUtf8(kAxisNames[at].data()));
}

void StripView::build()
{
    if (m_stretches.empty()) {
        showEmpty(tr("Nothing comes yet"), tr("Choose a source at the left."));
        return;
    }
    plot().plotLayout()->setMargins(QMargins(30, 10, 10, 8));
    QCPLayoutGrid &grid = addPanels();
    for (int strip = 0; strip < kStrips; ++strip) {
        QCPAxisRect &rect = addPanel(grid, strip, 0);
        drawStrip(rect, strip);
        QCPAxis &bottom = *rect.axis(QCPAxis::atBottom);
        bottom.setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(3)));
        if (strip < kTemperature) {
            bottom.setTicks(false);
            bottom.setBasePen(Qt::NoPen);
            hideAxisText(bottom);
        } else {
            bottom.setLabel(tr("Time before now (s)"));
        }
        grid.setRowStretchFactor(strip, strip < kTemperature ? 1.0 : 0.9);
    }
}

} // namespace driftbench
