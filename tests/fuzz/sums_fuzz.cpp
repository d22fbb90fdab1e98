/// libFuzzer's way to what lies behind zstd (see ./run).

#include "tests/fuzz/heard.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    pdr::test::unpackAnySums(std::as_bytes(std::span(data, size)));
    return 0;
}
