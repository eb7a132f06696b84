// The Source page: the simulated bridge streams at its true figures, devices come and go, logs are read in.
#include "support/gui_window.h"

#include "app/gui/source/bridge_list.h"
#include "app/gui/source/source_form.h"
#include "support/test_data.h"
#include "widgets/views/strip_view.h"

#include <QAction>
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QTest>

#include <atomic>

using namespace driftbench;
using namespace driftbench::test;

class TestGuiSource : public QObject
{
    Q_OBJECT

private slots:
    void simulated_chosen_streamsWhatTheFormSays();
    void simulated_used_becomesTheSessions();
    void devices_notPermitted_giveTheirUdevLine();
    void devices_unplugged_leaveTheList();
    void logs_read_becomeRuns();
    void logs_sessionOpenedAgain_noBridgeTakesTheirPlace();
    void logs_damaged_areSaidAndTheOthersRead();
    void survey_ofTheSharedLogs_saysWhatToExpect_data();
    void survey_ofTheSharedLogs_saysWhatToExpect();
};

namespace {

struct SourceWindow : GuiWindow
{
    using GuiWindow::GuiWindow;
    SourcePage &page() { return static_cast<SourcePage &>(*main().page(Step::Source)); }
    bool waitForDevices(int rows)
    {
        return QTest::qWaitFor([&] { return page().bridges().rowCount() == rows; }, 5000);
    }
};

// A log of one heating, small but whole.
std::filesystem::path writeLog(const std::filesystem::path &folder, const std::string &name)
{
    const auto file = folder / name;
    QFile log(QString::fromStdString(file.string()));
    if (!log.open(QIODevice::WriteOnly))
        qFatal("no log");
    log.write("time_s,temperature_C,gyro_x_dps,gyro_y_dps,gyro_z_dps\n");
    for (int i = 0; i < 3000; ++i) {
        const double temperature = -20.0 + 0.02 * i;
        const double noise = 0.01 * ((i * 7919) % 13 - 6);
        log.write(QByteArray::number(0.1 * i) + ',' + QByteArray::number(temperature) + ',' +
                  QByteArray::number(0.01 * temperature + noise) + ',' +
                  QByteArray::number(-0.02 * temperature + noise) + ',' + QByteArray::number(noise) + '\n');
    }
    return file;
}

HidIdentity nativeIdentity()
{
    HidIdentity identity;
    identity.path = "/dev/hidraw3";
    identity.vendorId = 0x1209;
    identity.productId = 0x0001;
    identity.serial = "GB-7";
    return identity;
}

} // namespace

void TestGuiSource::simulated_chosen_streamsWhatTheFormSays()
{
    SourceWindow window;
    QVERIFY(window.waitForDevices(1));
    QTRY_VERIFY_WITH_TIMEOUT(window.page().strips().latest(0).has_value(), 10000);
    // Reference 25, 5, 53 dps under curved drift of a few dps, noise of 0.14; held at -40.
    QVERIFY(std::abs(*window.page().strips().latest(0) - 25.0) < 5.0);
    QVERIFY(std::abs(*window.page().strips().latest(1) - 5.0) < 5.0);
    QVERIFY(std::abs(*window.page().strips().latest(2) - 53.0) < 5.0);
    QVERIFY(std::abs(*window.page().strips().latest(3) + 40.0) < 0.5);
    QTRY_COMPARE_WITH_TIMEOUT(
        window.page().bridges().data(window.page().bridges().index(0), BridgeModel::StateWordRole).toString(),
        QString("Streaming"), 5000);
    QVERIFY(window.bench->isSourceSimulated());
    window.bench->stopSource();
}

void TestGuiSource::simulated_used_becomesTheSessions()
{
    SourceWindow window;
    QVERIFY(window.waitForDevices(1));
    QVERIFY(!window.bench->session().source());
    QTest::keyClick(&window.page(), Qt::Key_Return);
    QCOMPARE(window.main().currentStep(), Step::Plan);
    QVERIFY(window.bench->session().source().has_value());
    const auto *simulated = window.bench->session().source()->as<SimulatedChoice>();
    QVERIFY(simulated);
    QCOMPARE(simulated->sensor, std::string("L3GD20H"));
    QCOMPARE(simulated->drift, std::string("curved"));
    QCOMPARE(window.page().stepState().mark, StepMark::Done);
}

void TestGuiSource::devices_notPermitted_giveTheirUdevLine()
{
    HidAccess access = GuiWindow::noDevices();
    access.list = [] { return std::vector<HidIdentity>{nativeIdentity()}; };
    access.open = [](const HidIdentity &) -> Result<std::unique_ptr<HidTransport>> {
        return Error{Errc::DeviceNotPermitted, "You may not open /dev/hidraw3."};
    };
    SourceWindow window(Settings{}, access);
    QVERIFY(window.waitForDevices(2));
    QVERIFY(window.page().banners().holds("permission"));
    const BannerContent &content = window.page().banners().banner().content();
    const QString line =
        "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"1209\", ATTRS{idProduct}==\"0001\", TAG+=\"uaccess\"";
    QCOMPARE(content.code, line);
    QCOMPARE(content.actions.size(), std::size_t{2});
    content.actions[0]->trigger();
    QCOMPARE(QGuiApplication::clipboard()->text(), line);
    QCOMPARE(
        window.page().bridges().data(window.page().bridges().index(1), BridgeModel::StateWordRole).toString(),
        QString("Not permitted"));
}

