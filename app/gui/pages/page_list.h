// The page of each step.
#pragma once

#include "app/gui/page.h"

namespace driftbench {

Page *makePage(Step step, AppContext &context); // without a parent yet: the window takes it

} // namespace driftbench
