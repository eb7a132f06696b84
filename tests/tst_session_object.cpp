// The session: one value a stage, dropped and signalled as its header says, and the same after it was opened
// again.
#include "app/session/session.h"
#include "engine/models/model_file.h"
#include "support/session_runs.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestSessionObject : public QObject
{
    Q_OBJECT

private slots:
    void create_newSession_isEmptyAndNamed();
    void createUnnamed_withoutRuns_leavesNothing();
    void createUnnamed_withRuns_isFoundAgainUntilNamed();
    void saveAs_namedSession_goesOnInTheCopy();
    void editPlan_change_isOneSignalAndSaved();
    void editPlan_nothingChanged_isNoSignal();
    void editPlan_withResult_dropsWhatIsComputed();
    void undo_afterReopening_hasNoSteps();
    void refreshRuns_newRun_takesPartAndDropsTheResult();
    void removeRun_ofThree_planFollows();
    void recording_askedTwice_isTheSameObject();
    void setPrepared_ofAnotherPlan_isNotTaken();
    void setResult_reopened_isTheSame();
    void stages_reopened_areTheSame();
    void open_whileOpen_isReadOnlyAndRefusesEdits();
    void open_damagedDocument_keepsTheRuns();
    void setResult_afterAnEdit_isNotTaken();
    void refreshRuns_nothingNew_keepsTheResult();
    void events_haveTimeAndSeverity();
};

namespace {

struct Counter : QObject
{
    explicit Counter(Session &session)
    {
        const auto note = [this](const char *name) { return [this, name] { order << name; }; };
        connect(&session, &Session::sourceChanged, this, note("source"));
        connect(&session, &Session::testPlanChanged, this, note("testPlan"));
        connect(&session, &Session::runsChanged, this, note("runs"));
        connect(&session, &Session::planChanged, this, note("plan"));
        connect(&session, &Session::preparedChanged, this, note("prepared"));
        connect(&session, &Session::resultChanged, this, note("result"));
        connect(&session, &Session::exportChoiceChanged, this, note("choice"));
    }

    QStringList take() { return std::exchange(order, {}); }

    QStringList order;
};

std::unique_ptr<Session> newSession(const QTemporaryDir &folder, int runs = 0)
{
    auto session = Session::create(folder.filePath("s.driftbench").toStdString());
    if (!session)
        qFatal("%s", session.error().message.c_str());
    if (runs > 0)
        addRuns(**session, runs);
    return *std::move(session);
}

std::unique_ptr<Session> opened(const std::filesystem::path &path)
{
    auto session = Session::open(path);
    if (!session)
        qFatal("%s", session.error().message.c_str());
    return *std::move(session);
}

// Trains what is quick.
std::shared_ptr<const CalibrationResult> trainedOn(Session &session)
{
    CalibrationPlan plan = session.plan();
    plan.models = {"constant", "linear", "cubic"};
    if (!session.editPlan(plan, "models"))
        qFatal("edit");
    const auto runs = loadRuns(session.file(), session.plan(), {});
    const auto prepared = prepareCampaign(session.plan(), *runs);
    if (!prepared || prepared->refusal)
        qFatal("%s", prepared ? prepared->refusal->message.c_str() : prepared.error().message.c_str());
    if (!session.setPrepared(std::make_shared<const PreparedCampaign>(*prepared)))
        qFatal("prepared by another plan");
    auto result = calibrate(*prepared);
    if (!result)
        qFatal("%s", result.error().message.c_str());
    auto shared = std::make_shared<const CalibrationResult>(*std::move(result));
    if (!session.setResult(shared))
        qFatal("result");
    return shared;
}

} // namespace

void TestSessionObject::create_newSession_isEmptyAndNamed()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder);
    QCOMPARE(session->name(), QString("s"));
    QVERIFY(!session->isUnnamed());
    QVERIFY(!session->isReadOnly());
    QVERIFY(session->isSaved());
    QVERIFY(session->runs().empty());
    QVERIFY(!session->source() && !session->testPlan() && !session->prepared() && !session->result());
    QVERIFY(!session->chosenModel());
}

void TestSessionObject::createUnnamed_withoutRuns_leavesNothing()
{
    const QTemporaryDir folder;
    const std::filesystem::path place = folder.filePath("app/data").toStdString();
    {
        auto session = Session::createUnnamed(place);
        QVERIFY(session);
        QVERIFY((*session)->isUnnamed());
        QVERIFY(!std::filesystem::is_empty(place));
    }
    QVERIFY(std::filesystem::is_empty(place));
}

