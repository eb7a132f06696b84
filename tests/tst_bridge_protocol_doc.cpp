// docs/bridge-protocol.md says what the headers and the reference firmware do: every constant of its tables,
// the order of the fields, the report descriptor and each byte of its worked example.
#include "support/firmware_device.h"
#include "support/test_data.h"

#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestBridgeProtocolDoc : public QObject
{
    Q_OBJECT

private slots:
    void constants_ofHeaders_areAllInTheDocument();
    void constants_ofDocument_areAllInTheHeaders();
    void byteTables_fields_followEachOther();
    void descriptor_inDocument_isThatOfTheHeader();
    void checkValue_inDocument_isThatOfTheChecksum();
    void example_inDocument_isWhatTheFirmwareDoes();
};

namespace {

QString contentOf(const QString &path)
{
    QFile file(driftbench::test::sourceFolder() + "/" + path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString document()
{
    return contentOf("docs/bridge-protocol.md");
}

// Constants with a number; the pieces of the descriptor macro are compared as bytes.
QMap<QString, qlonglong> headerConstants()
{
    static const QRegularExpression define(R"(^#define (BRIDGE_\w+) (0x[0-9A-Fa-f]+|\d+)u?\b)",
                                           QRegularExpression::MultilineOption);
    QMap<QString, qlonglong> constants;
    for (const char *path : {"engine/exports/device_image_layout.h", "device/bridge/bridge_protocol.h",
                             "device/firmware/bridge_bank.h", "device/firmware/bridge_flash.h"}) {
        auto matches = define.globalMatch(contentOf(path));
        while (matches.hasNext()) {
            const auto match = matches.next();
            if (!match.captured(1).startsWith("BRIDGE_DESCRIPTOR_"))
                constants[match.captured(1)] = match.captured(2).toLongLong(nullptr, 0);
        }
    }
    return constants;
}

struct Row
{
    qlonglong number;
    QString type; // of a byte table
    QString constant;
    bool inByteTable;
    int table; // rows of one table share it
};

QList<Row> documentRows()
{
    static const QRegularExpression row(R"(^\| (0x[0-9A-Fa-f]+|\d+) \|(?: ([^|`]+) \|)? `(BRIDGE_\w+)` \|)");
    QList<Row> rows;
    int table = 0;
    bool bytes = false;
    for (const QString &line : document().split('\n')) {
        if (!line.startsWith('|')) {
            ++table;
            bytes = false;
        }
        if (line.startsWith("| byte |"))
            bytes = true;
        const auto match = row.match(line);
        if (match.hasMatch())
            rows.append({match.captured(1).toLongLong(nullptr, 0), match.captured(2), match.captured(3),
                         bytes, table});
    }
    return rows;
}

// 0: as long as the table image is.
qlonglong sizeOf(const QString &type)
{
    static const QMap<QString, qlonglong> sizes{{"u8", 1}, {"u16", 2}, {"u32", 4}, {"i32", 4}};
    if (sizes.contains(type))
        return sizes[type];
    static const QRegularExpression bytes(R"(^(\d+) bytes$)");
    const auto match = bytes.match(type);
    return match.hasMatch() ? match.captured(1).toLongLong() : 0;
}

// Lines of hexadecimal bytes behind a name; lines that begin with blanks go on.
QMap<QString, QList<QByteArray>> hexBlocks()
{
    static const QRegularExpression line(R"(^(\w[\w ]*?|) +((?:[0-9a-f]{2}(?: +|$))+)$)");
    QMap<QString, QList<QByteArray>> blocks;
    QString name;
    for (const QString &text : document().split('\n')) {
        const auto match = line.match(text);
        if (!match.hasMatch())
            continue;
        if (!match.captured(1).isEmpty()) {
            name = match.captured(1);
            blocks[name].append(QByteArray());
        }
        blocks[name].last() += QByteArray::fromHex(match.captured(2).toLatin1());
    }
    return blocks;
}

// As the document shows a report: 16 bytes a line, without the zeros at the end.
QString shown(const QString &name, const Report &report)
{
    std::size_t count = report.size();
    while (count > 1 && report[count - 1] == 0)
        --count;
    QString text;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % 16 == 0)
            text +=
                (i == 0 ? QString() : QStringLiteral("\n")) + (i == 0 ? name : QString()).leftJustified(13);
        text += QStringLiteral("%1%2").arg(i % 16 == 0 ? "" : " ").arg(report[i], 2, 16, QLatin1Char('0'));
    }
    return text + "\n";
}

Bytes exampleImage()
{
    CompensationTable table;
    table.firstMilliC = -10000;
    table.lastMilliC = 40000;
    table.compensated = {true, true, false};
    table.provenance.sensor = {"L3GD20H", "SIM-0001"};
    table.tdeDps.resize(2, 3);
    table.tdeDps << 0.5, -0.25, 0.0, 1.0, 0.75, 0.0;
    return imageOf(table, DeviceTableKind::FixedPoint);
}

void sampleTwice(FirmwareDevice &firmware)
{
    bridge_sample sample{1000000, {1000, -2000, 300}, true, false, 15000, 0};
    bridge_device_sample(&firmware.device, &sample);
    sample = {1001000, {1001, -2001, 299}, true, false, 15001, 0};
    bridge_device_sample(&firmware.device, &sample);
}

} // namespace

