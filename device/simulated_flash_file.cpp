#include "device/simulated_flash_file.h"

#include "engine/base/atomic_file.h"

#include <fstream>
#include <iterator>

namespace driftbench {

Status loadFlash(RamFlash &flash, const std::filesystem::path &file)
{
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        return {};
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in.is_open() || in.bad())
        return Error{Errc::FileUnreadable,
                     "The flash file " + file.string() + " can't be read; check its permissions."};
    const std::size_t bank = flash.bank(0).size();
    if (bytes.size() != 2 * bank)
        return Error{Errc::InvalidOption, "The flash file " + file.string() + " has " +
                                              std::to_string(bytes.size()) + " bytes and not " +
                                              std::to_string(2 * bank) +
                                              "; it is none of a simulated bridge, name another."};
    const auto middle = bytes.begin() + static_cast<std::ptrdiff_t>(bank);
    flash.restore(0, {bytes.begin(), middle});
    flash.restore(1, {middle, bytes.end()});
    return {};
}

Status saveFlash(RamFlash &flash, const std::filesystem::path &file)
{
    std::string bytes;
    for (std::size_t bank = 0; bank < 2; ++bank)
        bytes.append(flash.bank(bank).begin(), flash.bank(bank).end());
    return writeFileAtomically(file, bytes);
}

} // namespace driftbench
