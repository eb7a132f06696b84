// The table store under power cuts: whatever is cut at whatever point, the device comes up with the old or
// the new table, whole, and its status says which.
#include "support/firmware_device.h"
#include "support/models_for_export.h"

#include <QTest>
#include <cstring>
#include <memory>

using namespace driftbench;
using namespace driftbench::test;

class TestFirmwareStore : public QObject
{
    Q_OBJECT

private slots:
    void install_cutAtEveryFlashOperation_oldOrNewWhole_data();
    void install_cutAtEveryFlashOperation_oldOrNewWhole();
    void install_cutAtEveryReport_oldOrNewWhole_data();
    void install_cutAtEveryReport_oldOrNewWhole();
    void install_cutTwice_oldOrNewWhole_data();
    void install_cutTwice_oldOrNewWhole();
    void rollback_cutInEveryWay_oldOrNewAndRepeatable();
    void install_everyFlashRefusal_isToldAndHarmless();
    void erase_losesOnlyTheRevocation_revokedStaysUnused();
    void erase_bankThatCannotBeRetired_isNotErased();
    void bank_everyBitFlipped_isNeverUsedDamaged();
    void marks_runOut_isToldAndAnUploadHelps();
};

namespace {

constexpr std::uint32_t kBankBytes = 2048;
constexpr int kTornSeeds = 50;

// Known images: what a bank holds must be one of them, whole.
struct Scene
{
    explicit Scene(std::uint64_t seed) : random(seed)
    {
        for (Bytes *image : {&older, &newer, &uploaded, &afterwards})
            *image = randomImage(random, 2 + static_cast<int>(random.below(5)),
                                 random.below(2) == 0 ? DeviceTableKind::FixedPoint : DeviceTableKind::Float);
    }

    Random random;
    RamFlash flash{kBankBytes};
    Bytes older, newer, uploaded, afterwards;
    std::optional<Bytes> active; // in the start state
};

void upload(FirmwareDevice &device, const Bytes &image, std::uint16_t transaction)
{
    const std::vector<Report> reports = uploadReports(image, transaction);
    QCOMPARE(device.send(reports), static_cast<int>(reports.size()));
}

void bringInto(const QByteArray &state, Scene &scene)
{
    FirmwareDevice device(scene.flash);
    if (state == "foreign table")
        device.identity.serial[0] = 'X';
    if (state == "no table")
        return;
    if (state == "foreign table") {
        std::memcpy(scene.older.data() + BRIDGE_TABLE_SERIAL, device.identity.serial, BRIDGE_SERIAL_SIZE);
        device.powerUp();
        QCOMPARE(device.install(scene.older, 1), std::uint8_t(BRIDGE_RESULT_OK));
        return;
    }
    if (state == "committed only") {
        upload(device, scene.older, 1);
        return;
    }
    QCOMPARE(device.install(scene.older, 1), std::uint8_t(BRIDGE_RESULT_OK));
    scene.active = scene.older;
    if (state == "one active")
        return;
    if (state == "one rolled back") {
        QCOMPARE(device.rollback(), std::uint8_t(BRIDGE_RESULT_OK));
        scene.active.reset();
        return;
    }
    QCOMPARE(device.install(scene.newer, 2), std::uint8_t(BRIDGE_RESULT_OK));
    scene.active = scene.newer;
    if (state == "two, newer rolled back") {
        QCOMPARE(device.rollback(), std::uint8_t(BRIDGE_RESULT_OK));
        scene.active = scene.older;
    }
}

void addStates()
{
    QTest::addColumn<QByteArray>("state");
    for (const char *state : {"no table", "committed only", "one active", "two active",
                              "two, newer rolled back", "one rolled back", "foreign table"})
        QTest::newRow(state) << QByteArray(state);
}

std::optional<Bytes> activeImage(FirmwareDevice &device)
{
    const std::uint8_t bank = device.status().active;
    if (bank == BRIDGE_NO_BANK)
        return std::nullopt;
    return device.image(bank);
}

// Does every bank that is not empty hold one of the scene's images, with the length and CRC of the status?
bool banksAreWhole(FirmwareDevice &device, const Scene &scene)
{
    const DeviceStatus status = device.status();
    for (std::uint8_t bank = 0; bank < BRIDGE_BANKS; ++bank) {
        const BankStatus &told = status.banks[bank];
        if (told.state == BRIDGE_BANK_EMPTY) {
            if (told != BankStatus{} || status.active == bank)
                return false;
            continue;
        }
        const Bytes image = device.image(bank);
        if (image.size() != told.bytes || deviceImageCrc(image) != told.crc ||
            (image != scene.older && image != scene.newer && image != scene.uploaded &&
             image != scene.afterwards))
            return false;
        if (status.active == bank && told.state != BRIDGE_BANK_ACTIVATED)
            return false;
    }
    return true;
}

// After a cut: the table is the expected one, nothing is torn, and a fresh upload and its undoing work.
void checkAndContinue(RamFlash &flash, const Scene &scene, bool mayBeOld, bool mayBeNew)
{
    FirmwareDevice device(flash);
    const std::optional<Bytes> found = activeImage(device);
    QVERIFY(banksAreWhole(device, scene));
    QVERIFY((mayBeOld && found == scene.active) || (mayBeNew && found == scene.uploaded));

    QCOMPARE(device.install(scene.afterwards, 3), std::uint8_t(BRIDGE_RESULT_OK));
    device.powerUp();
    QVERIFY(activeImage(device) == scene.afterwards);
    QVERIFY(banksAreWhole(device, scene));
    QCOMPARE(device.rollback(), std::uint8_t(BRIDGE_RESULT_OK));
    device.powerUp();
    QVERIFY(activeImage(device) == found);
    QCOMPARE(flash.violations(), 0);
}

int operationsOfInstall(const Scene &scene)
{
    RamFlash flash(scene.flash);
    FirmwareDevice device(flash);
    const int before = flash.operations();
    device.install(scene.uploaded, 2);
    return flash.operations() - before;
}

template <class Check>
void forEveryCut(int operations, const Check &check)
{
    for (int operation = 0; operation < operations; ++operation) {
        check(operation, PowerCut::Before, 0);
        check(operation, PowerCut::After, 0);
        for (int seed = 0; seed < kTornSeeds; ++seed)
            check(operation, PowerCut::Torn, seed);
    }
}

} // namespace

