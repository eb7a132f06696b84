// One pen for each role of a line, and which role a model plays. Solid is measured or the main result, dashed
// is not measured (reference, plan, limit, training); the dash also parts the models for eyes that see fewer
// colours.
#pragma once

#include "widgets/style/palette.h"

#include <QPen>
#include <QString>

#include <string_view>

namespace driftbench {

enum class Role
{
    Raw,
    Compensated,
    BpNetwork,
    Cubic,
    Line,
    Constant, // also plan, reference, limit
    Heating,
    Cooling,
    Excluded
};

QColor roleColor(Role role, const Palette &palette);
QPen rolePen(Role role, const Palette &palette); // 1 px

// By the name of the model in files ("rbf", "cubic", ...). "auto" has the role of the main result.
Role roleOfModel(std::string_view name);
QString modelLabel(std::string_view name);      // "RBF network", "cubic", ...
QString shortModelLabel(std::string_view name); // "RBF", "BP", "cubic", "line": in margins

} // namespace driftbench
