// Random numbers, checksums, quantiles, numbers as text, files: against published values and laws.
#include "engine/base/atomic_file.h"
#include "engine/base/checksum.h"
#include "engine/base/parallel_for.h"
#include "engine/base/random.h"
#include "engine/base/statistics.h"
#include "engine/base/text.h"
#include "support/no_room.h"
#include "support/test_data.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>

using namespace driftbench;

class TestBase : public QObject
{
    Q_OBJECT

private slots:
    void xoshiro_fromKnownState_givesTheReferenceSequence();
    void normal_moments_areThoseOfTheNormal();
    void normal_tails_haveTheirProbabilities();
    void normal_distribution_passesKolmogorovSmirnov();
    void uniform_and_below_stayInRangeAndAreEven();
    void fork_streams_areApartAndRepeatable();
    void crc32_checkValue_isThePublishedOne();
    void crc32_inParts_equalsTheWhole();
    void studentTwoSided_agreesWithTheTables_data();
    void studentTwoSided_agreesWithTheTables();
    void median_and_robustSigma_ofKnownValues();
    void shortest_randomDoubles_readBackTheSame();
    void parseNumber_takesNumbersOnly();
    void fixed_and_forReading_haveTheirSigns();
    void parallelFor_everyIndexOnce();
    void atomicFile_withoutCommit_keepsTheOldContent();
    void atomicFile_tooLargeForItsDisk_keepsTheOldContent();
    void writeFilesTogether_oneTooLarge_keepsTheOldContentOfAll();
    void atomicFile_missingFolder_isAnError();
    void ensureWritableFolder_onAFile_isAnError();
};

static std::string contentOf(const std::filesystem::path &path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
}

// splitmix64 seeded with 0 starts e220a8397b1dcdaf, 6e789e6aa1b965f4, 06c45d188009454f, f88bb8a8724c81ec (its
// authors' reference code); xoshiro256++ returns rotl(s0 + s3, 23) + s0 of that state first.
void TestBase::xoshiro_fromKnownState_givesTheReferenceSequence()
{
    constexpr std::uint64_t kFirst = 0xe220a8397b1dcdafULL;
    constexpr std::uint64_t kFourth = 0xf88bb8a8724c81ecULL;
    QCOMPARE(Random(0).bits(), std::rotl(kFirst + kFourth, 23) + kFirst);
}

void TestBase::normal_moments_areThoseOfTheNormal()
{
    constexpr std::uint64_t kSeed = 20261121;
    constexpr int kCount = 2000000;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    double first = 0.0;
    double second = 0.0;
    double third = 0.0;
    double fourth = 0.0;
    for (int i = 0; i < kCount; ++i) {
        const double x = random.normal();
        first += x / kCount;
        second += x * x / kCount;
        third += x * x * x / kCount;
        fourth += x * x * x * x / kCount;
    }
    // Five standard errors each: of x^k these are sqrt(E x^2k - (E x^k)^2) / sqrt(n).
    const double unit = 5.0 / std::sqrt(static_cast<double>(kCount));
    QVERIFY(std::abs(first) < unit);
    QVERIFY(std::abs(second - 1.0) < std::sqrt(2.0) * unit);
    QVERIFY(std::abs(third) < std::sqrt(15.0) * unit);
    QVERIFY(std::abs(fourth - 3.0) < std::sqrt(96.0) * unit);
}

void TestBase::normal_tails_haveTheirProbabilities()
{
    constexpr int kCount = 4000000;
    Random random(99);
    constexpr std::array<double, 6> kLimits{0.5, 1.0, 2.0, 3.0, 3.6541528853610088, 4.0};
    std::array<int, kLimits.size()> above{};
    std::array<int, kLimits.size()> below{};
    for (int i = 0; i < kCount; ++i) {
        const double x = random.normal();
        for (std::size_t k = 0; k < kLimits.size(); ++k) {
            above[k] += x > kLimits[k] ? 1 : 0;
            below[k] += x < -kLimits[k] ? 1 : 0;
        }
    }
    for (std::size_t k = 0; k < kLimits.size(); ++k) {
        const double expected = kCount * 0.5 * std::erfc(kLimits[k] / std::numbers::sqrt2);
        QVERIFY(std::abs(above[k] - expected) < 5.0 * std::sqrt(expected));
        QVERIFY(std::abs(below[k] - expected) < 5.0 * std::sqrt(expected));
    }
}

