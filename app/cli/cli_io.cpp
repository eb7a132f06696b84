#include "app/cli/cli_io.h"

#include <cerrno>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

namespace driftbench::cli {

namespace {

void printToStandardError(std::string_view sentence)
{
    const std::string line = std::string(kProgramName) + ": " + std::string(sentence) + "\n";
    std::fwrite(line.data(), 1, line.size(), stderr);
}

} // namespace

void printError(std::string_view sentence)
{
    printToStandardError(sentence);
}

void printNotice(std::string_view sentence)
{
    printToStandardError(sentence);
}

Status printResult(std::string_view text)
{
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (written && std::fflush(stdout) == 0)
        return {};
    if (errno == ENOSPC)
        return Error{Errc::OutputFull, "Standard output can't take the result: no room is left on its disk."};
    return Error{Errc::OutputNotWritable, "Standard output can't be written to, so the result is not shown."};
}

Status printJson(const nlohmann::ordered_json &json)
{
    // File names need not be valid UTF-8; JSON must be.
    return printResult(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

} // namespace driftbench::cli
