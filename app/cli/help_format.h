// Help texts that fit a terminal of 80 columns: descriptions are broken between words and stay in their
// column.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace driftbench::cli {

inline constexpr std::size_t kHelpColumns = 80;

class HelpFormat : public CLI::Formatter
{
public:
    HelpFormat();

    std::string make_description(const CLI::App *app) const override;
    std::string make_subcommand(const CLI::App *command) const override;
    std::string make_option(const CLI::Option *option, bool isPositional) const override;
    std::string make_option_opts(const CLI::Option *option) const override;
};

} // namespace driftbench::cli
