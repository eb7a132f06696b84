// Work off the owner's thread: outcomes arrive on the owner's, a cancel is heeded, an owner that goes takes
// its work along.
#include "app/session/load_job.h"
#include "app/session/session.h"
#include "app/session/session_source.h"
#include "engine/exports/device_image.h"
#include "engine/formats/csv_writer.h"
#include "support/session_runs.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

using namespace driftbench;
using namespace driftbench::test;

class TestSessionJobs : public QObject
{
    Q_OBJECT

private slots:
    void task_outcome_arrivesOnTheOwnersThread();
    void task_cancelled_isTold();
    void task_whileRunning_isRefused();
    void task_ownerGone_isCancelledAndSilent();
    void task_inItsOwnOutcome_mayStartAgainOrGo();
    void progress_manyReports_areFewSignals();
    void training_session_givesPreparedModelsAndResult();
    void training_withoutTrain_endsPrepared();
    void training_refusedRun_saysSo();
    void training_sameSeed_isTheSameAsWithoutAThread();
    void training_cancelledAfterAModel_keepsFinishedOnes();
    void training_cancelledAtOnce_isCancelled();
    void load_logs_areRunsAndErrors();
    void load_cancelled_keepsWhatIsIn();
    void upload_simulatedBridge_isVerifiedAndRolledBack();
    void upload_noDevice_isAnError();
};

namespace {

std::unique_ptr<Session> newSession(const QTemporaryDir &folder, int runs)
{
    auto session = Session::create(folder.filePath("s.driftbench").toStdString());
    if (!session)
        qFatal("%s", session.error().message.c_str());
    if (runs > 0)
        addRuns(**session, runs);
    return *std::move(session);
}

void setModels(Session &session, const std::vector<std::string> &models)
{
    CalibrationPlan plan = session.plan();
    plan.models = models;
    if (!session.editPlan(plan, "models"))
        qFatal("edit");
}

using Trained = Result<std::shared_ptr<const CalibrationResult>>;

// Follows a training job.
struct Trainee : QObject
{
    explicit Trainee(TrainingJob &job)
    {
        connect(&job, &TrainingJob::prepared, this,
                [this](const std::shared_ptr<const PreparedCampaign> &made) { campaign = made; });
        connect(&job, &TrainingJob::modelTrained, this, [this](const QString &name) { models << name; });
        connect(&job, &TrainingJob::trained, this, [this](const Trained &result) { outcome = result; });
        connect(&job, &TrainingJob::failed, this, [this](const Error &error) { failure = error; });
    }

    std::shared_ptr<const PreparedCampaign> campaign;
    QStringList models;
    std::optional<Trained> outcome;
    std::optional<Error> failure;
};

std::filesystem::path writtenLog(const QTemporaryDir &folder, const char *name, int run)
{
    const std::filesystem::path path = folder.filePath(name).toStdString();
    if (!writeCsv(path, shortRun(run)))
        qFatal("write");
    return path;
}

} // namespace

void TestSessionJobs::task_outcome_arrivesOnTheOwnersThread()
{
    TaskJob job;
    std::optional<Status> outcome;
    QThread *worker = nullptr;
    connect(&job, &TaskJob::finished, this, [&](const Status &status) {
        QCOMPARE(QThread::currentThread(), thread());
        QVERIFY(!job.isRunning());
        outcome = status;
    });
    QVERIFY(job.start([&worker](const ProgressHook &) {
        worker = QThread::currentThread();
        return Status(Error{Errc::OutputFull, "Full."});
    }));
    QVERIFY(job.isRunning());
    QTRY_VERIFY(outcome);
    QCOMPARE(outcome->error().code, Errc::OutputFull);
    QVERIFY(worker != thread());
}

void TestSessionJobs::task_cancelled_isTold()
{
    TaskJob job;
    std::optional<Status> outcome;
    connect(&job, &TaskJob::finished, this, [&](const Status &status) { outcome = status; });
    job.start([](const ProgressHook &hook) {
        while (report(hook, "turning", 0.5) == Flow::Continue)
            QThread::yieldCurrentThread();
        return Status(Error{Errc::Cancelled, "Stopped."});
    });
    job.cancel();
    QVERIFY(job.isCancelled());
    QTRY_VERIFY(outcome);
    QCOMPARE(outcome->error().code, Errc::Cancelled);
}

