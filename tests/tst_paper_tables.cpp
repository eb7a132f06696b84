// Expected figures that are not worked out in the test come from a program of exact fractions (Python's
// fractions.Fraction) that read the digits from the paper's own text and knows nothing of the code here.
#include "engine/base/random.h"
#include "engine/evaluation/paper_statements.h"
#include "engine/evaluation/paper_tables.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

using namespace driftbench;

class TestPaperTables : public QObject
{
    Q_OBJECT

private slots:
    void printedFigure_range_isHalfAUnitOfTheLastDigit_data();
    void printedFigure_range_isHalfAUnitOfTheLastDigit();
    void printedFigure_inThisForm_hasAsManyDigits_data();
    void printedFigure_inThisForm_hasAsManyDigits();
    void printedTables_sumsOfColumns_areThoseOfThePaper();
    void check_everyQAndPercentage_isRecomputed();
    void check_cellsThatNoRoundingExplains_areThoseOfExactFractions();
    void check_cellsOffInTheLastDigit_areThoseOfExactFractions();
    void check_possibleRange_holdsWhateverIsPrintedSo();
    void improvements_thirdAxisOfTable4_agreeAmongThemselves();
    void improvement_ofOneModelOnAnother_keepsItsSign();
    void statements_recomputed_areThoseOfExactFractions();
    void unseenRunBound_rowsBelowIt_areThoseOfTheSamePythonProgram();
    void unseenRunBound_meanOfTheOthersDrifts_neverLeavesLess();

private:
    static std::vector<PaperCheck> allChecks();
    static QString nameOf(const PaperCheck &check);
};

std::vector<PaperCheck> TestPaperTables::allChecks()
{
    std::vector<PaperCheck> all;
    for (int number = 1; number <= kPaperTableCount; ++number) {
        for (const PaperCheck &check : checkPaperTable(paperTable(number)))
            all.push_back(check);
    }
    return all;
}

// "4 3 z |Q4-Q3|/Q3": table, run, axis, column.
QString TestPaperTables::nameOf(const PaperCheck &check)
{
    return QStringLiteral("%1 %2 %3 %4")
        .arg(check.table)
        .arg(check.row.run + 1)
        .arg(QLatin1Char("xyz"[check.row.axis]))
        .arg(QString::fromStdString(std::string(check.column.name)));
}

void TestPaperTables::printedFigure_range_isHalfAUnitOfTheLastDigit_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("lowest");
    QTest::addColumn<double>("highest");
    QTest::newRow("decimals") << "9.5552" << 9.55515 << 9.55525;
    QTest::newRow("trailing zero") << "0.0200" << 0.01995 << 0.02005;
    QTest::newRow("power of ten") << "3.5555e-2" << 0.0355545 << 0.0355555;
    QTest::newRow("trailing zero, power of ten") << "3.720e-2" << 0.037195 << 0.037205;
    QTest::newRow("no decimals") << "12" << 11.5 << 12.5;
}

void TestPaperTables::printedFigure_range_isHalfAUnitOfTheLastDigit()
{
    QFETCH(QString, text);
    QFETCH(double, lowest);
    QFETCH(double, highest);
    const std::string kept = text.toStdString();
    const RoundingRange range = PrintedFigure(kept).range();
    QVERIFY(std::abs(range.lowest - lowest) < 1e-14);
    QVERIFY(std::abs(range.highest - highest) < 1e-14);
}

void TestPaperTables::printedFigure_inThisForm_hasAsManyDigits_data()
{
    QTest::addColumn<QString>("form");
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("decimals") << "9.5552" << 12.34567 << "12.3457";
    QTest::newRow("power of ten") << "3.721e-3" << 0.0123456 << "1.235e-2";
    QTest::newRow("rounds up to the next power") << "3.721e-3" << 0.0099996 << "1.000e-2";
    QTest::newRow("one") << "3.721e-3" << 1.0 << "1.000e0";
    QTest::newRow("negative") << "9.51" << -0.017 << "-0.02";
    QTest::newRow("zero") << "3.721e-3" << 0.0 << "0.000";
}

void TestPaperTables::printedFigure_inThisForm_hasAsManyDigits()
{
    QFETCH(QString, form);
    QFETCH(double, value);
    QFETCH(QString, text);
    const std::string kept = form.toStdString();
    QCOMPARE(QString::fromStdString(PrintedFigure(kept).inThisForm(value)), text);
}

