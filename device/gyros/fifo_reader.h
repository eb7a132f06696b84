// The samples of a gyro's FIFO, each exactly once, with their times and with what was lost between them.
//
// The FIFO says when it is full, but not how many samples it has dropped since, nor whether more were dropped
// while it was read. So each burst is held back until the FIFO is looked at again: if it may have run over,
// what was lost is the difference between the samples taken by then, from the data rate, and those seen. The
// first looks serve to find that data rate, and their samples are not given.
//
// Errors: those of the bus. A failed transfer costs the samples in the FIFO, which is emptied and counted as
// lost; kMostFailures in a row are an error.
#pragma once

#include "device/gyros/fifo_clock.h"
#include "device/gyros/st_gyro.h"
#include "device/host_clock.h"

#include <array>
#include <limits>
#include <optional>

namespace driftbench {

struct FifoBurst
{
    std::array<st_gyro::Counts, st_gyro::kFifoSamples> counts{};
    int samples = 0;
    std::int64_t firstSample = 0; // of those delivered
    std::int64_t lostBefore = 0;
    bool lostInTransfer = false; // a failed transfer is among the causes
    double firstS = 0.0;         // host times
    double lastS = 0.0;
};

class FifoReader
{
public:
    static constexpr int kMostFailures = 3;

    // gyro and clock must outlive the reader; longestRead in bytes.
    FifoReader(StGyro &gyro, HostClock &clock, std::size_t longestRead);

    Status start(); // empties the FIFO
    // Looks at the FIFO, fetches what it holds and gives what the look before fetched: nothing at first.
    Result<FifoBurst> next();
    FifoBurst last();  // what is held back, when there is no further look
    void wait() const; // until it pays to look again
    double rateHz() const { return 1.0 / m_fifoClock.periodS(); }
    // Of a failed transfer that was overcome, once.
    std::optional<Error> takeFailure();

private:
    struct Look
    {
        st_gyro::FifoState state;
        double beganS = 0.0;
        double endedS = 0.0;
        double atS() const { return 0.5 * (beganS + endedS); }
    };

    Result<Look> look();
    double jitterS(const Look &look) const;
    Status fetch(const Look &look);
    FifoBurst settle(const Look *look);
    std::int64_t lostBeforeHeld(const Look *look) const;
    void setTimes(FifoBurst &burst);
    Status overcome(const Error &error);

    StGyro &m_gyro;
    HostClock &m_clock;
    std::size_t m_samplesPerRead;
    FifoClock m_fifoClock;
    FifoBurst m_held;
    Look m_heldLook;
    bool m_heldSuspect = false; // samples may be missing before it
    bool m_restarted = false;   // the FIFO was emptied, and nothing was fetched since
    int m_looks = 0;
    std::int64_t m_taken = 0; // given, lost, or before the first one given
    std::int64_t m_delivered = 0;
    double m_shortestLookS = std::numeric_limits<double>::infinity();
    double m_lastS = 0.0; // time of the last one delivered
    int m_failures = 0;   // in a row
    std::optional<Error> m_failure;
    std::optional<Error> m_fatal;
};

} // namespace driftbench
