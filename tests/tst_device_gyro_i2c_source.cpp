// A gyro behind each of the bridges as a sample source: what it records is what the gyro model measured, each
// sample once, in order, at its time, and what is missing is counted.
#include "device/gyros/gyro_i2c_source.h"
#include "support/bridges.h"
#include "support/gyro_model.h"
#include "support/thermometer_models.h"

#include <QTest>
#include <cmath>

using namespace driftbench;
using namespace driftbench::test;

class TestDeviceGyroI2cSource : public QObject
{
    Q_OBJECT

private slots:
    void fifoClock_drawnLevels_findsPeriodAndPhase();
    void samples_everyBridgeGyroAndRate_areThoseMeasured_data();
    void samples_everyBridgeGyroAndRate_areThoseMeasured();
    void samples_slowReader_lossIsCountedExactly_data() { bridges(); }
    void samples_slowReader_lossIsCountedExactly();
    void transfers_thatFail_areOvercomeAndCounted_data() { bridges(); }
    void transfers_thatFail_areOvercomeAndCounted();
    void bus_thatKeepsFailing_endsTheRunWithItsError_data() { bridges(); }
    void bus_thatKeepsFailing_endsTheRunWithItsError();
    void bridge_unpluggedAnywhere_deliversWhatCameBefore_data() { bridges(); }
    void bridge_unpluggedAnywhere_deliversWhatCameBefore();
    void answers_randomBytes_endOrGoOn_data() { bridges(); }
    void answers_randomBytes_endOrGoOn();
    void temperature_external_isPreferredAndInStep();
    void temperature_die_hasOffsetAndScale();
    void temperature_warmUp_confirmsTheSign();
    void temperature_deadThermometer_isAnError();
    void saturation_isCountedAndToldOnce();
    void open_wrongSensor_isNamed();
    void open_optionsNobodyHas_areRefused();
    void info_saysWhatIsMeasured();

private:
    static void bridges();
};

namespace {

// Which sample a row holds, as GyroModel::numbered made it.
std::int64_t numberOf(const Eigen::RowVector3d &rateDps, double sensitivityDps)
{
    const auto low = static_cast<std::int64_t>(std::llround(rateDps[0] / sensitivityDps));
    const auto high = static_cast<std::int64_t>(std::llround(rateDps[2] / sensitivityDps)) + 1;
    return std::llround(rateDps[1] / sensitivityDps) == -low ? high * 30011 + low : -1;
}

struct Row
{
    double timeS;
    double temperatureC;
    Eigen::RowVector3d rateDps;
};

class Recorder final : public SampleSink
{
public:
    explicit Recorder(std::int64_t wanted) : m_wanted(wanted) {}

    std::vector<Row> rows;
    std::vector<SampleGap> gaps;
    std::vector<std::string> events;
    std::function<void(std::int64_t)> onBlock; // with the number of rows so far

    Flow samples(const SampleBlock &block, Eigen::Index count) override
    {
        m_consecutive = m_consecutive && block.firstSample == static_cast<std::int64_t>(rows.size());
        for (Eigen::Index i = 0; i < count; ++i)
            rows.push_back({block.timeS[i], block.temperatureC[i], block.rateDps.row(i)});
        if (onBlock)
            onBlock(static_cast<std::int64_t>(rows.size()));
        return static_cast<std::int64_t>(rows.size()) < m_wanted ? Flow::Continue : Flow::Stop;
    }
    void gap(const SampleGap &gap) override
    {
        gaps.push_back(gap);
        gapAt.push_back(rows.size());
    }
    void event(const std::string &sentence) override { events.push_back(sentence); }

    bool told(const char *part) const
    {
        return std::any_of(events.begin(), events.end(),
                           [&](const std::string &event) { return event.find(part) != std::string::npos; });
    }
    bool firstSamplesAreConsecutive() const { return m_consecutive; }
    std::vector<std::size_t> gapAt; // rows before each gap

private:
    std::int64_t m_wanted;
    bool m_consecutive = true;
};

struct Bench
{
    Bench(const QString &bridgeName, const QString &model, double rateFactor = 1.0)
        : bridge(makeBridge(bridgeName.toStdString()))
        , clock(&bridge->clock)
        , gyro(model.toStdString(), bridge->clock, rateFactor)
        , tmp117(bridge->clock)
    {
        bridge->wires.attach(model == "L3GD20H" ? 0x6B : 0x68, gyro);
    }

