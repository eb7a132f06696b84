// A compensation table as JSON: provenance, bounds, the knots in dps and the fixed-point table
// (fixed_point_table.h) beside them. All of it reads back exactly.
#pragma once

#include "engine/base/result.h"
#include "engine/compensation/compensation_table.h"

#include <string>
#include <string_view>

namespace driftbench {

inline constexpr int kTableFormatVersion = 1;

std::string tableToJson(const CompensationTable &table);

// name: of the file, for messages. Errc: ModelDamaged (cut, not JSON, a field missing or of the wrong shape),
// ModelEdited (the fixed-point table is not that of the knots), ModelTooNew.
Result<CompensationTable> tableFromJson(std::string_view json, const std::string &name);

// Either of the two formats that can be read back (table_csv.h is the other), found by content.
Result<CompensationTable> readTable(std::string_view text, const std::string &name);

} // namespace driftbench