void TestFirmwareStore::install_cutAtEveryFlashOperation_oldOrNewWhole_data()
{
    addStates();
}

void TestFirmwareStore::install_cutAtEveryFlashOperation_oldOrNewWhole()
{
    QFETCH(QByteArray, state);
    Scene scene(announced(20261201).bits());
    bringInto(state, scene);
    const int operations = operationsOfInstall(scene);
    const int oldBank = scene.active ? FirmwareDevice(scene.flash).status().active : -1;
    int cuts = 0;
    forEveryCut(operations, [&](int operation, PowerCut how, int seed) {
        RamFlash flash(scene.flash);
        FirmwareDevice device(flash);
        flash.cutPowerAt(operation, how, static_cast<std::uint64_t>(1000 * operation + seed));
        device.install(scene.uploaded, 2);
        QVERIFY(!flash.hasPower());
        if (oldBank >= 0)
            QVERIFY(flash.bank(static_cast<std::size_t>(oldBank)) ==
                    scene.flash.bank(static_cast<std::size_t>(oldBank)));
        // The mark of activation is the last operation; before it nothing has changed for the user.
        const bool last = operation == operations - 1;
        checkAndContinue(flash, scene, !last || how != PowerCut::After, last && how != PowerCut::Before);
        ++cuts;
    });
    qInfo("%d flash operations, %d cuts", operations, cuts);
}

void TestFirmwareStore::install_cutAtEveryReport_oldOrNewWhole_data()
{
    addStates();
}

void TestFirmwareStore::install_cutAtEveryReport_oldOrNewWhole()
{
    QFETCH(QByteArray, state);
    Scene scene(announced(20261202).bits());
    scene.uploaded = randomImage(scene.random, 30);
    bringInto(state, scene);
    const std::vector<Report> reports = uploadReports(scene.uploaded, 2);
    for (std::size_t sent = 0; sent <= reports.size() + 1; ++sent) {
        RamFlash flash(scene.flash);
        {
            FirmwareDevice device(flash);
            const std::size_t count = std::min(sent, reports.size());
            QCOMPARE(device.send({reports.begin(), reports.begin() + static_cast<std::ptrdiff_t>(count)}),
                     static_cast<int>(count));
            if (sent > reports.size()) {
                const DeviceStatus status = device.status();
                const std::uint32_t newest = std::max(status.banks[0].generation, status.banks[1].generation);
                QCOMPARE(device.set(generationReport(BRIDGE_REPORT_ACTIVATE, newest)),
                         std::uint8_t(BRIDGE_RESULT_OK));
            }
        }
        checkAndContinue(flash, scene, sent <= reports.size(), sent > reports.size());
    }
    qInfo("%zu reports, cut after each", reports.size() + 1);
}

