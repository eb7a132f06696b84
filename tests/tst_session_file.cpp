// The session file: what goes in comes out, other files are refused, two programs do not write at once.
#include "app/session/session_file.h"

#include "app/session/database.h"
#include "engine/physics/datasheets.h"
#include "support/cli_process.h"
#include "support/models_for_export.h"
#include "support/session_data.h"

#include <QTest>

#include <algorithm>
#include <thread>

using namespace driftbench;
using namespace driftbench::test;

class TestSessionFile : public QObject
{
    Q_OBJECT

private slots:
    void create_newFile_isEmptyAndWhole();
    void create_existingFile_isRefused();
    void open_whatIsNoSession_isRefused_data();
    void open_whatIsNoSession_isRefused();
    void open_newerVersion_isRefusedUntouched();
    void open_newerVersionInItsLog_isRefusedUntouched();
    void open_twice_secondIsReadOnlyAndSaysSo();
    void open_readOnly_leavesNothingBehind();
    void importRun_randomColumns_comeBackBitForBit();
    void importRun_hookStops_leavesNothing();
    void importRun_anotherSensor_isRefused();
    void readRange_anyRange_isThatPartOfTheRun();
    void overview_run_boundsItsSamples();
    void runs_renamedAndRemoved_stayConsistent();
    void marks_setTwice_areTheLast();
    void mask_ofAnotherLength_isRefused();
    void documents_setAndRemoved_areKeptByName();
    void results_added_comeBack();
    void log_notesAndEvents_comeBackInOrder();
    void everything_readOnly_cannotBeChanged();
    void another_usedByThreads_seesTheSameFile();
    void saveCopy_session_isTheSameAndWritable();
};

namespace {

SessionFile newSession()
{
    auto made = SessionFile::create(newSessionPath(), {{}, "test 1.0"});
    if (!made)
        qFatal("%s", made.error().message.c_str());
    return std::move(*made);
}

std::vector<std::string> filesBeside(const std::filesystem::path &path)
{
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(path.parent_path())) {
        const std::string name = entry.path().filename().string();
        if (name.find(path.filename().string()) != std::string::npos)
            names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

void setVersion(const std::filesystem::path &path, int version, bool leaveInLog)
{
    const auto database = Database::open(path, DatabaseMode::ReadWrite);
    QVERIFY(database.ok());
    if (leaveInLog)
        database->leaveLogOnClose();
    QVERIFY(database->run("PRAGMA user_version = " + std::to_string(version)).ok());
}

} // namespace

void TestSessionFile::create_newFile_isEmptyAndWhole()
{
    const auto path = newSessionPath();
    {
        auto file = SessionFile::create(path);
        QVERIFY2(file.ok(), file.ok() ? "" : file.error().message.c_str());
        QVERIFY(!file->readOnly());
        QCOMPARE(file->formatVersion(), kSessionFormatVersion);
        QVERIFY(file->runs()->empty());
        QVERIFY(file->check()->empty());
        QVERIFY(!file->sensor()->known());
        QVERIFY(!file->plan()->has_value());
    }
    QCOMPARE(filesBeside(path), std::vector<std::string>{path.filename().string()});
}

void TestSessionFile::create_existingFile_isRefused()
{
    const auto path = newSessionPath();
    QVERIFY(SessionFile::create(path).ok());
    const auto bytes = bytesOf(QString::fromStdString(path.string()));
    const auto again = SessionFile::create(path);
    QVERIFY(!again.ok());
    QCOMPARE(again.error().code, Errc::OutputNotWritable);
    QCOMPARE(bytesOf(QString::fromStdString(path.string())), bytes);
    const auto nowhere = SessionFile::create(scratchFolder() / "no such folder" / "a.driftbench");
    QCOMPARE(nowhere.error().code, Errc::OutputNotWritable);
}

void TestSessionFile::open_whatIsNoSession_isRefused_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("database");
    QTest::newRow("empty") << QByteArray() << false;
    QTest::newRow("text") << QByteArray("time,temperature\n0,25\n") << false;
    QTest::newRow("starts like one") << QByteArray("SQLite format 3\0and no more", 28) << false;
    QTest::newRow("another program's database") << QByteArray() << true;
}