void TestPaperTables::printedTables_sumsOfColumns_areThoseOfThePaper()
{
    const std::vector<std::vector<double>> sums{
        {47.7795, 0.17718, 0.158543, 0.0185414, 0.0165911, 52.5},
        {14.082, 0.0766, 0.0667, 0.0617, 0.044984, 0.037505, 0.035463, 36.24, 56.44, 22.51},
        {11.3392, 0.0721, 0.0622, 0.0594, 0.049953, 0.040249, 0.038511, 37.7, 49.36, 13.46},
        {14.1027, 0.0779, 0.0669, 0.0625, 0.046187, 0.038179, 0.035917, 45.68, 59.4, 15.78},
        {11.3321, 0.0729, 0.0627, 0.06, 0.050698, 0.040059, 0.038584, 38.36, 49.82, 12.93},
        {11.3465, 0.0728, 0.0619, 0.0604, 0.050474, 0.039903, 0.038816, 41.48, 47.65, 7.24}};
    for (int number = 1; number <= kPaperTableCount; ++number) {
        const PaperTable table = paperTable(number);
        const auto &expected = sums[static_cast<std::size_t>(number - 1)];
        QCOMPARE(table.columns.size(), expected.size());
        for (std::size_t c = 0; c < expected.size(); ++c) {
            double sum = 0.0;
            for (const PrintedRow &row : table.rows)
                sum += row.figure(c).value();
            QVERIFY2(std::abs(sum - expected[c]) < 1e-9,
                     qPrintable(QStringLiteral("table %1, column %2").arg(number).arg(c)));
        }
    }
}

void TestPaperTables::check_everyQAndPercentage_isRecomputed()
{
    // 5 rows of 2 Q and 1 percentage, 15 rows of 3 and 3.
    const std::vector<PaperCheck> checks = allChecks();
    QCOMPARE(checks.size(), std::size_t{5 * 3 + 15 * 6});
    // Table 1, first row, by hand: 0.035555 / 9.5552 and 1 - 0.032172 / 0.035555.
    QVERIFY(std::abs(checks[0].recomputed - 3.72101e-3) < 1e-8);
    QVERIFY(std::abs(checks[2].recomputed - 9.5148) < 1e-4);
    QCOMPARE(checks[2].agreement, PrintedAgreement::Exact);
}

void TestPaperTables::check_cellsThatNoRoundingExplains_areThoseOfExactFractions()
{
    struct Expected
    {
        double recomputed, lowest, highest;
    };
    const std::map<QString, Expected> expected{
        {"4 3 z |Q4-Q3|/Q3", {18.928571428571428, 18.604651162790697, 19.251336898395721}},
        {"4 3 z |Q5-Q3|/Q3", {23.571428571428571, 23.255813953488372, 23.885918003565063}},
        {"4 3 z |Q5-Q4|/Q4", {5.7268722466960353, 5.2980132450331126, 6.1538461538461542}},
    };
    std::size_t found = 0;
    for (const PaperCheck &check : allChecks()) {
        if (check.agreement != PrintedAgreement::No)
            continue;
        const auto is = expected.find(nameOf(check));
        QVERIFY2(is != expected.end(), qPrintable(nameOf(check)));
        QVERIFY(std::abs(check.recomputed - is->second.recomputed) < 1e-9);
        QVERIFY(std::abs(check.possible.lowest - is->second.lowest) < 1e-9);
        QVERIFY(std::abs(check.possible.highest - is->second.highest) < 1e-9);
        ++found;
    }
    QCOMPARE(found, expected.size());
}

void TestPaperTables::check_cellsOffInTheLastDigit_areThoseOfExactFractions()
{
    const std::map<QString, double> expected{
        {"1 2 x Q2", 0.0033224871572207285}, {"1 4 x Q2", 0.0032784810126582280},
        {"1 5 x Q2", 0.0033149402661585016}, {"3 2 y |Q4-Q3|/Q3", 14.453125},
        {"4 3 x Q4", 0.0042277988237510200}, {"4 3 x Q5", 0.0039766424579836330},
        {"5 4 x |Q4-Q3|/Q3", 0.5},           {"5 4 y Q5", 0.0030934787708186720},
    };
    std::size_t found = 0;
    for (const PaperCheck &check : allChecks()) {
        if (check.agreement != PrintedAgreement::WithinRounding)
            continue;
        const auto is = expected.find(nameOf(check));
        QVERIFY2(is != expected.end(), qPrintable(nameOf(check)));
        QVERIFY(std::abs(check.recomputed / is->second - 1.0) < 1e-12);
        ++found;
    }
    QCOMPARE(found, expected.size());
}

void TestPaperTables::check_possibleRange_holdsWhateverIsPrintedSo()
{
    constexpr std::uint64_t kSeed = 20;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    for (const PaperCheck &check : allChecks()) {
        const PaperTable table = paperTable(check.table);
        double lowest = check.possible.highest;
        double highest = check.possible.lowest;
        for (int draw = 0; draw < 500; ++draw) {
            MsdByRole msds = table.msds(check.row);
            for (std::size_t c = 0; c < table.columns.size(); ++c) {
                if (table.columns[c].kind != PaperColumnKind::Msd)
                    continue;
                const RoundingRange range = check.row.figure(c).range();
                msds[static_cast<std::size_t>(table.columns[c].role)] =
                    random.uniform(range.lowest, range.highest);
            }
            const double value = std::abs(check.column.of(msds));
            QVERIFY2(value >= check.possible.lowest && value <= check.possible.highest,
                     qPrintable(nameOf(check)));
            lowest = std::min(lowest, value);
            highest = std::max(highest, value);
        }
        // And the range is no wider than it must be.
        QVERIFY2(highest - lowest > 0.7 * (check.possible.highest - check.possible.lowest),
                 qPrintable(nameOf(check)));
    }
}

