#pragma once
/// Bytes of a known number as exactly one zstd frame, which says their number.

#include <span>

#include "app/wire/messages.h"

namespace pdr::wire {

/// Behind `head`, the bytes that go before the frame. `level`: of zstd; the lower the faster.
Bytes packedFrame(std::span<const std::byte> head, std::span<const std::byte> raw, int level);
/// Whether it is one frame, all of it, that says it holds so many bytes. To be asked before memory is taken for them.
bool isFrameOf(std::span<const std::byte> frame, std::size_t rawBytes);
/// Into all of `raw`. False: it is no frame of so many bytes.
bool unpackFrame(std::span<const std::byte> frame, std::span<std::byte> raw);

}  // namespace pdr::wire
