#include "engine/exports/comparison_files.h"
#include "support/simple_recipes.h"
#include "support/test_data.h"
#include "support/thermal_runs.h"

#include <QTest>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace driftbench;

class TestComparisonFiles : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void write_folderThatIsNotThere_leavesFiveFiles();
    void write_folderThatIsAFile_isRefused();
    void json_rows_areTheSameDoubles();
    void json_everythingElse_isThere();
    void json_unknownFigures_areNull();
    void csv_rows_areTheSameDoubles();
    void csv_namesWithCommas_areQuoted();
    void recommendation_threeAxes_inWordsAndJson();
    void markdown_tables_holdTheFigures();
    void markdown_simulated_saysSo();
    void factsOf_run_countsWhatIsMasked();

private:
    Comparison m_comparison;
    CampaignSummary m_campaign;
};

void TestComparisonFiles::initTestCase()
{
    Random random(81);
    TrainingSet set{{}, -40.0};
    for (const char *name : {"first", "second", "third, again"}) {
        set.runs.push_back(test::makeRun(name, {}, test::bentCurve(random, 0.005), random));
        RunFacts facts;
        facts.name = name;
        facts.file = std::string(name) + ".csv";
        facts.referenceRateDps = {25.0, 5.0, 53.0};
        facts.samples = 2010;
        facts.usable = 2000;
        facts.masked = {{"motion", 10}};
        m_campaign.runs.push_back(facts);
    }
    m_campaign.referenceTemperatureC = -40.0;
    m_campaign.sensor = {"I3G4250D", "7"};
    auto comparison = compareRecipes({test::constantRecipe(), test::linearRecipe(), test::cubicRecipe(),
                                      test::gaussianRecipe("bpnn"), test::gaussianRecipe()},
                                     set, {m_campaign.sensor, true});
    QVERIFY(comparison.ok());
    m_comparison = std::move(comparison).value();
    RbfSelection selection;
    selection.chosen = {3, 4, 5};
    selection.heldOutLoss[1] = {1.0, 0.5, 0.25};
    m_comparison.rbfSelection = selection;
}