void TestPaperTables::improvements_thirdAxisOfTable4_agreeAmongThemselves()
{
    // (1 - 0.2635) / (1 - 0.2491) = 1 - 0.0192
    const PaperTable table = paperTable(4);
    QVERIFY(improvementsAgreeAmongThemselves(table, table.rows[2]));
    PrintedRow mixed = table.rows[2];
    std::vector<std::string_view> figures(mixed.figures.begin(), mixed.figures.end());
    figures.back() = "5.73"; // what the printed MSDs give
    mixed.figures = figures;
    QVERIFY(!improvementsAgreeAmongThemselves(table, mixed));
}

void TestPaperTables::improvement_ofOneModelOnAnother_keepsItsSign()
{
    const PaperColumn column{"", PaperColumnKind::Improvement, PaperRole::Novel, PaperRole::Conventional2};
    QVERIFY(std::abs(column.of({1.0, 0.4, 0.2, 0.1}) - 50.0) < 1e-12);
    QVERIFY(std::abs(column.of({1.0, 0.4, 0.2, 0.3}) + 50.0) < 1e-12);
}

void TestPaperTables::statements_recomputed_areThoseOfExactFractions()
{
    const std::vector<double> expected{10.501313471303062, 2.4727617216784084, 12.89183332965737,
                                       17.326383842270143, 5.048748891290299,  1.5112575525845038};
    const std::vector<PaperStatement> statements = checkPaperStatements();
    QCOMPARE(statements.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        QVERIFY2(std::abs(statements[i].fromTables / expected[i] - 1.0) < 1e-12, statements[i].about.c_str());
}

void TestPaperTables::unseenRunBound_rowsBelowIt_areThoseOfTheSamePythonProgram()
{
    struct Expected
    {
        int table, axis;
        double least, printed;
    };
    const std::vector<Expected> expected{{2, 0, 0.02646891393, 0.0193},
                                         {2, 1, 0.05397749036, 0.0214},
                                         {4, 0, 0.02635164616, 0.0190},
                                         {4, 1, 0.05586274492, 0.0221}};
    const std::vector<UnseenRunBound> bounds = rowsBelowUnseenRunBound();
    QCOMPARE(bounds.size(), expected.size());
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        QCOMPARE(bounds[i].table, expected[i].table);
        QCOMPARE(bounds[i].run, expected[i].table - 2);
        QCOMPARE(bounds[i].axis, expected[i].axis);
        QCOMPARE(bounds[i].printed, expected[i].printed);
        QVERIFY(std::abs(bounds[i].least / expected[i].least - 1.0) < 1e-8);
    }
}

void TestPaperTables::unseenRunBound_meanOfTheOthersDrifts_neverLeavesLess()
{
    // Drifts of any shape with the rms that Table 2 to 6 print on x: the mean of four is never nearer to the
    // fifth than the bound for Table 2 says.
    constexpr std::uint64_t kSeed = 21;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    const UnseenRunBound bound = rowsBelowUnseenRunBound().front();
    constexpr int kPoints = 6;
    double nearest = 1e9;
    for (int draw = 0; draw < 20000; ++draw) {
        // All alike but for a share of their own, from none to a tenth.
        const double own = 0.1 * random.uniform();
        std::array<double, kPoints> common{};
        for (double &value : common)
            value = random.normal();
        std::array<double, kPoints> difference{};
        for (int number = 2; number <= kPaperTableCount; ++number) {
            const PaperTable table = paperTable(number);
            const MsdByRole msds = table.msds(table.rows[0]);
            const bool held = number == 2;
            const double meanSquare = msds[0] - (held ? msds[3] : 0.0);
            std::array<double, kPoints> drift{};
            double square = 0.0;
            for (std::size_t i = 0; i < drift.size(); ++i) {
                drift[i] = common[i] + own * random.normal();
                square += drift[i] * drift[i] / kPoints;
            }
            for (std::size_t i = 0; i < drift.size(); ++i)
                difference[i] += (held ? 1.0 : -0.25) * drift[i] * std::sqrt(meanSquare / square);
        }
        double left = 0.0;
        for (const double value : difference)
            left += value * value / kPoints;
        QVERIFY(left >= bound.least * (1.0 - 1e-12));
        nearest = std::min(nearest, left);
    }
    QVERIFY(nearest < 1.01 * bound.least); // reached where the runs differ in size alone
}

QTEST_APPLESS_MAIN(TestPaperTables)
#include "tst_paper_tables.moc"
