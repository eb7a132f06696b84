#include "device/node_holders.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <unistd.h>

namespace driftbench {

namespace {

namespace fs = std::filesystem;

bool isProcess(const std::string &name)
{
    return !name.empty() && std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
}

// Processes come and go, and others' are closed to us: what can't be read holds nothing.
bool hasOpen(const fs::path &process, const fs::path &node)
{
    std::error_code error;
    for (fs::directory_iterator file(process / "fd", error), end; !error && file != end;
         file.increment(error)) {
        std::error_code gone;
        if (fs::read_symlink(file->path(), gone) == node && !gone)
            return true;
    }
    return false;
}

} // namespace

bool isHeldElsewhere(const fs::path &node)
{
    const std::string self = std::to_string(::getpid());
    std::error_code error;
    for (fs::directory_iterator each("/proc", error), end; !error && each != end; each.increment(error)) {
        const std::string name = each->path().filename().string();
        if (isProcess(name) && name != self && hasOpen(each->path(), node))
            return true;
    }
    return false;
}

} // namespace driftbench
