// Session files of every version that there was are read, and are brought up to date when they are written
// to.
#include "support/cli_process.h"
#include "support/golden_session.h"
#include "support/test_data.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestSessionGolden : public QObject
{
    Q_OBJECT

private slots:
    void open_everyVersion_holdsWhatWasWritten_data();
    void open_everyVersion_holdsWhatWasWritten();
};

void TestSessionGolden::open_everyVersion_holdsWhatWasWritten_data()
{
    QTest::addColumn<int>("version");
    QTest::addColumn<bool>("write");
    for (int version = 1; version <= kSessionFormatVersion; ++version) {
        QTest::addRow("version %d, read", version) << version << false;
        QTest::addRow("version %d, written to", version) << version << true;
    }
}

void TestSessionGolden::open_everyVersion_holdsWhatWasWritten()
{
    QFETCH(int, version);
    QFETCH(bool, write);
    const auto golden =
        (driftbench::test::sourceFolder() + "/tests/golden/session-v%1.driftbench").arg(version);
    const QByteArray bytes = bytesOf(golden);
    QVERIFY(!bytes.isEmpty());
    const auto path = newSessionPath();
    writeBytes(QString::fromStdString(path.string()), bytes);
    {
        auto file = SessionFile::open(path, write ? SessionAccess::ReadWrite : SessionAccess::ReadOnly);
        QVERIFY2(file.ok(), file.ok() ? "" : file.error().message.c_str());
        QCOMPARE(file->formatVersion(), write ? kSessionFormatVersion : version);
        QVERIFY(file->check()->empty());
        const auto runs = *file->runs();
        QCOMPARE(runs.size(), std::size_t{1});
        QCOMPARE(runs[0].description.name, std::string("golden"));
        QCOMPARE(runs[0].description.referenceRateDps, Eigen::Vector3d(25.0, 5.0, 53.0));
        QCOMPARE(runs[0].description.startedUtc, std::string("2026-01-02T03:04:05.678Z"));
        QVERIFY(sameSamples(*file->readRun(runs[0].id), goldenRecording()));
        const auto overview = *file->overview(runs[0].id);
        QCOMPARE(overview.size(), Eigen::Index{3});
        const auto rows = goldenRecording().rateDps.middleRows(256, 256).eval();
        for (int axis = 0; axis < 3; ++axis) {
            QCOMPARE(overview.lowest(1, 1 + axis), static_cast<float>(rows.col(axis).minCoeff()));
            QCOMPARE(overview.highest(1, 1 + axis), static_cast<float>(rows.col(axis).maxCoeff()));
            QVERIFY(std::abs(overview.mean(1, 1 + axis) - rows.col(axis).mean()) < 1e-5);
        }
        const auto mask = *file->mask(runs[0].id);
        QVERIFY(mask.has_value());
        QCOMPARE(mask->count(MaskReason::Motion), Eigen::Index{2});
        QCOMPARE(file->exclusions(runs[0].id)->front().note, std::string("a knock"));
        QCOMPARE(**file->document("view"), std::string("{}"));
        QCOMPARE(file->notes()->front().text, std::string("A note."));
        QCOMPARE(file->uploads()->front().generation, 7U);
        QCOMPARE(file->events()->front().atSample, std::int64_t{5});
        QCOMPARE(file->sensor()->serial, std::string("SIM-0001"));
        if (write)
            QVERIFY(file->setDocument("view", "changed").ok());
    }
    QCOMPARE(bytesOf(QString::fromStdString(path.string())) == bytes, !write);
}

QTEST_GUILESS_MAIN(TestSessionGolden)
#include "tst_session_golden.moc"
