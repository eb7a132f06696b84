// The exported parameters are read back as the autopilots read them and put through their published formulas,
// in their 32-bit floats:
//   PX4 src/modules/temperature_compensation/TemperatureCompensation.cpp, calc_thermal_offsets_3D
//   ArduPilot libraries/AP_InertialSensor/AP_InertialSensor_tempcal.cpp, correct_sensor and polynomial_eval,
//   and AP_InertialSensor_Backend.cpp, _rotate_and_correct_gyro
#include "engine/base/axes.h"
#include "engine/exports/cubic_refit.h"
#include "engine/exports/export_model.h"
#include "support/models_for_export.h"

#include <QMap>
#include <QTest>
#include <cmath>

using namespace driftbench;
using namespace driftbench::test;

class TestExportAutopilots : public QObject
{
    Q_OBJECT

private slots:
    void refitCubic_cubicModel_isRecovered();
    void refitCubic_randomModels_noOtherCubicIsCloser();
    void px4_randomModels_formulaGivesTheCubic();
    void px4_deviceId_isRequired();
    void ardupilot_randomModels_formulaGivesTheCubic();
    void ardupilot_beyondItsLimits_isClampedAndSaidSo();
    void ardupilot_narrowRange_isRefused();
    void autopilots_unknownGyro_isRefused_data();
    void autopilots_unknownGyro_isRefused();
    void autopilots_axisLeftOut_staysUntouched();
    void autopilots_modelWithoutRange_isRefused();
};

static constexpr std::array<bool, 3> kAllAxes{true, true, true};
using Parameters = QMap<QString, float>;

static Parameters px4Parameters(const std::string &text)
{
    Parameters parameters;
    for (const QString &line : QString::fromStdString(text).split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        if (line.startsWith(QLatin1Char('#')))
            continue;
        const QStringList fields = line.split(QLatin1Char('\t'));
        if (fields.size() != 5 || fields[0] != QLatin1String("1") || fields[1] != QLatin1String("1"))
            return {};
        const bool integer =
            fields[2].endsWith(QLatin1String("_ID")) || fields[2].endsWith(QLatin1String("ENABLE"));
        if (fields[4] != (integer ? QLatin1String("6") : QLatin1String("9")))
            return {};
        parameters[fields[2]] = fields[3].toFloat();
    }
    return parameters;
}

static Parameters ardupilotParameters(const std::string &text)
{
    Parameters parameters;
    for (const QString &line : QString::fromStdString(text).split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        if (!line.startsWith(QLatin1Char('#')))
            parameters[line.section(QLatin1Char(' '), 0, 0)] = line.section(QLatin1Char(' '), 1, 1).toFloat();
    }
    return parameters;
}

// Offset in rad/s that PX4 takes off.
static float px4Offset(const Parameters &p, const QString &gyro, int axis, float temperatureC)
{
    float d = temperatureC - p[gyro + QStringLiteral("TREF")];
    if (temperatureC > p[gyro + QStringLiteral("TMAX")])
        d = p[gyro + QStringLiteral("TMAX")] - p[gyro + QStringLiteral("TREF")];
    else if (temperatureC < p[gyro + QStringLiteral("TMIN")])
        d = p[gyro + QStringLiteral("TMIN")] - p[gyro + QStringLiteral("TREF")];
    const auto x = [&](int power) { return p[gyro + QStringLiteral("X%1_%2").arg(power).arg(axis)]; };
    return x(0) + x(1) * d + x(2) * (d * d) + x(3) * (d * d * d);
}

// What ArduPilot makes of a raw rate in rad/s.
static float ardupilotCorrected(const Parameters &p, int imu, int axis, float temperatureC, float raw)
{
    const QString tcal = QStringLiteral("INS_TCAL%1_").arg(imu);
    const QString letter = QStringLiteral("XYZ").mid(axis, 1);
    const auto clamped = [&](float t) {
        return std::clamp(t, p[tcal + QStringLiteral("TMIN")], p[tcal + QStringLiteral("TMAX")]);
    };
    const auto polynomial = [&](float d) {
        const auto c = [&](int k) { return p[tcal + QStringLiteral("GYR%1_").arg(k) + letter]; };
        return (c(1) + (c(2) + c(3) * d) * d) * d * 1.0e-6F;
    };
    const QString offset =
        (imu == 1 ? QStringLiteral("INS_GYROFFS_") : QStringLiteral("INS_GYR%1OFFS_").arg(imu)) + letter;
    const float calibratedAt = clamped(p[QStringLiteral("INS_GYR%1_CALTEMP").arg(imu)]);
    return raw - polynomial(clamped(temperatureC) - 35.0F) + polynomial(calibratedAt - 35.0F) - p[offset];
}

