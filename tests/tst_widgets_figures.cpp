// What the views draw, as pictures. Set DRIFTBENCH_FIGURES to a folder to look at them.
#include "support/test_data.h"
#include "support/view_data.h"
#include "widgets/figure/figure_export.h"
#include "widgets/views/allan_view.h"
#include "widgets/views/before_after_view.h"
#include "widgets/views/centres_view.h"
#include "widgets/views/residual_view.h"
#include "widgets/views/tcq_scatter_view.h"
#include "widgets/views/tcq_time_view.h"

#include <QDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace driftbench;

static constexpr qsizetype kLargestSvg = 1'500'000;

class TestWidgetsFigures : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void tcqTime_run_hasQuantitiesAndAxes();
    void tcqScatter_fiveFullRuns_hasAxesLegendAndStaysSmall();
    void beforeAfter_run_hasRatesTemperatureAndFigures();
    void residual_fiveFullRuns_namesAxes();
    void allan_beforeAndAfter_labelsDecades();
    void centres_selection_marksChosenNumber();
    void everyView_withoutData_saysSo();
    void everyView_onePoint_draws();
    void everyView_extremeAndMissingValues_draws();
    void density_ofRuns_countsEverySampleOnce();
    void density_curveThroughAllSamples_leavesItsResidualAroundZero();
    void scatter_withDensity_drawsCellsForDots();
    void everyView_valuesBeyondTheRange_stayInThePanel();
    void everyView_dark_isDark();
    void saveFigure_eachEnding_writesThatFormat();
    void saveFigure_unknownEnding_isRefused();

private:
    void keep(PlotView &view, const char *name);
    TcqScatterData scatterData(int axis) const;
    BeforeAfterData beforeAfterData() const;
    ResidualData residualData() const;
    CentresData centresData() const;

    std::vector<std::shared_ptr<const RunFeatures>> m_runs;
};

static QString svgOf(PlotView &view)
{
    return QString::fromUtf8(figureAsSvg(view, view.figureSize(), {QStringLiteral("title"), QString()}));
}

// What a reader can select in the picture, in the order of drawing. A label in two scripts is two elements.
static QString textOf(const QString &svg)
{
    static const QRegularExpression kText(QStringLiteral("<text[^>]*>([^<]*)</text>"));
    QString text;
    for (auto match = kText.globalMatch(svg); match.hasNext();)
        text += match.next().captured(1);
    return text;
}

static int coloursOf(const QImage &image)
{
    std::set<QRgb> colours;
    for (int y = 0; y < image.height(); y += 2) {
        for (int x = 0; x < image.width(); x += 2)
            colours.insert(image.pixel(x, y));
    }
    return static_cast<int>(colours.size());
}

#define VERIFY_TEXT(svg, text) QVERIFY2(textOf(svg).contains(QStringLiteral(text)), text)

