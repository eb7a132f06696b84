// Certified results of the NIST Statistical Reference Datasets, linear least squares regression
// (https://www.itl.nist.gov/div898/strd/lls/lls.shtml; U.S. government work, public domain).
#include "engine/base/random.h"
#include "engine/models/least_squares.h"

#include <QTest>

#include <cmath>
#include <vector>

using namespace driftbench;

class TestLeastSquares : public QObject
{
    Q_OBJECT

private slots:
    void solve_norris_asCertified();
    void solve_wampler_data();
    void solve_wampler();
    void solve_longley_asCertified();
    void solve_filip_sixDigits();
    void solve_sameColumnTwice_shortestSolution();
    void solve_noRows_zero();
    void triangles_stacked_sameAsAllRows();
};

// The digits of agreement that NIST calls LRE, of the worst coefficient.
static double digits(const Eigen::VectorXd &found, const Eigen::VectorXd &certified)
{
    const double worst = ((found - certified).array() / certified.array()).abs().maxCoeff();
    return worst == 0.0 ? 16.0 : -std::log10(worst);
}

static Eigen::VectorXd vectorOf(const std::vector<double> &values)
{
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void TestLeastSquares::solve_norris_asCertified()
{
    const Eigen::VectorXd y =
        vectorOf({0.1, 338.8, 118.1, 888.0, 9.2,   228.1, 668.5, 998.5, 449.1, 778.9, 559.2, 0.3,
                  0.1, 778.1, 668.8, 339.3, 448.9, 10.8,  557.7, 228.3, 998.0, 888.8, 119.6, 0.3,
                  0.6, 557.6, 339.3, 888.0, 998.5, 778.9, 10.2,  117.6, 228.9, 668.4, 449.2, 0.2});
    const Eigen::VectorXd x =
        vectorOf({0.2, 337.4, 118.2, 884.6, 10.1,  226.5, 666.3, 996.3, 448.6, 777.0, 558.2, 0.4,
                  0.6, 775.5, 666.9, 338.0, 447.5, 11.6,  556.0, 228.1, 995.8, 887.6, 120.2, 0.3,
                  0.3, 556.8, 339.1, 887.2, 999.0, 779.0, 11.1,  118.3, 229.2, 669.1, 448.9, 0.5});
    const Eigen::VectorXd found = solveLeastSquares(powersOf(x, 1), y);
    QVERIFY(digits(found, Eigen::Vector2d(-0.262323073774029, 1.00211681802045)) > 11.0);
}

void TestLeastSquares::solve_wampler_data()
{
    QTest::addColumn<std::vector<double>>("y");
    QTest::addColumn<double>("ratio"); // of each coefficient to the one before; the first is 1
    QTest::addColumn<double>("wantedDigits");
    QTest::newRow("Wampler1") << std::vector<double>{1,       6,       63,     364,    1365,    3906,
                                                     9331,    19608,   37449,  66430,  111111,  177156,
                                                     271453,  402234,  579195, 813616, 1118481, 1508598,
                                                     2000719, 2613660, 3368421}
                              << 1.0 << 9.0;
    QTest::newRow("Wampler2") << std::vector<double>{1.00000,  1.11111,  1.24992,  1.42753,  1.65984,
                                                     1.96875,  2.38336,  2.94117,  3.68928,  4.68559,
                                                     6.00000,  7.71561,  9.92992,  12.75603, 16.32384,
                                                     20.78125, 26.29536, 33.05367, 41.26528, 51.16209,
                                                     63.00000}
                              << 0.1 << 12.0;
    QTest::newRow("Wampler3") << std::vector<double>{760,     -2042,   2111,   -1684,  3888,    1858,
                                                     11379,   17560,   39287,  64382,  113159,  175108,
                                                     273291,  400186,  581243, 811568, 1121004, 1506550,
                                                     2002767, 2611612, 3369180}
                              << 1.0 << 9.0;
    QTest::newRow("Wampler4") << std::vector<double>{75901,   -204794, 204863, -204436, 253665,  -200894,
                                                     214131,  -185192, 221249, -138370, 315911,  -27644,
                                                     455253,  197434,  783995, 608816,  1370781, 1303798,
                                                     2205519, 2408860, 3444321}
                              << 1.0 << 7.5;
    QTest::newRow("Wampler5") << std::vector<double>{7590001,   -20479994, 20480063,  -20479636, 25231365,
                                                     -20476094, 20489331,  -20460392, 18417449,  -20413570,
                                                     20591111,  -20302844, 18651453,  -20077766, 21059195,
                                                     -19666384, 26348481,  -18971402, 22480719,  -17866340,
                                                     10958421}
                              << 1.0 << 5.5;
}

void TestLeastSquares::solve_wampler()
{
    QFETCH(std::vector<double>, y);
    QFETCH(double, ratio);
    QFETCH(double, wantedDigits);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(21, 0.0, 20.0);
    const Eigen::VectorXd found = solveLeastSquares(powersOf(x, 5), vectorOf(y));
    Eigen::VectorXd certified = Eigen::VectorXd::Ones(6);
    for (Eigen::Index k = 1; k < 6; ++k)
        certified[k] = certified[k - 1] * ratio;
    QVERIFY2(digits(found, certified) > wantedDigits, qPrintable(QString::number(digits(found, certified))));
}

void TestLeastSquares::solve_longley_asCertified()
{
    Eigen::MatrixXd data(16, 7);
    data << 60323, 83.0, 234289, 2356, 1590, 107608, 1947, //
        61122, 88.5, 259426, 2325, 1456, 108632, 1948,     //
        60171, 88.2, 258054, 3682, 1616, 109773, 1949,     //
        61187, 89.5, 284599, 3351, 1650, 110929, 1950,     //
        63221, 96.2, 328975, 2099, 3099, 112075, 1951,     //
        63639, 98.1, 346999, 1932, 3594, 113270, 1952,     //
        64989, 99.0, 365385, 1870, 3547, 115094, 1953,     //
        63761, 100.0, 363112, 3578, 3350, 116219, 1954,    //
        66019, 101.2, 397469, 2904, 3048, 117388, 1955,    //
        67857, 104.6, 419180, 2822, 2857, 118734, 1956,    //
        68169, 108.4, 442769, 2936, 2798, 120445, 1957,    //
        66513, 110.8, 444546, 4681, 2637, 121950, 1958,    //
        68655, 112.6, 482704, 3813, 2552, 123366, 1959,    //
        69564, 114.2, 502601, 3931, 2514, 125368, 1960,    //
        69331, 115.7, 518173, 4806, 2572, 127852, 1961,    //
        70551, 116.9, 554894, 4007, 2827, 130081, 1962;
    Eigen::MatrixXd design(16, 7);
    design << Eigen::VectorXd::Ones(16), data.rightCols(6);
    Eigen::VectorXd certified(7);
    certified << -3482258.63459582, 15.0618722713733, -0.358191792925910E-01, -2.02022980381683,
        -1.03322686717359, -0.511041056535807E-01, 1829.15146461355;
    const Eigen::VectorXd found = solveLeastSquares(design, data.col(0));
    QVERIFY2(digits(found, certified) > 10.0, qPrintable(QString::number(digits(found, certified))));
}

void TestLeastSquares::solve_filip_sixDigits()
{
    const Eigen::VectorXd y = vectorOf(
        {0.8116, 0.9072, 0.9052, 0.9039, 0.8053, 0.8377, 0.8667, 0.8809, 0.7975, 0.8162, 0.8515, 0.8766,
         0.8885, 0.8859, 0.8959, 0.8913, 0.8959, 0.8971, 0.9021, 0.909,  0.9139, 0.9199, 0.8692, 0.8872,
         0.89,   0.891,  0.8977, 0.9035, 0.9078, 0.7675, 0.7705, 0.7713, 0.7736, 0.7775, 0.7841, 0.7971,
         0.8329, 0.8641, 0.8804, 0.7668, 0.7633, 0.7678, 0.7697, 0.77,   0.7749, 0.7796, 0.7897, 0.8131,
         0.8498, 0.8741, 0.8061, 0.846,  0.8751, 0.8856, 0.8919, 0.8934, 0.894,  0.8957, 0.9047, 0.9129,
         0.9209, 0.9219, 0.7739, 0.7681, 0.7665, 0.7703, 0.7702, 0.7761, 0.7809, 0.7961, 0.8253, 0.8602,
         0.8809, 0.8301, 0.8664, 0.8834, 0.8898, 0.8964, 0.8963, 0.9074, 0.9119, 0.9228});
    const Eigen::VectorXd x = vectorOf(
        {-6.860120914, -4.324130045, -4.358625055, -4.358426747, -6.955852379, -6.661145254, -6.355462942,
         -6.118102026, -7.115148017, -6.815308569, -6.519993057, -6.204119983, -5.853871964, -6.109523091,
         -5.79832982,  -5.482672118, -5.171791386, -4.851705903, -4.517126416, -4.143573228, -3.709075441,
         -3.499489089, -6.300769497, -5.953504836, -5.642065153, -5.031376979, -4.680685696, -4.329846955,
         -3.928486195, -8.56735134,  -8.363211311, -8.107682739, -7.823908741, -7.522878745, -7.218819279,
         -6.920818754, -6.628932138, -6.323946875, -5.991399828, -8.781464495, -8.663140179, -8.473531488,
         -8.247337057, -7.971428747, -7.676129393, -7.352812702, -7.072065318, -6.774174009, -6.478861916,
         -6.159517513, -6.835647144, -6.53165267,  -6.224098421, -5.910094889, -5.598599459, -5.290645224,
         -4.974284616, -4.64454848,  -4.290560426, -3.885055584, -3.408378962, -3.13200249,  -8.726767166,
         -8.66695597,  -8.511026475, -8.165388579, -7.886056648, -7.588043762, -7.283412422, -6.995678626,
         -6.691862621, -6.392544977, -6.067374056, -6.684029655, -6.378719832, -6.065855188, -5.752272167,
         -5.132414673, -4.811352704, -4.098269308, -3.66174277,  -3.2644011});
    Eigen::VectorXd certified(11);
    certified << -1467.48961422980, -2772.17959193342, -2316.37108160893, -1127.97394098372,
        -354.478233703349, -75.1242017393757, -10.8753180355343, -1.06221498588947, -0.670191154593408E-01,
        -0.246781078275479E-02, -0.402962525080404E-04;
    const Eigen::VectorXd found = solveLeastSquares(powersOf(x, 10), y);
    QVERIFY2(digits(found, certified) > 6.0, qPrintable(QString::number(digits(found, certified))));
}

void TestLeastSquares::solve_sameColumnTwice_shortestSolution()
{
    Eigen::MatrixXd design(4, 2);
    design << 1, 1, 2, 2, 3, 3, 4, 4;
    const Eigen::VectorXd found = solveLeastSquares(design, 6.0 * design.col(0));
    QVERIFY((found - Eigen::Vector2d(3.0, 3.0)).norm() < 1e-13);
}

void TestLeastSquares::solve_noRows_zero()
{
    const Eigen::MatrixXd found = solveLeastSquares(Eigen::MatrixXd(0, 4), Eigen::MatrixXd(0, 3));
    QCOMPARE(found, Eigen::MatrixXd(Eigen::MatrixXd::Zero(4, 3)));
}

void TestLeastSquares::triangles_stacked_sameAsAllRows()
{
    constexpr std::uint64_t kSeed = 11;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    Random random(kSeed);
    Eigen::MatrixXd rows(3000, 6);
    for (Eigen::Index i = 0; i < rows.size(); ++i)
        rows.data()[i] = random.normal();
    const Eigen::MatrixXd whole = solveJoined(rows, 4);
    Eigen::MatrixXd stacked(18, 6);
    stacked << triangleOf(rows.topRows(3)), triangleOf(rows.middleRows(3, 1500)),
        triangleOf(rows.bottomRows(1497));
    QVERIFY((solveJoined(stacked, 4) - whole).norm() < 1e-13);
}

QTEST_APPLESS_MAIN(TestLeastSquares)
#include "tst_least_squares.moc"
