// Tick labels as the workbench wants them: real minus, thin space, plain numbers, one number of decimals an
// axis.
#pragma once

#include <qcustomplot.h>

namespace driftbench {

// Linear axis, steps of 1, 2 or 5 times a power of ten. Beyond 99 999 999 or below 1e-6 a step, ticks read
// "2.5×10⁷".
class NumberTicker : public QCPAxisTicker
{
public:
    explicit NumberTicker(int tickCount = 5) { setTickCount(tickCount); }

protected:
    double getTickStep(const QCPRange &range) override;
    int getSubTickCount(double) override { return 0; }
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override;

private:
    int m_decimals = 0;
    double m_step = 1.0;
};

// Whole numbers only (a number of centres).
class CountTicker : public NumberTicker
{
public:
    using NumberTicker::NumberTicker;

protected:
    double getTickStep(const QCPRange &range) override;
};

// Keys in hours, labels h:min, steps that a clock has.
class HourMinuteTicker : public QCPAxisTicker
{
public:
    explicit HourMinuteTicker(int tickCount = 6) { setTickCount(tickCount); }

protected:
    double getTickStep(const QCPRange &range) override;
    int getSubTickCount(double) override { return 0; }
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override;
};

// Keys in seconds, labels h:min, or h:min:s where ticks are closer than a minute; steps that a clock has.
class ClockTicker : public QCPAxisTicker
{
public:
    explicit ClockTicker(int tickCount = 6) { setTickCount(tickCount); }

    static double stepFor(double spanS, int tickCount);
    static bool needsSeconds(double stepS) { return stepS < 60.0; }

protected:
    double getTickStep(const QCPRange &range) override;
    int getSubTickCount(double) override { return 0; }
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override;

private:
    double m_stepS = 60.0;
};

// Logarithmic axis: decades only.
class DecadeTicker : public QCPAxisTickerLog
{
public:
    explicit DecadeTicker(int tickCount = 7)
    {
        setTickCount(tickCount);
        setSubTickCount(0);
    }

protected:
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override;
};

} // namespace driftbench