static std::string contents(const std::filesystem::path &file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

void TestComparisonFiles::write_folderThatIsNotThere_leavesFiveFiles()
{
    const auto folder = test::scratchFolder() / "deep" / "fit";
    QVERIFY(writeComparisonFiles(m_comparison, m_campaign, folder).ok());
    QCOMPARE(contents(folder / "comparison.json"), comparisonToJson(m_comparison, m_campaign));
    QCOMPARE(contents(folder / "comparison.csv"), comparisonToCsv(m_comparison));
    QCOMPARE(contents(folder / "comparison.md"), comparisonToMarkdown(m_comparison, m_campaign));
    QCOMPARE(contents(folder / "recommendation.json"), recommendationToJson(m_comparison));
    QCOMPARE(contents(folder / "recommendation.txt"), recommendationToText(m_comparison));
    const auto entries = std::distance(std::filesystem::directory_iterator(folder), {});
    QCOMPARE(entries, std::ptrdiff_t{5});
}

void TestComparisonFiles::write_folderThatIsAFile_isRefused()
{
    const auto file = test::scratchFolder() / "in_the_way";
    std::ofstream(file) << "x";
    const Status status = writeComparisonFiles(m_comparison, m_campaign, file);
    QVERIFY(!status.ok() && status.error().code == Errc::OutputNotWritable);
}

void TestComparisonFiles::json_rows_areTheSameDoubles()
{
    const auto json = nlohmann::json::parse(comparisonToJson(m_comparison, m_campaign));
    const auto &rows = json.at("rows");
    QCOMPARE(rows.size(), m_comparison.rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ComparisonRow &row = m_comparison.rows[i];
        const auto equals = [&](const char *key, double value) {
            return rows[i].at(key).get<double>() == value;
        };
        QVERIFY(rows[i].at("run") == row.run && rows[i].at("model") == row.model);
        QVERIFY(rows[i].at("axis") == std::string("xyz").substr(static_cast<std::size_t>(row.axis), 1));
        QVERIFY(equals("msd_before", row.msdBefore) && equals("msd_after", row.msdAfter));
        QVERIFY(equals("q", row.q) && equals("noise_floor", row.noiseFloor));
        QVERIFY(equals("excess_over_floor", row.excessOverFloor) && equals("rms10s_dps", row.rms10sDps));
        QVERIFY(equals("rms_dps", row.rmsDps) && equals("bias_instability_dps", row.biasInstabilityDps));
        QVERIFY(rows[i].at("samples") == row.samples);
        QVERIFY(rows[i].at("trained_on").get<std::vector<std::string>>() == row.trainedOn);
    }
}

void TestComparisonFiles::json_everythingElse_isThere()
{
    const auto json = nlohmann::json::parse(comparisonToJson(m_comparison, m_campaign));
    QVERIFY(json.at("simulated") == true);
    QVERIFY(json.at("judging") == "absolute");
    QVERIFY(json.at("seed") == 1);
    QVERIFY(json.at("reference_temperature_C") == -40.0);
    QVERIFY(json.at("sensor").at("serial") == "7");
    QVERIFY(json.at("warnings").is_array());
    const auto &run = json.at("runs").at(2);
    QVERIFY(run.at("file") == "third, again.csv" && run.at("masked").at("motion") == 10);
    QVERIFY(run.at("reference_rate_dps") == nlohmann::json({25.0, 5.0, 53.0}));
    QVERIFY(json.at("hysteresis").at("passages").size() == 3);
    QVERIFY(json.at("hysteresis").at("passages").at(0).at("tde_dps").size() == 3);
    QVERIFY(json.at("rbf_selection").at("y").at("chosen") == 4);
    QVERIFY(json.at("rbf_selection").at("y").at("held_out_loss").size() == 3);
    QVERIFY(json.at("band").at("runs") == 3);
    QVERIFY(json.at("band").at("curve_half_width_dps").at("z").size() == 64);
    QVERIFY(json.at("verdicts").at(1).at("verdict") == "yes");
}

void TestComparisonFiles::json_unknownFigures_areNull()
{
    Comparison comparison = m_comparison;
    comparison.rows[0].rms10sDps = std::numeric_limits<double>::quiet_NaN();
    comparison.verdicts[0].gainModelFree = std::numeric_limits<double>::quiet_NaN();
    comparison.models.back().band.reset();
    comparison.rbfSelection.reset();
    CampaignSummary campaign = m_campaign;
    campaign.runs[0].file = "not utf-8: \xff";
    const auto json = nlohmann::json::parse(comparisonToJson(comparison, campaign));
    QVERIFY(json.at("rows").at(0).at("rms10s_dps").is_null());
    QVERIFY(json.at("verdicts").at(0).at("gain_model_free").is_null());
    QVERIFY(json.at("band").is_null() && json.at("rbf_selection").is_null());
    // Nothing of heating against cooling is known of runs that only heat.
    QVERIFY(json.at("hysteresis").at("rms_dps").at(0).is_null());
}

void TestComparisonFiles::csv_rows_areTheSameDoubles()
{
    std::istringstream lines(comparisonToCsv(m_comparison));
    std::string line;
    std::getline(lines, line);
    QVERIFY(
        line.starts_with("run,axis,model,msd_before,msd_after,q,noise_floor,excess_over_floor,rms10s_dps"));
    std::getline(lines, line);
    const QStringList fields = QString::fromStdString(line).split(QLatin1Char(','));
    const ComparisonRow &row = m_comparison.rows.front();
    QCOMPARE(fields.at(0), QStringLiteral("first"));
    QCOMPARE(fields.at(4).toDouble(), row.msdAfter);
    QCOMPARE(fields.at(10).toDouble(), row.biasInstabilityDps);
    QCOMPARE(fields.at(11), QStringLiteral("2000"));
}

void TestComparisonFiles::csv_namesWithCommas_areQuoted()
{
    const std::string csv = comparisonToCsv(m_comparison);
    QVERIFY(csv.find("\n\"third, again\",x,constant,") != std::string::npos);
    QVERIFY(csv.find(",2000,\"second;third, again\"\n") != std::string::npos);
}

void TestComparisonFiles::recommendation_threeAxes_inWordsAndJson()
{
    const auto json = nlohmann::json::parse(recommendationToJson(m_comparison));
    QCOMPARE(json.size(), std::size_t{3});
    const std::string text = recommendationToText(m_comparison);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const AxisVerdict &verdict = m_comparison.verdicts[axis];
        QCOMPARE(json[axis].size(), std::size_t{6});
        QVERIFY(json[axis].at("axis") == std::string("xyz").substr(axis, 1));
        QVERIFY(json[axis].at("verdict") == std::string(verdictName(verdict.verdict)));
        QVERIFY(json[axis].at("model") == verdict.model);
        QVERIFY(json[axis].at("gain").get<double>() == verdict.gain);
        QVERIFY(json[axis].at("gain_model_free").get<double>() == verdict.gainModelFree);
        QVERIFY(json[axis].at("reason") == verdict.reason);
        QVERIFY(text.find(verdict.reason) != std::string::npos);
    }
    QVERIFY(text.find("Simulated data") != std::string::npos);
    QVERIFY(text.find("z: yes, ") != std::string::npos);
}

