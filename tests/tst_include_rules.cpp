// Who may include whom: app -> {widgets, device} -> engine; widgets and device never meet; the engine knows
// neither Qt nor hidapi, and inside it a folder includes only itself and the folders above it in data order.
#include "support/test_data.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

class TestIncludeRules : public QObject
{
    Q_OBJECT

private slots:
    void includes_everyFile_followTheRules_data();
    void includes_everyFile_followTheRules();
    void rules_knownOffence_isFound();
};

namespace {

const QStringList kEngineOrder{"base",   "recording",  "formats",      "physics", "features",
                               "models", "evaluation", "compensation", "exports"};

// Why a file of this folder ("engine/models", "widgets/...") must not include that header; empty: it may.
QString offence(const QString &file, const QString &included)
{
    const QString room = file.section('/', 0, 0);
    const QString target = included.section('/', 0, 0);
    if (room == "engine") {
        if (target == "widgets" || target == "device" || target == "app")
            return "the engine includes only itself";
        static const QRegularExpression foreign("^(Q[A-Z].*|Qt.*|hidapi.*|qcustomplot.*|CLI.*)");
        if (foreign.match(included).hasMatch())
            return "the engine knows neither Qt nor hidapi nor the command line";
        if (target == "engine" &&
            kEngineOrder.indexOf(included.section('/', 1, 1)) > kEngineOrder.indexOf(file.section('/', 1, 1)))
            return "an engine folder includes only those above it in data order";
    }
    if (room == "widgets" && (target == "device" || target == "app"))
        return "widgets use the engine only";
    if (room == "device") {
        if (target == "widgets" || target == "app")
            return "device uses the engine only";
        if (included.startsWith("hidapi") && !file.endsWith("/hidapi_transport.cpp"))
            return "only hidapi_transport.cpp includes hidapi.h";
        static const QRegularExpression foreign("^(Q[A-Z].*|Qt.*|qcustomplot.*|CLI.*)");
        if (foreign.match(included).hasMatch())
            return "device knows neither Qt nor the command line";
    }
    if (file.startsWith("device/firmware/")) {
        static const QRegularExpression core("^(std(bool|int)\\.h|device/firmware/bridge_\\w+\\.h|"
                                             "device/bridge/bridge_protocol\\.h|"
                                             "engine/exports/device_image_layout\\.h)$");
        static const QRegularExpression board("^(stddef\\.h|semihosting\\.h)$");
        if (!core.match(included).hasMatch() &&
            !(file.startsWith("device/firmware/cortex_m/") && board.match(included).hasMatch()))
            return "the firmware core is copied with itself and two headers, and has no library";
    }
    if (file.startsWith("app/cli") && (target == "widgets" || included.startsWith("app/gui")))
        return "the command line links neither widgets nor gui";
    return {};
}

} // namespace

void TestIncludeRules::includes_everyFile_followTheRules_data()
{
    QTest::addColumn<QString>("room");
    const QDir root(driftbench::test::sourceFolder());
    for (const char *room : {"engine", "widgets", "device", "app"}) {
        if (root.exists(room))
            QTest::newRow(room) << QString(room);
    }
}

void TestIncludeRules::includes_everyFile_followTheRules()
{
    QFETCH(QString, room);
    static const QRegularExpression include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])",
                                            QRegularExpression::MultilineOption);
    const QDir root(driftbench::test::sourceFolder());
    QDirIterator files(root.filePath(room), {"*.h", "*.cpp", "*.c"}, QDir::Files,
                       QDirIterator::Subdirectories);
    int seen = 0;
    QStringList offences;
    while (files.hasNext()) {
        QFile file(files.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString name = root.relativeFilePath(file.fileName());
        auto matches = include.globalMatch(QString::fromUtf8(file.readAll()));
        while (matches.hasNext()) {
            const QString included = matches.next().captured(1);
            ++seen;
            const QString why = offence(name, included);
            if (!why.isEmpty())
                offences << name + " includes " + included + ": " + why;
        }
    }
    QVERIFY(seen > 0);
    QVERIFY2(offences.isEmpty(), qPrintable(offences.join('\n')));
}

void TestIncludeRules::rules_knownOffence_isFound()
{
    QVERIFY(!offence("engine/base/x.h", "engine/models/y.h").isEmpty());
    QVERIFY(offence("engine/models/x.h", "engine/base/y.h").isEmpty());
    QVERIFY(!offence("engine/models/x.h", "QString").isEmpty());
    QVERIFY(!offence("widgets/x.h", "device/y.h").isEmpty());
    QVERIFY(!offence("device/x.cpp", "hidapi/hidapi.h").isEmpty());
    QVERIFY(offence("device/hidapi_transport.cpp", "hidapi/hidapi.h").isEmpty());
    QVERIFY(!offence("device/bridge/x.h", "QObject").isEmpty());
    QVERIFY(!offence("device/x.cpp", "app/y.h").isEmpty());
    QVERIFY(!offence("engine/base/x.h", "device/y.h").isEmpty());
    QVERIFY(!offence("device/firmware/x.c", "string.h").isEmpty());
    QVERIFY(!offence("device/firmware/x.c", "engine/exports/device_image.h").isEmpty());
    QVERIFY(offence("device/firmware/x.c", "engine/exports/device_image_layout.h").isEmpty());
    QVERIFY(!offence("app/cli/x.cpp", "widgets/y.h").isEmpty());
}

QTEST_APPLESS_MAIN(TestIncludeRules)
#include "tst_include_rules.moc"