void TestSessionFile::open_whatIsNoSession_isRefused()
{
    QFETCH(QByteArray, bytes);
    QFETCH(bool, database);
    const auto path = newSessionPath();
    writeBytes(QString::fromStdString(path.string()), bytes);
    if (database)
        QVERIFY(Database::open(path, DatabaseMode::ReadWrite)
                    ->script("CREATE TABLE t(x); PRAGMA user_version=1")
                    .ok());
    const auto before = bytesOf(QString::fromStdString(path.string()));
    for (const SessionAccess access : {SessionAccess::ReadWrite, SessionAccess::ReadOnly}) {
        const auto opened = SessionFile::open(path, access);
        QVERIFY(!opened.ok());
        QCOMPARE(opened.error().code, Errc::UnknownFormat);
    }
    QCOMPARE(bytesOf(QString::fromStdString(path.string())), before);
    QCOMPARE(filesBeside(path), std::vector<std::string>{path.filename().string()});
    QCOMPARE(SessionFile::open(scratchFolder() / "none", SessionAccess::ReadOnly).error().code,
             Errc::FileNotFound);
    QCOMPARE(SessionFile::open(scratchFolder(), SessionAccess::ReadOnly).error().code, Errc::UnknownFormat);
}

void TestSessionFile::open_newerVersion_isRefusedUntouched()
{
    const auto path = newSessionPath();
    QVERIFY(SessionFile::create(path).ok());
    setVersion(path, kSessionFormatVersion + 1, false);
    const auto before = bytesOf(QString::fromStdString(path.string()));
    for (const SessionAccess access : {SessionAccess::ReadWrite, SessionAccess::ReadOnly}) {
        const auto opened = SessionFile::open(path, access);
        QVERIFY(!opened.ok());
        QCOMPARE(opened.error().code, Errc::SessionTooNew);
    }
    QCOMPARE(bytesOf(QString::fromStdString(path.string())), before);
    QCOMPARE(filesBeside(path), std::vector<std::string>{path.filename().string()});
}

void TestSessionFile::open_newerVersionInItsLog_isRefusedUntouched()
{
    // As a newer program that was killed behind its migration would leave it.
    const auto path = newSessionPath();
    QVERIFY(SessionFile::create(path).ok());
    setVersion(path, kSessionFormatVersion + 1, true);
    const QString log = QString::fromStdString(path.string() + "-wal");
    const auto before = bytesOf(QString::fromStdString(path.string()));
    const auto logBefore = bytesOf(log);
    QVERIFY(!logBefore.isEmpty());
    for (const SessionAccess access : {SessionAccess::ReadWrite, SessionAccess::ReadOnly}) {
        const auto opened = SessionFile::open(path, access);
        QVERIFY(!opened.ok());
        QCOMPARE(opened.error().code, Errc::SessionTooNew);
    }
    QCOMPARE(bytesOf(QString::fromStdString(path.string())), before);
    QCOMPARE(bytesOf(log), logBefore);
}

void TestSessionFile::open_twice_secondIsReadOnlyAndSaysSo()
{
    const auto path = newSessionPath();
    auto first = std::make_optional(*SessionFile::create(path));
    const auto second = SessionFile::open(path, SessionAccess::ReadWrite);
    QVERIFY(second.ok());
    QVERIFY(second->readOnly());
    QVERIFY(second->readOnlyReason().find("process " + std::to_string(QCoreApplication::applicationPid())) !=
            std::string::npos);
    QVERIFY(first->setDocument("view", "seen by both").ok());
    QCOMPARE(**second->document("view"), std::string("seen by both"));
    // While one more object of the program that writes lives, the file stays its.
    auto other = std::make_optional(*first->another());
    first.reset();
    QVERIFY(SessionFile::open(path, SessionAccess::ReadWrite)->readOnly());
    other.reset();
    QVERIFY(!SessionFile::open(path, SessionAccess::ReadWrite)->readOnly());
}

void TestSessionFile::open_readOnly_leavesNothingBehind()
{
    const auto path = newSessionPath();
    QVERIFY(SessionFile::create(path)->importRun(measuredRecording(1, 100, 10.0), {}).ok());
    const auto before = bytesOf(QString::fromStdString(path.string()));
    {
        const auto opened = SessionFile::open(path, SessionAccess::ReadOnly);
        QVERIFY(opened.ok());
        QCOMPARE(opened->readRun(1)->size(), Eigen::Index{100});
    }
    QCOMPARE(bytesOf(QString::fromStdString(path.string())), before);
    QCOMPARE(filesBeside(path), std::vector<std::string>{path.filename().string()});
}