    std::unique_ptr<GyroI2cSource> open(const GyroI2cOptions &options = {})
    {
        Result<std::unique_ptr<GyroI2cSource>> source =
            GyroI2cSource::open(std::move(bridge->bus), options, *clock);
        return source ? std::move(*source) : nullptr;
    }

    std::unique_ptr<Bridge> bridge;
    SimulatedClock *clock;
    GyroModel gyro;
    Tmp117Model tmp117;
};

GyroI2cOptions atRate(double rateHz)
{
    GyroI2cOptions options;
    options.gyro.rateHz = rateHz;
    return options;
}

constexpr double kSensitivityDps = 0.00875;

bool endsWith(const Recorder &recorder, const driftbench::test::Counts &counts)
{
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (recorder.rows.back().rateDps[axis] != counts[static_cast<std::size_t>(axis)] * kSensitivityDps)
            return false;
    }
    return true;
}

// Empty if all samples are there, those missing are gaps of the right size, and times go forward.
QString flaw(const Recorder &recorder)
{
    if (!recorder.firstSamplesAreConsecutive())
        return "blocks do not follow each other";
    std::size_t gap = 0;
    for (std::size_t i = 0; i < recorder.rows.size(); ++i) {
        const std::int64_t number = numberOf(recorder.rows[i].rateDps, kSensitivityDps);
        if (number < 0)
            return QString("row %1 is no sample").arg(i);
        const bool gapHere = gap < recorder.gapAt.size() && recorder.gapAt[gap] == i;
        const std::int64_t lost = gapHere ? recorder.gaps[gap].lostSamples : 0;
        if (i > 0) {
            const std::int64_t before = numberOf(recorder.rows[i - 1].rateDps, kSensitivityDps);
            if (number != before + 1 + lost)
                return QString("row %1: sample %2 after %3, %4 said to be lost")
                    .arg(i)
                    .arg(number)
                    .arg(before)
                    .arg(lost);
            if (recorder.rows[i].timeS <= recorder.rows[i - 1].timeS)
                return QString("row %1: time goes backwards").arg(i);
        }
        if (gapHere) {
            if (recorder.gaps[gap].startS != recorder.rows[i - 1].timeS ||
                recorder.gaps[gap].endS != recorder.rows[i].timeS)
                return QString("row %1: the gap is not between its neighbours").arg(i);
            ++gap;
        }
    }
    return gap == recorder.gaps.size() ? QString() : "a gap without samples after it";
}

} // namespace

void TestDeviceGyroI2cSource::bridges()
{
    QTest::addColumn<QString>("name");
    for (const char *name : kBridgeNames)
        QTest::newRow(name) << QString(name);
}

void TestDeviceGyroI2cSource::fifoClock_drawnLevels_findsPeriodAndPhase()
{
    for (const double factor : {0.93, 1.0, 1.07}) {
        const double rateHz = 100.0 * factor;
        const double beganS = 17.3;
        FifoClock clock(100.0);
        Random random(31);
        double nowS = beganS + 0.1;
        double worst = 0.0;
        for (int look = 0; look < 4000; ++look, nowS += random.uniform(0.05, 0.15)) {
            const auto taken = static_cast<std::int64_t>(std::floor((nowS - beganS) * rateHz));
            if (look > 300) {
                worst = std::max(worst, std::abs(clock.takenAt(nowS) + 0.0 - (nowS - beganS) * rateHz + 0.5));
                worst = std::max(worst,
                                 std::abs(clock.timeS(taken) - (beganS + (taken + 1.0) / rateHz)) * rateHz);
            }
            clock.see(taken, nowS, 0.001);
        }
        QVERIFY2(worst < 0.15, qPrintable(QString("%1 samples off at %2").arg(worst).arg(factor)));
        QVERIFY(std::abs(clock.periodS() * rateHz - 1.0) < 1e-4);
    }
}