void TestBase::normal_distribution_passesKolmogorovSmirnov()
{
    constexpr int kCount = 200000;
    Random random(5);
    std::vector<double> values(kCount);
    for (double &value : values)
        value = random.normal();
    std::sort(values.begin(), values.end());
    double distance = 0.0;
    for (int i = 0; i < kCount; ++i) {
        const double exact = 0.5 * std::erfc(-values[static_cast<std::size_t>(i)] / std::numbers::sqrt2);
        distance = std::max({distance, std::abs(exact - static_cast<double>(i) / kCount),
                             std::abs(exact - static_cast<double>(i + 1) / kCount)});
    }
    // 1.95 / sqrt(n) is passed by 99.9 % of true samples.
    QVERIFY(distance < 1.95 / std::sqrt(static_cast<double>(kCount)));
}

void TestBase::uniform_and_below_stayInRangeAndAreEven()
{
    Random random(17);
    std::array<int, 7> counts{};
    constexpr int kCount = 700000;
    for (int i = 0; i < kCount; ++i) {
        const double value = random.uniform(-2.0, 3.0);
        QVERIFY(value >= -2.0 && value < 3.0);
        ++counts[random.below(counts.size())];
    }
    double chiSquared = 0.0;
    for (const int count : counts)
        chiSquared += std::pow(count - kCount / 7.0, 2) / (kCount / 7.0);
    QVERIFY(chiSquared < 22.46); // 99.9 % quantile with 6 degrees of freedom
}

void TestBase::fork_streams_areApartAndRepeatable()
{
    Random random(4);
    QCOMPARE(random.fork(1).bits(), Random(4).fork(1).bits());
    QVERIFY(random.fork(1).bits() != random.fork(2).bits());
    const std::uint64_t before = random.fork(3).bits();
    random.bits();
    QCOMPARE(random.fork(3).bits(), before);
}

void TestBase::crc32_checkValue_isThePublishedOne()
{
    QCOMPARE(crc32("123456789"), 0xCBF43926U);
    QCOMPARE(crc32(""), 0U);
}

void TestBase::crc32_inParts_equalsTheWhole()
{
    const std::string text = "The mask is part of a run and shown in every output.";
    for (std::size_t cut = 0; cut <= text.size(); ++cut)
        QCOMPARE(crc32(text.substr(cut), crc32(text.substr(0, cut))), crc32(text));
}

void TestBase::studentTwoSided_agreesWithTheTables_data()
{
    QTest::addColumn<double>("confidence");
    QTest::addColumn<double>("degreesOfFreedom");
    QTest::addColumn<double>("expected"); // as printed in tables, three decimals
    QTest::newRow("95 %, 1") << 0.95 << 1.0 << 12.706;
    QTest::newRow("95 %, 2") << 0.95 << 2.0 << 4.303;
    QTest::newRow("95 %, 3") << 0.95 << 3.0 << 3.182;
    QTest::newRow("95 %, 4") << 0.95 << 4.0 << 2.776;
    QTest::newRow("95 %, 10") << 0.95 << 10.0 << 2.228;
    QTest::newRow("95 %, 60") << 0.95 << 60.0 << 2.000;
    QTest::newRow("95 %, 100") << 0.95 << 100.0 << 1.984;
    QTest::newRow("99 %, 4") << 0.99 << 4.0 << 4.604;
    QTest::newRow("90 %, 1") << 0.90 << 1.0 << 6.314;
    QTest::newRow("95 %, normal") << 0.95 << 1e7 << 1.960;
}

void TestBase::studentTwoSided_agreesWithTheTables()
{
    QFETCH(const double, confidence);
    QFETCH(const double, degreesOfFreedom);
    QFETCH(const double, expected);
    const double t = studentTwoSided(confidence, degreesOfFreedom);
    QVERIFY2(std::abs(t - expected) <= 0.0005001, qPrintable(QString::number(t)));
}

void TestBase::median_and_robustSigma_ofKnownValues()
{
    QVERIFY(std::isnan(median({})));
    QCOMPARE(median({3.0, 1.0, 2.0}), 2.0);
    QCOMPARE(median({4.0, 1.0, 3.0, 2.0}), 2.5);
    QCOMPARE(robustSigma({1.0, 2.0, 3.0, 4.0, 1000.0}), 1.4826);
    Random random(8);
    std::vector<double> values(100001);
    for (double &value : values)
        value = 5.0 + 0.3 * random.normal();
    QVERIFY(std::abs(robustSigma(values) / 0.3 - 1.0) < 0.02);
}

void TestBase::shortest_randomDoubles_readBackTheSame()
{
    constexpr std::uint64_t kSeed = 77;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    for (int i = 0; i < 100000; ++i) {
        const auto value = std::bit_cast<double>(random.bits());
        if (!std::isfinite(value))
            continue;
        const auto back = parseNumber(shortest(value));
        QVERIFY(back && std::bit_cast<std::uint64_t>(*back) == std::bit_cast<std::uint64_t>(value));
    }
}