void TestSessionObject::createUnnamed_withRuns_isFoundAgainUntilNamed()
{
    const QTemporaryDir folder;
    const std::filesystem::path place = folder.filePath("data").toStdString();
    std::filesystem::path path;
    {
        auto session = Session::createUnnamed(place);
        QVERIFY(session);
        addRuns(**session, 1);
        path = (*session)->path();
        QVERIFY2(Session::unnamedSessions(place).empty(), "it is in use");
    }
    const auto found = Session::unnamedSessions(place);
    QCOMPARE(found.size(), std::size_t(1));
    QCOMPARE(found.front().filename(), path.filename());
    auto session = opened(found.front());
    QVERIFY(session->isUnnamed());
    QSignalSpy named(session.get(), &Session::nameChanged);
    const std::filesystem::path target = folder.filePath("gyro 7.driftbench").toStdString();
    QVERIFY(session->saveAs(target));
    QCOMPARE(named.count(), 1);
    QCOMPARE(session->name(), QString("gyro 7"));
    QCOMPARE(session->runs().size(), std::size_t(1));
    session.reset();
    QVERIFY(Session::unnamedSessions(place).empty());
    QVERIFY(!std::filesystem::exists(path));
    QVERIFY(!opened(target)->isUnnamed());
}

void TestSessionObject::saveAs_namedSession_goesOnInTheCopy()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 1);
    const std::filesystem::path before = session->path();
    const std::filesystem::path target = folder.filePath("t.driftbench").toStdString();
    QVERIFY(!session->saveAs(before));
    QVERIFY(session->saveAs(target));
    QVERIFY(session->renameRun(session->runs()[0].id, "renamed"));
    QCOMPARE(opened(before)->runs()[0].description.name, std::string("run 1"));
    QCOMPARE(session->runs()[0].description.name, std::string("renamed"));
}

void TestSessionObject::editPlan_change_isOneSignalAndSaved()
{
    const QTemporaryDir folder;
    auto session = newSession(folder, 2);
    Counter counter(*session);
    CalibrationPlan plan = session->plan();
    plan.runs[1].excluded.push_back({{10.0, 22.5}, "door"});
    plan.runs[0].referenceRateDps = {1.0, 2.0, 3.0};
    plan.limitRmsDps = 0.2;
    QVERIFY(session->editPlan(plan, "exclude 12.5 s of run 2"));
    QCOMPARE(counter.take(), QStringList{"plan"});
    QCOMPARE(session->history().undoText(), QString("exclude 12.5 s of run 2"));
    const CalibrationPlan kept = session->plan();
    const auto path = session->path();
    session.reset();
    QVERIFY(opened(path)->plan() == kept);
}

void TestSessionObject::editPlan_nothingChanged_isNoSignal()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 1);
    Counter counter(*session);
    QVERIFY(session->editPlan(session->plan(), "nothing"));
    QVERIFY(session->undo());
    QVERIFY(session->redo());
    QVERIFY(counter.take().isEmpty());
}

void TestSessionObject::editPlan_withResult_dropsWhatIsComputed()
{
    const QTemporaryDir folder;
    auto session = newSession(folder, 3);
    trainedOn(*session);
    QVERIFY(session->chosenModel());
    QVERIFY(session->modelId("linear"));
    Counter counter(*session);
    CalibrationPlan plan = session->plan();
    plan.runs[2].takesPart = false;
    QVERIFY(session->editPlan(plan, "leave out run 3"));
    QCOMPARE(counter.take(), (QStringList{"plan", "prepared", "result"}));
    QVERIFY(!session->prepared() && !session->result() && !session->chosenModel() &&
            !session->modelId("linear"));
    QVERIFY(session->undo());
    QCOMPARE(counter.take(), QStringList{"plan"});
    const auto path = session->path();
    session.reset();
    QVERIFY2(!opened(path)->result(), "a result of another plan is not shown again");
}

void TestSessionObject::undo_afterReopening_hasNoSteps()
{
    const QTemporaryDir folder;
    auto session = newSession(folder, 1);
    CalibrationPlan plan = session->plan();
    plan.seed = 5;
    QVERIFY(session->editPlan(plan, "seed"));
    QVERIFY(session->history().canUndo());
    const auto path = session->path();
    session.reset();
    session = opened(path);
    QCOMPARE(session->plan().seed, 5u);
    QVERIFY(!session->history().canUndo());
}

