#include "app/cli/interrupt.h"

#include <csignal>

namespace driftbench::cli {

namespace {

// A signal handler can leave its message nowhere else.
volatile std::sig_atomic_t wasInterrupted = 0;

extern "C" void noteInterrupt(int signalNumber)
{
    wasInterrupted = 1;
    std::signal(signalNumber, SIG_DFL);
}

} // namespace

void listenForInterrupts()
{
    std::signal(SIGINT, noteInterrupt);
    std::signal(SIGTERM, noteInterrupt);
    // A file that may not grow further is then an error of writing it, and what was written of it goes.
    std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted()
{
    return wasInterrupted != 0;
}

} // namespace driftbench::cli
