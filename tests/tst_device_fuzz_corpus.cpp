// What the fuzzer starts from, and a short walk away from it: every seed of tests/corpus/device is what the
// encoders give and is taken by its decoder; seeds with changed bytes and plain noise break no contract.
// With DRIFTBENCH_WRITE_CORPUS set the seeds are written instead of compared.
#include "support/device_decoders.h"
#include "support/firmware_device.h"
#include "support/models_for_export.h"
#include "support/test_data.h"

#include <QDir>
#include <QFile>
#include <QMap>
#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceFuzzCorpus : public QObject
{
    Q_OBJECT

private slots:
    void corpus_files_areWhatTheEncodersGive();
    void corpus_everyDecoder_hasASeedThatItTakes();
    void decode_changedSeeds_breakNoContract();
    void decode_noise_breaksNoContract();
};

namespace {

using Seeds = QMap<QString, Bytes>;

QString corpusFolder()
{
    return sourceFolder() + "/tests/corpus/device";
}

Bytes seed(DeviceDecoder decoder, std::initializer_list<std::uint8_t> bytes)
{
    Bytes made{static_cast<std::uint8_t>(decoder)};
    made.insert(made.end(), bytes);
    return made;
}

void append(Bytes &bytes, const Report &report)
{
    bytes.insert(bytes.end(), report.begin(), report.end());
}

Bytes seed(DeviceDecoder decoder, const Report &report)
{
    Bytes made = seed(decoder, {});
    append(made, report);
    return made;
}

// Padded to the size of a HID report, as the chips send it.
Bytes chipSeed(DeviceDecoder decoder, std::initializer_list<std::uint8_t> bytes)
{
    Bytes made = seed(decoder, bytes);
    made.resize(1 + BRIDGE_REPORT_SIZE);
    return made;
}

// Compensated reports, their twins, and one that was lost on the way.
std::vector<Report> streamed(FirmwareDevice &firmware)
{
    Report config = firmware.get(BRIDGE_REPORT_CONFIG);
    config[BRIDGE_CONFIG_STREAM] = config[BRIDGE_CONFIG_PAIR] = 1;
    firmware.set(config);
    std::vector<Report> reports;
    for (std::uint32_t i = 0; i < 28; ++i) {
        const auto counts = static_cast<std::int16_t>(100 * i);
        const bridge_sample sample{
            0xFFFFFF00U + 1000U * i, {counts, -5, INT16_MAX}, true, true, 20000, 21000};
        bridge_device_sample(&firmware.device, &sample);
        Report report;
        while (bridge_device_take(&firmware.device, report.data()))
            reports.push_back(report);
    }
    reports.erase(reports.begin() + 4);
    return reports;
}

void addBridgeSeeds(Seeds &seeds)
{
    Random random(31);
    RamFlash flash(4096);
    FirmwareDevice firmware(flash);
    const Bytes fixed = randomImage(random, 5);
    const Bytes floating = randomImage(random, 4, DeviceTableKind::Float);
    firmware.install(fixed, 1);
    seeds["bridge_info"] = seed(DeviceDecoder::BridgeInfo, firmware.get(BRIDGE_REPORT_INFO));
    seeds["bridge_config"] = seed(DeviceDecoder::BridgeConfig, firmware.get(BRIDGE_REPORT_CONFIG));
    seeds["bridge_status"] = seed(DeviceDecoder::BridgeStatus, firmware.get(BRIDGE_REPORT_STATUS));
    Report choice = makeReport(BRIDGE_REPORT_READ);
    choice[BRIDGE_READ_LENGTH] = BRIDGE_READ_BYTES;
    firmware.set(choice);
    seeds["bridge_table_part"] = seed(DeviceDecoder::BridgeTablePart, firmware.get(BRIDGE_REPORT_READ));
    Bytes stream = seed(DeviceDecoder::BridgeStream, {});
    for (const Report &report : streamed(firmware)) {
        stream.push_back(7);
        append(stream, report);
    }
    seeds["bridge_stream"] = stream;
    seeds["bridge_samples"] = Bytes(stream.begin() + 1, stream.begin() + 2 + BRIDGE_REPORT_SIZE);
    seeds["bridge_samples"][0] = static_cast<std::uint8_t>(DeviceDecoder::BridgeSamples);
    for (const auto &[name, image] :
         {std::pair("device_image_fixed", fixed), {"device_image_float", floating}}) {
        seeds[name] = seed(DeviceDecoder::DeviceImage, {});
        seeds[name].insert(seeds[name].end(), image.begin(), image.end());
    }
    Bytes host = seed(DeviceDecoder::Firmware, {});
    for (const Report &report : uploadReports(fixed, 7))
        append(host, report);
    append(host, generationReport(BRIDGE_REPORT_ACTIVATE, 1));
    Report config = firmware.get(BRIDGE_REPORT_CONFIG);
    append(host, config);
    append(host, choice);
    append(host, generationReport(BRIDGE_REPORT_ROLLBACK, 1));
    seeds["firmware"] = host;
}

void addChipSeeds(Seeds &seeds)
{
    seeds["mcp2221a_status"] = chipSeed(DeviceDecoder::Mcp2221a, {0x10, 0, 0, 0x20, 27});
    seeds["mcp2221a_data"] = chipSeed(DeviceDecoder::Mcp2221a, {0x40, 0, 0x55, 3, 0xD7, 0x01, 0x02});
    seeds["mcp2221a_taken"] = chipSeed(DeviceDecoder::Mcp2221a, {0x90, 0});
    seeds["cp2112_data"] = chipSeed(DeviceDecoder::Cp2112, {0x13, 2, 3, 0xD7, 0x01, 0x02});
    seeds["cp2112_status"] = chipSeed(DeviceDecoder::Cp2112, {0x16, 2, 5, 0, 0, 0, 3});
    seeds["ft260_version"] = chipSeed(DeviceDecoder::Ft260, {0xA0, 0x02, 0x60, 0x02, 0});
    seeds["ft260_settings"] = chipSeed(DeviceDecoder::Ft260, {0xA1, 1, 1, 0, 1});
    seeds["ft260_status"] = chipSeed(DeviceDecoder::Ft260, {0xC0, 0x20, 0x90, 0x01});
    seeds["ft260_data"] = chipSeed(DeviceDecoder::Ft260, {0xD0, 3, 0xD7, 0x01, 0x02});
    seeds["st_gyro"] =
        seed(DeviceDecoder::StGyro, {0x10, 0x00, 0xF0, 0xFF, 0xFF, 0x7F, 0x00, 0x80, 1, 2, 3, 4});
    seeds["thermometers"] =
        seed(DeviceDecoder::Thermometers, {0x0C, 0x80, 0xC1, 0x90, 0x80, 0x00, 0x1F, 0xFF});
}

const Seeds &allSeeds()
{
    static const Seeds seeds = [] {
        Seeds made;
        addBridgeSeeds(made);
        addChipSeeds(made);
        return made;
    }();
    return seeds;
}

} // namespace

