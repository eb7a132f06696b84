// Certified results of the NIST Statistical Reference Datasets, nonlinear regression
// (https://www.itl.nist.gov/div898/strd/nls/nls_main.shtml; U.S. government work, public domain), from both
// of the published starts. Derivatives here are analytic and checked against differences first.
#include "engine/models/levenberg_marquardt.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <vector>

using namespace driftbench;

using Vector = std::vector<double>;

// y(x, b) and its gradient in b.
using ModelFunction = std::function<double(double x, const Eigen::VectorXd &b, Eigen::VectorXd &gradient)>;

struct ReferenceSet
{
    ModelFunction model;
    Vector x;
    Vector y;
    std::array<Vector, 2> starts;
    Vector certified;
    double certifiedSum = 0.0; // residual sum of squares
};

class TestLevenbergMarquardt : public QObject
{
    Q_OBJECT

private slots:
    void minimise_nist_data();
    void minimise_nist();
    void minimise_weights_asRepeatedSamples();
    void minimise_startNotFinite_saysSoAndKeepsStart();
    void minimise_hookStops_keepsBestSoFar();
    void minimise_alreadyThere_noStep();
    void minimise_uselessParameter_staysAndRestIsFound();
};

static ReferenceSet misra1a()
{
    return {
        [](double x, const Eigen::VectorXd &b, Eigen::VectorXd &g) {
            const double e = std::exp(-b[1] * x);
            g << 1.0 - e, b[0] * x * e;
            return b[0] * (1.0 - e);
        },
        {77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0},
        {10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78},
        {Vector{500, 0.0001}, Vector{250, 0.0005}},
        {2.3894212918E+02, 5.5015643181E-04},
        1.2455138894E-01};
}

static ReferenceSet chwirut2()
{
    return {[](double x, const Eigen::VectorXd &b, Eigen::VectorXd &g) {
                const double below = b[1] + b[2] * x;
                const double y = std::exp(-b[0] * x) / below;
                g << -x * y, -y / below, -x * y / below;
                return y;
            },
            {0.5,  1.0,  1.75, 3.75, 5.75, 0.875, 2.25, 3.25, 5.25, 0.75, 1.75, 2.75, 4.75, 0.625,
             1.25, 2.25, 4.25, 0.5,  3.0,  0.75,  3.0,  1.5,  6.0,  3.0,  6.0,  1.5,  3.0,  0.5,
             2.0,  4.0,  0.75, 2.0,  5.0,  0.75,  2.25, 3.75, 5.75, 3.0,  0.75, 2.5,  4.0,  0.75,
             2.5,  4.0,  0.75, 2.5,  4.0,  0.5,   6.0,  3.0,  0.5,  2.75, 0.5,  1.75},
            {92.9, 57.1,  31.05, 11.5875, 8.025, 63.6, 21.4,  14.25, 8.475, 63.8,  26.8, 16.4625, 7.125, 67.3,
             41.0, 21.15, 8.175, 81.5,    13.12, 59.9, 14.62, 32.9,  5.44,  12.56, 5.44, 32.0,    13.95, 75.8,
             20.0, 10.42, 59.5,  21.67,   8.55,  62.0, 20.2,  7.76,  3.75,  11.81, 54.7, 23.7,    11.55, 61.3,
             17.7, 8.74,  59.2,  16.3,    8.62,  81.0, 4.87,  14.62, 81.7,  17.17, 81.3, 28.9},
            {Vector{0.1, 0.01, 0.02}, Vector{0.15, 0.008, 0.010}},
            {1.6657666537E-01, 5.1653291286E-03, 1.2150007096E-02},
            5.1304802941E+02};
}

