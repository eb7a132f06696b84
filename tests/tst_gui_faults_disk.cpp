// The disk is full in the middle of each step, of a recording, and of whatever is written to a file: it is
// said in one sentence, nothing is half written, nothing that was measured is lost, and the window goes on.
#include "support/fault_vfs.h"
#include "support/fault_window.h"
#include "support/no_room.h"

#include "app/gui/export/file_choices.h"
#include "app/gui/pages/compare_page.h"
#include "app/gui/pages/export_page.h"
#include "app/gui/pages/record_page.h"
#include "app/gui/record/live_run.h"
#include "engine/formats/log_reader.h"
#include "widgets/controls/banner_slot.h"

#include <QFileDialog>
#include <QLineEdit>

using namespace driftbench;
using namespace driftbench::test;

class TestGuiFaultsDisk : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanup() { clearFaults(); }
    void diskFull_onEachStep_isSaidAndSavedLater_data() { addStepRows(); }
    void diskFull_onEachStep_isSaidAndSavedLater();
    void diskFull_sessionSavedElsewhere_hasAllOfIt();
    void diskFull_whileRecording_nothingIsLost();
    void diskFull_toTheEndOfARun_restIsSavedElsewhere();
    void diskFull_forTheReport_leavesNoHalfReport_data();
    void diskFull_forTheReport_leavesNoHalfReport();
    void diskFull_forTheFiles_leavesNone();
    void diskFull_forTheSession_leavesTheOldOne();
};

namespace {

std::filesystem::path newFolder(FaultyWindow &window, const char *name)
{
    const std::filesystem::path folder = window.folder() / name;
    std::filesystem::create_directory(folder);
    return folder;
}

const BannerContent &said(const Page &page)
{
    return page.banners().banner().content();
}

// As the user would, in the dialog that is open.
bool chooseFile(QWidget &window, const std::filesystem::path &file)
{
    auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
    auto *name = dialog != nullptr ? dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit")) : nullptr;
    if (name == nullptr)
        return false;
    name->setText(QString::fromStdString(file.string()));
    QMetaObject::invokeMethod(dialog, "accept");
    window.activateWindow(); // as a window manager does behind a dialog
    return QTest::qWaitFor([] { return QApplication::activeModalWidget() == nullptr; }, kPatienceMs) &&
           QTest::qWaitForWindowActive(&window);
}

// A recording that has begun, into a session on a disk of its own.
class RecordingWindow : public FaultyWindow
{
public:
    RecordingWindow() : FaultyWindow(0), disk(newFolder(*this, "disk"))
    {
        if (!bench->saveSessionAs(disk / "campaign.driftbench"))
            qFatal("not saved");
        main().showStep(Step::Record);
        if (!start())
            qFatal("not recording");
    }

    RecordPage &record() { return page<RecordPage>(Step::Record); }
    bool start()
    {
        record().startRecording();
        return QTest::qWaitFor([this] { return record().run().isRecording() && record().run().hasSamples(); },
                               kPatienceMs);
    }
    bool stop()
    {
        QTest::keyClick(&record(), Qt::Key_Period, Qt::ControlModifier);
        return QTest::qWaitFor([this] { return !bench->acquisition().isRecording(); }, kPatienceMs);
    }
    bool fillDisk()
    {
        injectFault(Fault::DiskFull, 1, true, disk.string());
        return QTest::qWaitFor([this] { return record().banners().holds(QStringLiteral("recorder")); },
                               kPatienceMs);
    }
    // As another program finds the run that is being recorded.
    Result<Recording> onDisk() const
    {
        auto file = SessionFile::open(session().path(), SessionAccess::ReadOnly);
        if (!file)
            return file.error();
        const auto wrong = file->check();
        if (!wrong)
            return wrong.error();
        if (!wrong->empty())
            return Error{Errc::SessionDamaged, wrong->front()};
        return file->readRun(file->runs()->back().id);
    }

    std::filesystem::path disk;
};

} // namespace

void TestGuiFaultsDisk::initTestCase()
{
    registerFaultVfs(true);
}