void TestExportAutopilots::refitCubic_cubicModel_isRecovered()
{
    Random random = announced(20261109);
    for (int i = 0; i < 50; ++i) {
        const TrainedModel model = randomCubic(random);
        const double centre = random.uniform(-50.0, 90.0);
        const CubicRefit cubic =
            refitCubic(model, kAllAxes, centre, model.lowestTemperatureC, model.highestTemperatureC);
        QVERIFY(cubic.largestLossDps.maxCoeff() < 1e-10);
        const auto &original = std::get<PolynomialModel>(model.model);
        const double shift = model.referenceTemperatureC + original.centreDeltaT - centre;
        QVERIFY((cubic.coefficientsDps.row(3) - original.coefficients.row(3)).norm() < 1e-14);
        // c2 in the other centre: a2 - 3 a3 shift
        QVERIFY((cubic.coefficientsDps.row(2) - original.coefficients.row(2) +
                 3.0 * shift * original.coefficients.row(3))
                    .norm() < 1e-12);
    }
}

void TestExportAutopilots::refitCubic_randomModels_noOtherCubicIsCloser()
{
    Random random = announced(20261110);
    for (int i = 0; i < 20; ++i) {
        const TrainedModel model = randomRbf(random);
        const double low = model.lowestTemperatureC;
        const double high = model.highestTemperatureC;
        const CubicRefit cubic = refitCubic(model, kAllAxes, 35.0, low, high);
        // The residual of a least-squares fit is orthogonal to every cubic.
        const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(2001, -1.0, 1.0);
        const Eigen::VectorXd temperatureC = (0.5 * (low + high) + 0.5 * (high - low) * x.array()).matrix();
        Eigen::MatrixX3d residual = predictAtTemperature(model, temperatureC).tdeDps;
        for (Eigen::Index k = 0; k < residual.rows(); ++k)
            residual.row(k) -= cubic.tdeDps(temperatureC[k]).transpose();
        for (int power = 0; power < 4; ++power)
            QVERIFY((x.array().pow(power).matrix().transpose() * residual).cwiseAbs().maxCoeff() < 1e-7);
        const double rms = std::sqrt(residual.col(1).squaredNorm() / 2001.0);
        QVERIFY(std::abs(rms - cubic.rmsLossDps[1]) < 1e-9);
        // The root is so steep at the reference temperature that the last digit of T shows.
        QVERIFY(std::abs(residual.col(1).cwiseAbs().maxCoeff() - cubic.largestLossDps[1]) < 1e-6);
    }
}

void TestExportAutopilots::px4_randomModels_formulaGivesTheCubic()
{
    Random random = announced(20261111);
    for (int gyro = 0; gyro < 4; ++gyro) {
        const TrainedModel model = randomModel(random);
        const auto exported = exportModel(model, ExportFormat::Px4, {.gyro = gyro});
        QVERIFY(exported.ok());
        const Parameters parameters = px4Parameters(exported->text);
        QCOMPARE(parameters.size(), 1 + 1 + 3 + 12);
        const QString prefix = QStringLiteral("TC_G%1_").arg(gyro);
        QCOMPARE(parameters[QStringLiteral("TC_G_ENABLE")], 1.0F);
        QCOMPARE(parameters[prefix + QStringLiteral("ID")], 3408138.0F);
        const double low = model.lowestTemperatureC;
        const double high = model.highestTemperatureC;
        const CubicRefit cubic = refitCubic(model, kAllAxes, 0.5 * (low + high), low, high);
        for (double t = low - 20.0; t < high + 20.0; t += 0.37) {
            for (int axis = 0; axis < 3; ++axis) {
                const double dps =
                    px4Offset(parameters, prefix, axis, static_cast<float>(t)) * kDegreesPerRadian;
                QVERIFY(std::abs(dps - cubic.tdeDps(t)[axis]) < 1e-4);
            }
        }
    }
}

void TestExportAutopilots::px4_deviceId_isRequired()
{
    Random random(3);
    TrainedModel model = randomCubic(random);
    for (const char *serial : {"", "SIM-0001", "0", "12x", "99999999999"}) {
        model.sensor.serial = serial;
        const auto refused = exportModel(model, ExportFormat::Px4);
        QVERIFY2(!refused.ok(), serial);
        QCOMPARE(refused.error().code, Errc::InvalidOption);
        QVERIFY(refused.error().message.find("--device-id") != std::string::npos);
    }
    // Ids above 2^31 keep their bits in PX4's signed parameter.
    const auto exported = exportModel(model, ExportFormat::Px4, {.deviceId = 4294967295U});
    QVERIFY(exported.ok());
    QVERIFY(exported->text.find("\tTC_G0_ID\t-1\t6\n") != std::string::npos);
}

void TestExportAutopilots::ardupilot_randomModels_formulaGivesTheCubic()
{
    Random random = announced(20261112);
    for (int imu = 1; imu <= 3; ++imu) {
        TrainedModel model = randomModel(random);
        model.highestTemperatureC = std::min(model.highestTemperatureC, 80.0);
        const auto exported = exportModel(model, ExportFormat::ArduPilot, {.gyro = imu});
        QVERIFY(exported.ok());
        const Parameters parameters = ardupilotParameters(exported->text);
        QCOMPARE(parameters.size(), 3 + 9 + 1 + 3);
        QCOMPARE(parameters[QStringLiteral("INS_TCAL%1_ENABLE").arg(imu)], 1.0F);
        const double low = model.lowestTemperatureC;
        const double high = model.highestTemperatureC;
        const CubicRefit cubic = refitCubic(model, kAllAxes, 35.0, low, high);
        for (double t = low - 20.0; t < high + 20.0; t += 0.37) {
            for (int axis = 0; axis < 3; ++axis) {
                const float corrected =
                    ardupilotCorrected(parameters, imu, axis, static_cast<float>(t), 0.5F);
                const double tdeDps = (0.5 - corrected) * kDegreesPerRadian;
                QVERIFY(std::abs(tdeDps - cubic.tdeDps(t)[axis]) < 1e-4);
            }
        }
    }
}