static ReferenceSet thurber()
{
    return {[](double x, const Eigen::VectorXd &b, Eigen::VectorXd &g) {
                const double above = b[0] + x * (b[1] + x * (b[2] + x * b[3]));
                const double below = 1.0 + x * (b[4] + x * (b[5] + x * b[6]));
                const double y = above / below;
                g << 1.0, x, x * x, x * x * x, -x * y, -x * x * y, -x * x * x * y;
                g /= below;
                return y;
            },
            {-3.067, -2.981, -2.921, -2.912, -2.840, -2.797, -2.702, -2.699, -2.633, -2.481,
             -2.363, -2.322, -1.501, -1.460, -1.274, -1.212, -1.100, -1.046, -0.915, -0.714,
             -0.566, -0.545, -0.400, -0.309, -0.109, -0.103, 0.010,  0.119,  0.377,  0.790,
             0.963,  1.006,  1.115,  1.572,  1.841,  2.047,  2.200},
            {80.574,   84.248,   87.264,   87.195,   89.076,   89.608,   89.868,   90.101,
             92.405,   95.854,   100.696,  101.060,  401.672,  390.724,  567.534,  635.316,
             733.054,  759.087,  894.206,  990.785,  1090.109, 1080.914, 1122.643, 1178.351,
             1260.531, 1273.514, 1288.339, 1327.543, 1353.863, 1414.509, 1425.208, 1421.384,
             1442.962, 1464.350, 1468.705, 1447.894, 1457.628},
            {Vector{1000, 1000, 400, 40, 0.7, 0.3, 0.03}, Vector{1300, 1500, 500, 75, 1, 0.4, 0.05}},
            {1.2881396800E+03, 1.4910792535E+03, 5.8323836877E+02, 7.5416644291E+01, 9.6629502864E-01,
             3.9797285797E-01, 4.9727297349E-02},
            5.6427082397E+03};
}

static ReferenceSet mgh09()
{
    return {[](double x, const Eigen::VectorXd &b, Eigen::VectorXd &g) {
                const double above = x * x + x * b[1];
                const double below = x * x + x * b[2] + b[3];
                const double y = b[0] * above / below;
                g << above / below, b[0] * x / below, -x * y / below, -y / below;
                return y;
            },
            {4.0, 2.0, 1.0, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625},
            {0.1957, 0.1947, 0.1735, 0.16, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246},
            {Vector{25, 39, 41.5, 39}, Vector{0.25, 0.39, 0.415, 0.39}},
            {1.9280693458E-01, 1.9128232873E-01, 1.2305650693E-01, 1.3606233068E-01},
            3.0750560385E-04};
}