void TestGuiFaultsDisk::diskFull_onEachStep_isSaidAndSavedLater()
{
    QFETCH(int, step);
    FaultyWindow window(2);
    QVERIFY(window.train());
    window.main().showStep(static_cast<Step>(step));
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    QVERIFY(window.session().isSaved());
    QSignalSpy problems(window.bench.get(), &Workbench::problem);
    injectFault(Fault::DiskFull, 1, true);
    // What each step writes into the session.
    CalibrationPlan plan = window.session().plan();
    switch (static_cast<Step>(step)) {
    case Step::Source:
        (void)window.bench->useSource().ok();
        break;
    case Step::Plan: {
        TestPlan test = shortPlan();
        test.runs = 3;
        (void)window.session().setTestPlan(test).ok();
        break;
    }
    case Step::Inspect:
        plan.runs.front().excluded.push_back({{100.0, 200.0}, "a bump"});
        (void)window.session().editPlan(plan, QStringLiteral("exclude")).ok();
        break;
    case Step::Compare:
        window.page<ComparePage>(Step::Compare).setLimit(0.5);
        break;
    case Step::Export: {
        ExportChoice choice = window.session().exportChoice();
        choice.model = "linear";
        (void)window.session().setExportChoice(choice).ok();
        break;
    }
    default:
        plan.rbf.centres = 7;
        (void)window.session().editPlan(plan, QStringLiteral("take 7 centres")).ok();
        (void)window.bench->train().ok();
        QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    }
    QTRY_VERIFY_WITH_TIMEOUT(!problems.isEmpty(), kPatienceMs);
    QVERIFY(faultHappened());
    QVERIFY(!window.session().isSaved());
    QVERIFY2(window.main().sessionText().contains(QStringLiteral("not saved")),
             qPrintable(window.main().sessionText()));
    QVERIFY(window.events.rowCount() > 0);
    window.expectUsable();
    QTRY_VERIFY_WITH_TIMEOUT(window.idle(), kPatienceMs);
    clearFaults();
    QVERIFY(window.session().saveAgain().ok());
    QVERIFY(window.session().isSaved());
}

// What the disk of the session did not take is in the copy on another one.
void TestGuiFaultsDisk::diskFull_sessionSavedElsewhere_hasAllOfIt()
{
    FaultyWindow window(2);
    const std::filesystem::path full = newFolder(window, "full");
    const std::filesystem::path elsewhere = newFolder(window, "elsewhere") / "campaign.driftbench";
    QVERIFY(window.bench->saveSessionAs(full / "campaign.driftbench").ok());
    injectFault(Fault::DiskFull, 1, true, full.string());
    CalibrationPlan plan = window.session().plan();
    plan.models = {"constant"};
    QVERIFY(!window.session().editPlan(plan, QStringLiteral("models")).ok());
    QVERIFY(!window.session().isSaved());
    QVERIFY(window.bench->saveSessionAs(elsewhere).ok());
    QVERIFY(window.session().isSaved());
    QVERIFY(window.bench->newSession().ok());
    QVERIFY(window.bench->openSession(elsewhere).ok());
    QCOMPARE(window.session().plan().models, std::vector<std::string>{"constant"});
    QCOMPARE(window.session().runs().size(), std::size_t(2));
    window.expectUsable();
}

void TestGuiFaultsDisk::diskFull_whileRecording_nothingIsLost()
{
    RecordingWindow window;
    QVERIFY(window.fillDisk());
    QCOMPARE(said(window.record()).kind, BannerKind::Bad);
    QCOMPARE(said(window.record()).what, QString("The disk takes no more."));
    QVERIFY(!said(window.record()).closable);
    const std::int64_t shown = window.record().run().link().samples;
    QTRY_VERIFY_WITH_TIMEOUT(window.record().run().link().samples > shown + 20, kPatienceMs);
    const auto whole = window.onDisk();
    QVERIFY2(whole.ok(), whole.ok() ? "" : whole.error().message.c_str());
    QVERIFY(whole->size() < window.bench->acquisition().recorderStats()->taken);
    window.expectUsable();
    QVERIFY(window.bench->acquisition().isRecording());
    clearFaults();
    QTRY_COMPARE_WITH_TIMEOUT(said(window.record()).kind, BannerKind::Info, kPatienceMs);
    QVERIFY(said(window.record()).what.contains(QStringLiteral("on the disk again")));
    QVERIFY(window.stop());
    const RunRecord run = window.session().runs().back();
    QCOMPARE(run.state, RunState::Complete);
    QVERIFY(run.samples > shown);
    QCOMPARE(window.onDisk()->size(), run.samples);
}