void TestBase::parseNumber_takesNumbersOnly()
{
    QCOMPARE(parseNumber(" 1.5\t").value(), 1.5);
    QCOMPARE(parseNumber("+2e-3").value(), 0.002);
    QVERIFY(std::isnan(parseNumber("nan").value()));
    QCOMPARE(parseNumber("-inf").value(), -std::numeric_limits<double>::infinity());
    for (const char *text : {"", " ", "1,5", "1.5x", "0x10", "+-1", "++1", "+", "-", "e5", "1e"})
        QVERIFY2(!parseNumber(text), text);
}

void TestBase::fixed_and_forReading_haveTheirSigns()
{
    QCOMPARE(fixed(-3.994, 2), std::string("-3.99"));
    QCOMPARE(fixed(-0.001, 2), std::string("0.00"));
    QCOMPARE(forReading(-3.994, 2), std::string("\u22123.99"));
    QCOMPARE(fixed(1e300, 0).size(), std::size_t{301});
}

void TestBase::parallelFor_everyIndexOnce()
{
    for (const int threads : {0, 1, 2, 7}) {
        std::vector<std::atomic<int>> calls(1000);
        parallelFor(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
        QVERIFY(std::all_of(calls.begin(), calls.end(), [](const auto &count) { return count == 1; }));
    }
}

void TestBase::atomicFile_withoutCommit_keepsTheOldContent()
{
    const auto path = test::scratchFolder() / "kept.txt";
    QVERIFY(writeFileAtomically(path, "old"));
    {
        auto file = AtomicFile::create(path);
        QVERIFY(file);
        QVERIFY(file->write("new"));
    }
    QCOMPARE(contentOf(path), std::string("old"));
    {
        auto file = AtomicFile::create(path);
        QVERIFY(file && file->write("new") && file->prepare());
    }
    QCOMPARE(contentOf(path), std::string("old"));
    QVERIFY(writeFileAtomically(path, "new"));
    QCOMPARE(contentOf(path), std::string("new"));
    const auto files = std::distance(std::filesystem::directory_iterator(test::scratchFolder()), {});
    QCOMPARE(files, 1); // no temporary file is left behind
}

// A limit on the size of files stands in for a full disk.
void TestBase::atomicFile_tooLargeForItsDisk_keepsTheOldContent()
{
    const auto path = test::scratchFolder() / "limited.txt";
    QVERIFY(writeFileAtomically(path, "old"));
    const auto written = [&path] {
        const test::NoRoom full(65536);
        return writeFileAtomically(path, std::string(3000000, 'x'));
    }();
    QVERIFY(!written);
    QVERIFY(written.error().message.find("limited.txt") != std::string::npos);
    QCOMPARE(contentOf(path), std::string("old"));
}

void TestBase::writeFilesTogether_oneTooLarge_keepsTheOldContentOfAll()
{
    const auto first = test::scratchFolder() / "first.txt";
    const auto second = test::scratchFolder() / "second.txt";
    const auto write = [&](std::size_t bytes) {
        return writeFilesTogether({{first, "new"}, {second, std::string(bytes, 'x')}});
    };
    QVERIFY(writeFilesTogether({{first, "old"}, {second, "old"}}));
    {
        const test::NoRoom full(65536);
        const Status written = write(3000000);
        QVERIFY(!written);
        QVERIFY(written.error().message.find("second.txt") != std::string::npos);
    }
    QCOMPARE(contentOf(first), std::string("old"));
    QCOMPARE(contentOf(second), std::string("old"));
    QVERIFY(write(10));
    QCOMPARE(contentOf(first), std::string("new"));
    QCOMPARE(contentOf(second), std::string(10, 'x'));
}

void TestBase::atomicFile_missingFolder_isAnError()
{
    const Status written = writeFileAtomically(test::scratchFolder() / "no" / "such" / "file.txt", "x");
    QVERIFY(!written);
    QCOMPARE(written.error().code, Errc::OutputNotWritable);
}

void TestBase::ensureWritableFolder_onAFile_isAnError()
{
    const auto path = test::scratchFolder() / "a_file";
    QVERIFY(writeFileAtomically(path, "x"));
    QVERIFY(!ensureWritableFolder(path));
    QVERIFY(!ensureWritableFolder(path / "below"));
    QVERIFY(ensureWritableFolder(test::scratchFolder() / "made" / "here"));
}

QTEST_APPLESS_MAIN(TestBase)
#include "tst_base.moc"