void TestSessionObject::refreshRuns_newRun_takesPartAndDropsTheResult()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 2);
    trainedOn(*session);
    Counter counter(*session);
    addRuns(*session, 1);
    QCOMPARE(counter.take(), (QStringList{"runs", "plan", "prepared", "result"}));
    QCOMPARE(session->runs().size(), std::size_t(3));
    QCOMPARE(session->plan().runs.size(), std::size_t(3));
    QVERIFY(session->plan().runs[2].takesPart);
    QCOMPARE(session->plan().models.size(), std::size_t(3));
    QCOMPARE(session->sensor().model, std::string("L3GD20H"));
    QVERIFY(session->isSimulated());
}

void TestSessionObject::removeRun_ofThree_planFollows()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 3);
    const RunId second = session->runs()[1].id;
    CalibrationPlan plan = session->plan();
    plan.holdOut = {second};
    QVERIFY(session->editPlan(plan, "hold out run 2"));
    QVERIFY(session->removeRun(second));
    QCOMPARE(session->plan().runs.size(), std::size_t(2));
    QVERIFY(session->plan().holdOut.empty());
    QVERIFY(!session->run(second));
    QCOMPARE(session->removeRun(second).error().code, Errc::NoSuchRun);
}

void TestSessionObject::recording_askedTwice_isTheSameObject()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 1);
    const auto first = session->recording(session->runs()[0].id);
    const auto second = session->recording(session->runs()[0].id);
    QVERIFY(first && second);
    QCOMPARE(first->get(), second->get());
    QVERIFY(sameBits(**first, shortRun(0)));
    QCOMPARE(session->recording(99).error().code, Errc::NoSuchRun);
}

void TestSessionObject::setPrepared_ofAnotherPlan_isNotTaken()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 2);
    const auto runs = loadRuns(session->file(), session->plan(), {});
    QVERIFY(runs);
    const auto prepared = prepareCampaign(session->plan(), *runs);
    QVERIFY(prepared);
    CalibrationPlan plan = session->plan();
    plan.seed += 1;
    QVERIFY(session->editPlan(plan, "seed"));
    Counter counter(*session);
    QVERIFY(!session->setPrepared(std::make_shared<const PreparedCampaign>(*prepared)));
    QVERIFY(counter.take().isEmpty());
    QVERIFY(session->undo());
    QVERIFY(session->setPrepared(std::make_shared<const PreparedCampaign>(*prepared)));
    QCOMPARE(counter.take(), (QStringList{"plan", "prepared"}));
}

void TestSessionObject::setResult_reopened_isTheSame()
{
    const QTemporaryDir folder;
    auto session = newSession(folder, 3);
    const auto result = trainedOn(*session);
    const auto path = session->path();
    session.reset();
    session = opened(path);
    QVERIFY(session->result());
    const CalibrationResult &back = *session->result();
    QCOMPARE(back.comparisonJson, result->comparisonJson);
    QCOMPARE(back.figures.rows.size(), result->figures.rows.size());
    QVERIFY(!back.figures.rows.empty());
    for (std::size_t i = 0; i < back.figures.rows.size(); ++i) {
        QCOMPARE(back.figures.rows[i].msdAfter, result->figures.rows[i].msdAfter);
        QCOMPARE(back.figures.rows[i].rmsDps, result->figures.rows[i].rmsDps);
    }
    QCOMPARE(back.models.size(), result->models.size());
    for (std::size_t i = 0; i < back.models.size(); ++i)
        QCOMPARE(modelToJson(back.models[i]), modelToJson(result->models[i]));
    QCOMPARE(back.heldOut.size(), std::size_t(3));
    for (std::size_t fold = 0; fold < back.heldOut.size(); ++fold) {
        QCOMPARE(back.heldOut[fold].fold, result->heldOut[fold].fold);
        for (std::size_t i = 0; i < back.heldOut[fold].models.size(); ++i)
            QCOMPARE(modelToJson(back.heldOut[fold].models[i]), modelToJson(result->heldOut[fold].models[i]));
    }
    QVERIFY(back.heldOutModel("run 2", "cubic"));
    QCOMPARE(back.trainingS, result->trainingS);
    QVERIFY(session->modelId("auto"));
    QVERIFY(session->chosenModel());
}

