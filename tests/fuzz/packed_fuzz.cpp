/// libFuzzer's way through whole frames to what lies behind zstd (see ./run).

#include "tests/fuzz/packed.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto frame = pdr::test::packedFrameOf(std::as_bytes(std::span(data, size)));
    pdr::test::hearAnything(frame.reader, frame.bytes);
    return 0;
}
