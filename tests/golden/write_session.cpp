// write_session FILE: the golden session file of the present version (target write_session, not built by
// default). Files of earlier versions stay as they are; they were written by this program in its time.
#include "support/golden_session.h"

#include <cstdio>

using namespace driftbench;

int main(int argc, char **argv)
{
    if (argc != 2)
        return 2;
    auto file = SessionFile::create(argv[1], {{}, "golden"});
    const Status filled = file ? test::fillGoldenSession(*file) : Status(file.error());
    if (!filled)
        std::fprintf(stderr, "%s\n", filled.error().message.c_str());
    return filled ? 0 : 1;
}
