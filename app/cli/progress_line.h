// Progress of long work as one line on standard error that is redrawn in place and wiped at the end. Silent
// where standard error is no terminal, and for work that is done before a person would look.
//
//   ProgressLine progress;
//   fitSomething(input, progress.hook());
//
// The hook also passes on an interrupt as the wish to stop.
#pragma once

#include "engine/base/progress.h"

#include <chrono>
#include <string>

namespace driftbench::cli {

class ProgressLine
{
public:
    ProgressLine();
    ~ProgressLine();
    ProgressLine(const ProgressLine &) = delete;
    ProgressLine &operator=(const ProgressLine &) = delete;

    ProgressHook hook();                // must not outlive this; may be called from one thread at a time
    void show(const std::string &text); // in place of the percentage

private:
    std::chrono::steady_clock::time_point m_nextDraw;
    bool m_terminal;
    bool m_drawn = false;
};

} // namespace driftbench::cli
