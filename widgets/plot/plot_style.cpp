#include "widgets/plot/plot_style.h"

#include "widgets/plot/tickers.h"
#include "widgets/style/fonts.h"

#include <algorithm>
#include <cmath>

namespace driftbench {

static constexpr int kTickLength = 4;
static constexpr double kSmallestShownRange = 1e-9;
static constexpr double kLargestShownValue = 1e200; // beyond, QCustomPlot refuses the range

void applyPlotStyle(QCustomPlot &plot, const Palette &palette)
{
    plot.setBackground(QBrush(palette.base));
    plot.setAntialiasedElements(QCP::aePlottables | QCP::aeItems | QCP::aeScatters);
    plot.setNotAntialiasedElements(QCP::aeAxes | QCP::aeGrid | QCP::aeSubGrid | QCP::aeFills |
                                   QCP::aeZeroLine);
    plot.setFont(noteFont());
    followLocale(plot);
}

void followLocale(QCustomPlot &plot)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    plot.setLocale(locale);
}

static void styleAxis(QCPAxis &axis, const Palette &palette)
{
    const QPen line(palette.axisLine, 1.0);
    axis.setBasePen(line);
    axis.setTickPen(line);
    axis.setTickLength(0, kTickLength);
    axis.setSubTicks(false);
    axis.setTickLabelFont(noteFont());
    axis.setLabelFont(noteFont());
    axis.setTickLabelColor(palette.mutedText);
    axis.setLabelColor(palette.mutedText);
    axis.setTickLabelPadding(4);
    axis.setLabelPadding(3);
    axis.setPadding(0);
    axis.grid()->setPen(QPen(palette.grid, 1.0, Qt::SolidLine));
    axis.grid()->setSubGridVisible(false);
    axis.grid()->setZeroLinePen(Qt::NoPen);
    axis.grid()->setAntialiased(false);
}

void applyPlotStyle(QCPAxisRect &rect, const Palette &palette)
{
    rect.setMinimumMargins(QMargins(0, kPanelGap, kPanelGap, 0));
    for (QCPAxis *axis : rect.axes()) {
        const bool shown = axis->axisType() == QCPAxis::atLeft || axis->axisType() == QCPAxis::atBottom;
        axis->setVisible(shown);
        axis->setLayer(QStringLiteral("axes"));
        axis->grid()->setLayer(QStringLiteral("grid"));
        if (shown)
            styleAxis(*axis, palette);
    }
    rect.axis(QCPAxis::atLeft)->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker));
    rect.axis(QCPAxis::atBottom)->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(5)));
    rect.setLayer(QStringLiteral("background")); // else its background would hide the grid
    rect.setBackground(QBrush(palette.base));
}

QPen referencePen(const Palette &palette)
{
    QPen pen(palette.constant, 1.0);
    pen.setDashPattern({5, 3});
    pen.setCapStyle(Qt::FlatCap);
    return pen;
}

QPen zeroPen(const Palette &palette)
{
    return {palette.text, 1.0};
}

void hideAxisText(QCPAxis &axis)
{
    axis.setTickLabels(false);
    axis.setLabel(QString());
}

TimeScale timeScaleFor(double spanS)
{
    if (spanS <= 180.0)
        return {1.0, QStringLiteral("s")};
    if (spanS <= 5400.0)
        return {60.0, QStringLiteral("min")};
    return {3600.0, QStringLiteral("h:min")};
}

void applyTimeScale(QCPAxis &axis, const TimeScale &scale, const QString &name)
{
    axis.setLabel(QStringLiteral("%1 (%2)").arg(name, scale.unit));
    if (scale.secondsPerUnit == 3600.0)
        axis.setTicker(QSharedPointer<QCPAxisTicker>(new HourMinuteTicker));
}

void applyLogScale(QCPAxis &axis, double lowest, double highest)
{
    axis.setScaleType(QCPAxis::stLogarithmic);
    axis.setTicker(QSharedPointer<QCPAxisTicker>(new DecadeTicker));
    const double low = std::pow(10.0, std::floor(std::log10(lowest) + 1e-9));
    const double high = std::pow(10.0, std::ceil(std::log10(highest) - 1e-9));
    axis.setRange(low, std::max(high, 10.0 * low));
}

void Extent::include(double value)
{
    if (!std::isfinite(value))
        return;
    value = std::clamp(value, -kLargestShownValue, kLargestShownValue);
    if (empty()) {
        m_low = m_high = value;
        return;
    }
    m_low = std::min(m_low, value);
    m_high = std::max(m_high, value);
}

QCPRange Extent::padded(double share) const
{
    if (empty())
        return {0.0, 1.0};
    const double size = m_high - m_low;
    if (size < kSmallestShownRange || size < 1e-6 * std::abs(m_high)) {
        const double half = std::max(0.5, 0.05 * std::abs(m_high));
        return {m_low - half, m_high + half};
    }
    return {m_low - share * size, m_high + share * size};
}

} // namespace driftbench
