// How far the centre of a still chamber is from its new temperature after a step of the walls, over time, and
// when it comes within what its thermometer can tell.
#pragma once

#include "engine/physics/chamber_transient.h"
#include "widgets/plot/plot_view.h"

#include <optional>

namespace driftbench {

struct TransientData
{
    ChamberTransient transient;
    double stepC = 0.5;
    double accuracyC = 0.03; // of the thermometer, +-
};

class TransientView : public PlotView
{
    Q_OBJECT

public:
    explicit TransientView(const Palette &look, QWidget *parent = nullptr);

    void setData(const std::optional<TransientData> &shown);

    QSize figureSize() const override { return {360, 180}; }

protected:
    void build() override;

private:
    std::optional<TransientData> m_data;
};

} // namespace driftbench
