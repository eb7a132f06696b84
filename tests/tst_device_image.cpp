// Table images: what is encoded reads back, and damage gives one sentence.
#include "engine/exports/device_image_layout.h"
#include "support/firmware_device.h"
#include "support/models_for_export.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceImage : public QObject
{
    Q_OBJECT

private slots:
    void decode_encoded_givesTheTableBack();
    void encode_models_fitsBothKinds();
    void encode_unusableTable_isRefused_data();
    void encode_unusableTable_isRefused();
    void decode_damaged_givesOneSentence_data();
    void decode_damaged_givesOneSentence();
    void decode_randomBytes_neverCrashes();
};

void TestDeviceImage::decode_encoded_givesTheTableBack()
{
    Random random = announced(20261221);
    for (int i = 0; i < 60; ++i) {
        const CompensationTable table = randomTable(random, 2 + static_cast<int>(random.below(500)),
                                                    std::pow(10.0, random.uniform(-6.0, 5.0)));
        const auto kind = i % 2 == 0 ? DeviceTableKind::FixedPoint : DeviceTableKind::Float;
        const auto thermometer = i % 3 == 0 ? DeviceThermometer::External : DeviceThermometer::Die;
        const Bytes image = imageOf(table, kind, thermometer);
        const auto read = decodeDeviceImage(image, "bank 0");
        QVERIFY2(read.ok(), read.ok() ? "" : read.error().message.c_str());
        QCOMPARE(read->kind(), kind);
        QCOMPARE(read->thermometer, thermometer);
        QCOMPARE(read->table.firstMilliC, table.firstMilliC);
        QCOMPARE(read->table.lastMilliC, table.lastMilliC);
        QCOMPARE(read->table.compensated, table.compensated);
        QCOMPARE(read->table.provenance.sensor.text(), table.provenance.sensor.text());
        if (kind == DeviceTableKind::Float) {
            QVERIFY(read->table.tdeDps == table.tdeDps.cast<float>().cast<double>());
        } else {
            const FixedPointTable fixed = makeFixedPointTable(table);
            QVERIFY(read->fixed->values == fixed.values);
            QCOMPARE(read->fixed->reciprocal, fixed.reciprocal);
            QCOMPARE(read->fixed->shift, fixed.shift);
            QCOMPARE(read->fixed->fractionBits, fixed.fractionBits);
        }
        // What was read can be written again, to the same bytes where the knots are exact.
        if (kind == DeviceTableKind::Float)
            QCOMPARE(imageOf(read->table, kind, thermometer), image);
    }
}

void TestDeviceImage::encode_models_fitsBothKinds()
{
    Random random = announced(20261222);
    for (int i = 0; i < 4; ++i) {
        const auto table = makeCompensationTable(randomModel(random), {true, i % 2 == 0, true});
        QVERIFY(table.ok());
        for (const DeviceTableKind kind : {DeviceTableKind::FixedPoint, DeviceTableKind::Float}) {
            const Bytes image = imageOf(*table, kind);
            QCOMPARE(image.size(), std::size_t(56 + 12 * table->size()));
            QVERIFY(decodeDeviceImage(image, "image").ok());
        }
    }
}

void TestDeviceImage::encode_unusableTable_isRefused_data()
{
    Random random(5);
    const CompensationTable table = randomTable(random, 4);
    QTest::addColumn<CompensationTable>("table");
    const auto row = [&](const char *name, const auto &change) {
        CompensationTable changed = table;
        change(changed);
        QTest::newRow(name) << changed;
    };
    row("no sensor", [](auto &t) { t.provenance.sensor = {}; });
    row("no serial", [](auto &t) { t.provenance.sensor.serial.clear(); });
    row("model too long", [](auto &t) { t.provenance.sensor.model = "thirteen chars"; });
    row("serial too long", [](auto &t) { t.provenance.sensor.serial = "seventeen letters"; });
    row("serial not ASCII", [](auto &t) { t.provenance.sensor.serial = "1\xC3\xA9"; });
    row("no axis", [](auto &t) {
        t.compensated = {};
        t.tdeDps.setZero();
    });
    row("too large", [](auto &t) { t.tdeDps(1, 0) = 1073741824.0; });
}

