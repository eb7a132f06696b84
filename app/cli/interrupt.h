// Ctrl-C and SIGTERM ask long work to stop at its next progress report, so that no half file is left. A
// second one ends the program at once. A limit on the size of files becomes an error instead of a signal.
#pragma once

namespace driftbench::cli {

void listenForInterrupts();
bool interrupted();

} // namespace driftbench::cli
