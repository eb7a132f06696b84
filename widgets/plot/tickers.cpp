#include "widgets/plot/tickers.h"

#include "widgets/style/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace driftbench {

static constexpr double kLargestPlain = 1e8;
static constexpr int kMostDecimals = 6;
static constexpr double kFreedom = 0.7; // steps may be this much smaller than the wanted number of ticks asks

// The fewest decimals that write every multiple of step exactly.
static int decimalsOfStep(double step)
{
    for (int decimals = 0; decimals < kMostDecimals; ++decimals) {
        const double scaled = step * std::pow(10.0, decimals);
        if (scaled > 0.5 && std::abs(scaled - std::round(scaled)) < 1e-6 * scaled)
            return decimals;
    }
    return kMostDecimals;
}

double NumberTicker::getTickStep(const QCPRange &range)
{
    const double wanted = kFreedom * range.size() / tickCount();
    const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
    m_step = 10.0 * decade;
    for (const double mantissa : {5.0, 2.0, 1.0}) {
        if (mantissa * decade >= wanted)
            m_step = mantissa * decade;
    }
    m_decimals = decimalsOfStep(m_step);
    return m_step;
}

QString NumberTicker::getTickLabel(double tick, const QLocale &locale, QChar, int)
{
    if (std::abs(tick) < 1e-9 * m_step)
        tick = 0.0;
    if (std::abs(tick) >= kLargestPlain || m_step < std::pow(10.0, -kMostDecimals))
        return powerText(tick, 1, locale);
    return numberText(tick, m_decimals, locale);
}

double CountTicker::getTickStep(const QCPRange &range)
{
    return std::max(1.0, std::round(NumberTicker::getTickStep(range)));
}

double HourMinuteTicker::getTickStep(const QCPRange &range)
{
    static constexpr std::array<double, 13> kMinutes{1, 2, 5, 10, 15, 30, 60, 120, 180, 360, 720, 1440, 2880};
    const double wanted = 60.0 * range.size() / tickCount();
    const auto *const step = std::lower_bound(kMinutes.begin(), kMinutes.end(), 0.8 * wanted);
    if (step != kMinutes.end())
        return *step / 60.0;
    return 24.0 * std::ceil(wanted / 1440.0);
}

QString HourMinuteTicker::getTickLabel(double tick, const QLocale &, QChar, int)
{
    return hourMinuteText(tick);
}

double ClockTicker::stepFor(double spanS, int tickCount)
{
    static constexpr std::array<double, 21> kSteps{1,     2,     5,     10,    15,     30,     60,
                                                   120,   300,   600,   900,   1800,   3600,   7200,
                                                   10800, 21600, 43200, 86400, 172800, 432000, 864000};
    const double wanted = 0.8 * spanS / tickCount;
    if (wanted < 0.5)
        return std::pow(10.0, std::ceil(std::log10(wanted)));
    const auto *const step = std::lower_bound(kSteps.begin(), kSteps.end(), wanted);
    return step != kSteps.end() ? *step : 86400.0 * std::ceil(wanted / 86400.0);
}

double ClockTicker::getTickStep(const QCPRange &range)
{
    m_stepS = stepFor(range.size(), tickCount());
    return m_stepS;
}

QString ClockTicker::getTickLabel(double tick, const QLocale &locale, QChar, int)
{
    if (!needsSeconds(m_stepS))
        return hourMinuteText(tick / 3600.0);
    const QString whole = clockText(std::floor(tick + 1e-9 * std::abs(tick) + 1e-9));
    if (m_stepS >= 1.0)
        return whole;
    const int decimals = std::min(6, static_cast<int>(std::lround(-std::log10(m_stepS))));
    const double rest = tick - std::floor(tick + 1e-9 * std::abs(tick) + 1e-9);
    return whole + numberText(rest, decimals, locale).mid(1); // ".05"
}

QString DecadeTicker::getTickLabel(double tick, const QLocale &locale, QChar, int)
{
    return decadeText(static_cast<int>(std::lround(std::log10(tick))), locale);
}

} // namespace driftbench
