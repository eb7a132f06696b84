// How many centres the RBF network needs, and where they stand. Above: the loss on runs left out and on the
// training runs against the number of centres, the chosen number as a vertical line, what other models leave
// as levels. Below: the curve less its straight line with the means that it was fitted to, its centres and
// their widths. Either part may be shown alone.
#pragma once

#include "engine/features/run_features.h"
#include "engine/models/rbf_trainer.h"
#include "widgets/plot/plot_view.h"
#include "widgets/views/model_curve.h"
#include "widgets/views/rbf_centres.h"

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QCPRange;

namespace driftbench {

// What another model leaves on runs held out, beside the network's curve.
struct ExcessLevel
{
    std::string model;                                  // by its name in files
    std::array<double, 3> excessPercent{NAN, NAN, NAN}; // of each axis, over the noise floor
};

struct CentresData
{
    std::optional<RbfSelection> selection;
    ModelCurve curve; // of the network, over its trained range
    std::vector<RbfCentre> centres;
    std::array<int, 3> centreCount{}; // used by each axis
    std::vector<std::shared_ptr<const RunFeatures>> runs;
    double referenceTemperatureC = 0.0;
    std::vector<ExcessLevel> levels;
};

class CentresView : public PlotView
{
    Q_OBJECT

public:
    enum class Part
    {
        Both,
        Losses,
        Curves
    };

    explicit CentresView(const Palette &look = lightPalette(), QWidget *parent = nullptr,
                         Part part = Part::Both);

    void setData(CentresData shown);

    // The number of centres at a key of one of the loss panels, within what was tried.
    int countAt(double key) const;
    // Mouse and keys, and clicks on a loss panel: countPicked.
    void enablePicking();

    QSize figureSize() const override { return {1040, m_data.selection && m_part == Part::Both ? 560 : 320}; }

signals:
    void countPicked(int centres);

protected:
    void build() override;

private:
    struct LossRange;

    void buildLosses();
    LossRange lossRange() const;
    void drawLosses(QCPAxisRect &rect, std::size_t axis);
    void buildCurves();
    QCPRange curveRange() const; // of all axes
    void drawCurve(QCPAxisRect &rect, int axis);

    Part m_part;
    CentresData m_data;
};

} // namespace driftbench
