// A report put together from its head and the bytes that it carries.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace driftbench {

inline std::vector<std::uint8_t> reportOf(std::initializer_list<std::uint8_t> head,
                                          std::span<const std::uint8_t> bytes)
{
    std::vector<std::uint8_t> report(head.size() + bytes.size());
    std::copy(head.begin(), head.end(), report.begin());
    std::copy(bytes.begin(), bytes.end(), report.begin() + static_cast<std::ptrdiff_t>(head.size()));
    return report;
}

} // namespace driftbench
