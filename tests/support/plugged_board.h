// A native gyro bridge that is plugged into the computer, and can be pulled out: a simulated board behind the
// list of HID devices, as the drivers and the watch for hotplug see real ones. It keeps its tables while it
// is away.
#pragma once

#include "device/hid_access.h"
#include "device/simulated_bridge.h"
#include "engine/physics/sensor_presets.h"

#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>

namespace driftbench::test {

class PluggedBoard
{
public:
    // The gyro of the runs in support/session_runs.h, so many times as fast as the clock on the wall, held at
    // 25 degrees for a day.
    explicit PluggedBoard(double speed)
    {
        SimulationOptions simulation = *presetSimulation("L3GD20H", Eigen::Vector3d::Zero());
        simulation.sensor.serial = "T-1";
        simulation.profile = *TemperatureProfile::build("held", 25.0, {HoldSegment{86400.0}});
        SimulatedBoardOptions options{std::move(simulation)};
        options.speed = speed;
        options.highestRateHz = 200.0; // at which it starts
        auto made = SimulatedBoard::create(std::move(options));
        if (!made)
            qFatal("%s", made.error().message.c_str());
        m_board = *std::move(made);
    }

    SimulatedBoard *operator->() const { return m_board.get(); }

    HidAccess access() const
    {
        HidAccess access;
        access.list = [board = m_board, users = m_users] {
            users->note();
            return board->pluggedIn() ? std::vector<HidIdentity>{board->identity()}
                                      : std::vector<HidIdentity>();
        };
        access.open = [board = m_board, cut = m_cut,
                       users = m_users](const HidIdentity &) -> Result<std::unique_ptr<HidTransport>> {
            users->note();
            auto link = SimulatedBridge::open(board);
            if (!link)
                return link.error();
            return std::unique_ptr<HidTransport>(std::make_unique<Link>(*std::move(link), board, cut, users));
        };
        access.sysfs = "/nonexistent";
        access.clock = &m_board->clock();
        return access;
    }

    // Unplugs it in the middle of an exchange: instead of the n-th set of that feature report from now on.
    void cutAtSet(std::uint8_t report, int nth) const
    {
        const std::lock_guard lock(m_cut->mutex);
        m_cut->at = {report, nth};
    }

    // The threads that looked for it, opened it or talked to it.
    std::set<std::thread::id> users() const
    {
        const std::lock_guard lock(m_users->mutex);
        return m_users->threads;
    }

private:
    struct Users
    {
        std::mutex mutex;
        std::set<std::thread::id> threads;

        void note()
        {
            const std::lock_guard lock(mutex);
            threads.insert(std::this_thread::get_id());
        }
    };
    struct Cut
    {
        std::mutex mutex;
        std::optional<std::pair<std::uint8_t, int>> at;

        bool isDue(std::uint8_t report)
        {
            const std::lock_guard lock(mutex);
            if (!at || at->first != report || --at->second > 0)
                return false;
            at.reset();
            return true;
        }
    };

    class Link final : public HidTransport
    {
    public:
        Link(std::unique_ptr<HidTransport> below, std::shared_ptr<SimulatedBoard> board,
             std::shared_ptr<Cut> cut, std::shared_ptr<Users> users)
            : m_below(std::move(below))
            , m_board(std::move(board))
            , m_cut(std::move(cut))
            , m_users(std::move(users))
        {
        }

        const HidIdentity &identity() const override { return m_below->identity(); }
        Result<std::size_t> read(std::span<std::uint8_t> report, std::chrono::milliseconds timeout) override
        {
            m_users->note();
            return m_below->read(report, timeout);
        }
        Status write(std::span<const std::uint8_t> report) override { return m_below->write(report); }
        Result<std::size_t> getFeature(std::span<std::uint8_t> report) override
        {
            m_users->note();
            return m_below->getFeature(report);
        }
        Status sendFeature(std::span<const std::uint8_t> report) override
        {
            m_users->note();
            if (m_cut->isDue(report[0]))
                m_board->unplug();
            return m_below->sendFeature(report);
        }

    private:
        std::unique_ptr<HidTransport> m_below;
        std::shared_ptr<SimulatedBoard> m_board;
        std::shared_ptr<Cut> m_cut;
        std::shared_ptr<Users> m_users;
    };

    std::shared_ptr<SimulatedBoard> m_board;
    std::shared_ptr<Cut> m_cut = std::make_shared<Cut>();
    std::shared_ptr<Users> m_users = std::make_shared<Users>();
};

} // namespace driftbench::test
