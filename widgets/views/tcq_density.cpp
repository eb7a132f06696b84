#include "widgets/views/tcq_density.h"

#include "engine/base/statistics.h"
#include "engine/features/temperature_quantities.h"
#include "widgets/plot/decimation.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace driftbench {

namespace {

constexpr Eigen::Index kGridColumns = 180;
constexpr Eigen::Index kGridRows = 120;
constexpr double kFaintest = 0.12; // of the colour: a single sample is still seen

struct Edges
{
    double low = kInfinity;
    double high = -kInfinity;

    void include(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    Eigen::Index cell(double value, Eigen::Index cells) const
    {
        const double place = (value - low) / (high - low) * static_cast<double>(cells);
        return std::clamp(static_cast<Eigen::Index>(place), Eigen::Index(0), cells - 1);
    }
};

// TDE of the axis, or what the curve leaves of it; NaN for a sample that does not count.
std::vector<Eigen::VectorXd> valuesOf(const std::vector<std::shared_ptr<const RunFeatures>> &runs, int axis,
                                      const ModelCurve *curve)
{
    std::vector<Eigen::VectorXd> values;
    for (const auto &run : runs) {
        Eigen::VectorXd ofRun = run->tdeDps.col(axis);
        for (Eigen::Index i = 0; i < ofRun.size(); ++i) {
            const auto at = static_cast<std::size_t>(i);
            if (at < run->usableForTraining.size() && run->usableForTraining[at] == 0)
                ofRun[i] = kNaN;
            else if (curve)
                ofRun[i] -= interpolated(*curve, axis, run->deltaT[i]);
        }
        values.push_back(std::move(ofRun));
    }
    return values;
}

DirectedDensity densityOf(const std::vector<std::shared_ptr<const RunFeatures>> &runs,
                          const std::vector<std::vector<std::uint8_t>> &heating, int axis,
                          const ModelCurve *curve)
{
    const std::vector<Eigen::VectorXd> valueDps = valuesOf(runs, axis, curve);
    const auto visitAll = [&](const auto &visitor) {
        for (std::size_t r = 0; r < runs.size(); ++r) {
            for (Eigen::Index i = 0; i < valueDps[r].size(); ++i) {
                if (std::isfinite(runs[r]->deltaT[i]) && std::isfinite(valueDps[r][i]))
                    visitor(runs[r]->deltaT[i], valueDps[r][i], heating[r][static_cast<std::size_t>(i)] != 0);
            }
        }
    };
    Edges deltaTs, values;
    visitAll([&](double deltaT, double value, bool) {
        deltaTs.include(deltaT);
        values.include(value);
    });
    DirectedDensity density;
    if (!(deltaTs.low < deltaTs.high) || !(values.low < values.high))
        return density;
    for (DensityGrid *grid : {&density.heating, &density.cooling})
        *grid = {deltaTs.low, deltaTs.high, values.low, values.high,
                 Eigen::MatrixXi::Zero(kGridRows, kGridColumns)};
    visitAll([&](double deltaT, double value, bool rising) {
        (rising ? density.heating : density.cooling)
            .samples(values.cell(value, kGridRows), deltaTs.cell(deltaT, kGridColumns)) += 1;
    });
    for (DensityGrid *grid : {&density.heating, &density.cooling}) {
        if (grid->samples.maxCoeff() == 0)
            *grid = {};
    }
    return density;
}

// A graph without data of its own, so that legend, layers and deletion are the plot's.
class DensityGraph : public QCPGraph
{
public:
    DensityGraph(QCPAxisRect &rect, const DensityGrid &grid, int quantity, const QColor &color)
        : QCPGraph(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft))
        , m_grid(grid)
        , m_quantity(quantity)
        , m_color(color)
        , m_fullest(std::log1p(static_cast<double>(grid.samples.maxCoeff())))
    {
    }

protected:
    void draw(QCPPainter *painter) override
    {
        painter->save();
        painter->setAntialiasing(false);
        painter->setPen(Qt::NoPen);
        const QVector<double> x = pixelsOfColumns();
        const QVector<double> y = pixelsOfRows();
        for (Eigen::Index column = 0; column < m_grid.samples.cols(); ++column) {
            for (Eigen::Index row = 0; row < m_grid.samples.rows(); ++row) {
                const int samples = m_grid.samples(row, column);
                if (samples == 0)
                    continue;
                const QRectF cell =
                    QRectF(QPointF(x[column], y[row]), QPointF(x[column + 1], y[row + 1])).normalized();
                // A vector file has no clipping to rely on.
                if (const QRectF seen = cell & QRectF(clipRect()); !seen.isEmpty())
                    painter->fillRect(seen, shade(samples));
            }
        }
        painter->restore();
    }

private:
    // On the screen cells meet at whole pixels: no seams, no double shade.
    static double place(double pixel) { return std::round(pixel); }

    QVector<double> pixelsOfColumns() const
    {
        QVector<double> x;
        const Eigen::Index columns = m_grid.samples.cols();
        for (Eigen::Index i = 0; i <= columns; ++i) {
            const double deltaT = m_grid.lowestDeltaT + (m_grid.highestDeltaT - m_grid.lowestDeltaT) *
                                                            static_cast<double>(i) /
                                                            static_cast<double>(columns);
            x.append(place(keyAxis()->coordToPixel(temperatureQuantities(deltaT)[m_quantity])));
        }
        return x;
    }

    QVector<double> pixelsOfRows() const
    {
        QVector<double> y;
        const Eigen::Index rows = m_grid.samples.rows();
        for (Eigen::Index i = 0; i <= rows; ++i) {
            const double dps = m_grid.lowestDps + (m_grid.highestDps - m_grid.lowestDps) *
                                                      static_cast<double>(i) / static_cast<double>(rows);
            y.append(place(valueAxis()->coordToPixel(dps)));
        }
        return y;
    }

    QColor shade(int samples) const
    {
        QColor color = m_color;
        const double fullness = std::log1p(static_cast<double>(samples)) / m_fullest;
        color.setAlphaF(static_cast<float>(kFaintest + (1.0 - kFaintest) * fullness));
        return color;
    }

    DensityGrid m_grid;
    int m_quantity;
    QColor m_color;
    double m_fullest;
};

} // namespace

TcqDensity tcqDensity(const std::vector<std::shared_ptr<const RunFeatures>> &runs, const ModelCurve *curve)
{
    std::vector<std::vector<std::uint8_t>> heating;
    for (const auto &run : runs)
        heating.push_back(heatingFlags(run->timeS, run->deltaT));
    TcqDensity density;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        density.tde[axis] = densityOf(runs, heating, static_cast<int>(axis), nullptr);
        if (curve)
            density.residual[axis] = densityOf(runs, heating, static_cast<int>(axis), curve);
    }
    return density;
}

void addDensity(QCPAxisRect &rect, const DensityGrid &grid, int quantity, const QColor &color,
                const QString &name)
{
    if (grid.empty())
        return;
    auto *graph = new DensityGraph(rect, grid, quantity, color);
    graph->setName(name);
}

} // namespace driftbench