void TestSessionFile::importRun_randomColumns_comeBackBitForBit()
{
    const auto seed = static_cast<std::uint64_t>(QDateTime::currentMSecsSinceEpoch());
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    Random random(seed);
    auto file = newSession();
    for (const Eigen::Index size : {1, 2, 255, 256, 257, 16383, 16384, 16385, 40000}) {
        const Recording recording = randomRecording(random.bits(), size);
        const auto id = file.importRun(recording, describeRecording(recording.info, {}));
        QVERIFY2(id.ok(), id.ok() ? "" : id.error().message.c_str());
        const auto back = file.readRun(*id);
        QVERIFY2(back.ok(), back.ok() ? "" : back.error().message.c_str());
        QVERIFY(sameSamples(*back, recording));
        QCOMPARE(back->info.source, recording.info.source);
        QCOMPARE(back->info.format, recording.info.format);
        QCOMPARE(back->info.instance, recording.info.instance);
        QCOMPARE(back->info.sensor.text(), recording.info.sensor.text());
        QCOMPARE(back->info.simulated, true);
        QCOMPARE(back->info.warnings, recording.info.warnings);
        const auto record = file.run(*id);
        QCOMPARE(record->samples, size);
        QVERIFY(record->state == RunState::Imported);
    }
    QCOMPARE(file.runs()->front().description.name, std::string("random"));
    QCOMPARE(file.runs()->back().description.name, std::string("random-9"));
    QVERIFY(file.importRun(Recording(), {}).ok());
    QCOMPARE(file.readRun(file.runs()->back().id)->size(), Eigen::Index{0});
    QVERIFY(file.check()->empty());
    QCOMPARE(file.readRun(999).error().code, Errc::NoSuchRun);
}

void TestSessionFile::importRun_hookStops_leavesNothing()
{
    auto file = newSession();
    const auto stopped =
        file.importRun(measuredRecording(2, 100, 10.0), {}, [](const Progress &) { return Flow::Stop; });
    QCOMPARE(stopped.error().code, Errc::Cancelled);
    QVERIFY(file.runs()->empty());
    QCOMPARE(*file.database().integer("SELECT count(*) FROM run"), std::int64_t{0});
}

void TestSessionFile::importRun_anotherSensor_isRefused()
{
    auto file = newSession();
    Recording recording = measuredRecording(3, 50, 10.0);
    QVERIFY(file.importRun(recording, describeRecording(recording.info, "a")).ok());
    QCOMPARE(file.sensor()->serial, std::string("SIM-0001"));
    recording.info.sensor.serial = "SIM-0002";
    const auto other = file.importRun(recording, describeRecording(recording.info, "b"));
    QCOMPARE(other.error().code, Errc::DifferentSensors);
    recording.info.sensor = {};
    QVERIFY(file.importRun(recording, describeRecording(recording.info, "c")).ok());
    QCOMPARE(file.runs()->size(), std::size_t{2});
}

void TestSessionFile::readRange_anyRange_isThatPartOfTheRun()
{
    Random random(7);
    auto file = newSession();
    const Recording recording = randomRecording(5, 40000);
    const auto id = *file.importRun(recording, {});
    for (int trial = 0; trial < 40; ++trial) {
        const auto first = static_cast<std::int64_t>(random.below(40000));
        const auto count = static_cast<std::int64_t>(random.below(20000));
        const auto part = file.readRange(id, {first, count});
        QVERIFY(part.ok());
        const auto there = std::min<Eigen::Index>(count, recording.size() - first);
        QVERIFY(sameSamples(*part, rowsOf(recording, first, there)));
    }
    QCOMPARE(file.readRange(id, {50000, 10})->size(), Eigen::Index{0});
    QCOMPARE(file.readRange(id, {-1, 10}).error().code, Errc::InvalidOption);
}