void TestSessionJobs::task_whileRunning_isRefused()
{
    TaskJob job;
    std::atomic<bool> goOn{false};
    QSignalSpy running(&job, &Job::runningChanged);
    const auto wait = [&goOn](const ProgressHook &) {
        while (!goOn)
            QThread::yieldCurrentThread();
        return Status();
    };
    QVERIFY(job.start(wait));
    QVERIFY(!job.start(wait));
    goOn = true;
    QTRY_VERIFY(!job.isRunning());
    QCOMPARE(running.count(), 2);
}

void TestSessionJobs::task_ownerGone_isCancelledAndSilent()
{
    for (int i = 0; i < 50; ++i) {
        auto job = std::make_unique<TaskJob>();
        int calls = 0;
        connect(job.get(), &TaskJob::finished, this, [&calls] { ++calls; });
        connect(job.get(), &Job::progress, this, [&calls] { ++calls; });
        job->start([i](const ProgressHook &hook) {
            // Some are done before they are destroyed, some are not.
            for (int turn = 0; i % 2 == 0 || turn < 10; ++turn) {
                if (report(hook, "turning", 0.1) == Flow::Stop)
                    break;
            }
            return Status();
        });
        if (i % 3 == 0)
            QThread::yieldCurrentThread();
        job.reset();
        QCoreApplication::processEvents();
        QCOMPARE(calls, 0);
    }
}

void TestSessionJobs::task_inItsOwnOutcome_mayStartAgainOrGo()
{
    auto job = std::make_unique<TaskJob>();
    int runs = 0;
    connect(job.get(), &TaskJob::finished, this, [&] {
        if (++runs < 3)
            QVERIFY(job->start([](const ProgressHook &) { return Status(); }));
        else
            job.release()->deleteLater();
    });
    job->start([](const ProgressHook &) { return Status(); });
    QTRY_VERIFY(!job);
    QCOMPARE(runs, 3);
}

void TestSessionJobs::progress_manyReports_areFewSignals()
{
    TaskJob job;
    QSignalSpy signal(&job, &Job::progress);
    QSignalSpy finished(&job, &TaskJob::finished);
    job.start([](const ProgressHook &hook) {
        for (int i = 0; i < 100000; ++i)
            (void)report(hook, "counting", i / 100000.0);
        return Status();
    });
    QTRY_COMPARE(finished.count(), 1);
    QVERIFY(signal.count() >= 1);
    QVERIFY(signal.count() < 1000);
    QCOMPARE(signal.front().front().toString(), QString("counting"));
    QCOMPARE(job.stage(), QString("counting"));
    QCOMPARE(job.fraction(), 0.99999); // the last one is told, however fast it went
}

void TestSessionJobs::training_session_givesPreparedModelsAndResult()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 3);
    setModels(*session, {"constant", "cubic"});
    TrainingJob job;
    Trainee trainee(job);
    connect(&job, &TrainingJob::prepared, session.get(), &Session::setPrepared);
    auto input = session->trainingInput();
    QVERIFY(input);
    QVERIFY(job.start(*std::move(input)));
    QTRY_VERIFY(trainee.outcome);
    QVERIFY2(*trainee.outcome, *trainee.outcome ? "" : trainee.outcome->error().message.c_str());
    QVERIFY(!trainee.failure);
    QVERIFY(session->prepared() && !session->prepared()->refusal);
    QCOMPARE(session->prepared()->runs.size(), std::size_t(3));
    trainee.models.sort();
    QCOMPARE(trainee.models, (QStringList{"constant", "cubic"}));
    const auto &result = **trainee.outcome;
    QCOMPARE(result->models.size(), std::size_t(3)); // and auto
    QCOMPARE(result->heldOut.size(), std::size_t(3));
    QVERIFY(result->trainingS.at("cubic") > 0.0);
    QVERIFY(session->setResult(result));

    trainee.campaign.reset();
    trainee.outcome.reset();
    QVERIFY(job.start(*session->trainingInput()));
    QTRY_VERIFY(trainee.outcome);
    QVERIFY2(!trainee.campaign, "what is prepared is not prepared again");
    QCOMPARE((**trainee.outcome)->comparisonJson, result->comparisonJson);
}

void TestSessionJobs::training_withoutTrain_endsPrepared()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 2);
    TrainingJob job;
    Trainee trainee(job);
    QVERIFY(job.start(*session->trainingInput(false)));
    QTRY_VERIFY(trainee.campaign);
    QTRY_VERIFY(!job.isRunning());
    QVERIFY(!trainee.outcome);
}