void TestComparisonFiles::markdown_tables_holdTheFigures()
{
    Comparison comparison = m_comparison;
    comparison.rows.resize(15); // the first run: 3 axes, 5 models
    for (ComparisonRow &row : comparison.rows) {
        row.msdBefore = 4.7794;
        row.msdAfter = row.model == "linear" ? 0.0216 : row.model == "bpnn" ? 0.0214 : 0.0193;
    }
    comparison.verdicts[2].gain = -0.65;
    // The x row of the paper's Table 2.
    const std::string text = comparisonToMarkdown(comparison, m_campaign);
    const std::string expected = "| x | 4.779 | 0.02160 | 0.02140 | 0.01930 | 4.519 \u00d7 10\u207b\u00b3 | "
                                 "4.478 \u00d7 10\u207b\u00b3 | 4.038 \u00d7 10\u207b\u00b3 | 0.93 % | "
                                 "10.65 % | 9.81 % |";
    QVERIFY2(text.find(expected) != std::string::npos, text.c_str());
    QVERIFY(text.find("\u22120.650") != std::string::npos);
    QVERIFY(text.find("| motion 10 |") != std::string::npos);
    QVERIFY(text.find("### first") != std::string::npos);
}

void TestComparisonFiles::markdown_simulated_saysSo()
{
    QVERIFY(comparisonToMarkdown(m_comparison, m_campaign).find("Simulated data") != std::string::npos);
    Comparison real = m_comparison;
    real.simulated = false;
    QVERIFY(comparisonToMarkdown(real, m_campaign).find("imulated") == std::string::npos);
    QVERIFY(recommendationToText(real).find("imulated") == std::string::npos);
}

void TestComparisonFiles::factsOf_run_countsWhatIsMasked()
{
    auto recording = std::make_shared<Recording>();
    recording->timeS.setLinSpaced(10, 0.0, 9.0);
    recording->info.source = "logs/a.csv";
    recording->info.format = "csv";
    Run run{"a", recording, {1.0, 2.0, 3.0}, Mask(10), {}};
    run.mask.set(3, MaskReason::Motion);
    run.mask.set(4, MaskReason::Motion);
    run.mask.set(5, MaskReason::Outlier);
    const RunFacts facts = factsOf(run);
    QCOMPARE(facts.file, std::string("logs/a.csv"));
    QCOMPARE(facts.samples, Eigen::Index{10});
    QCOMPARE(facts.usable, Eigen::Index{8});
    QCOMPARE(facts.masked.size(), std::size_t{2});
    QCOMPARE(facts.masked.at("motion"), Eigen::Index{2});
}

QTEST_APPLESS_MAIN(TestComparisonFiles)
#include "tst_comparison_files.moc"
