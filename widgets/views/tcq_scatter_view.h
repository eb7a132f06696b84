// TDE of one axis against each temperature-correlated quantity (Fig. 8 of the paper), with the fitted curves
// and the 95 % band of a new run's curve, and what the main curve leaves below it. Heating and cooling in two
// colours: where they part, no curve of temperature alone can follow.
#pragma once

#include "engine/features/run_features.h"
#include "engine/models/trained_model.h"
#include "widgets/plot/plot_view.h"
#include "widgets/views/model_curve.h"
#include "widgets/views/scatter_dots.h"
#include "widgets/views/tcq_density.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace driftbench {

struct TcqScatterData
{
    int axis = 0; // 0, 1, 2: x, y, z
    std::vector<std::shared_ptr<const RunFeatures>> runs;
    // Drawn instead of the runs' dots, where it is given: of more samples than dots could show.
    std::shared_ptr<const TcqDensity> density;
    // The first is the main one: the residuals are against it and the band is drawn around it.
    std::vector<ModelCurve> curves;
    std::optional<UncertaintyBand> band;
    QString bandText;                   // what the band is, if not the 95 % band of a new run's curve
    double referenceTemperatureC = 0.0; // of the band's temperatures
    QString heatingText, coolingText;   // of the legend, where it is known which runs these are
    // Samples that were taken out before the features were made; shown only.
    Eigen::VectorXd excludedDeltaT;
    Eigen::MatrixX3d excludedTdeDps;
    // Samples that are selected here or in another plot; drawn over the others.
    Eigen::VectorXd selectedDeltaT;
    Eigen::MatrixX3d selectedTdeDps;
};

// The dots of it: TDE, and what the main curve leaves (none without a curve). Made of long runs off the
// thread of the window.
struct TcqDots
{
    ScatterDots tde, left;
};
TcqDots tcqDots(const TcqScatterData &data);

class TcqScatterView : public PlotView
{
    Q_OBJECT

public:
    explicit TcqScatterView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    void setData(TcqScatterData shown);
    void setData(TcqScatterData shown, TcqDots dots); // made of it before
    const TcqScatterData &shown() const { return m_data; }
    // The quantity (0, 1, 2) and the row (0 TDE, 1 residual) of a panel.
    std::pair<int, int> placeOf(const QCPAxisRect *panel) const;

    QSize figureSize() const override { return {1040, 480}; }

protected:
    void build() override;

private:
    void addLegendRow(const ScatterDots &dots);
    void drawSelected(QCPAxisRect &rect, int quantity, bool residuals) const;
    void linkPanels() const;

    TcqScatterData m_data;
    TcqDots m_dots;
};

} // namespace driftbench