void TestFirmwareStore::install_cutTwice_oldOrNewWhole_data()
{
    addStates();
}

void TestFirmwareStore::install_cutTwice_oldOrNewWhole()
{
    QFETCH(QByteArray, state);
    Scene scene(announced(20261203).bits());
    scene.uploaded = randomImage(scene.random, 2);
    bringInto(state, scene);
    const int operations = operationsOfInstall(scene);
    int cuts = 0;
    for (int first = 0; first < operations; ++first) {
        for (int second = 0; second < operations; ++second) {
            for (std::uint64_t seed = 0; seed < 8; ++seed) {
                RamFlash flash(scene.flash);
                FirmwareDevice device(flash);
                flash.cutPowerAt(first, PowerCut::Torn, seed + 10);
                device.install(scene.uploaded, 2);
                device.powerUp();
                const bool alreadyNew = activeImage(device) == scene.uploaded;
                flash.cutPowerAt(second, PowerCut::Torn, seed + 20);
                device.install(scene.uploaded, 4);
                checkAndContinue(flash, scene, !alreadyNew, true);
                ++cuts;
            }
        }
    }
    qInfo("%d pairs of cuts", cuts);
}

void TestFirmwareStore::rollback_cutInEveryWay_oldOrNewAndRepeatable()
{
    Scene scene(announced(20261204).bits());
    bringInto("two active", scene);
    const std::uint32_t generation = [&] {
        const DeviceStatus status = FirmwareDevice(scene.flash).status();
        return status.banks[status.active].generation;
    }();
    forEveryCut(1, [&](int operation, PowerCut how, int seed) {
        RamFlash flash(scene.flash);
        FirmwareDevice device(flash);
        flash.cutPowerAt(operation, how, static_cast<std::uint64_t>(seed));
        device.rollback();
        device.powerUp();
        const std::optional<Bytes> found = activeImage(device);
        QVERIFY(found == scene.older || found == scene.newer);
        if (how != PowerCut::Torn)
            QVERIFY(found == (how == PowerCut::After ? scene.older : scene.newer));
        QCOMPARE(device.set(generationReport(BRIDGE_REPORT_ROLLBACK, generation)),
                 std::uint8_t(BRIDGE_RESULT_OK));
        device.powerUp();
        QVERIFY(activeImage(device) == scene.older);
        QVERIFY(banksAreWhole(device, scene));
        QCOMPARE(flash.violations(), 0);
    });
}

void TestFirmwareStore::install_everyFlashRefusal_isToldAndHarmless()
{
    Scene scene(announced(20261205).bits());
    bringInto("two active", scene);
    const int operations = operationsOfInstall(scene);
    for (int operation = 0; operation < operations; ++operation) {
        RamFlash flash(scene.flash);
        FirmwareDevice device(flash);
        flash.refuseAt(operation);
        const std::uint8_t result = device.install(scene.uploaded, 2);
        // A unit for retiring or a slot for a mark that refuses has a neighbour.
        const bool hasNeighbour = operation == 0 || operation == operations - 1;
        QCOMPARE(result, std::uint8_t(hasNeighbour ? BRIDGE_RESULT_OK : BRIDGE_RESULT_FLASH));
        const std::optional<Bytes> before = activeImage(device);
        QVERIFY(banksAreWhole(device, scene));
        checkAndContinue(flash, scene, !hasNeighbour, hasNeighbour);
        QVERIFY(before == (hasNeighbour ? scene.uploaded : *scene.active));
    }
}