void TestDeviceImage::encode_unusableTable_isRefused()
{
    QFETCH(CompensationTable, table);
    const auto image = encodeDeviceImage(table, DeviceTableKind::FixedPoint, DeviceThermometer::Die);
    QVERIFY(!image.ok());
    QCOMPARE(image.error().code, Errc::InvalidOption);
    QVERIFY(image.error().message.ends_with("."));
}

void TestDeviceImage::decode_damaged_givesOneSentence_data()
{
    Random random(6);
    QTest::addColumn<Bytes>("image");
    QTest::addColumn<Errc>("code");
    for (const DeviceTableKind kind : {DeviceTableKind::FixedPoint, DeviceTableKind::Float}) {
        CompensationTable table = randomTable(random, 4);
        table.compensated = {true, true, false};
        table.tdeDps.col(2).setZero();
        const Bytes image = imageOf(table, kind);
        const QByteArray prefix = kind == DeviceTableKind::Float ? "float: " : "fixed: ";
        const auto row = [&](const char *name, std::size_t at, std::uint8_t value,
                             Errc code = Errc::ModelDamaged) {
            Bytes changed = image;
            changed.at(at) = value;
            QTest::newRow((prefix + name).constData()) << changed << code;
        };
        row("magic", BRIDGE_TABLE_MAGIC, 0);
        row("version 0", BRIDGE_TABLE_VERSION, 0);
        row("newer", BRIDGE_TABLE_VERSION, 2, Errc::ModelTooNew);
        row("kind", BRIDGE_TABLE_KIND, 3);
        row("no axes", BRIDGE_TABLE_AXES, 0);
        row("axes", BRIDGE_TABLE_AXES, 8);
        row("thermometer", BRIDGE_TABLE_THERMOMETER, 2);
        row("last below first", BRIDGE_TABLE_LAST + 3, 0x80);
        row("knots", BRIDGE_TABLE_KNOTS, 3);
        row("far too many knots", BRIDGE_TABLE_KNOTS + 3, 0x7F);
        row("reciprocal", BRIDGE_TABLE_RECIPROCAL, static_cast<std::uint8_t>(image[48] + 1));
        row("shift", BRIDGE_TABLE_SHIFT, 50);
        row("fraction", BRIDGE_TABLE_FRACTION, 31);
        row("value beyond the limit", BRIDGE_TABLE_VALUES + 3, 0x7F);
        row("value on an axis that is not compensated", BRIDGE_TABLE_VALUES + 8, 1);
        QTest::newRow((prefix + "empty").constData()) << Bytes() << Errc::ModelDamaged;
        QTest::newRow((prefix + "cut").constData())
            << Bytes(image.begin(), image.end() - 1) << Errc::ModelDamaged;
        QTest::newRow((prefix + "cut in the header").constData())
            << Bytes(image.begin(), image.begin() + 55) << Errc::ModelDamaged;
    }
}

void TestDeviceImage::decode_damaged_givesOneSentence()
{
    QFETCH(Bytes, image);
    QFETCH(Errc, code);
    const auto read = decodeDeviceImage(image, "bank 1");
    QVERIFY(!read.ok());
    QCOMPARE(read.error().code, code);
    const QString message = QString::fromStdString(read.error().message);
    QVERIFY2(message.startsWith("bank 1 ") && message.endsWith('.') && message.count(". ") == 0,
             qPrintable(message));
}

void TestDeviceImage::decode_randomBytes_neverCrashes()
{
    Random random = announced(20261223);
    for (int i = 0; i < 100000; ++i) {
        Bytes bytes(random.below(200));
        for (std::uint8_t &byte : bytes)
            byte = static_cast<std::uint8_t>(random.bits());
        if (bytes.size() >= BRIDGE_TABLE_VALUES && random.below(2) == 0) {
            bridge_put_u32(bytes.data(), BRIDGE_TABLE_MAGIC_VALUE);
            bytes[BRIDGE_TABLE_VERSION] = 1;
            bytes[BRIDGE_TABLE_KIND] = static_cast<std::uint8_t>(random.below(3));
            bridge_put_u32(bytes.data() + BRIDGE_TABLE_KNOTS,
                           static_cast<std::uint32_t>((bytes.size() - 56) / 12));
        }
        QVERIFY(!decodeDeviceImage(bytes, "bytes").ok());
    }
}

QTEST_APPLESS_MAIN(TestDeviceImage)
#include "tst_device_image.moc"
