#include "engine/base/checksum.h"
#include "engine/models/model_file.h"
#include "support/random_models.h"
#include "support/test_data.h"

#include <QTest>

#include <nlohmann/json.hpp>

#include <fstream>
#include <functional>

using namespace driftbench;
using Json = nlohmann::ordered_json;

class TestModelFile : public QObject
{
    Q_OBJECT

private slots:
    void roundTrip_everyKind_sameBytesAndPredictions();
    void read_fieldByField_asWritten();
    void read_cutAtEveryByte_refused();
    void read_everyByteEdited_neverLoadsSilently();
    void read_signedButWrong_data();
    void read_signedButWrong();
    void read_newerVersion_saysWhatToDo();
    void read_notAModel_data();
    void read_notAModel();
    void write_nameNotUtf8_readsBack();
    void write_numberNotFinite_refusedOnReading();
    void saveAndLoad_file();
    void load_badFiles_ownErrors();
};

static constexpr std::uint64_t kSeed = 20261121;

static std::vector<TrainedModel> models(int round = 0)
{
    Random random(kSeed + static_cast<std::uint64_t>(round));
    return test::randomModelsOfEveryKind(random);
}

static bool samePredictions(const TrainedModel &left, const TrainedModel &right)
{
    const Eigen::VectorXd temperatureC = Eigen::VectorXd::LinSpaced(301, -60.0, 100.0);
    const Eigen::MatrixX3d a = predictAtTemperature(left, temperatureC).tdeDps;
    const Eigen::MatrixX3d b = predictAtTemperature(right, temperatureC).tdeDps;
    return (a.array() == b.array()).all();
}

// The checksum that the file ought to have: of the compact document without the field.
static std::string signedAgain(Json document)
{
    document.erase("crc32");
    char text[9];
    std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(crc32(document.dump())));
    document["crc32"] = text;
    return document.dump();
}

void TestModelFile::roundTrip_everyKind_sameBytesAndPredictions()
{
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    for (int round = 0; round < 20; ++round) {
        for (const TrainedModel &model : models(round)) {
            const std::string json = modelToJson(model);
            const auto back = modelFromJson(json, "m.json");
            QVERIFY2(back.ok(), back.ok() ? "" : back.error().message.c_str());
            QCOMPARE(modelToJson(*back), json);
            QVERIFY(samePredictions(*back, model));
        }
    }
}

void TestModelFile::read_fieldByField_asWritten()
{
    const TrainedModel model = models()[4];
    const auto back = modelFromJson(modelToJson(model), "m.json");
    QVERIFY(back.ok());
    QCOMPARE(back->name, model.name);
    QCOMPARE(back->referenceTemperatureC, model.referenceTemperatureC);
    QCOMPARE(back->lowestTemperatureC, model.lowestTemperatureC);
    QCOMPARE(back->highestTemperatureC, model.highestTemperatureC);
    QCOMPARE(back->sensor.serial, model.sensor.serial);
    QCOMPARE(back->simulated, model.simulated);
    QCOMPARE(back->trainedOn, model.trainedOn);
    QCOMPARE(back->seed, model.seed);
    QCOMPARE(back->judging, model.judging);
    QCOMPARE(back->summary, model.summary);
    QVERIFY(back->verdicts == model.verdicts);
    QVERIFY(back->reasons == model.reasons);
    QCOMPARE(back->band.has_value(), model.band.has_value());
}

void TestModelFile::read_cutAtEveryByte_refused()
{
    for (const std::size_t kind : {0U, 3U, 5U}) {
        const std::string json = modelToJson(models()[kind]);
        const std::size_t step = kind == 5U ? 11 : 1; // the largest one not quite at every byte
        for (std::size_t length = 0; length + 1 < json.size(); length += step) { // all but the last line feed
            const auto back = modelFromJson(std::string_view(json).substr(0, length), "m.json");
            QVERIFY(!back.ok());
            QCOMPARE(back.error().code, Errc::ModelDamaged);
            QVERIFY(back.error().message.find(length == 0 ? "empty" : "cut off") != std::string::npos);
        }
    }
}

