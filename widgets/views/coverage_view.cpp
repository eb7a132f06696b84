#include "widgets/views/coverage_view.h"

#include "widgets/plot/plot_interaction.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/tickers.h"

#include <cmath>

namespace driftbench {

static constexpr double kBarWidthC = 0.7; // of a bin of 1 °C

namespace {

// What goes downwards is no less than what goes upwards.
class SizeTicker : public NumberTicker
{
public:
    using NumberTicker::NumberTicker;

protected:
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override
    {
        return NumberTicker::getTickLabel(std::abs(tick), locale, formatChar, precision);
    }
};

} // namespace

CoverageView::CoverageView(const Palette &look, QWidget *parent)
    : PlotView([] { return tr("Coverage of the temperature range"); }, look, parent)
{
    setLegendInside(false);
    PlotInteraction &interaction = enableInteraction();
    interaction.setDragAction(PlotInteraction::DragAction::SelectKeys);
    interaction.setFreeAxes(Qt::Horizontal);
    connect(&interaction, &PlotInteraction::keysSelected, this,
            [this](QCPAxisRect *, double low, double high) { setSelection(std::pair(low, high)); });
    connect(&interaction, &PlotInteraction::selectionEnded, this, [this] {
        if (m_selectedC)
            emit selected(m_selectedC->first, m_selectedC->second);
    });
    rebuild();
}

void CoverageView::setData(TemperatureCoverage coverage, std::optional<std::pair<double, double>> wantedC)
{
    m_coverage = std::move(coverage);
    m_wantedC = wantedC;
    rebuild();
}

void CoverageView::setSelection(const std::optional<std::pair<double, double>> &rangeC)
{
    m_selectedC = rangeC;
    if (auto *shade = plot().findChild<QCPItemRect *>(QStringLiteral("selection"))) {
        shade->setVisible(rangeC.has_value());
        if (rangeC) {
            shade->topLeft->setCoords(rangeC->first, 0.0);
            shade->bottomRight->setCoords(rangeC->second, 1.0);
        }
        plot().replot(QCustomPlot::rpQueuedReplot);
    }
}

static QCPItemRect *addShade(QCPAxisRect &rect, double fromC, double toC, const QColor &fill,
                             const QString &layer)
{
    auto *shade = new QCPItemRect(rect.parentPlot());
    shade->setLayer(layer);
    shade->setClipAxisRect(&rect);
    shade->setPen(Qt::NoPen);
    shade->setBrush(fill);
    shade->setAntialiased(false);
    for (QCPItemPosition *corner : {shade->topLeft, shade->bottomRight}) {
        corner->setAxisRect(&rect);
        corner->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
        corner->setTypeX(QCPItemPosition::ptPlotCoords);
        corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    shade->topLeft->setCoords(fromC, 0.0);
    shade->bottomRight->setCoords(toC, 1.0);
    return shade;
}

static void addBars(QCPAxisRect &rect, double firstC, const Eigen::VectorXd &seconds, double sign,
                    const QColor &color, const QString &name)
{
    auto *bars = new QCPBars(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    bars->setWidth(kBarWidthC);
    bars->setPen(Qt::NoPen);
    bars->setBrush(color);
    bars->setAntialiasedFill(false);
    bars->setName(name);
    for (Eigen::Index i = 0; i < seconds.size(); ++i) {
        if (seconds[i] > 0.0)
            bars->addData(firstC + double(i) + 0.5, sign * seconds[i]);
    }
}

void CoverageView::build()
{
    const Eigen::Index cells = m_coverage.heatingS.size();
    if (cells == 0) {
        showEmpty(tr("No coverage yet"), tr("It shows where the temperature has been."));
        return;
    }
    QCPAxisRect &rect = addPanel(addPanels(), 0, 0);
    const double low = m_wantedC ? std::min(m_wantedC->first, m_coverage.lowestC) : m_coverage.lowestC;
    const double high = m_wantedC ? std::max(m_wantedC->second, m_coverage.highestC) : m_coverage.highestC;
    QCPAxis &keys = *rect.axis(QCPAxis::atBottom);
    keys.setRange(low - 0.5, high + 0.5);
    keys.setLabel(tr("T (°C)"));
    QCPAxis &values = *rect.axis(QCPAxis::atLeft);
    // A hold at an end would press the sweep flat: the bars of all but the highest few count.
    std::vector<double> seconds(m_coverage.heatingS.begin(), m_coverage.heatingS.end());
    seconds.insert(seconds.end(), m_coverage.coolingS.begin(), m_coverage.coolingS.end());
    std::sort(seconds.begin(), seconds.end());
    const double most = seconds.back();
    const double usual = seconds[seconds.size() * 19 / 20];
    const double shownMost = std::max(1.0, std::min(most, 4.0 * std::max(usual, 1.0))) * 1.08;
    const bool cooled = m_coverage.coolingS.maxCoeff() > 0.0;
    const bool heated = m_coverage.heatingS.maxCoeff() > 0.0;
    values.setRange(cooled ? -shownMost : -0.04 * shownMost, heated ? shownMost : 0.04 * shownMost);
    values.setTicker(QSharedPointer<QCPAxisTicker>(new SizeTicker(3)));
    values.setLabel(tr("s per °C"));
    const QString below = QStringLiteral("background");
    if (low < m_coverage.lowestC)
        addShade(rect, low - 1.0, m_coverage.lowestC, look().page, below);
    if (high > m_coverage.highestC)
        addShade(rect, m_coverage.highestC, high + 1.0, look().page, below);
    addBars(rect, m_coverage.firstC, m_coverage.heatingS, 1.0, look().heating, tr("Heating"));
    addBars(rect, m_coverage.firstC, m_coverage.coolingS, -1.0, look().cooling, tr("Cooling"));
    auto *zero = new QCPItemStraightLine(&plot());
    zero->setClipAxisRect(&rect);
    zero->setAntialiased(false);
    zero->setPen(QPen(look().axisLine, 1.0));
    zero->point1->setAxes(&keys, &values);
    zero->point2->setAxes(&keys, &values);
    zero->point1->setCoords(0.0, 0.0);
    zero->point2->setCoords(1.0, 0.0);
    QColor accent = look().accent;
    accent.setAlpha(31);
    QCPItemRect *selection = addShade(rect, 0.0, 0.0, accent, QStringLiteral("overlay"));
    selection->setObjectName(QStringLiteral("selection"));
    selection->setVisible(m_selectedC.has_value());
    if (m_selectedC) {
        selection->topLeft->setCoords(m_selectedC->first, 0.0);
        selection->bottomRight->setCoords(m_selectedC->second, 1.0);
    }
}

} // namespace driftbench
