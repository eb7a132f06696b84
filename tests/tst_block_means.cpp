// Long recordings as means of their samples: the statistics are those of the samples, and what is wrong with
// a recording is still there.
#include "engine/base/random.h"
#include "engine/evaluation/scoring.h"
#include "engine/features/run_features.h"
#include "engine/models/linear_model.h"
#include "engine/recording/block_means.h"
#include "engine/recording/quality.h"
#include "support/synthetic_recording.h"

#include <QTest>

#include <bit>
#include <limits>

using namespace driftbench;
using namespace driftbench::test;

class TestBlockMeans : public QObject
{
    Q_OBJECT

private slots:
    void samplesAPoint_anyLength_isTheSmallestPowerOfTwo();
    void shortened_fewSamples_isTheRecordingItself();
    void means_anyRecordingInAnyParts_keepTheSums();
    void features_ofMeans_areThoseOfTheSamples();
    void standstill_keepsItsBits();
    void gap_endsAPoint();
    void backwardTime_isStillThere();
    void nonFinite_isAPointOfItsOwn();
    void repeatedTimes_areLeftOutAndTold();
    void temperatureStairs_keepTheirReadings();
    void checkRun_means_areToldAndDriftIsStillFound();
    void checkRun_fastShaking_isStillMasked();
};

static Random announced(std::uint64_t seed)
{
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    return Random(seed);
}

// In parts of any size, as a file's chunks come.
static Recording meansOf(const Recording &recording, std::int64_t each, Random &random)
{
    BlockMeans means(each, 1);
    for (Eigen::Index at = 0; at < recording.size();) {
        const auto count =
            std::min<Eigen::Index>(static_cast<Eigen::Index>(random.below(3000)), recording.size() - at);
        means.add(recording.timeS.data() + at, recording.temperatureC.data() + at,
                  {recording.rateDps.col(0).data() + at, recording.rateDps.col(1).data() + at,
                   recording.rateDps.col(2).data() + at},
                  count);
        at += count;
    }
    return means.finish(recording.info);
}

static Recording meansOf(const Recording &recording, std::int64_t each)
{
    Random random(1);
    return meansOf(recording, each, random);
}

static RunFeatures featuresOf(Recording recording)
{
    Run run;
    run.name = "a";
    run.mask = Mask(recording.size());
    run.recording = std::make_shared<const Recording>(std::move(recording));
    return makeRunFeatures(run, 0.0);
}

static bool near(const Eigen::Vector3d &a, const Eigen::Vector3d &b, double relative)
{
    return ((a - b).array().abs() <= relative * b.array().abs()).all();
}

void TestBlockMeans::samplesAPoint_anyLength_isTheSmallestPowerOfTwo()
{
    Random random = announced(20261126);
    for (int trial = 0; trial < 1000; ++trial) {
        const auto most = static_cast<std::int64_t>(1 + random.below(1000));
        const auto samples = static_cast<std::int64_t>(random.below(1'000'000));
        const auto each = samplesAPoint(samples, most);
        QVERIFY(std::has_single_bit(static_cast<std::uint64_t>(each)));
        QVERIFY((samples + each - 1) / each <= most);
        QVERIFY(each == 1 || (samples + each / 2 - 1) / (each / 2) > most);
    }
    QCOMPARE(samplesAPoint(kMostPoints), std::int64_t{1});
    QCOMPARE(samplesAPoint(kMostPoints + 1), std::int64_t{2});
}

void TestBlockMeans::shortened_fewSamples_isTheRecordingItself()
{
    const Recording recording = restingRecording();
    const Recording same = shortened(recording, recording.size());
    QVERIFY(same.points.empty());
    QCOMPARE(same.samples(), std::int64_t{recording.size()});
    QVERIFY(same.timeS == recording.timeS && same.temperatureC == recording.temperatureC &&
            same.rateDps == recording.rateDps);
    QVERIFY(!shortened(recording, recording.size() - 1).points.empty());
}

