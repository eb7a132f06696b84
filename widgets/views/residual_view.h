// What a model leaves of the TDE, against temperature, for each axis: samples as dots by the direction of the
// temperature, the mean of each run over 1 degree as a line. A good model leaves level lines at zero.
#pragma once

#include "engine/features/run_features.h"
#include "engine/models/trained_model.h"
#include "widgets/plot/decimation.h"
#include "widgets/plot/plot_view.h"
#include "widgets/views/scatter_dots.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace driftbench {

struct ResidualData
{
    std::vector<std::shared_ptr<const RunFeatures>> runs;
    std::vector<Eigen::MatrixX3d> residualDps; // of each run, as many rows as it has samples
    double referenceTemperatureC = 0.0;
    std::optional<UncertaintyBand> band; // of the curve, drawn around zero
};

// What is drawn of it, for each axis. Made of long runs off the thread of the window.
struct ResidualTraces
{
    std::array<ScatterDots, 3> dots;
    std::array<std::vector<Envelope>, 3> means; // over 1 degree, of each run in each direction
    double referenceTemperatureC = 0.0;
    std::optional<UncertaintyBand> band;
};
ResidualTraces residualTraces(const ResidualData &data);

class ResidualView : public PlotView
{
    Q_OBJECT

public:
    explicit ResidualView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    void setData(const ResidualData &shown) { setTraces(residualTraces(shown)); }
    void setTraces(ResidualTraces traces);

    QSize figureSize() const override { return {1040, 360}; }

protected:
    void build() override;

private:
    void drawMeans(QCPAxisRect &rect, int axis) const;
    void drawBand(QCPAxisRect &rect, int axis, bool filled) const; // filled, or its edges

    ResidualTraces m_shown;
};

} // namespace driftbench
