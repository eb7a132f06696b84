#include "app/cli/text_layout.h"

#include <algorithm>

namespace driftbench::cli {

namespace {

std::string padding(std::string_view text, std::size_t width)
{
    return std::string(width - std::min(width, widthOf(text)), ' ');
}

} // namespace

std::size_t widthOf(std::string_view text)
{
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string left(const std::string &text, std::size_t width)
{
    return text + padding(text, width);
}

std::string right(const std::string &text, std::size_t width)
{
    return padding(text, width) + text;
}

std::string wrapped(const std::string &lead, const std::string &text)
{
    std::string lines;
    std::string line = lead;
    const std::size_t indent = widthOf(lead);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        const bool first = widthOf(line) == indent;
        if (!first && widthOf(line) + 1 + widthOf(word) > kTextColumns) {
            lines += line + "\n";
            line = std::string(indent, ' ') + word;
        } else {
            line += (first ? "" : " ") + word;
        }
        at = end + 1;
    }
    return lines + line + "\n";
}

} // namespace driftbench::cli
