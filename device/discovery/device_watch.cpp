#include "device/discovery/device_watch.h"

#include <chrono>
#include <utility>

namespace driftbench {

bool DeviceChanges::see(const DeviceList &list, bool asked)
{
    if (!asked && m_told && sameDevices(list, *m_told)) {
        m_agreed = 0;
        return false;
    }
    m_agreed = m_agreed > 0 && sameDevices(list, m_candidate) ? m_agreed + 1 : 1;
    m_candidate = list;
    if (!asked && m_told && m_agreed < m_agreeingScans)
        return false;
    m_told = list;
    m_agreed = 0;
    return true;
}

DeviceWatch::DeviceWatch(Scan scan, Changed changed, WatchOptions options)
    : m_scan(std::move(scan))
    , m_changed(std::move(changed))
    , m_options(options)
    , m_thread([this](const std::stop_token &stop) { watch(stop); })
{
}

DeviceWatch::~DeviceWatch() = default;

void DeviceWatch::lookAgain()
{
    {
        const std::lock_guard lock(m_mutex);
        m_request.afresh = true;
        m_asked = true;
    }
    m_wake.notify_all();
}

void DeviceWatch::setInUse(std::vector<HidIdentity> inUse)
{
    {
        const std::lock_guard lock(m_mutex);
        m_request.inUse = std::move(inUse);
        m_asked = true;
    }
    m_wake.notify_all();
}

void DeviceWatch::watch(const std::stop_token &stop)
{
    DeviceChanges changes(m_options.agreeingScans);
    while (!stop.stop_requested()) {
        ScanRequest request;
        bool asked = false;
        {
            const std::lock_guard lock(m_mutex);
            request = m_request;
            m_request.afresh = false;
            asked = std::exchange(m_asked, false);
        }
        const DeviceList list = m_scan(request);
        if (stop.stop_requested())
            return;
        if (changes.see(list, asked))
            m_changed(list);
        waitS(changes.pending() ? m_options.confirmS : m_options.intervalS, stop);
    }
}

void DeviceWatch::waitS(double durationS, const std::stop_token &stop)
{
    std::unique_lock lock(m_mutex);
    m_wake.wait_for(lock, stop, std::chrono::duration<double>(durationS), [this] { return m_asked; });
}

} // namespace driftbench