void TestModelFile::read_everyByteEdited_neverLoadsSilently()
{
    Random random(kSeed);
    for (const std::size_t kind : {2U, 5U}) {
        const std::string json = modelToJson(models()[kind]);
        for (std::size_t at = 0; at < json.size(); ++at) {
            std::vector<char> edits{static_cast<char>(random.below(256))};
            if (kind == 2U)
                edits.insert(edits.end(), {'0', '9', '"', ' ', '\0', static_cast<char>(json[at] ^ 1)});
            for (const char put : edits) {
                std::string edited = json;
                edited[at] = put;
                const auto back = modelFromJson(edited, "m.json");
                if (back.ok())
                    QCOMPARE(modelToJson(*back), json);
                else
                    QVERIFY(back.error().code == Errc::ModelDamaged ||
                            back.error().code == Errc::ModelEdited || back.error().code == Errc::ModelTooNew);
            }
        }
    }
}

using Change = std::function<void(Json &)>;
Q_DECLARE_METATYPE(Change)

void TestModelFile::read_signedButWrong_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<Change>("change");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *name, int kind, const Change &change, const QString &says) {
        QTest::newRow(name) << kind << change << says;
    };
    row(
        "missing", 1, [](Json &j) { j["parameters"].erase("bias_dps"); }, "parameters.bias_dps is missing");
    row(
        "wrong type", 1, [](Json &j) { j["simulated"] = 1; }, "simulated is not true or false");
    row(
        "text for number", 1, [](Json &j) { j["reference_temperature_C"] = "20"; },
        "reference_temperature_C is not");
    row(
        "null for number", 2, [](Json &j) { j["parameters"]["centre_dT_C"] = nullptr; },
        "not a finite number");
    row(
        "two numbers of three", 0, [](Json &j) { j["parameters"]["bias_dps"].erase(0); },
        "a list of 3 numbers");
    row(
        "row too short", 2, [](Json &j) { j["parameters"]["coefficients_dps"][3].erase(0); }, "4 rows of 3");
    row(
        "unknown kind", 1, [](Json &j) { j["kind"] = "oracle"; }, "does not know");
    row(
        "other features", 1, [](Json &j) { j["features"]["set"] = "dT,dT^2"; }, "features.set is not \"dT\"");
    row(
        "other units", 1, [](Json &j) { j["units"]["rate"] = "rad/s"; }, "units.rate is not \"dps\"");
    row(
        "range upside down", 1, [](Json &j) { j["trained_range"]["lowest_temperature_C"] = 1e3; },
        "above the highest");
    row(
        "unknown verdict", 1, [](Json &j) { j["verdicts"][0]["verdict"] = "maybe"; }, "verdicts[0].verdict");
    row(
        "two verdicts", 1, [](Json &j) { j["verdicts"].erase(2); }, "verdicts is not a list of 3");
    row(
        "seed below 0", 1, [](Json &j) { j["seed"] = -1; }, "seed is not a whole number");
    row(
        "sizes differ", 3, [](Json &j) { j["parameters"]["axes"][1]["hidden_bias"].push_back(1.0); },
        "parameters.axes[1].hidden_weights");
    row(
        "no hidden unit", 3, [](Json &j) { j["parameters"]["axes"][1]["hidden_bias"] = Json::array(); },
        "no size");
    row(
        "scale of 0", 3, [](Json &j) { j["parameters"]["normalisation"]["scale"][0] = 0.0; }, "not above 0");
    row(
        "absurd size", 4, [](Json &j) { j["parameters"]["widths"] = std::vector<double>(200000, 1.0); },
        "at most");
    row(
        "width below 0", 4, [](Json &j) { j["parameters"]["widths"] = {-1.0}; }, "widths");
    row(
        "more centres used than there are", 4, [](Json &j) { j["parameters"]["centre_count"][0] = 1000; },
        "centre_count");
    row(
        "model per axis in model per axis", 5,
        [](Json &j) { j["parameters"]["axes"][0]["kind"] = "per axis"; }, "again \"per axis\"");
    row(
        "damage within an axis", 5, [](Json &j) { j["parameters"]["axes"][2]["parameters"] = 3; },
        "parameters.axes[2].parameters");
    row(
        "parameters a list", 1, [](Json &j) { j["parameters"] = Json::array(); },
        "parameters is not an object");
}

void TestModelFile::read_signedButWrong()
{
    QFETCH(int, kind);
    QFETCH(Change, change);
    QFETCH(QString, says);
    Json document = Json::parse(modelToJson(models()[static_cast<std::size_t>(kind)]));
    QVERIFY(modelFromJson(signedAgain(document), "m.json").ok());
    change(document);
    const auto back = modelFromJson(signedAgain(document), "m.json");
    QVERIFY(!back.ok());
    QCOMPARE(back.error().code, Errc::ModelDamaged);
    const QString message = QString::fromStdString(back.error().message);
    QVERIFY2(message.contains("'m.json'") && message.contains(says) && message.endsWith("."),
             qPrintable(message));
    // Without a new checksum it is an edited file.
    const auto edited = modelFromJson(document.dump(), "m.json");
    QVERIFY(!edited.ok());
    QCOMPARE(edited.error().code, Errc::ModelEdited);
}