void TestFirmwareStore::erase_losesOnlyTheRevocation_revokedStaysUnused()
{
    Scene scene(announced(20261206).bits());
    bringInto("two, newer rolled back", scene);
    RamFlash flash(scene.flash);
    FirmwareDevice device(flash);
    const std::uint8_t bank = 1 - device.status().active;
    // The next upload goes into the revoked bank: retired, then its erasure is cut off before it began.
    flash.cutPowerAt(1, PowerCut::Before, 0);
    device.install(scene.uploaded, 3);
    QVERIFY(!flash.hasPower());
    Bytes &bytes = flash.bank(bank);
    const auto revoked = bytes.begin() + BRIDGE_BANK_MARKS_AT + 2 * BRIDGE_FLASH_UNIT;
    QCOMPARE(*revoked, std::uint8_t(BRIDGE_MARK_REVOKED));
    std::fill(revoked, revoked + BRIDGE_FLASH_UNIT, std::uint8_t(BRIDGE_FLASH_ERASED));
    device.powerUp();
    QCOMPARE(device.status().banks[bank].state, std::uint8_t(BRIDGE_BANK_EMPTY));
    QVERIFY(activeImage(device) == scene.older);
}

void TestFirmwareStore::erase_bankThatCannotBeRetired_isNotErased()
{
    Scene scene(announced(20261209).bits());
    bringInto("two, newer rolled back", scene);
    FirmwareDevice device(scene.flash);
    const DeviceStatus before = device.status();
    scene.flash.refuseAt(0, BRIDGE_BANK_RETIRE_UNITS);
    QCOMPARE(device.install(scene.uploaded, 3), std::uint8_t(BRIDGE_RESULT_FLASH));
    QVERIFY(device.status().banks == before.banks);
    device.powerUp();
    QVERIFY(device.status().banks == before.banks);
    QVERIFY(activeImage(device) == scene.older);
}

void TestFirmwareStore::bank_everyBitFlipped_isNeverUsedDamaged()
{
    Scene scene(announced(20261207).bits());
    bringInto("two active", scene);
    const std::uint8_t active = FirmwareDevice(scene.flash).status().active;
    const std::size_t used = BRIDGE_BANK_IMAGE_AT + scene.newer.size();
    const std::size_t reserved = BRIDGE_BANK_HEADER_AT + 20;
    const std::size_t activated = BRIDGE_BANK_MARKS_AT + BRIDGE_FLASH_UNIT;
    for (std::size_t bit = 0; bit < 8 * used; ++bit) {
        const std::size_t byte = bit / 8;
        RamFlash flash(scene.flash);
        flash.bank(active)[byte] ^= static_cast<std::uint8_t>(1U << (bit % 8));
        FirmwareDevice device(flash);
        QVERIFY(banksAreWhole(device, scene));
        // Nothing stands in the reserved bytes and the free slots, and the mark after the commitment decides.
        const bool harmless = (byte >= reserved && byte < activated) ||
                              (byte >= activated + BRIDGE_FLASH_UNIT && byte < BRIDGE_BANK_IMAGE_AT);
        QVERIFY2(activeImage(device) == (harmless ? scene.newer : scene.older),
                 qPrintable(QString::number(byte)));
    }
}

void TestFirmwareStore::marks_runOut_isToldAndAnUploadHelps()
{
    Scene scene(announced(20261208).bits());
    bringInto("one active", scene);
    FirmwareDevice device(scene.flash);
    const DeviceStatus status = device.status();
    const std::uint32_t generation = status.banks[status.active].generation;
    std::uint8_t result = BRIDGE_RESULT_OK;
    int marks = 2; // committed, activated
    for (; marks < 100; ++marks) {
        const bool active = device.status().active != BRIDGE_NO_BANK;
        result = device.set(generationReport(active ? std::uint8_t(BRIDGE_REPORT_ROLLBACK)
                                                    : std::uint8_t(BRIDGE_REPORT_ACTIVATE),
                                             generation));
        if (result != BRIDGE_RESULT_OK)
            break;
    }
    QCOMPARE(result, std::uint8_t(BRIDGE_RESULT_FULL));
    QCOMPARE(marks, static_cast<int>(BRIDGE_BANK_MARKS));
    const std::optional<Bytes> before = activeImage(device);
    device.powerUp();
    QVERIFY(activeImage(device) == before);
    QCOMPARE(device.install(scene.newer, 7), std::uint8_t(BRIDGE_RESULT_OK));
    QVERIFY(activeImage(device) == scene.newer);
    QCOMPARE(scene.flash.violations(), 0);
}

QTEST_APPLESS_MAIN(TestFirmwareStore)
#include "tst_firmware_store.moc"
