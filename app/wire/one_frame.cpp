#include "app/wire/one_frame.h"

#include <zstd.h>

#include <cassert>
#include <memory>

namespace pdr::wire {

Bytes packedFrame(std::span<const std::byte> head, std::span<const std::byte> raw, int level) {
    const std::size_t most = ZSTD_compressBound(raw.size());
    const auto frame = std::make_unique_for_overwrite<std::byte[]>(most);
    const std::size_t bytes = ZSTD_compress(frame.get(), most, raw.data(), raw.size(), level);
    assert(!ZSTD_isError(bytes));
    Bytes packed;
    packed.reserve(head.size() + bytes);
    packed.assign(head.begin(), head.end());
    packed.insert(packed.end(), frame.get(), frame.get() + bytes);
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
