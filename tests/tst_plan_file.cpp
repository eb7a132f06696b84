#include "engine/base/random.h"
#include "engine/base/text.h"
#include "engine/physics/plan_file.h"
#include "support/cli_process.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <nlohmann/json.hpp>

using namespace driftbench;
using namespace driftbench::test;

class TestPlanFile : public QObject
{
    Q_OBJECT

private slots:
    void json_randomPlans_comeBackToTheLastBit();
    void json_cutAnywhere_isDamaged();
    void json_fieldRemovedOrOfAnotherKind_isNamed();
    void json_newerVersion_saysSo();
    void json_otherContent_isDamaged_data();
    void json_otherContent_isDamaged();
    void json_planThatCannotBeRun_saysWhy();
    void file_written_isReadBack();
    void file_missingOrFolder_isAnError();
    void steps_ofThePaper_areTheStairs();
    void steps_tenthsOfADegree_haveNoStrayDigits();
    void segments_cycle_haveRates();
};

namespace {

TestPlan paperPlan()
{
    return *makeTestPlan(*namedSensor("L3GD20H"), *namedChamber("SET-Z-021"));
}

QList<QByteArray> linesOf(const std::string &text)
{
    QList<QByteArray> lines = QByteArray::fromStdString(text).split('\n');
    lines.removeLast();
    return lines;
}

bool isDamaged(const Result<TestPlan> &plan)
{
    return !plan.ok() && plan.error().code == Errc::PlanDamaged && plan.error().message.ends_with('.');
}

} // namespace

void TestPlanFile::json_randomPlans_comeBackToTheLastBit()
{
    constexpr std::uint64_t kSeed = 20;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    for (int i = 0; i < 200; ++i) {
        TestPlan plan = paperPlan();
        plan.kind = static_cast<PlanKind>(random.below(3));
        plan.lowestC = random.uniform(-200.0, 0.0);
        plan.highestC = plan.lowestC + random.uniform(10.0, 100.0);
        plan.stepC = random.uniform(0.01, 5.0);
        plan.periodS = random.uniform(0.1, 100.0);
        plan.holdS = random.uniform(0.0, 1e4);
        plan.sampleRateHz = random.uniform(0.1, 1e4);
        plan.cycles = plan.kind == PlanKind::Cycle ? 1 + static_cast<int>(random.below(3)) : 1;
        plan.runs = 1 + static_cast<int>(random.below(20));
        plan.sensor.noiseDensityDpsPerRootHz = random.uniform(1e-6, 1.0);
        plan.chamber.edgeM = random.uniform(0.01, 3.0);
        const std::string json = planToJson(plan);
        const auto again = planFromJson(json, "plan.json");
        QVERIFY2(again.ok(), again.ok() ? "" : again.error().message.c_str());
        QCOMPARE(planToJson(*again), json);
        QVERIFY(again->stepC == plan.stepC && again->kind == plan.kind && again->runs == plan.runs);
        QVERIFY(again->chamber.edgeM == plan.chamber.edgeM && again->cycles == plan.cycles);
        QCOMPARE(again->samplesPerRun(), plan.samplesPerRun());
        QCOMPARE(planStepsToCsv(*again), planStepsToCsv(plan));
    }
}

void TestPlanFile::json_cutAnywhere_isDamaged()
{
    const std::string json = planToJson(paperPlan());
    const std::size_t lastBrace = json.rfind('}');
    for (std::size_t length = 0; length <= lastBrace; ++length)
        QVERIFY(isDamaged(planFromJson(std::string_view(json).substr(0, length), "plan.json")));
}

void TestPlanFile::json_fieldRemovedOrOfAnotherKind_isNamed()
{
    const auto whole = nlohmann::ordered_json::parse(planToJson(paperPlan()));
    int fields = 0;
    const auto flat = whole.flatten();
    for (const auto &[path, value] : flat.items()) {
        const nlohmann::ordered_json::json_pointer pointer(path);
        const std::string key = pointer.back();
        nlohmann::ordered_json removed = whole;
        removed.at(pointer.parent_pointer()).erase(key);
        const auto without = planFromJson(removed.dump(), "plan.json");
        QVERIFY2(isDamaged(without), path.c_str());
        QVERIFY(without.error().message.find(key) != std::string::npos);
        nlohmann::ordered_json wrong = whole;
        wrong.at(pointer) = nlohmann::ordered_json::array();
        const auto other = planFromJson(wrong.dump(), "plan.json");
        QVERIFY2(isDamaged(other), path.c_str());
        QVERIFY(other.error().message.find(key) != std::string::npos);
        ++fields;
    }
    QCOMPARE(fields, 26);
}