void TestDeviceGyroI2cSource::samples_everyBridgeGyroAndRate_areThoseMeasured_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("model");
    QTest::addColumn<double>("rateHz");
    QTest::addColumn<double>("factor");
    for (const char *name : kBridgeNames) {
        for (const char *model : {"L3GD20H", "I3G4250D"}) {
            for (const double rateHz : {100.0, 200.0, 400.0, 800.0}) {
                for (const double factor : {0.95, 1.0, 1.05})
                    QTest::addRow("%s %s %g Hz x %g", name, model, rateHz, factor)
                        << QString(name) << QString(model) << rateHz << factor;
            }
        }
        QTest::addRow("%s L3GD20H 12.5 Hz", name) << QString(name) << QString("L3GD20H") << 12.5 << 1.02;
    }
}

void TestDeviceGyroI2cSource::samples_everyBridgeGyroAndRate_areThoseMeasured()
{
    QFETCH(QString, name);
    QFETCH(QString, model);
    QFETCH(double, rateHz);
    QFETCH(double, factor);
    Bench bench(name, model, factor);
    if (rateHz < 800.0) // pieces cost time
        bench.bridge->chip->splitData(5);
    const auto source = bench.open(atRate(rateHz));
    QVERIFY(source != nullptr);
    Recorder recorder(6000);
    const Result<SourceStats> stats = source->run(recorder, {});
    QVERIFY2(stats.ok(), stats.ok() ? "" : stats.error().message.c_str());
    QCOMPARE(flaw(recorder), QString());
    QCOMPARE(stats->samples, static_cast<std::int64_t>(recorder.rows.size()));
    QCOMPARE(stats->lostSamples, std::int64_t(0));
    QVERIFY(std::abs(stats->clockDriftPpm - (factor - 1.0) * 1e6) < 2000.0);
    // Once the true rate is found, every sample has its time, but for one offset common to all.
    const std::int64_t first = numberOf(recorder.rows[0].rateDps, kSensitivityDps);
    const auto error = [&](std::size_t i) {
        const double trueS =
            bench.gyro.timeOfSampleS(first + static_cast<std::int64_t>(i)) - bench.gyro.timeOfSampleS(first);
        return (recorder.rows[i].timeS - trueS) * bench.gyro.trueRateHz();
    };
    for (std::size_t i = 3000; i < recorder.rows.size(); ++i)
        QVERIFY2(std::abs(error(i) - error(3000)) < 0.5,
                 qPrintable(QString("row %1: %2").arg(i).arg(error(i))));
    QVERIFY(std::abs(error(3000)) < 2.0);
}

void TestDeviceGyroI2cSource::samples_slowReader_lossIsCountedExactly()
{
    QFETCH(QString, name);
    for (const double rateHz : {100.0, 200.0, 400.0}) {
        for (const std::uint64_t seed : {41, 42, 43}) {
            Bench bench(name, "L3GD20H", 1.03);
            const auto source = bench.open(atRate(rateHz));
            QVERIFY(source != nullptr);
            Recorder recorder(20000);
            Random random(seed);
            std::int64_t nextStall = 3000;
            std::int64_t overwrittenBefore = -1; // while the source was set up
            recorder.onBlock = [&](std::int64_t rows) {
                if (overwrittenBefore < 0)
                    overwrittenBefore = bench.gyro.overwritten();
                if (rows < nextStall || rows > 19000) // the last gap has samples after it
                    return;
                nextStall = rows + 700;
                bench.clock->waitS(random.uniform(0.01, 1.0)); // the host is busy
            };
            const Result<SourceStats> stats = source->run(recorder, {});
            QVERIFY(stats.ok());
            QVERIFY2(flaw(recorder).isEmpty(),
                     qPrintable(QString("%1 Hz, seed %2: %3").arg(rateHz).arg(seed).arg(flaw(recorder))));
            QVERIFY(recorder.gaps.size() >= 6);
            for (const SampleGap &gap : recorder.gaps)
                QCOMPARE(gap.cause, GapCause::DeviceOverrun);
            QCOMPARE(stats->lostSamples, bench.gyro.overwritten() - overwrittenBefore);
            QCOMPARE(stats->gaps, static_cast<std::int64_t>(recorder.gaps.size()));
        }
    }
}

