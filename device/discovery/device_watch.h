// Tells when devices come and go, by looking every now and then on a thread of its own: hidapi has no call
// for it, and a look takes too long for a thread that draws.
//
// A change counts when so many looks in a row agree on it, as a device that is being plugged in shows itself
// piece by piece. The first list, and those that were asked for (lookAgain, setInUse), are told at once.
#pragma once

#include "device/discovery/device_scan.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace driftbench {

struct WatchOptions
{
    double intervalS = 1.0;
    double confirmS = 0.25; // until the next look while a change waits to be confirmed
    int agreeingScans = 2;
};

// Which lists are news. Pure.
class DeviceChanges
{
public:
    explicit DeviceChanges(int agreeingScans) : m_agreeingScans(agreeingScans) {}

    // Whether this list is to be told; asked: without waiting for others that agree.
    bool see(const DeviceList &list, bool asked);
    bool pending() const { return m_agreed > 0; } // a change waits to be confirmed

private:
    int m_agreeingScans;
    std::optional<DeviceList> m_told;
    DeviceList m_candidate;
    int m_agreed = 0; // scans in a row that showed the candidate
};

class DeviceWatch
{
public:
    using Scan = std::function<DeviceList(const ScanRequest &)>;
    using Changed = std::function<void(const DeviceList &)>;

    // Both are called on the watch's thread, one after the other; changed must not destroy the watch.
    DeviceWatch(Scan scan, Changed changed, WatchOptions options = {});
    ~DeviceWatch(); // waits for the look that is being taken
    DeviceWatch(const DeviceWatch &) = delete;
    DeviceWatch &operator=(const DeviceWatch &) = delete;

    void lookAgain();                              // at once, inside all of them; any thread
    void setInUse(std::vector<HidIdentity> inUse); // by this program; any thread

private:
    void watch(const std::stop_token &stop);
    void waitS(double durationS, const std::stop_token &stop); // or until it is asked

    Scan m_scan;
    Changed m_changed;
    WatchOptions m_options;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    ScanRequest m_request;
    bool m_asked = true;
    std::jthread m_thread; // last: it uses all of the above
};

} // namespace driftbench
