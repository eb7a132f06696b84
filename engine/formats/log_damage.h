// What of a binary log could not be read, and the sentence about it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace driftbench {

struct LogDamage
{
    std::optional<std::uint64_t> firstByte; // nothing: the log is whole
    std::uint64_t places = 0;
    std::uint64_t bytesLeftOut = 0;
    bool toTheEnd = false; // nothing could be read behind the last place

    void add(std::uint64_t offset, std::uint64_t bytes)
    {
        if (!firstByte)
            firstByte = offset;
        ++places;
        bytesLeftOut += bytes;
    }

    std::string warning(const std::string &file) const
    {
        if (toTheEnd && places == 1) {
            return file + " is cut or damaged from byte " + std::to_string(*firstByte) + " on: the last " +
                   std::to_string(bytesLeftOut) + " bytes were left out.";
        }
        return file + " is damaged at byte " + std::to_string(*firstByte) + ": " +
               std::to_string(bytesLeftOut) + " bytes in " + std::to_string(places) +
               " places were left out.";
    }
};

} // namespace driftbench