void TestDeviceGyroI2cSource::transfers_thatFail_areOvercomeAndCounted()
{
    QFETCH(QString, name);
    Bench bench(name, "I3G4250D", 0.98);
    const auto source = bench.open(atRate(100.0));
    QVERIFY(source != nullptr);
    Recorder recorder(8000);
    std::int64_t nextFault = 2000;
    bool stuck = false;
    recorder.onBlock = [&](std::int64_t rows) {
        if (rows < nextFault)
            return;
        nextFault = rows + 700;
        if (stuck)
            bench.bridge->wires.holdLow(1);
        else
            bench.bridge->wires.refuseNext(1);
        stuck = !stuck;
    };
    const Result<SourceStats> stats = source->run(recorder, {});
    QVERIFY(stats.ok());
    QCOMPARE(flaw(recorder), QString());
    QVERIFY(recorder.told("Nothing answers at I2C address 0x68"));
    QVERIFY(recorder.told("is stuck"));
    for (const SampleGap &gap : recorder.gaps)
        QCOMPARE(gap.cause, GapCause::ReportsLost);
}

void TestDeviceGyroI2cSource::bus_thatKeepsFailing_endsTheRunWithItsError()
{
    QFETCH(QString, name);
    for (const bool heldLow : {false, true}) {
        Bench bench(name, "L3GD20H");
        const auto source = bench.open(atRate(100.0));
        QVERIFY(source != nullptr);
        Recorder recorder(1000000);
        recorder.onBlock = [&](std::int64_t rows) {
            if (rows > 1000)
                heldLow ? bench.bridge->wires.holdLow(1000000) : bench.bridge->wires.detach(0x6B);
        };
        const Result<SourceStats> stats = source->run(recorder, {});
        QVERIFY(!stats.ok());
        QCOMPARE(stats.error().code, heldLow ? Errc::BusStuck : Errc::BusNoAcknowledge);
        QCOMPARE(flaw(recorder), QString());
        // What was fetched before the bus failed has been delivered.
        QVERIFY(endsWith(recorder, bench.gyro.lastPopped()));
    }
}

void TestDeviceGyroI2cSource::bridge_unpluggedAnywhere_deliversWhatCameBefore()
{
    QFETCH(QString, name);
    for (int calls = 0; calls < 60; ++calls) {
        Bench bench(name, "L3GD20H");
        const auto source = bench.open(atRate(100.0));
        QVERIFY(source != nullptr);
        Recorder recorder(1000000);
        recorder.onBlock = [&](std::int64_t rows) {
            if (rows > 200) {
                bench.bridge->chip->unplugAfter(calls);
                recorder.onBlock = {};
            }
        };
        const Result<SourceStats> stats = source->run(recorder, {});
        QVERIFY(!stats.ok());
        QCOMPARE(stats.error().code, Errc::DeviceUnplugged);
        QCOMPARE(flaw(recorder), QString());
        QVERIFY(recorder.rows.size() > 200);
    }
}

// Wrong bytes can't be told from right ones everywhere; what counts is that the run stays within its buffers
// (sanitizers) and can always be stopped.
void TestDeviceGyroI2cSource::answers_randomBytes_endOrGoOn()
{
    QFETCH(QString, name);
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Bench bench(name, "L3GD20H");
        const auto source = bench.open(atRate(400.0));
        QVERIFY(source != nullptr);
        Recorder recorder(5000);
        recorder.onBlock = [&](std::int64_t rows) {
            if (rows > 500) {
                bench.bridge->chip->answerWithRandomBytes(seed);
                recorder.onBlock = {};
            }
        };
        const Result<SourceStats> stats = source->run(recorder, {});
        QVERIFY(stats.ok() || !stats.error().message.empty());
        QVERIFY(recorder.rows.size() > 500);
        for (std::size_t i = 1; i < recorder.rows.size(); ++i)
            QVERIFY(recorder.rows[i].timeS > recorder.rows[i - 1].timeS);
    }
}

