#include "app/wire/one_frame.h"

#include <zstd.h>

#include <algorithm>
#include <cassert>

namespace pdr::wire {

Bytes packedFrame(std::span<const std::byte> head, std::span<const std::byte> raw, int level) {
    Bytes packed(head.size() + ZSTD_compressBound(raw.size()));
    std::ranges::copy(head, packed.begin());
    std::byte* frame = packed.data() + head.size();
    const std::size_t bytes = ZSTD_compress(frame, packed.size() - head.size(), raw.data(), raw.size(), level);
    assert(!ZSTD_isError(bytes));
    packed.resize(head.size() + bytes);
    return packed;
}

bool isFrameOf(std::span<const std::byte> frame, std::size_t rawBytes) {
    return ZSTD_getFrameContentSize(frame.data(), frame.size()) == rawBytes &&
           ZSTD_findFrameCompressedSize(frame.data(), frame.size()) == frame.size();
}

bool unpackFrame(std::span<const std::byte> frame, std::span<std::byte> raw) {
    return isFrameOf(frame, raw.size()) &&
           ZSTD_decompress(raw.data(), raw.size(), frame.data(), frame.size()) == raw.size();
}

}  // namespace pdr::wire
