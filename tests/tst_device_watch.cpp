// Hotplug: which lists are news, as a pure rule; and the watch on its thread with a scan that a test makes up
// and milliseconds for seconds.
#include "device/discovery/device_watch.h"
#include "engine/base/random.h"

#include <QTest>

#include <atomic>

using namespace driftbench;

class TestDeviceWatch : public QObject
{
    Q_OBJECT

private slots:
    void changes_first_isToldAtOnce();
    void changes_newDevice_countsWhenTwoAgree();
    void changes_flicker_isNeverTold();
    void changes_asked_isToldThoughNothingChanged();
    void changes_randomLists_areToldOnlyAfterAgreement();
    void watch_plugAndUnplug_areTold();
    void watch_lookAgain_looksInsideAndTells();
    void watch_inUse_reachesTheScan();
    void watch_destroyedAtOnce_ends();
    void watch_callbacks_areNeverTwoAtATime();
};

namespace {

using namespace std::chrono_literals;

DeviceList withBridges(int count)
{
    std::vector<HidIdentity> seen;
    for (int i = 0; i < count; ++i)
        seen.push_back({0x1209, 1, "", "", "S" + std::to_string(i), "p" + std::to_string(i), -1});
    return listDevices(seen, [](UsbId) { return KernelDriverReport{}; }, {});
}

constexpr WatchOptions kFast{0.002, 0.001, 2};

// What a watch has told, and a way to wait for the next.
class Told
{
public:
    void add(const DeviceList &list)
    {
        {
            const std::lock_guard lock(m_mutex);
            m_sizes.push_back(list.size());
        }
        m_changed.notify_all();
    }
    bool waitFor(std::size_t count)
    {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, 20s, [&] { return m_sizes.size() >= count; });
    }
    std::vector<std::size_t> sizes()
    {
        const std::lock_guard lock(m_mutex);
        return m_sizes;
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::vector<std::size_t> m_sizes;
};

bool waitUntil(const std::function<bool()> &done)
{
    for (int i = 0; i < 20000 && !done(); ++i)
        std::this_thread::sleep_for(1ms);
    return done();
}

} // namespace

void TestDeviceWatch::changes_first_isToldAtOnce()
{
    DeviceChanges changes(3);
    QVERIFY(changes.see(withBridges(0), false));
    QVERIFY(!changes.see(withBridges(0), false));
}

void TestDeviceWatch::changes_newDevice_countsWhenTwoAgree()
{
    DeviceChanges changes(2);
    changes.see(withBridges(0), false);
    QVERIFY(!changes.see(withBridges(1), false));
    QVERIFY(changes.pending());
    QVERIFY(changes.see(withBridges(1), false));
    QVERIFY(!changes.pending());
    DeviceChanges hasty(1);
    hasty.see(withBridges(0), false);
    QVERIFY(hasty.see(withBridges(1), false));
}

void TestDeviceWatch::changes_flicker_isNeverTold()
{
    DeviceChanges changes(2);
    changes.see(withBridges(1), false);
    for (int i = 0; i < 10; ++i) {
        QVERIFY(!changes.see(withBridges(0), false));
        QVERIFY(!changes.see(withBridges(1), false));
    }
    // Two that differ do not agree on being different.
    QVERIFY(!changes.see(withBridges(2), false));
    QVERIFY(!changes.see(withBridges(3), false));
    QVERIFY(changes.see(withBridges(3), false));
}

void TestDeviceWatch::changes_asked_isToldThoughNothingChanged()
{
    DeviceChanges changes(2);
    changes.see(withBridges(1), false);
    QVERIFY(changes.see(withBridges(1), true));
    QVERIFY(changes.see(withBridges(2), true));
    QVERIFY(!changes.see(withBridges(2), false));
}