void TestDeviceGyroI2cSource::temperature_external_isPreferredAndInStep()
{
    Bench bench("MCP2221A", "L3GD20H");
    const double startS = bench.clock->nowS();
    const auto chamberC = [startS](double timeS) { return 20.0 + 0.5 * (timeS - startS); };
    bench.tmp117.temperatureC = chamberC;
    bench.bridge->wires.attach(0x48, bench.tmp117);
    const auto source = bench.open(atRate(100.0));
    QVERIFY(source != nullptr);
    Recorder recorder(3000);
    QVERIFY(source->run(recorder, {}).ok());
    QVERIFY(recorder.told("TMP117"));
    const std::int64_t first = numberOf(recorder.rows[0].rateDps, kSensitivityDps);
    for (std::size_t i = 0; i < recorder.rows.size(); ++i) {
        const double trueS = bench.gyro.timeOfSampleS(first + static_cast<std::int64_t>(i));
        // A conversion takes 1 s, and a reading serves until the next one 0.5 s later.
        const double ageS = (chamberC(trueS) - recorder.rows[i].temperatureC) / 0.5;
        QVERIFY2(ageS > -0.05 && ageS < 1.8, qPrintable(QString("row %1: %2 s old").arg(i).arg(ageS)));
    }
}

void TestDeviceGyroI2cSource::temperature_die_hasOffsetAndScale()
{
    Bench bench("CP2112", "I3G4250D");
    bench.gyro.dieCount = [](double) { return -15; };
    GyroI2cOptions options = atRate(100.0);
    options.temperature.dieOffsetC = 10.0;
    Recorder falling(100);
    QVERIFY(bench.open(options)->run(falling, {}).ok());
    QCOMPARE(falling.rows.back().temperatureC, 25.0);
    QVERIFY(falling.told("relative"));

    Bench other("CP2112", "I3G4250D");
    other.gyro.dieCount = [](double) { return -15; };
    other.bridge->wires.attach(0x48, other.tmp117);
    options.temperature.dieCPerCount = 1.0;
    options.temperature.useExternal = false;
    Recorder rising(100);
    QVERIFY(other.open(options)->run(rising, {}).ok());
    QCOMPARE(rising.rows.back().temperatureC, -5.0);
}

void TestDeviceGyroI2cSource::temperature_warmUp_confirmsTheSign()
{
    for (const double sign : {-1.0, 1.0}) {
        Bench bench("FT260", "L3GD20H");
        const double startS = bench.clock->nowS();
        bench.tmp117.temperatureC = [startS](double timeS) { return 20.0 + 0.2 * (timeS - startS); };
        bench.gyro.dieCount = [&, startS](double timeS) {
            return static_cast<int>(std::round(3.0 + sign * 0.2 * (timeS - startS)));
        };
        bench.bridge->wires.attach(0x4A, bench.tmp117);
        const auto source = bench.open(atRate(100.0));
        QVERIFY(source != nullptr);
        Recorder recorder(4000);
        QVERIFY(source->run(recorder, {}).ok());
        QVERIFY(recorder.told(sign < 0.0 ? "confirms its sign" : "set its scale to 1.0"));
    }
}