void TestGuiSource::devices_unplugged_leaveTheList()
{
    const auto there = std::make_shared<std::atomic<bool>>(true);
    HidAccess access = GuiWindow::noDevices();
    access.list = [there] {
        return *there ? std::vector<HidIdentity>{nativeIdentity()} : std::vector<HidIdentity>();
    };
    SourceWindow window(Settings{}, access);
    QVERIFY(window.waitForDevices(2));
    *there = false;
    window.bench->lookAgain();
    QVERIFY(window.waitForDevices(1));
    QVERIFY(!window.page().banners().holds("permission"));
}

void TestGuiSource::logs_read_becomeRuns()
{
    SourceWindow window;
    const auto first = writeLog(window.folder(), "heating.csv");
    const auto second = writeLog(window.folder(), "again.csv");
    window.main().openFiles({first, second});
    QTRY_COMPARE_WITH_TIMEOUT(window.bench->session().runs().size(), std::size_t{2}, 20000);
    QCOMPARE(window.bench->session().runs()[0].samples, 3000);
    QTRY_COMPARE(window.main().currentStep(), Step::Inspect);
    QCOMPARE(window.bench->settings().recentLogs.size(), 2);
    QVERIFY(!window.bench->session().isSimulated());
}

void TestGuiSource::logs_sessionOpenedAgain_noBridgeTakesTheirPlace()
{
    SourceWindow window;
    QVERIFY(window.waitForDevices(1));
    window.main().openFiles({writeLog(window.folder(), "heating.csv")});
    QTRY_COMPARE_WITH_TIMEOUT(window.bench->session().runs().size(), std::size_t{1}, 20000);
    const auto file = window.folder() / "logs.driftbench";
    QVERIFY(window.bench->saveSessionAs(file).ok());
    QVERIFY(window.bench->newSession().ok());
    for (const Qt::Key step : {Qt::Key_2, Qt::Key_1})
        QTest::keyClick(&window.main(), step, Qt::AltModifier);
    QTRY_VERIFY(window.bench->isSourceSimulated()); // what a new session begins with
    QVERIFY(window.bench->openSession(file).ok());
    QTRY_COMPARE(window.bench->acquisition().state(), Acquisition::State::Idle);
    for (const Qt::Key step : {Qt::Key_2, Qt::Key_1})
        QTest::keyClick(&window.main(), step, Qt::AltModifier);
    QCOMPARE(window.bench->acquisition().state(), Acquisition::State::Idle);
    QVERIFY(!window.bench->session().source());
}

void TestGuiSource::logs_damaged_areSaidAndTheOthersRead()
{
    SourceWindow window;
    const auto good = writeLog(window.folder(), "good.csv");
    const auto bad = window.folder() / "bad.csv";
    QFile file(QString::fromStdString(bad.string()));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("time_s,temperature_C,gyro_x_dps,gyro_y_dps,gyro_z_dps\n0,20,0,0,0\n1,20,twelve,0,0\n");
    file.close();
    window.main().openFiles({bad, good});
    QTRY_COMPARE_WITH_TIMEOUT(window.bench->session().runs().size(), std::size_t{1}, 20000);
    QTRY_VERIFY(window.page().banners().holds("problem"));
    QVERIFY(window.page().banners().banner().content().what.contains("bad.csv"));
    QCOMPARE(window.main().currentStep(), Step::Source);
}

void TestGuiSource::survey_ofTheSharedLogs_saysWhatToExpect_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("format");
    QTest::addColumn<QString>("expect");
    // What data/README.md says of these logs.
    QTest::newRow("chamber") << "climate_chamber/chamber_all.csv"
                             << "CSV"
                             << "x, z: hysteresis";
    QTest::newRow("control") << "no_drift_control/astropi_2015_sensehat.csv"
                             << "CSV"
                             << "No drift found";
    QTest::newRow("heating") << "climate_chamber/run2_heating.csv"
                             << "CSV"
                             << "";
}

void TestGuiSource::survey_ofTheSharedLogs_saysWhatToExpect()
{
    QFETCH(QString, file);
    QFETCH(QString, format);
    QFETCH(QString, expect);
    REQUIRE_SHARED_DATA(path, file.toStdString().c_str());
    const FileSurvey survey = surveyFile(path);
    QCOMPARE(survey.format, format);
    QCOMPARE(survey.origin, Origin::Real);
    QCOMPARE(survey.expect, expect);
}

QTEST_MAIN(TestGuiSource)
#include "tst_gui_source.moc"
