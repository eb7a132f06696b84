// From a device's clock (32 bits of microseconds, wraps after 71.6 min) to the host's time, in seconds since
// the first report.
//
//   time(n) = time(n-1) + (device(n) - device(n-1)) (1 + slope)
//
// A report comes a delay after its sample, sometimes much later, never earlier. So d = host - device, as a
// function of the device's time, lies above a straight line whose slope is that of the host's time against
// the device's: the lower envelope. Per window of device time the point that lies lowest (against the slope
// known so far) is kept; slope is the median of the slopes between all pairs of them that are at least a
// quarter of the whole span apart (Theil 1950, Sen 1968), so that windows in which everything came late do
// no harm. Windows are 5 s at first; when 64 are full, neighbours are joined and windows last twice as long.
// From 6 windows on the slope is used, limited to +-500 ppm (no quartz is worse); until then it is 0.
//
// The drift of the device's clock is 1 / (1 + slope) - 1: positive if it runs fast.
//
// Times never go backwards: a device clock that does (a reset, a damaged report) gives the last time again.
// More than half a wrap between two reports is told from the host's time.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace driftbench {

class ClockMap
{
public:
    // The time of a sample that the device took at deviceUs and whose report came at hostS.
    double map(std::uint32_t deviceUs, double hostS);

    // Seconds of the result per second of the device's clock, for samples after the one mapped last.
    double rate() const { return 1.0 + m_slope; }

    // The device was away and its clock may have started anew: the next time lies behind the last one by what
    // passed on the host.
    void restart();

    bool driftKnown() const { return m_driftKnown; }
    double driftPpm() const { return (1.0 / (1.0 + m_slope) - 1.0) * 1e6; } // 0 until it is known

private:
    struct Point
    {
        double deviceS = 0.0;
        double delayS = 0.0; // host - device, from an arbitrary zero
    };

    std::int64_t elapsedUs(std::uint32_t deviceUs, double hostS) const;
    void observe(const Point &point);
    void closeWindow();
    void estimateSlope();
    double residualS(const Point &point) const { return point.delayS - m_slope * point.deviceS; }

    bool m_started = false;
    bool m_restarted = false;
    std::uint32_t m_lastUs = 0;
    double m_lastHostS = 0.0;
    double m_lastTimeS = 0.0;

    // Time is counted from the last change of the slope, so that nothing adds up.
    std::int64_t m_deviceUs = 0; // since the first report, unwrapped, without the time away
    std::int64_t m_anchorUs = 0;
    double m_anchorS = 0.0;

    double m_originHostS = 0.0; // of the delays
    std::int64_t m_originUs = 0;
    double m_windowS = 0.0;
    double m_windowEndS = 0.0;
    std::optional<Point> m_lowest; // of the running window
    std::vector<Point> m_points;   // of the windows before
    double m_slope = 0.0;
    bool m_driftKnown = false;
};

} // namespace driftbench
