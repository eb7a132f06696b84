#include "app/cli/help_format.h"

#include <sstream>

namespace driftbench::cli {

namespace {

constexpr std::size_t kDescriptionColumn = 29;

// The words, as many a line as fit between the column and the edge; the text is already at the column.
std::string filled(const std::string &text, std::size_t column)
{
    std::istringstream words(text);
    std::string result;
    std::string word;
    std::size_t at = column;
    while (words >> word) {
        const bool first = at == column;
        if (!first && at + 1 + word.size() > kHelpColumns) {
            result += "\n" + std::string(column, ' ');
            at = column;
        } else if (!first) {
            result += ' ';
            ++at;
        }
        result += word;
        at += word.size();
    }
    return result + "\n";
}

std::string entry(const std::string &name, const std::string &description)
{
    std::string text = "  " + name;
    if (description.empty())
        return text + "\n";
    if (text.size() + 1 > kDescriptionColumn)
        text += "\n" + std::string(kDescriptionColumn, ' ');
    else
        text.resize(kDescriptionColumn, ' ');
    return text + filled(description, kDescriptionColumn);
}

} // namespace

HelpFormat::HelpFormat()
{
    column_width(kDescriptionColumn);
    label("SUBCOMMAND", "COMMAND");
}

std::string HelpFormat::make_description(const CLI::App *app) const
{
    return app->get_description().empty() ? std::string() : filled(app->get_description(), 0);
}

std::string HelpFormat::make_subcommand(const CLI::App *command) const
{
    return entry(command->get_name(), command->get_description());
}

std::string HelpFormat::make_option(const CLI::Option *option, bool isPositional) const
{
    std::string description = option->get_description();
    if (!isPositional && option->get_required())
        description += " (required)";
    if (!option->get_default_str().empty())
        description += " (default: " + option->get_default_str() + ")";
    return entry(make_option_name(option, isPositional) + make_option_opts(option), description);
}

std::string HelpFormat::make_option_opts(const CLI::Option *option) const
{
    // Positionals are named after what they hold.
    if (option->get_type_size() == 0 || option->get_positional() || option->get_type_name().empty())
        return {};
    return " " + option->get_type_name();
}

} // namespace driftbench::cli
