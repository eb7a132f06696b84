// A compensation table as CSV: `temperature_C,tde_x_dps,tde_y_dps,tde_z_dps`, one knot a row, numbers at full
// precision. Above it `# key: value` lines hold the provenance, the bounds, and per axis whether it is
// compensated and why. The texts of the user (names, reasons) go through forComment (export_text.h); all else
// reads back exactly.
#pragma once

#include "engine/base/result.h"
#include "engine/compensation/compensation_table.h"

#include <string>
#include <string_view>

namespace driftbench {

std::string tableToCsv(const CompensationTable &table);

// name: of the file, for messages, which name the line. Errc: ModelDamaged.
Result<CompensationTable> tableFromCsv(std::string_view text, const std::string &name);

// Is this a table that a model could have given: two knots or more, ascending, finite? For every reader.
Status checkReadTable(const CompensationTable &table, const std::string &name);

} // namespace driftbench
