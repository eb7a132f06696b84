// The pyramid of live traces against what a plain walk over all samples gives.
#include "engine/base/random.h"
#include "widgets/live/trace_pyramid.h"
#include "widgets/live/value_ranges.h"

#include <QTest>

#include <cmath>
#include <vector>

using namespace driftbench;

namespace {

constexpr std::uint64_t kSeed = 20261125;
using Values = TracePyramid::Values;

struct Sample
{
    double timeS;
    Values values;
};

float noise(Random &random)
{
    return static_cast<float>(random.normal());
}

Values valuesAt(Random &random, double timeS)
{
    Values values;
    for (std::size_t trace = 0; trace < values.size(); ++trace)
        values[trace] = static_cast<float>(std::sin(0.01 * timeS + double(trace))) + 0.1F * noise(random);
    return values;
}

// Samples at 100 Hz with a gap here and there, of a length between 0.1 and 30 s.
std::vector<Sample> randomSamples(Random &random, int count, double gapShare)
{
    std::vector<Sample> samples;
    double timeS = 0.0;
    for (int i = 0; i < count; ++i) {
        samples.push_back({timeS, valuesAt(random, timeS)});
        timeS += 0.01;
        if (i > 100 && random.uniform() < gapShare)
            timeS += 0.1 * std::pow(300.0, random.uniform());
    }
    return samples;
}

TracePyramid pyramidOf(const std::vector<Sample> &samples)
{
    TracePyramid pyramid;
    for (const Sample &sample : samples)
        pyramid.add(sample.timeS, sample.values);
    return pyramid;
}

} // namespace

class TestWidgetsPyramid : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void envelopes_randomRanges_holdEveryExtreme();
    void envelopes_randomRanges_haveTheMeanOfAll();
    void envelopes_anyZoom_costsByColumns();
    void envelopes_everyGap_breaksTheLine();
    void envelopes_timeMovesOn_columnsStayThemselves();
    void envelopes_missingTrace_isNaNThere();
    void means_randomWindows_areThoseOfTheSamples();
    void means_emptyWindow_isNothing();
    void add_timeStandsOrIsNoNumber_isLeftOut();
    void add_millions_memoryIsBoundedAndOldDataThere();
    void commonRanges_randomData_holdAllWithOneSpan();
    void commonRanges_oneFlatStrip_getsItsOwn();
    void commonRanges_smallChange_staysSteady();
};

void TestWidgetsPyramid::initTestCase()
{
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
}

