#include "device/sample_source.h"

#include <cassert>

namespace driftbench {

std::string_view gapCauseText(GapCause cause)
{
    switch (cause) {
    case GapCause::ReportsLost:
        return "reports lost";
    case GapCause::DeviceOverrun:
        return "overrun in the device";
    case GapCause::Unplugged:
        return "unplugged";
    case GapCause::Interrupted:
        return "recording interrupted";
    }
    assert(false);
    return {};
}

} // namespace driftbench
