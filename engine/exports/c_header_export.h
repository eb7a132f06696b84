// A compensation table as a C99 header that needs nothing but <stdint.h>, under the MIT licence, made to be
// copied into firmware. With the prefix NAME (`symbol`) it holds
//   NAME_tde_dps(float temperature_c, float tde[3])        the arithmetic of TableApply<float>
//   (table_apply.h) NAME_compensate(float temperature_c, const float rate_dps[3], float compensated_dps[3])
//   NAME_tde_q(int32_t temperature_milli_c, int32_t tde[3])  that of fixed_point_table.h, bit for bit
// the knots in float and fixed point, and in a comment where they come from and their error bounds.
// The float functions give the same bits as TableApply where the compiler rounds every operation to float
// (FLT_EVAL_METHOD 0) and does not contract a product and a sum.
//
// Errors: InvalidOption (the symbol is no C identifier or has more than 48 letters).
#pragma once

#include "engine/base/result.h"
#include "engine/compensation/compensation_table.h"

#include <string>

namespace driftbench {

Result<std::string> tableToCHeader(const CompensationTable &table, const std::string &symbol);

} // namespace driftbench
