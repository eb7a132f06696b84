#include "engine/base/output_error.h"

#include <cerrno>
#include <system_error>

namespace driftbench {

Error outputError(const std::filesystem::path &target, int errorNumber)
{
    if (errorNumber == ENOSPC || errorNumber == EDQUOT) {
        return {Errc::OutputFull,
                target.string() +
                    " was not written: no room is left on its disk. Make room or choose another folder."};
    }
    return {Errc::OutputNotWritable,
            target.string() + " can't be written: " + std::generic_category().message(errorNumber) +
                ". Choose a folder that you may write to."};
}

} // namespace driftbench