void TestWidgetsFigures::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    m_runs = test::syntheticRuns(5, 0.1);
    QCOMPARE(m_runs[0]->timeS.size(), Eigen::Index{111'000});
}

void TestWidgetsFigures::keep(PlotView &view, const char *name)
{
    const QString folder = qEnvironmentVariable("DRIFTBENCH_FIGURES");
    if (folder.isEmpty())
        return;
    QDir().mkpath(folder);
    for (const char *ending : {".png", ".svg", ".pdf"}) {
        const auto file = std::filesystem::path(folder.toStdString()) / (std::string(name) + ending);
        QVERIFY(saveFigure(view, file, {QString::fromUtf8(name), QString()}).ok());
    }
}

TcqScatterData TestWidgetsFigures::scatterData(int axis) const
{
    TcqScatterData data;
    data.axis = axis;
    data.runs = m_runs;
    data.curves = {modelCurve(test::syntheticRbf()), modelCurve(test::syntheticLine())};
    data.band = test::syntheticBand();
    data.referenceTemperatureC = test::kReferenceTemperatureC;
    return data;
}

BeforeAfterData TestWidgetsFigures::beforeAfterData() const
{
    const RunFeatures &run = *m_runs[0];
    BeforeAfterData data;
    data.referenceRateDps = Eigen::Vector3d(25.0, 5.0, 53.0);
    data.timeS = run.timeS;
    data.temperatureC = run.deltaT.array() + test::kReferenceTemperatureC;
    data.beforeDps = run.tdeDps.rowwise() + data.referenceRateDps.transpose();
    data.afterDps = test::residualOf(run, test::syntheticRbf()).rowwise() + data.referenceRateDps.transpose();
    data.afterText = QStringLiteral("RBF network trained on run2, run3");
    return data;
}

ResidualData TestWidgetsFigures::residualData() const
{
    ResidualData data;
    data.runs = m_runs;
    for (const auto &run : m_runs)
        data.residualDps.push_back(test::residualOf(*run, test::syntheticRbf()));
    data.referenceTemperatureC = test::kReferenceTemperatureC;
    data.band = test::syntheticBand();
    return data;
}

CentresData TestWidgetsFigures::centresData() const
{
    const TrainedModel model = test::syntheticRbf();
    const auto &network = std::get<RbfNetwork>(model.model);
    CentresData data;
    data.selection = test::syntheticSelection();
    data.curve = modelCurve(model);
    data.centres = rbfCentres(network);
    data.centreCount = network.centreCount;
    data.runs = m_runs;
    data.referenceTemperatureC = test::kReferenceTemperatureC;
    return data;
}

void TestWidgetsFigures::tcqTime_run_hasQuantitiesAndAxes()
{
    TcqTimeView view;
    view.setRun(m_runs[0]);
    keep(view, "tcq_time");
    const QString svg = svgOf(view);
    VERIFY_TEXT(svg, "ΔT (°C)");
    VERIFY_TEXT(svg, "ΔT² (°C²)");
    VERIFY_TEXT(svg, "√ΔT (√°C)");
    VERIFY_TEXT(svg, "TDE, z (dps)");
    VERIFY_TEXT(svg, "Time since start (h:min)");
    VERIFY_TEXT(svg, "2:30");
    QVERIFY(svg.size() < kLargestSvg);
    QVERIFY(coloursOf(figureAsImage(view, view.figureSize())) > 20);
}

void TestWidgetsFigures::tcqScatter_fiveFullRuns_hasAxesLegendAndStaysSmall()
{
    TcqScatterView view;
    view.setData(scatterData(1));
    keep(view, "tcq_scatter_y");
    const QString svg = svgOf(view);
    VERIFY_TEXT(svg, "TDE, y (dps)");
    VERIFY_TEXT(svg, "Residual (dps)");
    VERIFY_TEXT(svg, "Heating");
    VERIFY_TEXT(svg, "Excluded");
    VERIFY_TEXT(svg, "Fitted curve, RBF network, with its 95 % band");
    VERIFY_TEXT(svg, "line");
    QVERIFY2(svg.size() < kLargestSvg, qPrintable(QString::number(svg.size())));
    QVERIFY(!svg.contains(QStringLiteral("<image")));
}

void TestWidgetsFigures::beforeAfter_run_hasRatesTemperatureAndFigures()
{
    BeforeAfterView view;
    view.setData(beforeAfterData());
    keep(view, "before_after");
    const QString svg = svgOf(view);
    VERIFY_TEXT(svg, "x rate (dps)");
    VERIFY_TEXT(svg, "z rate (dps)");
    VERIFY_TEXT(svg, "T (°C)");
    VERIFY_TEXT(svg, "Compensated, RBF network trained on run2, run3");
    VERIFY_TEXT(svg, "dps rms comp.");
    VERIFY_TEXT(svg, "2:30");
    QVERIFY(svg.size() < kLargestSvg);
}

void TestWidgetsFigures::residual_fiveFullRuns_namesAxes()
{
    ResidualView view;
    view.setData(residualData());
    keep(view, "residual");
    const QString svg = svgOf(view);
    VERIFY_TEXT(svg, "Residual (dps)");
    VERIFY_TEXT(svg, "T (°C)");
    VERIFY_TEXT(svg, "y");
    VERIFY_TEXT(svg, "Mean over 1 °C, each run");
    VERIFY_TEXT(svg, "−0.2");
    QVERIFY(svg.size() < kLargestSvg);
}

void TestWidgetsFigures::allan_beforeAndAfter_labelsDecades()
{
    AllanView view;
    view.setData({test::syntheticAllan(2.0), test::syntheticAllan(0.01), QStringLiteral("RBF network")});
    keep(view, "allan");
    const QString svg = svgOf(view);
    VERIFY_TEXT(svg, "Averaging time τ (s)");
    VERIFY_TEXT(svg, "σ(τ) (dps)");
    VERIFY_TEXT(svg, "0.001");
    VERIFY_TEXT(svg, "1\u2009000");
    QVERIFY(!svg.contains(QStringLiteral("e+")));
}

void TestWidgetsFigures::centres_selection_marksChosenNumber()
{
    CentresView view;
    view.setData(centresData());
    keep(view, "centres");
    const QString svg = svgOf(view);
    VERIFY_TEXT(svg, "Number of centres");
    VERIFY_TEXT(svg, "Excess MSD (%)");
    VERIFY_TEXT(svg, "11 chosen");
    VERIFY_TEXT(svg, "TDE less line (dps)");
}

static std::vector<std::unique_ptr<PlotView>> everyView(const Palette &look = lightPalette())
{
    std::vector<std::unique_ptr<PlotView>> views;
    views.push_back(std::make_unique<TcqTimeView>(look));
    views.push_back(std::make_unique<TcqScatterView>(look));
    views.push_back(std::make_unique<BeforeAfterView>(look));
    views.push_back(std::make_unique<ResidualView>(look));
    views.push_back(std::make_unique<AllanView>(look));
    views.push_back(std::make_unique<CentresView>(look));
    return views;
}

static void giveData(std::vector<std::unique_ptr<PlotView>> &views, std::shared_ptr<const RunFeatures> run,
                     const Eigen::MatrixX3d &left)
{
    static_cast<TcqTimeView &>(*views[0]).setRun(run);
    TcqScatterData scatter;
    scatter.runs = {run};
    static_cast<TcqScatterView &>(*views[1]).setData(scatter);
    BeforeAfterData traces;
    traces.timeS = run->timeS;
    traces.beforeDps = run->tdeDps;
    traces.afterDps = left;
    static_cast<BeforeAfterView &>(*views[2]).setData(traces);
    ResidualData residual;
    residual.runs = {run};
    residual.residualDps = {left};
    static_cast<ResidualView &>(*views[3]).setData(residual);
    AllanCurve allan;
    allan.tauS = run->timeS.array() + 1.0;
    allan.deviationDps = left.cwiseAbs().array() + 1e-7;
    static_cast<AllanView &>(*views[4]).setData({allan, allan, QStringLiteral("nothing")});
    CentresData centres;
    centres.curve = {"rbf", run->deltaT, run->tdeDps};
    centres.runs = {run};
    static_cast<CentresView &>(*views[5]).setData(centres);
}

void TestWidgetsFigures::everyView_withoutData_saysSo()
{
    for (const auto &view : everyView()) {
        QVERIFY(view->isEmpty());
        const QString svg = svgOf(*view);
        QVERIFY2(svg.contains(QRegularExpression(QStringLiteral(">No[a-z]* [^<]+<"))),
                 qPrintable(view->accessibleName()));
        QVERIFY(!view->accessibleName().isEmpty());
    }
}

static std::shared_ptr<RunFeatures> smallRun(Eigen::Index count)
{
    auto run = std::make_shared<RunFeatures>();
    run->timeS = Eigen::VectorXd::LinSpaced(count, 0.0, static_cast<double>(count - 1));
    run->deltaT = Eigen::VectorXd::LinSpaced(count, 3.0, 3.0 + static_cast<double>(count - 1));
    run->tdeDps = Eigen::MatrixX3d::Constant(count, 3, 0.5);
    run->usableForTraining.assign(static_cast<std::size_t>(count), 1);
    return run;
}

void TestWidgetsFigures::everyView_onePoint_draws()
{
    auto views = everyView();
    giveData(views, smallRun(1), Eigen::MatrixX3d::Constant(1, 3, 0.1));
    for (const auto &view : views) {
        QVERIFY2(!view->isEmpty(), qPrintable(view->accessibleName()));
        QVERIFY(coloursOf(figureAsImage(*view, view->figureSize())) > 5);
    }
}

void TestWidgetsFigures::everyView_extremeAndMissingValues_draws()
{
    const auto run = smallRun(40);
    run->tdeDps(3, 0) = NAN;
    run->tdeDps(4, 0) = INFINITY;
    run->tdeDps(5, 1) = 1e300;
    run->tdeDps(6, 1) = -1e300;
    run->tdeDps.col(2) *= 1e-12;
    run->deltaT[7] = NAN;
    auto views = everyView();
    giveData(views, run, run->tdeDps);
    for (const auto &view : views) {
        const QString svg = svgOf(*view);
        QVERIFY2(!svg.contains(QStringLiteral(">nan<")) && !svg.contains(QStringLiteral(">inf<")),
                 qPrintable(view->accessibleName()));
        QVERIFY(coloursOf(figureAsImage(*view, view->figureSize())) > 5);
    }
}

void TestWidgetsFigures::density_ofRuns_countsEverySampleOnce()
{
    Eigen::Index usable = 0;
    for (const auto &run : m_runs)
        usable += std::count(run->usableForTraining.begin(), run->usableForTraining.end(), 1);
    const ModelCurve curve = modelCurve(test::syntheticRbf());
    const TcqDensity density = tcqDensity(m_runs, &curve);
    for (const auto *rows : {&density.tde, &density.residual}) {
        for (const DirectedDensity &axis : *rows)
            QCOMPARE(Eigen::Index(axis.heating.samples.sum()) + Eigen::Index(axis.cooling.samples.sum()),
                     usable);
    }
    QVERIFY(tcqDensity(m_runs, nullptr).residual[0].heating.empty());
    QVERIFY(tcqDensity({}, nullptr).tde[0].heating.empty());
}

void TestWidgetsFigures::density_curveThroughAllSamples_leavesItsResidualAroundZero()
{
    const ModelCurve curve = modelCurve(test::syntheticRbf());
    auto run = std::make_shared<RunFeatures>(*m_runs.front());
    for (Eigen::Index i = 0; i < run->deltaT.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis)
            run->tdeDps(i, axis) = interpolated(curve, axis, run->deltaT[i]) + (i % 2 == 0 ? 0.5 : -0.5);
    }
    const TcqDensity density = tcqDensity({run}, &curve);
    for (const DirectedDensity &axis : density.residual) {
        const Eigen::MatrixXi &samples = axis.heating.empty() ? axis.cooling.samples : axis.heating.samples;
        const Eigen::Index last = samples.rows() - 1;
        QCOMPARE(samples.row(0).sum() + samples.row(last).sum(), samples.sum());
        QVERIFY(std::abs(samples.row(0).sum() - samples.row(last).sum()) <= 1 + samples.sum() / 10);
    }
}

