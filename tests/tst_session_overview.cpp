// The overview that is stored with each chunk, and files of before it was.
#include "support/cli_process.h"
#include "support/session_data.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace driftbench;
using namespace driftbench::test;

class TestSessionOverview : public QObject
{
    Q_OBJECT

private slots:
    void overview_run_boundsItsSamples();
    void overview_stored_needsNoSamples();
    void overview_lostOrDamaged_isMadeFromTheSamples();
    void open_version1_readOnlyAsItIsElseBroughtUpToDate();
    void open_version1WithADamagedChunk_isBroughtUpToDate();
};

namespace {

SessionFile newSession()
{
    auto made = SessionFile::create(newSessionPath(), {{}, "test 1.0"});
    if (!made)
        qFatal("%s", made.error().message.c_str());
    return std::move(*made);
}

} // namespace

void TestSessionOverview::overview_run_boundsItsSamples()
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

void TestSessionOverview::overview_stored_needsNoSamples()
{
    auto file = newSession();
    const auto id = *file.importRun(randomRecording(21, 40000), {});
    const RunOverview before = *file.overview(id);
    QCOMPARE(*file.database().integer("SELECT count(*) FROM overview"), std::int64_t{3});
    QVERIFY(
        file.database()
            .run("UPDATE chunk SET time = x'', temperature = x'', rate_x = x'', rate_y = x'', rate_z = x''")
            .ok());
    QVERIFY(!file.readRun(id).ok());
    QVERIFY(sameOverview(*file.overview(id), before));
    QVERIFY(file.removeRun(id).ok());
    QCOMPARE(*file.database().integer("SELECT count(*) FROM overview"), std::int64_t{0});
}

void TestSessionOverview::overview_lostOrDamaged_isMadeFromTheSamples()
{
    auto file = newSession();
    const auto id = *file.importRun(randomRecording(22, 40000), {});
    const RunOverview before = *file.overview(id);
    const Database &database = file.database();
    QVERIFY(database.run("DELETE FROM overview WHERE chunk_id = 1").ok());
    QVERIFY(database.run("UPDATE overview SET figures = zeroblob(length(figures)) WHERE chunk_id = 2").ok());
    QVERIFY(database.run("UPDATE overview SET samples = 300 WHERE chunk_id = 3").ok());
    QVERIFY(sameOverview(*file.overview(id), before));
    const auto findings = *file.check();
    QCOMPARE(findings.size(), std::size_t{3});
    QVERIFY(findings[0].find("sample 0 has no overview") != std::string::npos);
    QVERIFY(findings[1].find("sample 16384 has an overview that does not fit") != std::string::npos);
    QVERIFY(findings[2].find("sample 32768 has an overview that does not fit") != std::string::npos);
}

void TestSessionOverview::open_version1_readOnlyAsItIsElseBroughtUpToDate()
{
    const auto path = newSessionPath();
    std::vector<Recording> recordings;
    std::vector<RunOverview> overviews;
    {
        auto file = *SessionFile::create(path);
        for (const Eigen::Index size : {1, 16384, 40000}) {
            recordings.push_back(randomRecording(static_cast<std::uint64_t>(size), size));
            overviews.push_back(*file.overview(*file.importRun(recordings.back(), {})));
        }
    }
    makeVersion1(path);
    const auto bytes = bytesOf(QString::fromStdString(path.string()));
    for (const SessionAccess access : {SessionAccess::ReadOnly, SessionAccess::ReadWrite}) {
        const auto file = SessionFile::open(path, access);
        QVERIFY2(file.ok(), file.ok() ? "" : file.error().message.c_str());
        const bool old = access == SessionAccess::ReadOnly;
        QCOMPARE(file->formatVersion(), old ? 1 : kSessionFormatVersion);
        QVERIFY(file->check()->empty());
        for (std::size_t run = 0; run < recordings.size(); ++run) {
            const auto id = static_cast<RunId>(run + 1);
            QVERIFY(sameSamples(*file->readRun(id), recordings[run]));
            QVERIFY(sameOverview(*file->overview(id), overviews[run]));
        }
        if (old)
            QCOMPARE(bytesOf(QString::fromStdString(path.string())), bytes);
    }
    QVERIFY(bytesOf(QString::fromStdString(path.string())).size() > bytes.size());
}

void TestSessionOverview::open_version1WithADamagedChunk_isBroughtUpToDate()
{
    const auto path = newSessionPath();
    const Recording recording = randomRecording(23, 40000);
    QVERIFY(SessionFile::create(path)->importRun(recording, {}).ok());
    makeVersion1(path);
    QVERIFY(Database::open(path, DatabaseMode::ReadWrite)
                ->run("UPDATE chunk SET crc32 = crc32 + 1 WHERE first_sample = 16384")
                .ok());
    const auto file = SessionFile::open(path, SessionAccess::ReadWrite);
    QVERIFY2(file.ok(), file.ok() ? "" : file.error().message.c_str());
    QCOMPARE(*file->database().integer("SELECT count(*) FROM overview"), std::int64_t{2});
    QCOMPARE(file->overview(1).error().code, Errc::SessionDamaged);
    QCOMPARE(file->readRun(1, {true})->size(), recording.size() - 16384);
    QCOMPARE(file->check()->size(), std::size_t{1});
}

QTEST_GUILESS_MAIN(TestSessionOverview)
#include "tst_session_overview.moc"