void TestSessionFile::overview_run_boundsItsSamples()
{
    auto file = newSession();
    Recording recording = measuredRecording(11, 20000, 100.0);
    recording.rateDps(300, 1) = std::numeric_limits<double>::quiet_NaN();
    recording.rateDps.col(2).segment(512, 256).setConstant(std::numeric_limits<double>::infinity());
    const auto id = *file.importRun(recording, {});
    const auto overview = file.overview(id);
    QVERIFY(overview.ok());
    QCOMPARE(overview->size(), Eigen::Index{64 + 15}); // 16384 and 3616 samples
    for (Eigen::Index row = 0; row < overview->size(); ++row) {
        const Eigen::Index first = row * 256;
        const Eigen::Index count = std::min<Eigen::Index>(256, recording.size() - first);
        QCOMPARE(overview->startS[row], recording.timeS[first]);
        QCOMPARE(overview->endS[row], recording.timeS[first + count - 1]);
        const auto temperature = recording.temperatureC.segment(first, count);
        QCOMPARE(overview->lowest(row, 0), static_cast<float>(temperature.minCoeff()));
        QCOMPARE(overview->highest(row, 0), static_cast<float>(temperature.maxCoeff()));
        QVERIFY(std::abs(overview->mean(row, 0) - temperature.mean()) < 1e-4);
    }
    QVERIFY(std::isfinite(overview->mean(1, 2)));
    QVERIFY(std::isnan(overview->mean(2, 3)));
}

void TestSessionFile::runs_renamedAndRemoved_stayConsistent()
{
    auto file = newSession();
    const auto a = *file.importRun(measuredRecording(1, 500, 10.0), {});
    const auto b = *file.importRun(measuredRecording(2, 500, 10.0), {});
    QVERIFY(file.renameRun(a, "cold start").ok());
    QCOMPARE(file.renameRun(b, "cold start").error().code, Errc::InvalidOption);
    QCOMPARE(file.renameRun(77, "x").error().code, Errc::NoSuchRun);
    QVERIFY(file.setReferenceRate(a, {25.0, 5.0, 53.0}).ok());
    QCOMPARE(file.run(a)->description.referenceRateDps, Eigen::Vector3d(25.0, 5.0, 53.0));
    QVERIFY(file.addEvent({a, 3, {}, "gap", "Something was lost."}).ok());
    QVERIFY(file.setExclusions(a, {{{1.0, 2.0}, "a knock"}}).ok());
    QVERIFY(file.setMask(a, Mask(500)).ok());
    Random random(3);
    TrainedModel model = randomCubic(random);
    model.trainedOn = {"cold start", "elsewhere"};
    QVERIFY(file.addModel(model).ok());
    QVERIFY(file.removeRun(a).ok());
    QCOMPARE(file.runs()->size(), std::size_t{1});
    QVERIFY(file.events()->empty());
    QCOMPARE(*file.database().integer("SELECT count(*) FROM chunk WHERE run_id = ?1", a), std::int64_t{0});
    QCOMPARE(file.models()->front().trainedOn, (std::vector<std::string>{"cold start", "elsewhere"}));
    QVERIFY(file.check()->empty());
    const auto c = *file.importRun(measuredRecording(4, 10, 10.0), {});
    QVERIFY(c > b); // numbers are never used again
}

void TestSessionFile::marks_setTwice_areTheLast()
{
    auto file = newSession();
    const auto id = *file.importRun(measuredRecording(1, 5000, 10.0), {});
    QVERIFY(!file.mask(id)->has_value());
    Random random(9);
    for (int trial = 0; trial < 3; ++trial) {
        Mask mask(5000);
        for (int i = 0; i < 200; ++i)
            mask.set(static_cast<Eigen::Index>(random.below(5000)),
                     kMaskReasons[random.below(kMaskReasons.size())]);
        QVERIFY(file.setMask(id, mask).ok());
        const auto back = file.mask(id);
        QVERIFY(back.ok() && back->has_value());
        for (Eigen::Index sample = 0; sample < 5000; ++sample) {
            for (const MaskReason reason : kMaskReasons)
                QCOMPARE((**back).has(sample, reason), mask.has(sample, reason));
        }
    }
    QVERIFY(file.setExclusions(id, {{{1.0, 2.0}, "a"}, {{5.0, 6.5}, "b"}}).ok());
    QVERIFY(file.setExclusions(id, {{{7.25, 8.0}, "c"}}).ok());
    QCOMPARE(file.exclusions(id)->size(), std::size_t{1});
    QCOMPARE(file.exclusions(id)->front().range.startS, 7.25);
    QCOMPARE(file.exclusions(id)->front().note, std::string("c"));
}

