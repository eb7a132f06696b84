#include "support/device_decoders.h"

#include <cstddef>

// The first byte picks the decoder; contracts are checked where the decoders are called.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t bytes)
{
    driftbench::test::decodeUntrusted({data, bytes});
    return 0;
}