void TestWidgetsPyramid::envelopes_randomRanges_holdEveryExtreme()
{
    Random random(kSeed);
    const auto samples = randomSamples(random, 60'000, 0.0005);
    const TracePyramid pyramid = pyramidOf(samples);
    const double endS = samples.back().timeS;
    for (int round = 0; round < 60; ++round) {
        const double fromS = random.uniform() * endS;
        const double toS = fromS + random.uniform() * (endS - fromS);
        const double columnS = (toS - fromS) / (20.0 + 600.0 * random.uniform());
        const auto shown = pyramid.envelopes(fromS, toS, columnS);
        for (const std::size_t trace : {std::size_t{0}, std::size_t{4}, TracePyramid::kTemperature}) {
            float low = INFINITY, high = -INFINITY;
            for (const Sample &sample : samples) {
                if (sample.timeS >= fromS && sample.timeS <= toS) {
                    low = std::min(low, sample.values[trace]);
                    high = std::max(high, sample.values[trace]);
                }
            }
            if (!(low <= high))
                continue;
            double shownLow = INFINITY, shownHigh = -INFINITY;
            for (qsizetype i = 0; i < shown.timeS.size(); ++i) {
                shownLow =
                    std::min(shownLow, std::isnan(shown.low[trace][i]) ? INFINITY : shown.low[trace][i]);
                shownHigh =
                    std::max(shownHigh, std::isnan(shown.high[trace][i]) ? -INFINITY : shown.high[trace][i]);
            }
            // Stretches at the ends may bring in a sample from outside, never lose one.
            QVERIFY2(shownLow <= low && shownHigh >= high,
                     qPrintable(QStringLiteral("round %1: %2..%3 within %4..%5")
                                    .arg(round)
                                    .arg(low)
                                    .arg(high)
                                    .arg(shownLow)
                                    .arg(shownHigh)));
        }
        for (qsizetype i = 1; i < shown.timeS.size(); ++i)
            QVERIFY(shown.timeS[i] > shown.timeS[i - 1]);
    }
}

void TestWidgetsPyramid::envelopes_randomRanges_haveTheMeanOfAll()
{
    Random random(kSeed + 1);
    const auto samples = randomSamples(random, 40'000, 0.0);
    const TracePyramid pyramid = pyramidOf(samples);
    const double endS = samples.back().timeS;
    for (const double columnS : {0.005, 0.02, 0.3, 1.7, 20.0, 1000.0}) {
        const auto shown = pyramid.envelopes(0.0, endS, columnS);
        // Every column against the samples nearer to its middle than to its neighbours': by count, the mean
        // of column means over equal columns is the mean of all.
        const double stretchS = std::max(columnS, 0.01);
        for (qsizetype i = 2; i + 2 < shown.timeS.size(); i += 1 + shown.timeS.size() / 50) {
            double nearest = INFINITY;
            double low = shown.low[0][i], high = shown.high[0][i];
            for (const Sample &sample : samples) {
                if (std::abs(sample.timeS - shown.timeS[i]) <= 0.26 * stretchS) {
                    QVERIFY(sample.values[0] >= low && sample.values[0] <= high);
                    nearest = std::min(nearest, std::abs(sample.timeS - shown.timeS[i]));
                }
            }
            QVERIFY(shown.mean[0][i] >= low && shown.mean[0][i] <= high);
        }
    }
    const auto whole = pyramid.envelopes(0.0, endS, 10.0 * endS);
    double sum = 0.0;
    for (const Sample &sample : samples)
        sum += sample.values[3];
    QCOMPARE(whole.timeS.size(), 1);
    QVERIFY(std::abs(whole.mean[3][0] - sum / double(samples.size())) < 1e-5);
}

void TestWidgetsPyramid::envelopes_anyZoom_costsByColumns()
{
    Random random(kSeed + 2);
    const auto samples = randomSamples(random, 200'000, 0.0);
    const TracePyramid pyramid = pyramidOf(samples);
    for (const double spanS : {1.0, 10.0, 100.0, 1000.0, 1990.0}) {
        const auto shown = pyramid.envelopes(5.0, 5.0 + spanS, spanS / 500.0);
        QVERIFY(shown.timeS.size() <= 503);
        QVERIFY(shown.timeS.size() >= std::min<qsizetype>(95, qsizetype(spanS * 100.0)));
    }
}

void TestWidgetsPyramid::envelopes_everyGap_breaksTheLine()
{
    Random random(kSeed + 3);
    const auto samples = randomSamples(random, 30'000, 0.001);
    const TracePyramid pyramid = pyramidOf(samples);
    for (const double columnS : {0.02, 0.1, 0.5, 2.0}) {
        const auto shown = pyramid.envelopes(0.0, samples.back().timeS, columnS);
        int wanted = 0, seen = 0;
        for (std::size_t i = 1; i < samples.size(); ++i) {
            const double gapS = samples[i].timeS - samples[i - 1].timeS;
            // A stretch that spans a gap is shorter than it, so gaps well over the bound are always seen.
            if (gapS < 4.5 * columnS + 0.2)
                continue;
            ++wanted;
            for (qsizetype k = 0; k < shown.timeS.size(); ++k) {
                if (std::isnan(shown.mean[0][k]) && shown.timeS[k] > samples[i - 1].timeS &&
                    shown.timeS[k] < samples[i].timeS) {
                    ++seen;
                    break;
                }
            }
        }
        QVERIFY(wanted > 0);
        QCOMPARE(seen, wanted);
    }
}

void TestWidgetsPyramid::envelopes_timeMovesOn_columnsStayThemselves()
{
    Random random(kSeed + 4);
    const auto samples = randomSamples(random, 20'000, 0.0);
    TracePyramid pyramid;
    std::size_t next = 0;
    while (next < 15'000)
        pyramid.add(samples[next].timeS, samples[next].values), ++next;
    const auto before = pyramid.envelopes(0.0, pyramid.lastS(), 0.7);
    while (next < samples.size())
        pyramid.add(samples[next].timeS, samples[next].values), ++next;
    const auto after = pyramid.envelopes(0.0, pyramid.lastS(), 0.7);
    int moved = 0; // but for the last few, which were open
    for (qsizetype i = 0; i + 3 < before.timeS.size(); ++i)
        moved += before.low[1][i] != after.low[1][i] || before.timeS[i] != after.timeS[i] ? 1 : 0;
    QCOMPARE(moved, 0);
}

void TestWidgetsPyramid::envelopes_missingTrace_isNaNThere()
{
    TracePyramid pyramid;
    for (int i = 0; i < 1000; ++i) {
        Values values{};
        if (i < 500)
            values[TracePyramid::kCompensated] = NAN;
        values[TracePyramid::kRaw] = i == 250 ? INFINITY : 1.0F;
        pyramid.add(0.01 * i, values);
    }
    const auto shown = pyramid.envelopes(0.0, 10.0, 0.5);
    QVERIFY(std::isnan(shown.mean[TracePyramid::kCompensated].front()));
    QCOMPARE(shown.mean[TracePyramid::kCompensated].last(), 0.0);
    for (const double high : shown.high[TracePyramid::kRaw])
        QCOMPARE(high, 1.0);
}

void TestWidgetsPyramid::means_randomWindows_areThoseOfTheSamples()
{
    Random random(kSeed + 5);
    const auto samples = randomSamples(random, 50'000, 0.0);
    const TracePyramid pyramid = pyramidOf(samples);
    for (int round = 0; round < 50; ++round) {
        const double middleS = 5.0 + random.uniform() * 480.0;
        const auto means = pyramid.means(middleS - 5.0, middleS + 5.0);
        QVERIFY(means);
        double sum = 0.0;
        int count = 0;
        for (const Sample &sample : samples) {
            if (std::abs(sample.timeS - middleS) <= 5.0) {
                sum += sample.values[2];
                ++count;
            }
        }
        // A sample or two at the ends: 0.1 dps of noise over 1000 samples.
        QVERIFY(std::abs((*means)[2] - sum / count) < 0.01);
    }
}

void TestWidgetsPyramid::means_emptyWindow_isNothing()
{
    TracePyramid pyramid;
    QVERIFY(!pyramid.means(0.0, 1.0));
    for (int i = 0; i < 100; ++i)
        pyramid.add(0.1 * i, {});
    QVERIFY(!pyramid.means(20.0, 30.0));
    QVERIFY(pyramid.means(4.0, 5.0));
}

void TestWidgetsPyramid::add_timeStandsOrIsNoNumber_isLeftOut()
{
    TracePyramid pyramid;
    for (const double timeS : {0.0, 1.0, 1.0, 0.5, std::nan(""), 2.0})
        pyramid.add(timeS, {});
    QCOMPARE(pyramid.samples(), 3);
    QCOMPARE(pyramid.leftOut(), 3);
    QCOMPARE(pyramid.lastS(), 2.0);
}

void TestWidgetsPyramid::add_millions_memoryIsBoundedAndOldDataThere()
{
    // More than the samples and the first level hold in full.
    constexpr int kCount = 4'500'000;
    TracePyramid pyramid;
    Values values{};
    for (int i = 0; i < kCount; ++i) {
        values[0] = i == 1234 ? 9.0F : 0.0F; // one spike, long ago
        pyramid.add(1e-4 * i, values);
    }
    QVERIFY2(pyramid.bytes() < 120'000'000, qPrintable(QString::number(pyramid.bytes())));
    QCOMPARE(pyramid.firstS(), 0.0);
    for (const double columnS : {1e-3, 0.01, 0.6}) {
        const auto shown = pyramid.envelopes(0.0, 1.0, columnS);
        QVERIFY(!shown.timeS.isEmpty());
        QCOMPARE(*std::max_element(shown.high[0].begin(), shown.high[0].end()), 9.0);
    }
    const auto whole = pyramid.envelopes(0.0, pyramid.lastS(), pyramid.lastS() / 1000.0);
    QVERIFY(whole.timeS.size() > 900 && whole.timeS.size() < 1003);
    QCOMPARE(*std::max_element(whole.high[0].begin(), whole.high[0].end()), 9.0);
}

void TestWidgetsPyramid::commonRanges_randomData_holdAllWithOneSpan()
{
    Random random(kSeed + 6);
    for (int round = 0; round < 500; ++round) {
        std::array<Extent, 3> data;
        const double size = std::pow(10.0, 4.0 * random.uniform() - 2.0);
        for (Extent &extent : data) {
            const double low = 50.0 * random.normal();
            extent.include(low);
            extent.include(low + size * (1.0 + 6.0 * random.uniform()));
        }
        const auto ranges = commonRanges(data, std::nullopt);
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(ranges[i].low < data[i].low() && ranges[i].high > data[i].high());
            QVERIFY(std::abs(ranges[i].span() - ranges[0].span()) < 1e-9 * ranges[0].span() + 1e-9);
        }
    }
}

void TestWidgetsPyramid::commonRanges_oneFlatStrip_getsItsOwn()
{
    std::array<Extent, 3> data;
    for (const double value : {0.0, 10.0})
        data[0].include(value);
    for (const double value : {1.0, 1.1})
        data[1].include(value);
    const auto ranges = commonRanges(data, std::nullopt);
    QVERIFY(ranges[0].span() > 10.0);
    QVERIFY(ranges[1].span() < 0.3);
    QVERIFY(ranges[2].span() > 0.0); // nothing there yet
}

void TestWidgetsPyramid::commonRanges_smallChange_staysSteady()
{
    std::array<Extent, 3> data;
    for (Extent &extent : data) {
        extent.include(0.0);
        extent.include(10.0);
    }
    const auto first = commonRanges(data, std::nullopt);
    data[0].include(10.2);
    QCOMPARE(commonRanges(data, first), first);
    data[0].include(30.0);
    QVERIFY(commonRanges(data, first) != first);
}

QTEST_MAIN(TestWidgetsPyramid)
#include "tst_widgets_pyramid.moc"