static ReferenceSet rat43()
{
    return {[](double x, const Eigen::VectorXd &b, Eigen::VectorXd &g) {
                const double e = std::exp(b[1] - b[2] * x);
                const double y = b[0] * std::pow(1.0 + e, -1.0 / b[3]);
                const double inner = -y * e / ((1.0 + e) * b[3]);
                g << y / b[0], inner, -x * inner, y * std::log1p(e) / (b[3] * b[3]);
                return y;
            },
            {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
            {16.08, 33.83, 65.80, 97.20, 191.55, 326.20, 386.87, 520.53, 590.03, 651.92, 724.93, 699.56,
             689.96, 637.56, 717.41},
            {Vector{100, 10, 1, 1}, Vector{700, 5, 0.75, 1.3}},
            {6.9964151270E+02, 5.2771253025E+00, 7.5962938329E-01, 1.2792483859E+00},
            8.7864049080E+03};
}

static ReferenceSet eckerle4()
{
    return {[](double x, const Eigen::VectorXd &b, Eigen::VectorXd &g) {
                const double u = (x - b[2]) / b[1];
                const double e = std::exp(-0.5 * u * u) / b[1];
                g << e, b[0] * e * (u * u - 1.0) / b[1], b[0] * e * u / b[1];
                return b[0] * e;
            },
            {400.0, 405.0, 410.0, 415.0, 420.0, 425.0, 430.0, 435.0, 436.5, 438.0, 439.5, 441.0,
             442.5, 444.0, 445.5, 447.0, 448.5, 450.0, 451.5, 453.0, 454.5, 456.0, 457.5, 459.0,
             460.5, 462.0, 463.5, 465.0, 470.0, 475.0, 480.0, 485.0, 490.0, 495.0, 500.0},
            {0.0001575, 0.0001699, 0.0002350, 0.0003102, 0.0004917, 0.0008710, 0.0017418,
             0.0046400, 0.0065895, 0.0097302, 0.0149002, 0.0237310, 0.0401683, 0.0712559,
             0.1264458, 0.2073413, 0.2902366, 0.3445623, 0.3698049, 0.3668534, 0.3106727,
             0.2078154, 0.1164354, 0.0616764, 0.0337200, 0.0194023, 0.0117831, 0.0074357,
             0.0022732, 0.0008800, 0.0004579, 0.0002345, 0.0001586, 0.0001143, 0.0000710},
            {Vector{1, 10, 500}, Vector{1.5, 5, 450}},
            {1.5543827178E+00, 4.0888321754E+00, 4.5154121844E+02},
            1.4635887487E-03};
}

static Eigen::VectorXd asEigen(const Vector &values)
{
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

static ResidualFunction residualsOf(const ReferenceSet &set)
{
    return [set](const Eigen::VectorXd &b, Eigen::VectorXd &residuals, Eigen::MatrixXd *jacobian) {
        Eigen::VectorXd gradient(b.size());
        for (std::size_t i = 0; i < set.x.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            residuals[row] = set.model(set.x[i], b, gradient) - set.y[i];
            if (jacobian != nullptr)
                jacobian->row(row) = gradient.transpose();
        }
    };
}

static bool derivativesAgree(const ReferenceSet &set)
{
    const Eigen::VectorXd b = asEigen(set.certified);
    Eigen::VectorXd gradient(b.size());
    Eigen::VectorXd ignored(b.size());
    for (const double x : set.x) {
        const double y = set.model(x, b, gradient);
        for (Eigen::Index j = 0; j < b.size(); ++j) {
            const double h = 1e-6 * std::abs(b[j]);
            Eigen::VectorXd up = b;
            Eigen::VectorXd down = b;
            up[j] += h;
            down[j] -= h;
            const double difference = (set.model(x, up, ignored) - set.model(x, down, ignored)) / (2.0 * h);
            const double rounding = 1e-15 * std::abs(y) / h;
            if (std::abs(difference - gradient[j]) > 1e-5 * std::abs(gradient[j]) + rounding)
                return false;
        }
    }
    return true;
}

Q_DECLARE_METATYPE(ReferenceSet)

void TestLevenbergMarquardt::minimise_nist_data()
{
    QTest::addColumn<ReferenceSet>("set");
    QTest::addColumn<int>("start");
    const std::vector<std::pair<const char *, ReferenceSet>> sets{
        {"Misra1a", misra1a()}, {"Chwirut2", chwirut2()}, {"Thurber", thurber()},
        {"MGH09", mgh09()},     {"Rat43", rat43()},       {"Eckerle4", eckerle4()}};
    for (const auto &[name, set] : sets) {
        for (int start = 0; start < 2; ++start)
            QTest::addRow("%s start %d", name, start + 1) << set << start;
    }
}

void TestLevenbergMarquardt::minimise_nist()
{
    QFETCH(ReferenceSet, set);
    QFETCH(int, start);
    QVERIFY(derivativesAgree(set));
    Eigen::VectorXd b = asEigen(set.starts[static_cast<std::size_t>(start)]);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(set.x.size()));
    LevenbergMarquardtOptions options;
    options.iterations = 2000;
    const auto summary = minimise(problemFromResiduals(residualsOf(set), ones), b, options);
    QVERIFY(summary.converged());
    const Eigen::VectorXd certified = asEigen(set.certified);
    const double worst = ((b - certified).array() / certified.array()).abs().maxCoeff();
    QVERIFY2(worst < 1e-7, qPrintable(QString("%1 after %2 iterations").arg(worst).arg(summary.iterations)));
    QVERIFY(std::abs(summary.finalLoss / set.certifiedSum - 1.0) < 1e-9);
}

void TestLevenbergMarquardt::minimise_weights_asRepeatedSamples()
{
    const ReferenceSet set = misra1a();
    ReferenceSet repeated = set;
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(set.x.size()));
    for (std::size_t i = 0; i < set.x.size(); i += 3) {
        repeated.x.insert(repeated.x.end(), 2, set.x[i]);
        repeated.y.insert(repeated.y.end(), 2, set.y[i]);
        weights[static_cast<Eigen::Index>(i)] = 3.0;
    }
    Eigen::VectorXd weighted = asEigen(set.starts[1]);
    Eigen::VectorXd unweighted = weighted;
    minimise(problemFromResiduals(residualsOf(set), weights), weighted);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(repeated.x.size()));
    minimise(problemFromResiduals(residualsOf(repeated), ones), unweighted);
    QVERIFY(((weighted - unweighted).array() / unweighted.array()).abs().maxCoeff() < 1e-8);
    QVERIFY(((weighted - asEigen(set.certified)).array() / weighted.array()).abs().maxCoeff() > 1e-5);
}

