// The firmware core compiled for a Cortex-M4F and run in an emulator, against the same core and the engine
// here; its size and the instructions of a sample.
#include "engine/compensation/table_apply.h"
#include "engine/exports/device_compensation.h"
#include "support/firmware_device.h"
#include "support/models_for_export.h"
#include "support/test_data.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTest>
#include <bit>
#include <cstring>

using namespace driftbench;
using namespace driftbench::test;

class TestFirmwareCortexM4f : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void core_compiled_callsNoDivisionNorDouble();
    void core_emulated_equalsHost_data();
    void core_emulated_equalsHost();

private:
    QString m_folder;
};

namespace {

constexpr std::uint32_t kBankBytes = 65536;
constexpr int kSamples = 20000;
constexpr double kTicksPerInstruction = 25.6; // 25 MHz SysTick, 2^10 ns an instruction (icount shift=10)

const QStringList kCompilerFlags{"-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard",
                                 "-std=c99",        "-O2",     "-ffp-contract=off", "-ffreestanding",
                                 "-nostdlib",       "-Wall",   "-Wextra",           "-Werror"};

// Standard output; a failed check where the program could not run or was not content.
QByteArray run(const QString &folder, const QString &program, const QStringList &arguments)
{
    QProcess process;
    process.setWorkingDirectory(folder);
    process.start(program, arguments);
    const bool ended = process.waitForFinished(60000);
    const QByteArray errors = process.readAllStandardError();
    if (!ended || process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
        QTest::qFail(qPrintable(program + ": " + process.errorString() + " " + errors), __FILE__, __LINE__);
    return process.readAllStandardOutput();
}

QStringList filesOf(const QString &folder)
{
    QStringList files;
    for (const QFileInfo &file : QDir(folder).entryInfoList({"*.c"}, QDir::Files, QDir::Name))
        files << file.filePath();
    return files;
}

void append(QByteArray &bytes, std::uint32_t value)
{
    std::uint8_t raw[4];
    bridge_put_u32(raw, value);
    bytes.append(reinterpret_cast<const char *>(raw), 4);
}

// Reads what the board wrote, in order.
class Results
{
public:
    explicit Results(QByteArray bytes) : m_bytes(std::move(bytes)) {}
    const std::uint8_t *take(qsizetype count)
    {
        static const std::uint8_t nothing[64] = {};
        if (m_at + count > m_bytes.size()) {
            m_cut = true;
            return nothing;
        }
        const auto *at = reinterpret_cast<const std::uint8_t *>(m_bytes.constData()) + m_at;
        m_at += count;
        return at;
    }
    std::uint32_t u32() { return bridge_get_u32(take(4)); }
    bool wereWhole() const { return !m_cut && m_at == m_bytes.size(); }

private:
    QByteArray m_bytes;
    qsizetype m_at = 0;
    bool m_cut = false;
};

// Distance in units of the last place; floats of one sign are in the order of their bits.
std::int64_t ulps(std::uint32_t a, std::uint32_t b)
{
    const auto ordered = [](std::uint32_t bits) {
        const std::int64_t magnitude = bits & 0x7FFFFFFFU;
        return (bits >> 31) != 0 ? -magnitude : magnitude;
    };
    return std::abs(ordered(a) - ordered(b));
}

// The samples that the board makes up (check.c).
bridge_sample sampleAt(std::uint32_t index, std::int32_t milliC)
{
    bridge_sample sample{};
    sample.time_us = 1000 * index;
    for (std::uint32_t axis = 0; axis < 3; ++axis)
        sample.counts[axis] =
            static_cast<std::int16_t>(static_cast<std::uint16_t>(index * (7919U + 1000U * axis)));
    sample.die_valid = true;
    sample.die_millic = milliC;
    return sample;
}

std::vector<std::int32_t> temperaturesFor(Random &random, const CompensationTable &table)
{
    std::vector<std::int32_t> milliC;
    const auto span = static_cast<std::uint64_t>(table.lastMilliC - table.firstMilliC);
    for (int i = 0; i < kSamples; ++i) {
        milliC.push_back(random.below(50) == 0 ? static_cast<std::int32_t>(random.bits())
                                               : table.firstMilliC - 1000 +
                                                     static_cast<std::int32_t>(random.below(span + 2000)));
    }
    return milliC;
}

std::vector<Report> installReports(const Bytes &image)
{
    std::vector<Report> reports = uploadReports(image, 1);
    reports.push_back(generationReport(BRIDGE_REPORT_ACTIVATE, 1));
    Report config = makeReport(BRIDGE_REPORT_CONFIG);
    bridge_put_u32(config.data() + BRIDGE_CONFIG_RATE, 1000000);
    config[BRIDGE_CONFIG_STREAM] = config[BRIDGE_CONFIG_COMPENSATE] = 1;
    reports.push_back(config);
    return reports;
}

QByteArray casesFor(const std::vector<Report> &reports, const std::vector<std::int32_t> &milliC)
{
    QByteArray cases;
    append(cases, static_cast<std::uint32_t>(reports.size()));
    for (const Report &report : reports)
        cases.append(reinterpret_cast<const char *>(report.data()), static_cast<qsizetype>(report.size()));
    append(cases, static_cast<std::uint32_t>(milliC.size()));
    for (const std::int32_t value : milliC)
        append(cases, static_cast<std::uint32_t>(value));
    return cases;
}

// tde of the engine as the board writes it: units, or the bits of float32.
std::array<std::uint32_t, 3> tdeOfEngine(const DeviceImage &image,
                                         const std::optional<TableApply<float>> &apply, std::int32_t milliC)
{
    std::array<std::uint32_t, 3> tde{};
    if (image.fixed) {
        const auto units = tdeUnits(*image.fixed, milliC);
        std::transform(units.begin(), units.end(), tde.begin(), [](auto u) { return std::uint32_t(u); });
    } else {
        const auto dps =
            apply->tde(TableApply<float>::Column::Constant(1, static_cast<float>(milliC) / 1000.0F));
        for (std::size_t axis = 0; axis < 3; ++axis)
            tde[axis] = std::bit_cast<std::uint32_t>(dps(0, static_cast<Eigen::Index>(axis)));
    }
    return tde;
}

} // namespace

void TestFirmwareCortexM4f::initTestCase()
{
    for (const char *program :
         {"arm-none-eabi-gcc", "arm-none-eabi-size", "arm-none-eabi-nm", "qemu-system-arm"}) {
        if (QStandardPaths::findExecutable(program).isEmpty())
            QSKIP(qPrintable(QStringLiteral("firmware_cortex_m4f: there is no %1 here").arg(program)));
    }
    m_folder = QString::fromStdString(scratchFolder().string());
    const QString source = driftbench::test::sourceFolder();
    const QStringList core = filesOf(source + "/device/firmware");
    QCOMPARE(core.size(), 8);
    run(m_folder, "arm-none-eabi-gcc", kCompilerFlags + QStringList{"-I" + source, "-c"} + core);
    QStringList objects;
    for (const QString &file : core)
        objects << QFileInfo(file).completeBaseName() + ".o";
    QFile map(m_folder + "/check.elf");
    const QString board = source + "/device/firmware/cortex_m";
    run(m_folder, "arm-none-eabi-gcc",
        kCompilerFlags + QStringList{"-I" + source, "-T", board + "/mps2.ld"} + filesOf(board) + objects +
            QStringList{"-lgcc", "-o", "check.elf"});
    QVERIFY(map.exists());
    const QByteArray sizes = run(m_folder, "arm-none-eabi-size", QStringList{"-t"} + objects);
    qInfo("arm-none-eabi-size of the core (-O2):\n%s", sizes.constData());
    static const QRegularExpression total(R"(\n\s*(\d+)\s+(\d+)\s+(\d+)\s+\d+\s+[0-9a-f]+\s+\(TOTALS\))");
    const auto match = total.match(QString::fromUtf8(sizes));
    QVERIFY(match.hasMatch());
    // No globals: the core has neither initialised nor zeroed data of its own.
    QCOMPARE(match.captured(2).toInt(), 0);
    QCOMPARE(match.captured(3).toInt(), 0);
}

void TestFirmwareCortexM4f::core_compiled_callsNoDivisionNorDouble()
{
    const QByteArray symbols = run(m_folder, "arm-none-eabi-nm", {"check.elf"});
    for (const char *routine : {"__aeabi_uldivmod", "__aeabi_ldivmod", "__aeabi_d", "__aeabi_f2d"})
        QVERIFY2(!symbols.contains(routine), routine);
}

void TestFirmwareCortexM4f::core_emulated_equalsHost_data()
{
    QTest::addColumn<DeviceTableKind>("kind");
    QTest::newRow("fixed point") << DeviceTableKind::FixedPoint;
    QTest::newRow("float") << DeviceTableKind::Float;
}

void TestFirmwareCortexM4f::core_emulated_equalsHost()
{
    QFETCH(DeviceTableKind, kind);
    Random random = announced(20261251);
    const CompensationTable table = randomTable(random, 2000, 3.0);
    const Bytes bytes = imageOf(table, kind);
    const DeviceImage image = *decodeDeviceImage(bytes, "image");
    std::optional<TableApply<float>> apply;
    if (kind == DeviceTableKind::Float)
        apply.emplace(image.table);
    const std::vector<std::int32_t> milliC = temperaturesFor(random, table);
    const std::vector<Report> reports = installReports(bytes);

    QFile cases(m_folder + "/cases");
    QVERIFY(cases.open(QIODevice::WriteOnly));
    cases.write(casesFor(reports, milliC));
    cases.close();
    run(m_folder, "qemu-system-arm",
        {"-M", "mps2-an386", "-nographic", "-monitor", "none", "-serial", "none", "-icount", "shift=10",
         "-semihosting-config", "enable=on,target=native", "-kernel", "check.elf"});
    QFile file(m_folder + "/results");
    QVERIFY(file.open(QIODevice::ReadOnly));
    Results results(file.readAll());

    for (std::size_t i = 0; i < reports.size(); ++i)
        QCOMPARE(int(*results.take(1)), int(BRIDGE_RESULT_OK));
    const DeviceCompensation compensation(image, 875);
    std::int64_t worstUlps = 0;
    for (const std::int32_t value : milliC) {
        const auto expected = tdeOfEngine(image, apply, value);
        const auto counts = compensation.tdeCounts(value);
        for (const std::uint32_t bits : expected) {
            const std::uint32_t found = results.u32();
            if (kind == DeviceTableKind::FixedPoint)
                QCOMPARE(found, bits);
            worstUlps = std::max(worstUlps, kind == DeviceTableKind::Float ? ulps(found, bits) : 0);
        }
        for (const std::int32_t expectedCounts : counts) {
            const auto found = static_cast<std::int32_t>(results.u32());
            QVERIFY(std::abs(found - expectedCounts) <= (kind == DeviceTableKind::Float ? 1 : 0));
        }
    }
    QVERIFY2(worstUlps <= 1, qPrintable(QString::number(worstUlps)));

    RamFlash flash(kBankBytes);
    FirmwareDevice host(flash);
    QCOMPARE(host.send(reports), static_cast<int>(reports.size()));
    const std::uint32_t made = results.u32();
    QCOMPARE(made, std::uint32_t(kSamples / BRIDGE_SAMPLES_PER_REPORT));
    int differing = 0;
    for (std::uint32_t i = 0; i < milliC.size(); ++i) {
        const bridge_sample sample = sampleAt(i, milliC[i]);
        bridge_device_sample(&host.device, &sample);
        Report report;
        if (bridge_device_take(&host.device, report.data()))
            differing +=
                std::memcmp(results.take(BRIDGE_REPORT_SIZE), report.data(), BRIDGE_REPORT_SIZE) != 0;
    }
    if (kind == DeviceTableKind::FixedPoint)
        QCOMPARE(differing, 0);

    const double perSample = kTicksPerInstruction * results.u32();
    const double lookUp = results.u32() / perSample;
    const double withCounts = results.u32() / perSample;
    const double wholeWay = results.u32() / perSample;
    const std::uint32_t deviceBytes = results.u32();
    QVERIFY(results.wereWhole());
    qInfo("%d temperatures: tde differs by at most %lld ulp, %d of %u reports differ", kSamples,
          static_cast<long long>(worstUlps), differing, made);
    qInfo("instructions a sample: table look-up of 3 axes %.1f, with counts %.1f, whole way into a report "
          "%.1f; "
          "struct bridge_device has %u bytes, a report in the ring 64",
          lookUp, withCounts, wholeWay, deviceBytes);
    QVERIFY(lookUp > 10.0 && lookUp < withCounts);
}

QTEST_APPLESS_MAIN(TestFirmwareCortexM4f)
#include "tst_firmware_cortex_m4f.moc"
