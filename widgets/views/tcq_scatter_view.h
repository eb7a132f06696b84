// TDE of one axis against each temperature-correlated quantity (Fig. 8 of the paper), with the fitted curves
// and the 95 % band of a new run's curve, and what the main curve leaves below it. Heating and cooling in two
// colours: where they part, no curve of temperature alone can follow.
#pragma once

#include "engine/features/run_features.h"
#include "engine/models/trained_model.h"
#include "widgets/plot/plot_view.h"
#include "widgets/views/model_curve.h"

#include <memory>
#include <optional>
#include <vector>

namespace driftbench {

struct ScatterDots;

struct TcqScatterData
{
    int axis = 0; // 0, 1, 2: x, y, z
    std::vector<std::shared_ptr<const RunFeatures>> runs;
    // The first is the main one: the residuals are against it and the band is drawn around it.
    std::vector<ModelCurve> curves;
    std::optional<UncertaintyBand> band;
    double referenceTemperatureC = 0.0; // of the band's temperatures
    // Samples that were taken out before the features were made; shown only.
    Eigen::VectorXd excludedDeltaT;
    Eigen::MatrixX3d excludedTdeDps;
};

class TcqScatterView : public PlotView
{
    Q_OBJECT

public:
    explicit TcqScatterView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    void setData(TcqScatterData shown);

    QSize figureSize() const override { return {1040, 480}; }

protected:
    void build() override;

private:
    void addLegendRow(const ScatterDots &dots);

    TcqScatterData m_data;
};

} // namespace driftbench