void TestBridgeProtocolDoc::constants_ofHeaders_areAllInTheDocument()
{
    const auto constants = headerConstants();
    QVERIFY(constants.size() > 120);
    QMap<QString, int> seen;
    for (const Row &row : documentRows())
        ++seen[row.constant];
    for (auto it = constants.begin(); it != constants.end(); ++it)
        QVERIFY2(seen.value(it.key()) == 1, qPrintable(it.key()));
}

void TestBridgeProtocolDoc::constants_ofDocument_areAllInTheHeaders()
{
    const auto constants = headerConstants();
    for (const Row &row : documentRows()) {
        QVERIFY2(constants.contains(row.constant), qPrintable(row.constant));
        QVERIFY2(constants[row.constant] == row.number, qPrintable(row.constant));
    }
}

void TestBridgeProtocolDoc::byteTables_fields_followEachOther()
{
    const QList<Row> rows = documentRows();
    int compared = 0;
    for (qsizetype i = 0; i < rows.size(); ++i) {
        if (!rows[i].inByteTable)
            continue;
        const QString prefix = rows[i].constant.section('_', 0, 1);
        const qlonglong end = rows[i].number + sizeOf(rows[i].type);
        const bool ofReport = prefix != "BRIDGE_TABLE" && prefix != "BRIDGE_BANK";
        QVERIFY2(!ofReport || (end > rows[i].number && end <= BRIDGE_REPORT_SIZE),
                 qPrintable(rows[i].constant));
        if (i + 1 < rows.size() && rows[i + 1].table == rows[i].table &&
            rows[i + 1].constant.section('_', 0, 1) == prefix) {
            ++compared;
            // A byte or two may be left out so that what follows is aligned.
            const qlonglong gap = rows[i + 1].number - end;
            QVERIFY2(gap >= 0 && gap <= 2, qPrintable(rows[i + 1].constant));
        }
    }
    QVERIFY(compared > 40);
}

void TestBridgeProtocolDoc::descriptor_inDocument_isThatOfTheHeader()
{
    static const std::uint8_t descriptor[] = BRIDGE_REPORT_DESCRIPTOR;
    const auto blocks = hexBlocks();
    QVERIFY(blocks.contains("descriptor"));
    QCOMPARE(blocks["descriptor"].first(),
             QByteArray(reinterpret_cast<const char *>(descriptor), sizeof descriptor));
}

void TestBridgeProtocolDoc::checkValue_inDocument_isThatOfTheChecksum()
{
    const std::string digits = "123456789";
    const std::uint32_t crc =
        deviceImageCrc({reinterpret_cast<const std::uint8_t *>(digits.data()), digits.size()});
    const QString text = "`123456789` is 0x" + QString::number(crc, 16).toUpper();
    QVERIFY(document().contains(text));
}

void TestBridgeProtocolDoc::example_inDocument_isWhatTheFirmwareDoes()
{
    RamFlash flash(4096);
    FirmwareDevice firmware(flash);
    const Bytes image = exampleImage();
    QString expected = shown("get info", firmware.get(BRIDGE_REPORT_INFO));
    static const QMap<int, QString> names{{BRIDGE_REPORT_BEGIN, "set begin"},
                                          {BRIDGE_REPORT_CHUNK, "set chunk"},
                                          {BRIDGE_REPORT_VERIFY, "set verify"},
                                          {BRIDGE_REPORT_COMMIT, "set commit"}};
    for (const Report &report : uploadReports(image, 0x1234)) {
        QCOMPARE(firmware.set(report), std::uint8_t(BRIDGE_RESULT_OK));
        expected += shown(names[report[0]], report);
    }
    expected += shown("get status", firmware.get(BRIDGE_REPORT_STATUS));
    const Report activate = generationReport(BRIDGE_REPORT_ACTIVATE, 1);
    QCOMPARE(firmware.set(activate), std::uint8_t(BRIDGE_RESULT_OK));
    expected += shown("set activate", activate);
    expected += shown("get status", firmware.get(BRIDGE_REPORT_STATUS));
    QCOMPARE(firmware.configure(true, true), std::uint8_t(BRIDGE_RESULT_OK));
    expected += shown("set config", firmware.get(BRIDGE_REPORT_CONFIG));
    sampleTwice(firmware);
    QCOMPARE(firmware.configure(false, true), std::uint8_t(BRIDGE_RESULT_OK));
    Report samples;
    QVERIFY(bridge_device_take(&firmware.device, samples.data()));
    expected += shown("input", samples);
    const bool asShown = document().contains("```\n" + expected + "```");
    for (const QString &line : expected.split('\n')) {
        if (!asShown)
            qWarning("%s", qPrintable(line));
    }
    QVERIFY2(asShown, "the example in docs/bridge-protocol.md should read as above");
}

QTEST_APPLESS_MAIN(TestBridgeProtocolDoc)
#include "tst_bridge_protocol_doc.moc"
