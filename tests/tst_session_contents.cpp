// What a session file holds beside the samples: marks, documents, results, notes and the log.
#include "engine/physics/datasheets.h"
#include "support/models_for_export.h"
#include "support/session_data.h"

#include <QTest>

using namespace driftbench;
using namespace driftbench::test;

class TestSessionContents : public QObject
{
    Q_OBJECT

private slots:
    void marks_setTwice_areTheLast();
    void mask_ofAnotherLength_isRefused();
    void documents_setAndRemoved_areKeptByName();
    void results_added_comeBack();
    void log_notesAndEvents_comeBackInOrder();
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

void TestSessionContents::marks_setTwice_areTheLast()
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

void TestSessionContents::mask_ofAnotherLength_isRefused()
{
    auto file = newSession();
    const auto id = *file.importRun(measuredRecording(1, 50, 10.0), {});
    QCOMPARE(file.setMask(id, Mask(49)).error().code, Errc::InvalidOption);
    QCOMPARE(file.setMask(id + 1, Mask(50)).error().code, Errc::NoSuchRun);
}

void TestSessionContents::documents_setAndRemoved_areKeptByName()
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

void TestSessionContents::results_added_comeBack()
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

void TestSessionContents::log_notesAndEvents_comeBackInOrder()
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

QTEST_GUILESS_MAIN(TestSessionContents)
#include "tst_session_contents.moc"