void TestWidgetsFigures::scatter_withDensity_drawsCellsForDots()
{
    TcqScatterData data = scatterData(1);
    TcqScatterView dots;
    dots.setData(data);
    data.density = std::make_shared<const TcqDensity>(tcqDensity(m_runs, &data.curves.front()));
    TcqScatterView cells;
    cells.setData(data);
    keep(cells, "tcq_density_y");
    const auto rectangles = [](const QString &svg) { return svg.count(QStringLiteral("<rect")); };
    QVERIFY(rectangles(svgOf(cells)) > rectangles(svgOf(dots)) + 500);
}

// Vector files have no clipping to rely on: coordinates themselves must stay in the picture.
void TestWidgetsFigures::everyView_valuesBeyondTheRange_stayInThePanel()
{
    TcqScatterData data = scatterData(0);
    for (ModelCurve &curve : data.curves)
        curve.tdeDps *= 50.0;
    data.curves.push_back(data.curves.front());
    data.curves.front() = modelCurve(test::syntheticRbf());
    data.excludedDeltaT = Eigen::VectorXd::LinSpaced(50, 0.0, 100.0);
    data.excludedTdeDps = Eigen::MatrixX3d::Constant(50, 3, 40.0);
    data.band->curveHalfWidthDps *= 100.0;
    TcqScatterView view;
    view.setData(data);
    const QString svg = svgOf(view);
    static const QRegularExpression kPair(
        QStringLiteral("(-?[0-9.]+(?:e[+-]?[0-9]+)?),(-?[0-9.]+(?:e[+-]?[0-9]+)?)[ L\"]"));
    int pairs = 0;
    for (auto match = kPair.globalMatch(svg); match.hasNext(); ++pairs) {
        const auto pair = match.next();
        const double y = pair.captured(2).toDouble();
        QVERIFY2(y >= -1.0 && y <= view.figureSize().height() + 1.0, qPrintable(pair.captured(0)));
    }
    QVERIFY(pairs > 1000);
}