void TestSessionFile::mask_ofAnotherLength_isRefused()
{
    auto file = newSession();
    const auto id = *file.importRun(measuredRecording(1, 50, 10.0), {});
    QCOMPARE(file.setMask(id, Mask(49)).error().code, Errc::InvalidOption);
    QCOMPARE(file.setMask(id + 1, Mask(50)).error().code, Errc::NoSuchRun);
}

void TestSessionFile::documents_setAndRemoved_areKeptByName()
{
    auto file = newSession();
    QVERIFY(!file.document("view")->has_value());
    QVERIFY(file.setDocument("view", "{\"a\": 1}").ok());
    QVERIFY(file.setDocument("view", "").ok());
    QCOMPARE(**file.document("view"), std::string());
    QVERIFY(file.removeDocument("view").ok());
    QVERIFY(!file.document("view")->has_value());
    auto plan = makeTestPlan(*namedSensor("L3GD20H"), *namedChamber("SET-Z-021"));
    QVERIFY(plan.ok());
    plan->stepC = 1.25;
    QVERIFY(file.setPlan(*plan).ok());
    const auto back = file.plan();
    QVERIFY(back.ok() && back->has_value());
    QCOMPARE((**back).stepC, 1.25);
    QCOMPARE((**back).samplesPerRun(), plan->samplesPerRun());
    QVERIFY(file.setDocument("plan", "{").ok());
    QCOMPARE(file.plan().error().code, Errc::PlanDamaged);
    QCOMPARE(file.check()->size(), std::size_t{1});
}

void TestSessionFile::results_added_comeBack()
{
    auto file = newSession();
    Random random(21);
    const TrainedModel model = randomRbf(random);
    const auto id = file.addModel(model);
    QVERIFY(id.ok());
    const auto back = file.model(*id);
    QVERIFY(back.ok());
    const Eigen::VectorXd temperatures =
        Eigen::VectorXd::LinSpaced(50, model.lowestTemperatureC, model.highestTemperatureC);
    QVERIFY(sameBits(predictAtTemperature(*back, temperatures).tdeDps,
                     predictAtTemperature(model, temperatures).tdeDps));
    QCOMPARE(file.model(*id + 1).error().code, Errc::NoSuchRun);

    QVERIFY(file.addComparison("{\"rows\": []}", "{\"verdicts\": {}}").ok());
    QCOMPARE(file.comparisons()->front().comparisonJson, std::string("{\"rows\": []}"));
    QVERIFY(file.addExport({{}, *id, "csv", "table.csv", 1234, 0xFFFFFFFFU}).ok());
    QCOMPARE(file.exports()->front().crc32, 0xFFFFFFFFU);
    QVERIFY(
        file.addUpload(
                {{}, *id, {"L3GD20H", "SIM-0001"}, "bridge", "fixed", 1, 7, 2048, 42, true, false, "Done."})
            .ok());
    const auto uploads = file.uploads();
    QCOMPARE(uploads->front().sensor.serial, std::string("SIM-0001"));
    QCOMPARE(uploads->front().generation, 7U);
    QVERIFY(uploads->front().verified && !uploads->front().activated);
    // What was made with a model stays when the model goes.
    QVERIFY(file.removeModel(*id).ok());
    QVERIFY(!file.exports()->front().model && !file.uploads()->front().model);
    QCOMPARE(file.exports()->front().path, std::string("table.csv"));
    QVERIFY(file.check()->empty());
}

void TestSessionFile::log_notesAndEvents_comeBackInOrder()
{
    auto file = newSession();
    const auto run = *file.importRun(measuredRecording(1, 50, 10.0), {});
    QVERIFY(file.addEvent({std::nullopt, 0, "2026-01-02T03:04:05.678Z", "device", "Unplugged."}).ok());
    QVERIFY(file.addEvent({run, 20, {}, "gap", "Three samples were lost."}).ok());
    QCOMPARE(file.events()->size(), std::size_t{2});
    QCOMPARE(file.events()->front().utc, std::string("2026-01-02T03:04:05.678Z"));
    QCOMPARE(file.events(run)->size(), std::size_t{1});
    QCOMPARE(file.events(run)->front().atSample, std::int64_t{20});
    const auto note = file.addNote({0, {}, run, "Door was open."});
    QVERIFY(note.ok());
    QVERIFY(file.addNote({0, {}, std::nullopt, "Zweite Meßreihe."}).ok());
    QCOMPARE(file.notes()->back().text, std::string("Zweite Meßreihe."));
    QVERIFY(file.removeNote(*note).ok());
    QCOMPARE(file.notes()->size(), std::size_t{1});
    // A note about a run that is not there.
    QVERIFY(!file.addNote({0, {}, RunId{99}, "x"}).ok());
}