void TestDeviceGyroI2cSource::temperature_deadThermometer_isAnError()
{
    Bench bench("CP2112", "L3GD20H");
    bench.tmp117.temperatureC = [](double) { return -256.0; }; // as before its first conversion, for ever
    bench.bridge->wires.attach(0x48, bench.tmp117);
    const auto source = bench.open(atRate(100.0));
    QVERIFY(source != nullptr);
    Recorder recorder(100);
    const Result<SourceStats> stats = source->run(recorder, {});
    QVERIFY(!stats.ok());
    QCOMPARE(stats.error().code, Errc::DeviceSilent);
    QVERIFY(stats.error().message.find("0x48") != std::string::npos);

    Bench pulled("CP2112", "L3GD20H");
    pulled.bridge->wires.attach(0x48, pulled.tmp117);
    const auto other = pulled.open(atRate(100.0));
    QVERIFY(other != nullptr);
    Recorder longer(1000000);
    longer.onBlock = [&](std::int64_t rows) {
        if (rows > 500)
            pulled.bridge->wires.detach(0x48);
    };
    const Result<SourceStats> ended = other->run(longer, {});
    QVERIFY(!ended.ok());
    QCOMPARE(ended.error().code, Errc::BusNoAcknowledge);
    QVERIFY(ended.error().message.find("0x48") != std::string::npos);
    QVERIFY(endsWith(longer, pulled.gyro.lastPopped()));
}

void TestDeviceGyroI2cSource::saturation_isCountedAndToldOnce()
{
    Bench bench("CP2112", "L3GD20H");
    bench.gyro.counts = [](std::int64_t sample) {
        return driftbench::test::Counts{0, static_cast<std::int16_t>(sample % 10 == 0 ? 32767 : 5), 0};
    };
    const auto source = bench.open(atRate(100.0));
    QVERIFY(source != nullptr);
    Recorder recorder(1000);
    const Result<SourceStats> stats = source->run(recorder, {});
    QVERIFY(stats.ok());
    QVERIFY(std::abs(static_cast<double>(stats->saturatedSamples) -
                     0.1 * static_cast<double>(stats->samples)) < 2.0);
    QCOMPARE(
        std::count_if(recorder.events.begin(), recorder.events.end(),
                      [](const std::string &event) { return event.find("axis y") != std::string::npos; }),
        1);
    QVERIFY(!recorder.told("axis x"));
}

void TestDeviceGyroI2cSource::open_wrongSensor_isNamed()
{
    Bench bench("MCP2221A", "I3G4250D");
    GyroI2cOptions options;
    options.model = "L3GD20H";
    options.address = 0x68;
    const auto source = GyroI2cSource::open(std::move(bench.bridge->bus), options, *bench.clock);
    QVERIFY(!source.ok());
    QCOMPARE(source.error().code, Errc::WrongSensor);
    QVERIFY(source.error().message.find("I3G4250D") != std::string::npos);
}

void TestDeviceGyroI2cSource::open_optionsNobodyHas_areRefused()
{
    const auto code = [](const GyroI2cOptions &options) {
        Bench bench("CP2112", "L3GD20H");
        const auto source = GyroI2cSource::open(std::move(bench.bridge->bus), options, *bench.clock);
        return source ? Errc::Cancelled : source.error().code;
    };
    GyroI2cOptions options;
    options.model = "MPU6050";
    QCOMPARE(code(options), Errc::InvalidOption);
    options.model.clear();
    options.address = 0x50;
    QCOMPARE(code(options), Errc::InvalidOption);
    QCOMPARE(code(atRate(5000.0)), Errc::InvalidOption);
    options = {};
    options.model = "I3G4250D";
    QCOMPARE(code(options), Errc::BusNoAcknowledge);
}

void TestDeviceGyroI2cSource::info_saysWhatIsMeasured()
{
    Bench bench("CP2112", "L3GD20H");
    GyroI2cOptions options = atRate(150.0);
    options.serial = "board 7";
    options.address = 0x6B;
    options.gyro.rangeDps = 400.0;
    const auto source = bench.open(options);
    QVERIFY(source != nullptr);
    QCOMPARE(source->info().name, std::string("CP2112 00A1B2C3 with L3GD20H at 0x6b"));
    QCOMPARE(source->info().sensor.model, std::string("L3GD20H"));
    QCOMPARE(source->info().sensor.serial, std::string("board 7"));
    QCOMPARE(source->info().sampleRateHz, 200.0);
    QCOMPARE(source->info().rangeDps, 500.0);
    QVERIFY(!source->info().simulated && !source->info().compensated);
}

QTEST_APPLESS_MAIN(TestDeviceGyroI2cSource)
#include "tst_device_gyro_i2c_source.moc"
