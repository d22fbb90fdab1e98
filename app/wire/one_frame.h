#pragma once
/// Bytes of a known number as exactly one zstd frame, which says their number. The memory that packing takes is kept
/// from frame to frame.

#include <memory>
#include <span>

#include "app/wire/messages.h"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace pdr::wire {

class FramePacker {
  public:
    /// `level`: of zstd; the lower the faster.
    explicit FramePacker(int level);
    /// The frame, until the next one.
    std::span<const std::byte> pack(std::span<const std::byte> raw);

  private:
    struct Free {
        void operator()(ZSTD_CCtx_s* context) const;
    };
    int level_;
    std::unique_ptr<ZSTD_CCtx_s, Free> context_;
    std::unique_ptr<std::byte[]> frame_;
    std::size_t most_ = 0;
};

class FrameUnpacker {
  public:
    FrameUnpacker();
    /// Into all of `raw`. False: it is no frame of so many bytes.
    bool unpack(std::span<const std::byte> frame, std::span<std::byte> raw);

  private:
    struct Free {
        void operator()(ZSTD_DCtx_s* context) const;
    };
    std::unique_ptr<ZSTD_DCtx_s, Free> context_;
};

/// Behind `head`, the bytes that go before the frame.
Bytes packedFrame(std::span<const std::byte> head, std::span<const std::byte> raw, int level);
/// Of the frame that `bytes` begin with, packed. 0: they begin with none.
std::size_t firstFrameBytes(std::span<const std::byte> bytes);
/// Whether it is one frame, all of it, that says it holds so many bytes. To be asked before memory is taken for them.
bool isFrameOf(std::span<const std::byte> frame, std::size_t rawBytes);

}  // namespace pdr::wire