void TestBlockMeans::means_anyRecordingInAnyParts_keepTheSums()
{
    Random random = announced(20261127);
    for (int trial = 0; trial < 30; ++trial) {
        RestingGyro gyro;
        gyro.intervalS = 0.01;
        gyro.durationS = random.uniform(1.0, 200.0);
        gyro.referenceRateDps = {25.0, -5.0, 53.0};
        gyro.seed = random.bits();
        const Recording samples = restingRecording(gyro);
        const std::int64_t each = std::int64_t{2} << random.below(8);
        const Recording means = meansOf(samples, each, random);
        QCOMPARE(means.samples(), std::int64_t{samples.size()});
        QCOMPARE(std::int64_t{means.size()}, (samples.size() + each - 1) / each);
        const Eigen::VectorXd count = means.points.samples.cast<double>();
        QVERIFY(std::abs(count.dot(means.timeS) / samples.timeS.sum() - 1.0) < 1e-12);
        QVERIFY(std::abs(count.dot(means.temperatureC) / samples.temperatureC.sum() - 1.0) < 1e-12);
        const Eigen::Vector3d sums = means.rateDps.transpose() * count;
        QVERIFY(near(sums, samples.rateDps.colwise().sum().transpose(), 1e-10));
        const Eigen::MatrixX3d squares = means.rateDps.cwiseAbs2() + means.points.varianceDps2.cast<double>();
        QVERIFY(near(squares.transpose() * count, samples.rateDps.colwise().squaredNorm().transpose(), 1e-9));
    }
}

// The temperature stands still within each point, so that a cell of it gets the same samples either way.
void TestBlockMeans::features_ofMeans_areThoseOfTheSamples()
{
    Random random = announced(20261128);
    constexpr Eigen::Index kEach = 32;
    RestingGyro gyro;
    gyro.intervalS = 0.01;
    gyro.durationS = 600.0;
    gyro.seed = random.bits();
    Recording samples = restingRecording(gyro);
    for (Eigen::Index i = 0; i < samples.size(); ++i)
        samples.temperatureC[i] = 0.5 * static_cast<double>(i / kEach % 100);
    const auto whole = std::make_shared<const RunFeatures>(featuresOf(samples));
    const auto means = std::make_shared<const RunFeatures>(featuresOf(meansOf(samples, kEach)));
    QCOMPARE(means->samples(), whole->samples());
    QVERIFY(means->timeS.size() * (kEach - 1) < whole->timeS.size());

    QCOMPARE(means->curve.firstKey(), whole->curve.firstKey());
    QCOMPARE(means->curve.cells().size(), whole->curve.cells().size());
    for (std::size_t i = 0; i < whole->curve.cells().size(); ++i) {
        const ThermalCell &a = means->curve.cells()[i];
        const ThermalCell &b = whole->curve.cells()[i];
        QCOMPARE(a.count, b.count);
        QVERIFY((a.sumQuantities - b.sumQuantities).norm() <= 1e-9 * b.sumQuantities.norm());
        QVERIFY((a.sumTdeDps - b.sumTdeDps).norm() <= 1e-9 * (1.0 + b.sumTdeDps.norm()));
        QVERIFY((a.sumTdeSquared - b.sumTdeSquared).norm() <= 1e-6 * b.sumTdeSquared.norm());
    }
    const JudgedRun a = prepareForJudging(means, means, Judging::Absolute);
    const JudgedRun b = prepareForJudging(whole, whole, Judging::Absolute);
    QVERIFY(near(a.msdBefore, b.msdBefore, 1e-6));
    QVERIFY(near(a.floor, b.floor, 1e-6));
    const AnyModel model = fitLinear({{whole}, 0.0});
    const DeltaTRange range{0.0, 50.0};
    QVERIFY(near(scoreModel(a, model, range).msd, scoreModel(b, model, range).msd, 1e-6));
}

void TestBlockMeans::standstill_keepsItsBits()
{
    Recording recording = restingRecording();
    recording.rateDps.col(1).setConstant(0.1);
    recording.temperatureC.setConstant(25.03);
    const Recording means = meansOf(recording, 128);
    QVERIFY((means.rateDps.col(1).array() == 0.1).all());
    QVERIFY((means.temperatureC.array() == 25.03).all());
    QVERIFY((means.points.varianceDps2.col(1).array() == 0.0f).all());
}

void TestBlockMeans::gap_endsAPoint()
{
    Recording recording = restingRecording();
    constexpr Eigen::Index kAt = 1000; // no multiple of 64
    recording.timeS.tail(recording.size() - kAt).array() += 100.0;
    const Recording means = meansOf(recording, 64);
    Eigen::Index before = 0;
    for (Eigen::Index i = 0, samples = 0; samples < kAt; samples += means.points.samples[i++])
        before = samples + means.points.samples[i];
    QCOMPARE(before, kAt);
    QCOMPARE(means.samples(), std::int64_t{recording.size()});
}

