// How many centres the RBF network needs, and where they stand. Above: the loss on runs left out and on the
// training runs against the number of centres, the chosen number as a vertical line. Below: the curve less
// its straight line with the means that it was fitted to, its centres and their widths.
#pragma once

#include "engine/features/run_features.h"
#include "engine/models/rbf_trainer.h"
#include "widgets/plot/plot_view.h"
#include "widgets/views/model_curve.h"
#include "widgets/views/rbf_centres.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace driftbench {

struct CentresData
{
    std::optional<RbfSelection> selection;
    ModelCurve curve; // of the network, over its trained range
    std::vector<RbfCentre> centres;
    std::array<int, 3> centreCount{}; // used by each axis
    std::vector<std::shared_ptr<const RunFeatures>> runs;
    double referenceTemperatureC = 0.0;
};

class CentresView : public PlotView
{
    Q_OBJECT

public:
    explicit CentresView(const Palette &look = lightPalette(), QWidget *parent = nullptr);

    void setData(CentresData shown);

    QSize figureSize() const override { return {1040, m_data.selection ? 560 : 320}; }

protected:
    void build() override;

private:
    void buildLosses();
    void buildCurves();
    void drawCurve(QCPAxisRect &rect, int axis);

    CentresData m_data;
};

} // namespace driftbench
