#include "app/session/session_file_state.h"

#include <chrono>
#include <cstdio>
#include <ctime>

namespace driftbench {

std::string utcNow()
{
    using namespace std::chrono;
    const auto now = system_clock::now();
    const std::time_t seconds = system_clock::to_time_t(floor<std::chrono::seconds>(now));
    const auto milliseconds =
        static_cast<int>(floor<std::chrono::milliseconds>(now.time_since_epoch()).count() % 1000);
    std::tm parts{};
    ::gmtime_r(&seconds, &parts);
    std::string text(40, '\0');
    const int length = std::snprintf(text.data(), text.size(), "%04d-%02d-%02dT%02d:%02d:%02d.%03dZ",
                                     parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday, parts.tm_hour,
                                     parts.tm_min, parts.tm_sec, milliseconds);
    text.resize(static_cast<std::size_t>(length));
    return text;
}

std::string orNow(const std::string &utc)
{
    return utc.empty() ? utcNow() : utc;
}

std::optional<double> secondsOfUtc(const std::string &utc)
{
    std::tm parts{};
    int milliseconds = 0;
    if (std::sscanf(utc.c_str(), "%4d-%2d-%2dT%2d:%2d:%2d.%3dZ", &parts.tm_year, &parts.tm_mon,
                    &parts.tm_mday, &parts.tm_hour, &parts.tm_min, &parts.tm_sec, &milliseconds) < 6)
        return std::nullopt;
    parts.tm_year -= 1900;
    parts.tm_mon -= 1;
    return static_cast<double>(::timegm(&parts)) + milliseconds * 1e-3;
}

} // namespace driftbench
