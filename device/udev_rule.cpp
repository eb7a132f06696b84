#include "device/udev_rule.h"

#include <array>
#include <optional>
#include <system_error>

namespace driftbench {

namespace {

namespace fs = std::filesystem;

constexpr const char *kRule = "70-driftbench.rules";

bool isThere(const fs::path &file)
{
    std::error_code error;
    return fs::is_regular_file(file, error);
}

// udev(7) has the folders.
std::optional<fs::path> ruleThatUdevReads(const fs::path &root)
{
    constexpr std::array kFolders{"etc/udev/rules.d", "run/udev/rules.d", "usr/local/lib/udev/rules.d",
                                  "usr/lib/udev/rules.d", "lib/udev/rules.d"};
    for (const char *folder : kFolders) {
        if (const fs::path file = root / folder / kRule; isThere(file))
            return file;
    }
    return std::nullopt;
}

std::optional<fs::path> ruleBeside(const fs::path &program)
{
    for (fs::path folder = program.parent_path(); folder != folder.root_path();
         folder = folder.parent_path()) {
        for (const fs::path &file : {folder / "lib/udev/rules.d" / kRule, folder / "resources" / kRule}) {
            if (isThere(file))
                return file;
        }
    }
    return std::nullopt;
}

constexpr const char *kIntoForce =
    "run \"udevadm control --reload\" and \"udevadm trigger\" as root, and plug the device in again";

} // namespace

std::string udevRuleHint(const fs::path &root, const fs::path &program)
{
    if (const auto read = ruleThatUdevReads(root))
        return "the udev rule " + read->string() + " permits it to the user at the screen: " + kIntoForce +
               ".";
    const auto beside = ruleBeside(program);
    const std::string rule =
        beside ? "\"" + beside->string() + "\"" : std::string(kRule) + ", which comes with Driftbench,";
    return "copy the udev rule " + rule + " as root into /etc/udev/rules.d, " + kIntoForce + ".";
}

std::string udevRuleHint()
{
    std::error_code error;
    return udevRuleHint("/", fs::read_symlink("/proc/self/exe", error));
}

} // namespace driftbench
