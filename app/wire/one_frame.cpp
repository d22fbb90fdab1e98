#include "app/wire/one_frame.h"

#include <zstd.h>

#include <cassert>

namespace pdr::wire {

void FramePacker::Free::operator()(ZSTD_CCtx_s* context) const {
    ZSTD_freeCCtx(context);
}

FramePacker::FramePacker(int level) : level_(level), context_(ZSTD_createCCtx()) {}

std::span<const std::byte> FramePacker::pack(std::span<const std::byte> raw) {
    if (const std::size_t most = ZSTD_compressBound(raw.size()); most > most_) {
        frame_ = std::make_unique_for_overwrite<std::byte[]>(most);
        most_ = most;
    }
    const std::size_t bytes = ZSTD_compressCCtx(context_.get(), frame_.get(), most_, raw.data(), raw.size(), level_);
    assert(!ZSTD_isError(bytes));
    return {frame_.get(), bytes};
}

void FrameUnpacker::Free::operator()(ZSTD_DCtx_s* context) const {
    ZSTD_freeDCtx(context);
}

FrameUnpacker::FrameUnpacker() : context_(ZSTD_createDCtx()) {}

bool FrameUnpacker::unpack(std::span<const std::byte> frame, std::span<std::byte> raw) {
    return isFrameOf(frame, raw.size()) &&
           ZSTD_decompressDCtx(context_.get(), raw.data(), raw.size(), frame.data(), frame.size()) == raw.size();
}

Bytes packedFrame(std::span<const std::byte> head, std::span<const std::byte> raw, int level) {
    FramePacker packer(level);
    const std::span<const std::byte> frame = packer.pack(raw);
    Bytes packed;
    packed.reserve(head.size() + frame.size());
    packed.assign(head.begin(), head.end());
    packed.insert(packed.end(), frame.begin(), frame.end());
    return packed;
}

std::size_t firstFrameBytes(std::span<const std::byte> bytes) {
    const std::size_t size = ZSTD_findFrameCompressedSize(bytes.data(), bytes.size());
    return ZSTD_isError(size) ? 0 : size;
}

bool isFrameOf(std::span<const std::byte> frame, std::size_t rawBytes) {
    return ZSTD_getFrameContentSize(frame.data(), frame.size()) == rawBytes && firstFrameBytes(frame) == frame.size();
}

void splitBytes(std::span<const std::byte> raw, std::span<std::byte> halves) {
    const std::size_t odds = raw.size() / 2, evens = raw.size() - odds;
    for (std::size_t i = 0; i < odds; ++i) {
        halves[i] = raw[2 * i];
        halves[evens + i] = raw[2 * i + 1];
    }
    if (evens > odds)
        halves[odds] = raw.back();
}

void joinBytes(std::span<const std::byte> halves, std::span<std::byte> raw) {
    const std::size_t odds = raw.size() / 2, evens = raw.size() - odds;
    for (std::size_t i = 0; i < odds; ++i) {
        raw[2 * i] = halves[i];
        raw[2 * i + 1] = halves[evens + i];
    }
    if (evens > odds)
        raw.back() = halves[odds];
}

}  // namespace pdr::wire
