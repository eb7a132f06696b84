// The figures of the combs' physics and the page that shows them, from a folder with a physics.json:
// capacitance_error, gap_profile, quantities_residual.
#pragma once

#include "app/report/figure_list.h"
#include "app/report/physics_file.h"
#include "widgets/style/palette.h"

#include <filesystem>

namespace driftbench {

Result<std::vector<WrittenFigure>> writePhysicsFigures(const PhysicsFile &physics, const Palette &look,
                                                       const std::filesystem::path &folder);

QString physicsPage(const PhysicsFile &physics, const std::vector<WrittenFigure> &figures,
                    const Palette &look);

} // namespace driftbench
