// The tables of a session file, version by version. A new file takes all steps, an older one those it lacks.
#pragma once

#include "app/session/database.h"
#include "engine/base/result.h"

namespace driftbench {

inline constexpr std::int64_t kSessionApplicationId = 0x44424E43; // "DBNC" at byte 68 of the file

// From that version (0: nothing yet) to the present one, in a transaction of its own.
Status bringUpToDate(const Database &database, int fromVersion);

} // namespace driftbench
