// The session file: what goes in comes out, other files are refused, two programs do not write at once.
#include "app/session/session_file.h"

#include "engine/recording/block_means.h"
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
    void readRun_longRunAsMeans_isWhatTheSamplesGive();
    void runs_renamedAndRemoved_stayConsistent();
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

void TestSessionFile::readRun_longRunAsMeans_isWhatTheSamplesGive()
{
    auto file = newSession();
    const Recording recording = measuredRecording(11, 70000, 1000.0);
    const auto id = *file.importRun(recording, {});
    for (const std::int64_t most : {1000, 34999, 35000, 69999}) {
        const auto read = file.readRun(id, {.mostPoints = most});
        const Recording means = shortened(recording, most);
        QVERIFY(read.ok() && !read->points.empty());
        QVERIFY(sameSamples(*read, means) && sameBits(read->points.samples, means.points.samples) &&
                sameBits(read->points.varianceDps2, means.points.varianceDps2));
    }
    QVERIFY(sameSamples(*file.readRun(id, {.mostPoints = 70000}), recording));
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