void TestSessionJobs::training_refusedRun_saysSo()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 2);
    CalibrationPlan plan = session->plan();
    plan.runs[1].excluded.push_back({{100.0, 1e9}, "all of it"});
    QVERIFY(session->editPlan(plan, "exclude"));
    TrainingJob job;
    Trainee trainee(job);
    QVERIFY(job.start(*session->trainingInput()));
    QTRY_VERIFY(trainee.outcome);
    QVERIFY(!trainee.outcome->ok());
    QVERIFY(trainee.campaign);
    QVERIFY(trainee.campaign->refusal);
    QVERIFY2(trainee.campaign->refusal->message.find("run 2") != std::string::npos,
             trainee.campaign->refusal->message.c_str());
    QVERIFY2(trainee.campaign->runs[1].checked.refusal, "it can still be looked at");
    QVERIFY(!trainee.campaign->runs[0].checked.refusal);
}

void TestSessionJobs::training_sameSeed_isTheSameAsWithoutAThread()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 3);
    setModels(*session, {"constant", "rbf"});
    CalibrationPlan plan = session->plan();
    plan.rbf.largestNumberOfCentres = 6;
    plan.holdOut = {session->runs()[2].id};
    QVERIFY(session->editPlan(plan, "hold out run 3"));
    TrainingJob job;
    Trainee trainee(job);
    QVERIFY(job.start(*session->trainingInput()));
    const auto runs = loadRuns(session->file(), session->plan(), {});
    const auto prepared = prepareCampaign(session->plan(), *runs);
    const auto here = calibrate(*prepared);
    QVERIFY2(here, here ? "" : here.error().message.c_str());
    QTRY_VERIFY_WITH_TIMEOUT(trainee.outcome, 60000);
    QCOMPARE((**trainee.outcome)->comparisonJson, here->comparisonJson);
    QCOMPARE(here->figures.holdOut, std::vector<std::string>{"run 3"});
    QVERIFY(here->figures.rbfSelection);
    QVERIFY(here->figures.rbfSelection->heldOutLoss[0].size() <= 7);
}

void TestSessionJobs::training_cancelledAfterAModel_keepsFinishedOnes()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 3);
    setModels(*session, {"constant", "linear", "bpnn"});
    CalibrationPlan plan = session->plan();
    plan.bp.starts = 50;
    plan.bp.iterations = 100000;
    QVERIFY(session->editPlan(plan, "long training"));
    TrainingJob job;
    Trainee trainee(job);
    connect(&job, &TrainingJob::modelTrained, &job, [&](const QString &) {
        if (trainee.models.size() == 2)
            job.cancel();
    });
    QVERIFY(job.start(*session->trainingInput()));
    QTRY_VERIFY_WITH_TIMEOUT(trainee.outcome, 60000);
    QVERIFY2(*trainee.outcome, *trainee.outcome ? "" : trainee.outcome->error().message.c_str());
    const CalibrationResult &result = ***trainee.outcome;
    QVERIFY(result.model("constant") && result.model("linear") && result.model("auto"));
    QVERIFY(!result.model("bpnn"));
    const auto isAbout = [](const std::string &warning) {
        return warning.find("'bpnn'") != std::string::npos;
    };
    QVERIFY(std::any_of(result.figures.warnings.begin(), result.figures.warnings.end(), isAbout));
}

void TestSessionJobs::training_cancelledAtOnce_isCancelled()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 2);
    TrainingJob job;
    Trainee trainee(job);
    QVERIFY(job.start(*session->trainingInput()));
    job.cancel();
    QTRY_VERIFY(!job.isRunning());
    const Error error = trainee.failure ? *trainee.failure : trainee.outcome->error();
    QCOMPARE(error.code, Errc::Cancelled);
}