void TestExportAutopilots::ardupilot_beyondItsLimits_isClampedAndSaidSo()
{
    Random random(5);
    TrainedModel model = randomCubic(random);
    model.lowestTemperatureC = model.referenceTemperatureC = -75.0;
    model.highestTemperatureC = 85.0;
    const auto exported = exportModel(model, ExportFormat::ArduPilot);
    QVERIFY(exported.ok());
    const Parameters parameters = ardupilotParameters(exported->text);
    QCOMPARE(parameters[QStringLiteral("INS_TCAL1_TMIN")], -70.0F);
    QCOMPARE(parameters[QStringLiteral("INS_TCAL1_TMAX")], 80.0F);
    QCOMPARE(parameters[QStringLiteral("INS_GYR1_CALTEMP")], -70.0F);
    // What is lost beyond the limits counts: the model goes on from 80 to 85 degrees, ArduPilot does not.
    const Prediction ends = predictAtTemperature(model, Eigen::Vector2d(80.0, 85.0));
    const double lost = std::abs(ends.tdeDps(1, 0) - ends.tdeDps(0, 0));
    const CubicRefit cubic = refitCubic(model, kAllAxes, 35.0, -70.0, 80.0);
    QVERIFY(cubic.largestLossDps[0] >= lost - 1e-9);
    QCOMPARE(exported->notes.size(), std::size_t(2));
    QVERIFY(exported->notes[1].find("80") != std::string::npos);
}

void TestExportAutopilots::ardupilot_narrowRange_isRefused()
{
    Random random(6);
    TrainedModel model = randomCubic(random);
    model.lowestTemperatureC = 75.0;
    model.highestTemperatureC = 120.0;
    const auto refused = exportModel(model, ExportFormat::ArduPilot);
    QVERIFY(!refused.ok());
    QCOMPARE(refused.error().code, Errc::ModelNotUsableHere);
}

void TestExportAutopilots::autopilots_unknownGyro_isRefused_data()
{
    QTest::addColumn<int>("format");
    QTest::addColumn<int>("gyro");
    QTest::newRow("px4 below") << static_cast<int>(ExportFormat::Px4) << -1;
    QTest::newRow("px4 above") << static_cast<int>(ExportFormat::Px4) << 4;
    QTest::newRow("ardupilot below") << static_cast<int>(ExportFormat::ArduPilot) << 0;
    QTest::newRow("ardupilot above") << static_cast<int>(ExportFormat::ArduPilot) << 4;
}

void TestExportAutopilots::autopilots_unknownGyro_isRefused()
{
    QFETCH(int, format);
    QFETCH(int, gyro);
    Random random(7);
    const auto refused = exportModel(randomCubic(random), static_cast<ExportFormat>(format), {.gyro = gyro});
    QVERIFY(!refused.ok());
    QCOMPARE(refused.error().code, Errc::InvalidOption);
}

void TestExportAutopilots::autopilots_axisLeftOut_staysUntouched()
{
    Random random(8);
    TrainedModel model = randomCubic(random);
    model.highestTemperatureC = std::min(model.highestTemperatureC, 80.0);
    model.verdicts[2] = Verdict::NotRepeatable;
    const Parameters px4 = px4Parameters(exportModel(model, ExportFormat::Px4)->text);
    const Parameters ardupilot = ardupilotParameters(exportModel(model, ExportFormat::ArduPilot)->text);
    QVERIFY(!ardupilot.contains(QStringLiteral("INS_GYROFFS_Z")));
    QVERIFY(ardupilot.contains(QStringLiteral("INS_GYROFFS_Y")));
    for (float t = -60.0F; t < 100.0F; t += 1.0F) {
        QCOMPARE(px4Offset(px4, QStringLiteral("TC_G0_"), 2, t), 0.0F);
        QCOMPARE(ardupilotCorrected(ardupilot, 1, 2, t, 0.5F), 0.5F);
    }
}

void TestExportAutopilots::autopilots_modelWithoutRange_isRefused()
{
    Random random(9);
    TrainedModel model = randomCubic(random);
    model.highestTemperatureC = model.lowestTemperatureC;
    for (const ExportFormat format : {ExportFormat::Px4, ExportFormat::ArduPilot}) {
        const auto refused = exportModel(model, format);
        QVERIFY(!refused.ok());
        QCOMPARE(refused.error().code, Errc::ModelNotUsableHere);
    }
}

QTEST_APPLESS_MAIN(TestExportAutopilots)
#include "tst_export_autopilots.moc"