void TestWidgetsFigures::everyView_dark_isDark()
{
    auto views = everyView(darkPalette());
    giveData(views, smallRun(40), Eigen::MatrixX3d::Constant(40, 3, 0.1));
    for (const auto &view : views) {
        const QImage image = figureAsImage(*view, view->figureSize());
        QCOMPARE(image.pixelColor(1, 1), darkPalette().base);
        view->setLook(lightPalette());
        QCOMPARE(figureAsImage(*view, view->figureSize()).pixelColor(1, 1), lightPalette().base);
        view->setLook(darkPalette());
    }
    TcqScatterView scatter(darkPalette());
    scatter.setData(scatterData(0));
    keep(scatter, "dark_tcq_scatter_x");
    BeforeAfterView traces(darkPalette());
    traces.setData(beforeAfterData());
    keep(traces, "dark_before_after");
    CentresView centres(darkPalette());
    centres.setData(centresData());
    keep(centres, "dark_centres");
}

void TestWidgetsFigures::saveFigure_eachEnding_writesThatFormat()
{
    AllanView view;
    view.setData({test::syntheticAllan(2.0), test::syntheticAllan(0.01), QStringLiteral("RBF network")});
    const auto folder = test::scratchFolder();
    const std::vector<std::pair<const char *, QByteArray>> starts{
        {"figure.svg", "<?xml"}, {"figure.pdf", "%PDF-"}, {"figure.png", "\x89PNG"}};
    for (const auto &[name, start] : starts) {
        QVERIFY(saveFigure(view, folder / name, {QStringLiteral("Allan"), QString()}).ok());
        QFile file(folder / name);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY2(file.read(8).startsWith(start), name);
    }
    QCOMPARE(QImage(QString::fromStdString((folder / "figure.png").string())).size(), 2 * view.figureSize());
}

void TestWidgetsFigures::saveFigure_unknownEnding_isRefused()
{
    AllanView view;
    const Status status = saveFigure(view, test::scratchFolder() / "figure.bmp", {});
    QVERIFY(!status.ok());
    QCOMPARE(status.error().code, Errc::InvalidOption);
}

QTEST_MAIN(TestWidgetsFigures)
#include "tst_widgets_figures.moc"