void TestSessionJobs::load_logs_areRunsAndErrors()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 0);
    LoadInput input;
    input.files = {writtenLog(folder, "first.csv", 0), folder.filePath("missing.csv").toStdString(),
                   writtenLog(folder, "second.csv", 1)};
    input.sensor = {"L3GD20H", "T-1"};
    input.referenceRateDps = {1.0, 2.0, 3.0};
    input.file = *session->anotherFile();
    LoadJob job;
    std::vector<LoadedLog> logs;
    connect(&job, &LoadJob::finished, this, [&logs](const std::vector<LoadedLog> &loaded) { logs = loaded; });
    QVERIFY(job.start(std::move(input)));
    QTRY_COMPARE(logs.size(), std::size_t(3));
    QVERIFY(logs[0].run && logs[2].run);
    QCOMPARE(logs[1].run.error().code, Errc::FileNotFound);
    QVERIFY(session->refreshRuns());
    QCOMPARE(session->runs().size(), std::size_t(2));
    const RunRecord &run = session->runs()[0];
    QCOMPARE(run.description.name, std::string("first"));
    QCOMPARE(run.description.sensor.serial, std::string("T-1"));
    QCOMPARE(run.state, RunState::Imported);
    QCOMPARE(session->plan().runs[0].referenceRateDps, Eigen::Vector3d(1.0, 2.0, 3.0));
    QCOMPARE((*session->recording(run.id))->size(), shortRun(0).size());
}

void TestSessionJobs::load_cancelled_keepsWhatIsIn()
{
    const QTemporaryDir folder;
    const auto session = newSession(folder, 0);
    LoadInput input;
    input.files = {writtenLog(folder, "first.csv", 0), writtenLog(folder, "second.csv", 1)};
    input.file = *session->anotherFile();
    const auto logs = importLogs(input, [](const Progress &progress) {
        return progress.stage.find("second") != std::string_view::npos ? Flow::Stop : Flow::Continue;
    });
    QCOMPARE(logs.size(), std::size_t(2));
    QVERIFY(logs[0].run);
    QCOMPARE(logs[1].run.error().code, Errc::Cancelled);
    QVERIFY(session->refreshRuns());
    QCOMPARE(session->runs().size(), std::size_t(1));
}

void TestSessionJobs::upload_simulatedBridge_isVerifiedAndRolledBack()
{
    const QTemporaryDir folder;
    auto choice = parseSourceChoice("simulated:L3GD20H:T-1");
    QVERIFY(choice);
    choice->as<SimulatedChoice>()->flashFile = folder.filePath("flash.bin").toStdString();
    CompensationTable table;
    table.firstMilliC = -40000;
    table.lastMilliC = 85000;
    table.tdeDps = Eigen::MatrixX3d::Random(100, 3);
    table.compensated = {true, true, true};
    table.provenance.sensor = {"L3GD20H", "T-1"};
    const auto image = encodeDeviceImage(table, DeviceTableKind::FixedPoint, DeviceThermometer::External);
    QVERIFY2(image, image ? "" : image.error().message.c_str());

    UploadJob job;
    std::optional<Result<UploadOutcome>> uploaded;
    std::optional<Result<std::optional<std::vector<std::uint8_t>>>> read;
    std::optional<Result<TableRollbackReport>> rolledBack;
    connect(&job, &UploadJob::uploaded, this, [&](const auto &outcome) { uploaded = outcome; });
    connect(&job, &UploadJob::readFinished, this, [&](const auto &outcome) { read = outcome; });
    connect(&job, &UploadJob::rolledBack, this, [&](const auto &outcome) { rolledBack = outcome; });
    QVERIFY(job.upload(clientOpener(*choice), *image));
    QTRY_VERIFY(uploaded);
    QVERIFY2(*uploaded, *uploaded ? "" : uploaded->error().message.c_str());
    QVERIFY((*uploaded)->report.activated);
    QCOMPARE((*uploaded)->device.sensor.serial, std::string("T-1"));
    QVERIFY(job.readBack(clientOpener(*choice)));
    QTRY_VERIFY(read);
    QVERIFY(*read && **read);
    QVERIFY(***read == *image);
    QVERIFY(job.rollBack(clientOpener(*choice)));
    QTRY_VERIFY(rolledBack);
    QVERIFY(*rolledBack);
}

void TestSessionJobs::upload_noDevice_isAnError()
{
    UploadJob job;
    std::optional<Result<UploadOutcome>> uploaded;
    connect(&job, &UploadJob::uploaded, this, [&](const auto &outcome) { uploaded = outcome; });
    job.upload(
        []() -> Result<std::shared_ptr<BridgeClient>> {
            return Error{Errc::DeviceNotFound, "None."};
        },
        {});
    QTRY_VERIFY(uploaded);
    QCOMPARE(uploaded->error().code, Errc::DeviceNotFound);
}

QTEST_GUILESS_MAIN(TestSessionJobs)
#include "tst_session_jobs.moc"
