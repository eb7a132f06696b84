// Any bytes as a session file; begin with tests/golden/session-v*.driftbench, so that what changes is their
// pages.
#include "app/session/session_file.h"
#include "fuzz_file.h"

#include <cstdlib>

using namespace driftbench;

namespace {

template <class T>
void expectSentence(const Result<T> &result)
{
    if (!result && result.error().message.empty())
        std::abort();
}

} // namespace

// Whatever the bytes are: an error with a sentence, or what is recoverable.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t bytes)
{
    const fuzz::FuzzFile bytesAsFile(data, bytes);
    if (!bytesAsFile.whole())
        return 0;
    const auto file = SessionFile::open(bytesAsFile.path(), SessionAccess::ReadOnly);
    expectSentence(file);
    if (!file)
        return 0;
    expectSentence(file->check());
    const auto runs = file->runs();
    expectSentence(runs);
    for (const RunRecord &run : runs ? *runs : std::vector<RunRecord>()) {
        const auto strict = file->readRun(run.id);
        const auto lenient = file->readRun(run.id, {true});
        expectSentence(strict);
        expectSentence(lenient);
        expectSentence(file->overview(run.id));
        expectSentence(file->gaps(run.id));
        expectSentence(file->exclusions(run.id));
        expectSentence(file->mask(run.id));
    }
    expectSentence(file->models());
    expectSentence(file->plan());
    expectSentence(file->comparisons());
    expectSentence(file->uploads());
    expectSentence(file->events());
    return 0;
}