void TestBlockMeans::backwardTime_isStillThere()
{
    Recording recording = restingRecording();
    recording.timeS.tail(5000).array() -= 300.0;
    const CheckedRun checked = checkRun(meansOf(recording, 64));
    QVERIFY(checked.refusal.has_value());
    QCOMPARE(checked.refusal->code, Errc::TimeBackwards);
}

void TestBlockMeans::nonFinite_isAPointOfItsOwn()
{
    Recording recording = restingRecording();
    recording.rateDps(1000, 2) = std::numeric_limits<double>::quiet_NaN();
    recording.temperatureC[5000] = std::numeric_limits<double>::infinity();
    const Recording means = meansOf(recording, 64);
    Eigen::Index bad = 0;
    for (Eigen::Index i = 0; i < means.size(); ++i) {
        if (std::isfinite(means.temperatureC[i]) && means.rateDps.row(i).allFinite())
            continue;
        ++bad;
        QCOMPARE(means.points.samples[i], 1);
    }
    QCOMPARE(bad, Eigen::Index{2});
    QCOMPARE(checkRun(means).refusal->code, Errc::NonFiniteValue);
    QVERIFY(!checkRun(means, {.maskBadRows = true}).refusal);
}

void TestBlockMeans::repeatedTimes_areLeftOutAndTold()
{
    Recording recording = restingRecording();
    for (const Eigen::Index i : {100, 101, 640, 5000})
        recording.timeS[i] = recording.timeS[i - 1];
    const Recording means = meansOf(recording, 64);
    QCOMPARE(means.samples(), std::int64_t{recording.size() - 4});
    QCOMPARE(means.info.warnings.size(), std::size_t{1});
    QVERIFY(means.info.warnings.front().starts_with("4 samples repeat"));
}

void TestBlockMeans::temperatureStairs_keepTheirReadings()
{
    Recording recording = restingRecording();
    recording.temperatureC = recording.temperatureC.array().round();
    const Recording means = meansOf(recording, 64);
    QVERIFY((means.temperatureC.array() == means.temperatureC.array().round()).all());
    const auto checked = checkRun(means);
    QVERIFY(std::any_of(checked.run.findings.begin(), checked.run.findings.end(),
                        [](const Finding &finding) { return finding.kind == "temperature stairs"; }));
}

static bool found(const CheckedRun &checked, const std::string &kind)
{
    return std::any_of(checked.run.findings.begin(), checked.run.findings.end(),
                       [&kind](const Finding &finding) { return finding.kind == kind; });
}

void TestBlockMeans::checkRun_means_areToldAndDriftIsStillFound()
{
    RestingGyro gyro;
    gyro.intervalS = 0.01;
    const CheckedRun samples = checkRun(restingRecording(gyro));
    const CheckedRun means = checkRun(meansOf(restingRecording(gyro), 32));
    QVERIFY(!found(samples, "means") && found(means, "means"));
    QVERIFY(!found(samples, "no drift") && !found(means, "no drift"));
    // So little that it is lost in the noise of the samples: in that of the means it is not.
    gyro.driftDpsPerC = 0.0008;
    QVERIFY(found(checkRun(restingRecording(gyro)), "no drift"));
    QVERIFY(found(checkRun(meansOf(restingRecording(gyro), 32)), "no drift"));
}

// A period of the shaking is a point of the means.
void TestBlockMeans::checkRun_fastShaking_isStillMasked()
{
    RestingGyro gyro;
    gyro.intervalS = 0.001;
    gyro.durationS = 300.0;
    gyro.rampCPerS = 0.1;
    Recording recording = restingRecording(gyro);
    for (Eigen::Index i = 100'000; i < 101'000; ++i)
        recording.rateDps(i, 0) += i % 32 < 16 ? 20.0 : -20.0;
    const CheckedRun checked = checkRun(meansOf(recording, 32));
    for (Eigen::Index i = 0; i < checked.run.mask.size(); ++i) {
        const double timeS = checked.run.recording->timeS[i];
        if (timeS > 100.0 && timeS < 101.0)
            QVERIFY(checked.run.mask.has(i, MaskReason::Motion));
        if (timeS < 95.0 || timeS > 106.0)
            QVERIFY(!checked.run.mask.has(i, MaskReason::Motion));
    }
}

QTEST_APPLESS_MAIN(TestBlockMeans)
#include "tst_block_means.moc"