void TestGuiFaultsDisk::diskFull_toTheEndOfARun_restIsSavedElsewhere()
{
    RecordingWindow window;
    QVERIFY(window.fillDisk());
    const std::int64_t shown = window.record().run().link().samples;
    QTRY_VERIFY_WITH_TIMEOUT(window.record().run().link().samples > shown + 20, kPatienceMs);
    QVERIFY(window.stop());
    QCOMPARE(said(window.record()).what, QString("A part of the run is not on the disk."));
    QCOMPARE(said(window.record()).actions.size(), std::size_t(2));
    const RecorderStats stats = *window.bench->acquisition().recorderStats();
    QVERIFY(stats.queued() > 20);
    QCOMPARE(window.onDisk()->size(), stats.written);
    window.expectUsable();
    // Again, while there is still no room: it is said again, and another run is refused in words.
    said(window.record()).actions[0]->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(said(window.record()).what, QString("A part of the run is not on the disk."),
                              kPatienceMs);
    window.chooseSimulated(20.0);
    QSignalSpy problems(window.bench.get(), &Workbench::problem);
    window.record().startRecording();
    QTRY_VERIFY_WITH_TIMEOUT(!problems.isEmpty(), kPatienceMs);
    QTRY_VERIFY(!window.bench->acquisition().isRecording());
    const std::filesystem::path rest = newFolder(window, "elsewhere") / "rest.csv";
    const auto actions = window.record().findChildren<QAction *>();
    const auto save = std::find_if(actions.begin(), actions.end(), [](const QAction *action) {
        return action->text() == QStringLiteral("Save it elsewhere…");
    });
    QVERIFY(save != actions.end());
    {
        const NoRoom full(100);
        (*save)->trigger();
        QVERIFY(chooseFile(window.main(), rest));
        QTRY_VERIFY_WITH_TIMEOUT(window.record().banners().holds(QStringLiteral("rest")), kPatienceMs);
        QCOMPARE(said(window.record()).kind, BannerKind::Bad);
        QVERIFY(std::filesystem::is_empty(rest.parent_path()));
    }
    said(window.record()).actions.front()->trigger();
    QVERIFY(chooseFile(window.main(), rest));
    QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(rest), kPatienceMs);
    const auto read = readLog(rest, {});
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().message.c_str());
    QCOMPARE(read->size(), stats.queued());
    // And the next run goes to a disk that has room.
    QVERIFY(window.bench->newSession().ok());
    QVERIFY(window.session().setTestPlan(shortPlan()).ok());
    window.chooseSimulated(20.0);
    window.main().showStep(Step::Record);
    QVERIFY(window.start());
    QVERIFY(window.stop());
    QCOMPARE(window.session().runs().back().state, RunState::Complete);
    QCOMPARE(window.onDisk()->size(), window.session().runs().back().samples);
    window.expectUsable();
}

void TestGuiFaultsDisk::diskFull_forTheReport_leavesNoHalfReport_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("html") << "report.html";
    QTest::newRow("pdf") << "report.pdf";
}

void TestGuiFaultsDisk::diskFull_forTheReport_leavesNoHalfReport()
{
    QFETCH(QString, name);
    FaultyWindow window(2);
    QVERIFY(window.train());
    auto &compare = window.page<ComparePage>(Step::Compare);
    window.main().showStep(Step::Compare);
    QTRY_VERIFY_WITH_TIMEOUT(window.session().prepared() != nullptr, kPatienceMs);
    const std::filesystem::path folder = newFolder(window, "reports");
    const std::filesystem::path file = folder / name.toStdString();
    {
        const NoRoom full(1000);
        compare.writeReport(file);
        QTRY_VERIFY_WITH_TIMEOUT(compare.banners().holds(QStringLiteral("report")), kPatienceMs);
    }
    QCOMPARE(said(compare).kind, BannerKind::Bad);
    QCOMPARE(said(compare).what, QString("The report was not written."));
    QVERIFY(!said(compare).toDo.isEmpty());
    QVERIFY(std::filesystem::is_empty(folder));
    window.expectUsable();
    compare.writeReport(file);
    QTRY_COMPARE_WITH_TIMEOUT(said(compare).what, QString("The report is written."), kPatienceMs);
    QVERIFY(std::filesystem::file_size(file) > 1000);
}

