/// libFuzzer's way into the reader of frames, of the side that PDR_READER names (see ./run).

#include "tests/fuzz/heard.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    pdr::test::hearAnything(pdr::wire::Role::PDR_READER, std::as_bytes(std::span(data, size)));
    return 0;
}