void TestSessionFile::everything_readOnly_cannotBeChanged()
{
    const auto path = newSessionPath();
    QVERIFY(SessionFile::create(path)->importRun(measuredRecording(1, 50, 10.0), {}).ok());
    auto file = *SessionFile::open(path, SessionAccess::ReadOnly);
    Random random(1);
    const std::vector<Status> tried{
        file.setSensor({"a", "b"}), file.renameRun(1, "x"),    file.setReferenceRate(1, {}),
        file.removeRun(1),          file.setExclusions(1, {}), file.setMask(1, Mask(50)),
        file.setDocument("a", "b"), file.removeDocument("a"),  file.removeModel(1),
        file.addExport({}),         file.addUpload({}),        file.removeNote(1),
        file.addEvent({})};
    for (const Status &status : tried) {
        QVERIFY(!status.ok());
        QCOMPARE(status.error().code, Errc::SessionReadOnly);
    }
    QCOMPARE(file.importRun(Recording(), {}).error().code, Errc::SessionReadOnly);
    QCOMPARE(file.addModel(randomCubic(random)).error().code, Errc::SessionReadOnly);
    QCOMPARE(file.addComparison({}, {}).error().code, Errc::SessionReadOnly);
    QCOMPARE(file.addNote({}).error().code, Errc::SessionReadOnly);
    // Also for SQLite itself.
    QVERIFY(!file.database().run("DELETE FROM run").ok());
}

void TestSessionFile::another_usedByThreads_seesTheSameFile()
{
    auto file = newSession();
    const Recording recording = measuredRecording(8, 20000, 1000.0);
    const auto id = *file.importRun(recording, {});
    std::array<bool, 3> same{};
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < same.size(); ++i)
        threads.emplace_back(
            [&same, i, own = std::make_shared<SessionFile>(*file.another()), id, &recording] {
                const auto noted = own->addNote({0, {}, std::nullopt, "from thread " + std::to_string(i)});
                const auto read = own->readRun(id);
                same[i] = noted.ok() && read.ok() && sameSamples(*read, recording);
            });
    threads.clear();
    QVERIFY(std::all_of(same.begin(), same.end(), [](bool ok) { return ok; }));
    QCOMPARE(file.notes()->size(), std::size_t{3});
}

void TestSessionFile::saveCopy_session_isTheSameAndWritable()
{
    auto file = newSession();
    const Recording recording = randomRecording(13, 30000);
    const auto id = *file.importRun(recording, describeRecording(recording.info, {}));
    const auto target = newSessionPath();
    writeBytes(QString::fromStdString(target.string()), "an older file");
    QCOMPARE(file.saveCopy(file.path()).error().code, Errc::InvalidOption);
    QCOMPARE(file.saveCopy(target, [](const Progress &) { return Flow::Stop; }).error().code,
             Errc::Cancelled);
    QCOMPARE(bytesOf(QString::fromStdString(target.string())), QByteArray("an older file"));
    QVERIFY(file.saveCopy(target).ok());
    QCOMPARE(filesBeside(target), std::vector<std::string>{target.filename().string()});
    auto copy = SessionFile::open(target, SessionAccess::ReadWrite);
    QVERIFY2(copy.ok(), copy.ok() ? "" : copy.error().message.c_str());
    QVERIFY(!copy->readOnly());
    QVERIFY(sameSamples(*copy->readRun(id), recording));
    QVERIFY(copy->check()->empty());
    QVERIFY(copy->removeRun(id).ok());
    QVERIFY(file.run(id).ok());
}

QTEST_GUILESS_MAIN(TestSessionFile)
#include "tst_session_file.moc"