void TestSessionObject::stages_reopened_areTheSame()
{
    const QTemporaryDir folder;
    auto session = newSession(folder, 1);
    Counter counter(*session);
    const auto source = parseSourceChoice("hid:SIM-0001");
    QVERIFY(session->setSource(*source));
    TestPlan plan = *makeTestPlan(*namedSensor("L3GD20H"), *namedChamber("SET-Z-021"));
    plan.runs = 3;
    QVERIFY(session->setTestPlan(plan));
    ExportChoice choice;
    choice.model = "linear";
    QVERIFY(session->setExportChoice(choice));
    QCOMPARE(counter.take(), (QStringList{"source", "testPlan", "choice"}));
    QVERIFY2(session->run(session->runs()[0].id), "what was measured is kept");
    ExportRecord made;
    made.format = "csv";
    made.path = "table.csv";
    QVERIFY(session->addExport(made));
    UploadRecord upload;
    upload.device = "native bridge SIM-0001";
    upload.verified = true;
    QVERIFY(session->addUpload(upload));
    QVERIFY(session->addNote("chamber 2", session->runs()[0].id));
    const auto path = session->path();
    session.reset();
    session = opened(path);
    QCOMPARE(sourceChoiceText(*session->source()), std::string("hid:SIM-0001"));
    QCOMPARE(session->testPlan()->runs, 3);
    QCOMPARE(session->exportChoice().model, std::string("linear"));
    QCOMPARE(session->exports().size(), std::size_t(1));
    QVERIFY(!session->exports()[0].utc.empty());
    QVERIFY(session->uploads()[0].verified);
    QCOMPARE(session->notes()[0].text, std::string("chamber 2"));
}

void TestSessionObject::open_whileOpen_isReadOnlyAndRefusesEdits()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 1);
    const auto second = opened(session->path());
    QVERIFY(second->isReadOnly());
    QVERIFY(!second->readOnlyReason().isEmpty());
    QCOMPARE(second->runs().size(), std::size_t(1));
    CalibrationPlan plan = second->plan();
    plan.seed += 1;
    Counter counter(*second);
    QCOMPARE(second->editPlan(plan, "seed").error().code, Errc::SessionReadOnly);
    QCOMPARE(second->setTestPlan({}).error().code, Errc::SessionReadOnly);
    QCOMPARE(second->removeRun(second->runs()[0].id).error().code, Errc::SessionReadOnly);
    QCOMPARE(second->addExport({}).error().code, Errc::SessionReadOnly);
    QVERIFY(counter.take().isEmpty());
    QVERIFY(second->recording(second->runs()[0].id));
}

void TestSessionObject::open_damagedDocument_keepsTheRuns()
{
    const QTemporaryDir folder;
    auto session = newSession(folder, 2);
    const auto path = session->path();
    session.reset();
    {
        auto file = SessionFile::open(path, SessionAccess::ReadWrite);
        QVERIFY(file);
        for (const char *name : {"source", "calibration-plan", "export-choice", "result"})
            QVERIFY(file->setDocument(name, "{\"half\": "));
    }
    session = opened(path);
    QCOMPARE(session->runs().size(), std::size_t(2));
    QCOMPARE(session->plan().runs.size(), std::size_t(2));
    QCOMPARE(session->events().size(), std::size_t(4));
    QCOMPARE(severityOf(session->events()[0]), EventSeverity::Problem);
}

void TestSessionObject::setResult_afterAnEdit_isNotTaken()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 2);
    const auto result = trainedOn(*session);
    CalibrationPlan plan = session->plan();
    plan.seed += 1;
    QVERIFY(session->editPlan(plan, "seed"));
    QCOMPARE(session->setResult(result).error().code, Errc::InvalidOption);
    QVERIFY(!session->result());
}

void TestSessionObject::refreshRuns_nothingNew_keepsTheResult()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 2);
    trainedOn(*session);
    Counter counter(*session);
    QVERIFY(session->refreshRuns());
    QVERIFY(counter.take().isEmpty());
    QVERIFY(session->result());
}

void TestSessionObject::events_haveTimeAndSeverity()
{
    const QTemporaryDir folder;
    auto session = newSession(folder);
    QSignalSpy added(session.get(), &Session::eventAdded);
    QVERIFY(session->addEvent({std::nullopt, 0, {}, "device", "Unplugged."}));
    QVERIFY(session->addEvent({std::nullopt, 0, {}, "note", "Looked at it."}));
    QCOMPARE(added.count(), 2);
    QCOMPARE(severityOf(session->events()[0]), EventSeverity::Warning);
    QCOMPARE(severityOf(session->events()[1]), EventSeverity::Note);
    QVERIFY(session->events()[0].utc.ends_with('Z'));
    const auto path = session->path();
    session.reset();
    QCOMPARE(opened(path)->events().size(), std::size_t(2));
}

QTEST_GUILESS_MAIN(TestSessionObject)
#include "tst_session_object.moc"