// All of them or none, also where the first would have had room.
void TestGuiFaultsDisk::diskFull_forTheFiles_leavesNone()
{
    FaultyWindow window(2);
    QVERIFY(window.train());
    QVERIFY(window.exportLine());
    window.main().showStep(Step::Export);
    auto &exports = window.page<ExportPage>(Step::Export);
    QTRY_VERIFY_WITH_TIMEOUT(exports.preview() && exports.preview()->model == "linear", kPatienceMs);
    std::vector<std::size_t> sizes;
    for (const ExportFormat format : window.session().exportChoice().formats) {
        const FilePreview *file = exports.preview()->file(format);
        if (file != nullptr && !file->refusal)
            sizes.push_back(file->exported.text.size());
    }
    QVERIFY(sizes.size() >= 2);
    const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
    QVERIFY(*least < *most);
    const std::filesystem::path folder = newFolder(window, "tables");
    {
        const NoRoom full((*least + *most) / 2);
        exports.saveFiles(folder);
        QTRY_VERIFY_WITH_TIMEOUT(exports.banners().holds(QStringLiteral("outcome")), kPatienceMs);
    }
    QCOMPARE(said(exports).kind, BannerKind::Bad);
    QCOMPARE(said(exports).what, QString("The files were not written."));
    QVERIFY(!said(exports).toDo.isEmpty());
    QVERIFY(std::filesystem::is_empty(folder));
    QVERIFY(window.session().exports().empty());
    window.expectUsable();
    QTRY_VERIFY_WITH_TIMEOUT(exports.saveAction()->isEnabled(), kPatienceMs);
    exports.saveFiles(folder);
    QTRY_COMPARE_WITH_TIMEOUT(window.session().exports().size(), sizes.size(), kPatienceMs);
}

void TestGuiFaultsDisk::diskFull_forTheSession_leavesTheOldOne()
{
    FaultyWindow window(2);
    const std::filesystem::path folder = newFolder(window, "sessions");
    const std::filesystem::path target = folder / "campaign.driftbench";
    QFile old(QString::fromStdString(target.string()));
    QVERIFY(old.open(QIODevice::WriteOnly));
    old.write("what was there before");
    old.close();
    const std::filesystem::path before = window.session().path();
    const auto saveAs = [&] {
        QTest::keyClick(&window.main(), Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
        auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
        if (dialog != nullptr)
            dialog->setOption(QFileDialog::DontConfirmOverwrite);
        return chooseFile(window.main(), target);
    };
    {
        const NoRoom full(20'000);
        QVERIFY(saveAs());
    }
    const Page &page = *window.main().page(window.main().currentStep());
    QVERIFY(page.banners().holds(QStringLiteral("session")));
    QCOMPARE(said(page).kind, BannerKind::Bad);
    QVERIFY2(said(page).what.contains(QStringLiteral("campaign.driftbench")), qPrintable(said(page).what));
    QCOMPARE(window.session().path(), before);
    QVERIFY(old.open(QIODevice::ReadOnly));
    QCOMPARE(old.readAll(), QByteArray("what was there before"));
    old.close();
    for (const auto &entry : std::filesystem::directory_iterator(folder))
        QCOMPARE(entry.path(), target);
    window.expectUsable();
    window.setModels({"constant"}); // into the file that is still the session's
    QVERIFY(window.session().isSaved());
    QVERIFY(saveAs());
    QCOMPARE(window.session().path(), target);
    QCOMPARE(window.session().runs().size(), std::size_t(2));
}

QTEST_MAIN(TestGuiFaultsDisk)
#include "tst_gui_faults_disk.moc"