void TestLevenbergMarquardt::minimise_startNotFinite_saysSoAndKeepsStart()
{
    const ReferenceSet set = misra1a();
    const Eigen::VectorXd start = Eigen::Vector2d(std::numeric_limits<double>::quiet_NaN(), 1.0);
    Eigen::VectorXd b = start;
    const auto summary = minimise(problemFromResiduals(residualsOf(set), Eigen::VectorXd::Ones(14)), b);
    QCOMPARE(summary.termination, LmTermination::StartNotFinite);
    QVERIFY(!summary.converged());
    QCOMPARE(b[1], start[1]);
}

void TestLevenbergMarquardt::minimise_hookStops_keepsBestSoFar()
{
    const ReferenceSet set = misra1a();
    Eigen::VectorXd b = asEigen(set.starts[0]);
    int asked = 0;
    const auto summary =
        minimise(problemFromResiduals(residualsOf(set), Eigen::VectorXd::Ones(14)), b, {},
                 [&asked](const Progress &) { return ++asked > 3 ? Flow::Stop : Flow::Continue; });
    QCOMPARE(summary.termination, LmTermination::Stopped);
    QCOMPARE(summary.iterations, 3);
    QVERIFY(summary.finalLoss < summary.initialLoss);
    QVERIFY(b.allFinite());
}

void TestLevenbergMarquardt::minimise_alreadyThere_noStep()
{
    const ResidualFunction exact = [](const Eigen::VectorXd &p, Eigen::VectorXd &r,
                                      Eigen::MatrixXd *jacobian) {
        r = p - Eigen::Vector2d(1.0, 2.0);
        if (jacobian != nullptr)
            jacobian->setIdentity();
    };
    Eigen::VectorXd p = Eigen::Vector2d(1.0, 2.0);
    const auto summary = minimise(problemFromResiduals(exact, Eigen::VectorXd::Ones(2)), p);
    QVERIFY(summary.converged());
    QCOMPARE(summary.iterations, 0);
}

void TestLevenbergMarquardt::minimise_uselessParameter_staysAndRestIsFound()
{
    const ResidualFunction line = [](const Eigen::VectorXd &p, Eigen::VectorXd &r,
                                     Eigen::MatrixXd *jacobian) {
        r << p[0] - 3.0, 2.0 * p[0] - 6.0;
        if (jacobian != nullptr)
            *jacobian << 1.0, 0.0, 2.0, 0.0;
    };
    Eigen::VectorXd p = Eigen::Vector2d(0.0, 5.0);
    const auto summary = minimise(problemFromResiduals(line, Eigen::VectorXd::Ones(2)), p);
    QVERIFY(summary.converged());
    QVERIFY(std::abs(p[0] - 3.0) < 1e-9);
    QCOMPARE(p[1], 5.0);
}

QTEST_APPLESS_MAIN(TestLevenbergMarquardt)
#include "tst_levenberg_marquardt.moc"