void TestDeviceFuzzCorpus::corpus_files_areWhatTheEncodersGive()
{
    const bool write = qEnvironmentVariableIsSet("DRIFTBENCH_WRITE_CORPUS");
    if (write)
        QVERIFY(QDir().mkpath(corpusFolder()));
    for (auto it = allSeeds().begin(); it != allSeeds().end(); ++it) {
        QFile file(corpusFolder() + "/" + it.key());
        const QByteArray bytes(reinterpret_cast<const char *>(it->data()),
                               static_cast<qsizetype>(it->size()));
        QVERIFY2(file.open(write ? QIODevice::WriteOnly : QIODevice::ReadOnly), qPrintable(it.key()));
        if (write)
            QCOMPARE(file.write(bytes), bytes.size());
        else
            QVERIFY2(file.readAll() == bytes, qPrintable(it.key()));
    }
}

// Those that the fuzzer found worth keeping are replayed with them.
void TestDeviceFuzzCorpus::corpus_everyDecoder_hasASeedThatItTakes()
{
    QMap<int, int> takenBy;
    const QFileInfoList files = QDir(corpusFolder()).entryInfoList(QDir::Files);
    for (const QFileInfo &info : files) {
        QFile file(info.filePath());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(!bytes.isEmpty());
        const Bytes input(bytes.begin(), bytes.end());
        const bool took = decodeUntrusted(input);
        QVERIFY2(took || !allSeeds().contains(info.fileName()), qPrintable(info.fileName()));
        takenBy[input[0]] += took ? 1 : 0;
    }
    for (int decoder = 0; decoder < static_cast<int>(DeviceDecoder::Count); ++decoder)
        QVERIFY2(takenBy.value(decoder) > 0, decoderName(static_cast<DeviceDecoder>(decoder)).data());
}

void TestDeviceFuzzCorpus::decode_changedSeeds_breakNoContract()
{
    Random random = announced(20261321);
    int taken = 0;
    for (int round = 0; round < 1500; ++round) {
        for (const Bytes &original : allSeeds()) {
            Bytes input = original;
            for (std::uint64_t change = random.below(4); change > 0; --change)
                input[1 + random.below(input.size() - 1)] = static_cast<std::uint8_t>(random.bits());
            if (random.below(8) == 0)
                input.resize(1 + random.below(input.size()));
            taken += decodeUntrusted(input) ? 1 : 0;
        }
    }
    // The walk stays near enough to what is valid to reach beyond the first check.
    QVERIFY(taken > 10000);
}

void TestDeviceFuzzCorpus::decode_noise_breaksNoContract()
{
    Random random = announced(20261322);
    int taken = 0;
    for (int round = 0; round < 100000; ++round) {
        Bytes input(random.below(200));
        for (std::uint8_t &byte : input)
            byte = static_cast<std::uint8_t>(random.bits());
        taken += decodeUntrusted(input) ? 1 : 0;
    }
    QVERIFY(taken > 0);
}

QTEST_APPLESS_MAIN(TestDeviceFuzzCorpus)
#include "tst_device_fuzz_corpus.moc"