void TestModelFile::read_newerVersion_saysWhatToDo()
{
    Json document = Json::parse(modelToJson(models()[0]));
    document["version"] = 2;
    for (const std::string &json : {document.dump(), signedAgain(document)}) {
        const auto back = modelFromJson(json, "m.json");
        QVERIFY(!back.ok());
        QCOMPARE(back.error().code, Errc::ModelTooNew);
        QCOMPARE(
            back.error().message,
            std::string("The model file 'm.json' was written by a newer Driftbench (format 2, this one reads "
                        "1): update, or save it again with this version."));
    }
}

void TestModelFile::read_notAModel_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("says");
    QTest::newRow("empty") << QByteArray() << "is empty";
    QTest::newRow("text") << QByteArray("hello") << "is not JSON at byte 1";
    QTest::newRow("other JSON") << QByteArray("{\"a\": 1}") << "is not a Driftbench model";
    QTest::newRow("a number") << QByteArray("1") << "is not a Driftbench model";
    QTest::newRow("no version") << QByteArray("{\"format\": \"driftbench model\"}") << "version is not";
    QTest::newRow("no checksum") << QByteArray("{\"format\": \"driftbench model\", \"version\": 1}")
                                 << "crc32 is missing";
    QTest::newRow("number too large") << QByteArray("[1e999]") << "out of range";
    QTest::newRow("not UTF-8") << QByteArray("[\"\xff\"]") << "is not JSON at byte 3";
    QTest::newRow("nested") << QByteArray(100000, '[') + QByteArray(100000, ']') << "nested deeper";
    QTest::newRow("nested and cut") << QByteArray(1000000, '[') << "cut off";
}

void TestModelFile::read_notAModel()
{
    QFETCH(QByteArray, content);
    QFETCH(QString, says);
    const auto back = modelFromJson(content.toStdString(), "m.json");
    QVERIFY(!back.ok());
    QCOMPARE(back.error().code, Errc::ModelDamaged);
    QVERIFY2(QString::fromStdString(back.error().message).contains(says), back.error().message.c_str());
}

void TestModelFile::write_nameNotUtf8_readsBack()
{
    TrainedModel model = models()[0];
    model.trainedOn = {"run\xff"};
    const auto back = modelFromJson(modelToJson(model), "m.json");
    QVERIFY(back.ok());
    QCOMPARE(back->trainedOn[0], std::string("run\xEF\xBF\xBD"));
}

void TestModelFile::write_numberNotFinite_refusedOnReading()
{
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        TrainedModel model = models()[0];
        model.model = ConstantModel{Eigen::Vector3d(0.0, bad, 0.0)};
        const auto back = modelFromJson(modelToJson(model), "m.json");
        QVERIFY(!back.ok());
        QCOMPARE(back.error().code, Errc::ModelDamaged);
    }
}

void TestModelFile::saveAndLoad_file()
{
    const auto file = test::scratchFolder() / "model.json";
    const TrainedModel model = models()[5];
    QVERIFY(saveModel(model, file).ok());
    const auto back = loadModel(file);
    QVERIFY(back.ok());
    QVERIFY(samePredictions(*back, model));
}

void TestModelFile::load_badFiles_ownErrors()
{
    const auto folder = test::scratchFolder();
    QCOMPARE(loadModel(folder / "none.json").error().code, Errc::FileNotFound);
    QCOMPARE(loadModel(folder).error().code, Errc::FileUnreadable);
    std::ofstream(folder / "empty.json");
    QCOMPARE(loadModel(folder / "empty.json").error().code, Errc::ModelDamaged);
    const auto huge = folder / "huge.json";
    std::ofstream(huge) << "{}";
    std::filesystem::resize_file(huge, std::uintmax_t{100} << 20U);
    QCOMPARE(loadModel(huge).error().code, Errc::ModelDamaged);
    QVERIFY(!saveModel(models()[0], folder / "no" / "such" / "m.json").ok());
}

QTEST_APPLESS_MAIN(TestModelFile)
#include "tst_model_file.moc"
