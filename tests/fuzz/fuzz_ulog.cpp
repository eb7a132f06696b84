#include "engine/formats/ulog_reader.h"
#include "fuzz_file.h"

#include <cstdlib>

using namespace driftbench;

// Whatever the bytes are: a recording with samples, or an error with a sentence.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t bytes)
{
    const fuzz::FuzzFile file(data, bytes);
    if (!file.whole())
        return 0;
    std::int64_t samples = 0;
    const BlockSink sink = [&](const SampleBlock &block) {
        samples += block.size();
        return Flow::Continue;
    };
    const auto info = readULogBlocks(file.path(), 0, sink);
    if (info ? samples == 0 : info.error().message.empty())
        std::abort();
    return 0;
}