void TestPlanFile::json_newerVersion_saysSo()
{
    auto json = nlohmann::ordered_json::parse(planToJson(paperPlan()));
    json["version"] = kPlanFormatVersion + 1;
    const auto plan = planFromJson(json.dump(), "plan.json");
    QVERIFY(isDamaged(plan));
    QVERIFY(plan.error().message.find("newer Driftbench") != std::string::npos);
}

void TestPlanFile::json_otherContent_isDamaged_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("a list") << QByteArray("[1, 2]");
    QTest::newRow("a number") << QByteArray("3");
    QTest::newRow("another format") << QByteArray(R"({"format": "driftbench model", "version": 1})");
    QTest::newRow("a log") << QByteArray("time_s,temperature_C\n0,1\n");
    QTest::newRow("huge number") << QByteArray(R"({"format": 1e999})");
    QTest::newRow("bytes") << QByteArray("\x00\xff\xfe", 3);
    QTest::newRow("deep") << QByteArray(100000, '[');
}

void TestPlanFile::json_otherContent_isDamaged()
{
    QFETCH(QByteArray, content);
    QVERIFY(isDamaged(planFromJson(content.toStdString(), "plan.json")));
}

void TestPlanFile::json_planThatCannotBeRun_saysWhy()
{
    TestPlan plan = paperPlan();
    plan.stepC = 0.0;
    const auto again = planFromJson(planToJson(plan), "plan.json");
    QVERIFY(isDamaged(again));
    QVERIFY(again.error().message.find("step of the plan is 0") != std::string::npos);
}

void TestPlanFile::file_written_isReadBack()
{
    QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("plan.json").toStdString();
    QVERIFY(writePlan(paperPlan(), file).ok());
    const auto again = readPlan(file);
    QVERIFY(again.ok());
    QCOMPARE(planToJson(*again), planToJson(paperPlan()));
    QCOMPARE(filesIn(folder.path()), QStringList{"plan.json"});
}

void TestPlanFile::file_missingOrFolder_isAnError()
{
    QTemporaryDir folder;
    const auto missing = readPlan(folder.filePath("none.json").toStdString());
    QVERIFY(!missing.ok());
    QCOMPARE(missing.error().code, Errc::FileNotFound);
    const auto directory = readPlan(folder.path().toStdString());
    QVERIFY(!directory.ok());
    QCOMPARE(directory.error().code, Errc::FileUnreadable);
    QVERIFY(!writePlan(paperPlan(), folder.filePath("none/plan.json").toStdString()).ok());
}

void TestPlanFile::steps_ofThePaper_areTheStairs()
{
    const QList<QByteArray> lines = linesOf(planStepsToCsv(paperPlan()));
    QCOMPARE(lines.size(), 252);
    QCOMPARE(lines[0], QByteArray("step,start_s,duration_s,setpoint_C"));
    QCOMPARE(lines[1], QByteArray("1,0,1800,-40"));
    QCOMPARE(lines[2], QByteArray("2,1800,30,-39.5"));
    QCOMPARE(lines[250], QByteArray("250,9240,30,84.5"));
    QCOMPARE(lines[251], QByteArray("251,9270,1830,85"));
}

void TestPlanFile::steps_tenthsOfADegree_haveNoStrayDigits()
{
    TestPlan plan = paperPlan();
    plan.stepC = 0.1;
    plan.lowestC = 0.0;
    const QList<QByteArray> lines = linesOf(planStepsToCsv(plan));
    for (int i = 1; i < lines.size(); ++i) {
        const QByteArray setpoint = lines[i].split(',').back();
        QVERIFY2(setpoint.size() <= 4, setpoint);
        QCOMPARE(setpoint.toDouble(), 0.1 * (i - 1));
    }
}

void TestPlanFile::segments_cycle_haveRates()
{
    TestPlan plan = paperPlan();
    plan.kind = PlanKind::Cycle;
    const QList<QByteArray> lines = linesOf(planSegmentsToCsv(plan));
    QCOMPARE(lines.size(), 6);
    QCOMPARE(lines[0], QByteArray("segment,kind,start_s,duration_s,from_C,to_C,rate_C_per_min"));
    QCOMPARE(lines[1], QByteArray("1,hold,0,1800,-40,-40,0"));
    QCOMPARE(lines[2], QByteArray("2,ramp,1800,7500,-40,85,1"));
    QCOMPARE(lines[4], QByteArray("4,ramp,11100,7500,85,-40,-1"));
}

QTEST_APPLESS_MAIN(TestPlanFile)
#include "tst_plan_file.moc"
