#include "app/cli/progress_line.h"

#include "app/cli/interrupt.h"
#include "engine/base/text.h"

#include <cstdio>
#include <string>
#include <unistd.h>

namespace driftbench::cli {

namespace {

constexpr std::chrono::milliseconds kQuietAtFirst{500};
constexpr std::chrono::milliseconds kBetweenDraws{100};
constexpr std::string_view kWipe = "\r\033[K";

void printNow(std::string_view text)
{
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

} // namespace

ProgressLine::ProgressLine()
    : m_nextDraw(std::chrono::steady_clock::now() + kQuietAtFirst), m_terminal(::isatty(STDERR_FILENO) == 1)
{
}

ProgressLine::~ProgressLine()
{
    if (m_drawn)
        printNow(kWipe);
}

ProgressHook ProgressLine::hook()
{
    return [this](const Progress &progress) {
        show(std::string(progress.stage) + "  " + fixed(100.0 * progress.fraction, 0) + " %");
        return interrupted() ? Flow::Stop : Flow::Continue;
    };
}

void ProgressLine::show(const std::string &text)
{
    const auto now = std::chrono::steady_clock::now();
    if (!m_terminal || now < m_nextDraw)
        return;
    m_nextDraw = now + kBetweenDraws;
    m_drawn = true;
    printNow(std::string(kWipe) + text);
}

} // namespace driftbench::cli
