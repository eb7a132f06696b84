#include "app/campaign/held_out_folders.h"

#include <algorithm>
#include <set>

namespace driftbench {

namespace {

// File systems allow 255 bytes; a number and the name of a temporary file must fit as well.
constexpr std::size_t kLongestFolderName = 200;

std::string asFolderName(std::string name)
{
    name.resize(std::min(name.size(), kLongestFolderName));
    for (char &c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '/' || c == '\\' || byte < 0x20 || byte == 0x7f)
            c = '_';
    }
    // Hidden folders, "." and ".."
    if (name.empty() || name.front() == '.')
        name.insert(0, "_");
    return name;
}

} // namespace

std::vector<std::string> heldOutFolders(const std::vector<std::string> &foldNames)
{
    std::vector<std::string> folders;
    std::set<std::string> taken;
    for (const std::string &name : foldNames) {
        const std::string base = asFolderName(name);
        std::string folder = base;
        for (int number = 2; !taken.insert(folder).second; ++number)
            folder = base + "-" + std::to_string(number);
        folders.push_back(folder);
    }
    return folders;
}

} // namespace driftbench