void TestDeviceWatch::changes_randomLists_areToldOnlyAfterAgreement()
{
    constexpr std::uint64_t kSeed = 77;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    for (const int agreeing : {1, 2, 3, 4}) {
        DeviceChanges changes(agreeing);
        std::vector<int> seen;
        int told = -1;
        for (int i = 0; i < 3000; ++i) {
            seen.push_back(random.below(3) == 0 || seen.empty() ? static_cast<int>(random.below(3))
                                                                : seen.back());
            const bool news = changes.see(withBridges(seen.back()), false);
            int inARow = 0;
            for (auto each = seen.rbegin(); each != seen.rend() && *each == seen.back(); ++each)
                ++inARow;
            const bool expected = told < 0 || (seen.back() != told && inARow >= agreeing);
            QCOMPARE(news, expected);
            if (news)
                told = seen.back();
        }
    }
}

void TestDeviceWatch::watch_plugAndUnplug_areTold()
{
    std::atomic<int> bridges = 0;
    Told told;
    DeviceWatch watch([&](const ScanRequest &) { return withBridges(bridges); },
                      [&](const DeviceList &list) { told.add(list); }, kFast);
    QVERIFY(told.waitFor(1));
    bridges = 2;
    QVERIFY(told.waitFor(2));
    bridges = 1;
    QVERIFY(told.waitFor(3));
    QCOMPARE(told.sizes(), (std::vector<std::size_t>{1, 3, 2}));
}

void TestDeviceWatch::watch_lookAgain_looksInsideAndTells()
{
    std::atomic<int> afresh = 0;
    Told told;
    // Seconds that nobody waits for: the request wakes the watch.
    DeviceWatch watch(
        [&](const ScanRequest &request) {
            afresh += request.afresh ? 1 : 0;
            return withBridges(1);
        },
        [&](const DeviceList &list) { told.add(list); }, {3600.0, 3600.0, 2});
    QVERIFY(told.waitFor(1));
    QCOMPARE(afresh.load(), 0);
    watch.lookAgain();
    QVERIFY(told.waitFor(2));
    QCOMPARE(afresh.load(), 1);
}

void TestDeviceWatch::watch_inUse_reachesTheScan()
{
    std::atomic<std::size_t> inUse = 0;
    std::atomic<int> scans = 0;
    DeviceWatch watch(
        [&](const ScanRequest &request) {
            inUse = request.inUse.size();
            ++scans;
            return withBridges(1);
        },
        [](const DeviceList &) {}, {3600.0, 3600.0, 2});
    watch.setInUse({HidIdentity{}, HidIdentity{}});
    QVERIFY(waitUntil([&] { return inUse == 2; }));
    const int before = scans;
    watch.lookAgain(); // it stays known
    QVERIFY(waitUntil([&] { return scans > before; }));
    QCOMPARE(inUse.load(), std::size_t(2));
}

void TestDeviceWatch::watch_destroyedAtOnce_ends()
{
    for (int i = 0; i < 100; ++i) {
        DeviceWatch watch([](const ScanRequest &) { return withBridges(0); }, [](const DeviceList &) {},
                          {3600.0, 3600.0, 2});
        if (i % 2 == 0)
            watch.lookAgain();
    }
}

void TestDeviceWatch::watch_callbacks_areNeverTwoAtATime()
{
    std::atomic<int> inside = 0;
    std::atomic<bool> overlapped = false;
    Told told;
    const auto enter = [&] { overlapped = overlapped || ++inside > 1; };
    DeviceWatch watch(
        [&](const ScanRequest &) {
            enter();
            --inside;
            return withBridges(0);
        },
        [&](const DeviceList &list) {
            enter();
            told.add(list);
            --inside;
        },
        kFast);
    for (std::size_t i = 1; i <= 20; ++i) {
        watch.lookAgain();
        watch.setInUse({});
        QVERIFY(told.waitFor(i));
    }
    QVERIFY(!overlapped);
}

QTEST_APPLESS_MAIN(TestDeviceWatch)
#include "tst_device_watch.moc"
