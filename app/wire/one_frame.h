#pragma once
/// Compresses bytes to exactly one zstd frame that states their number. Memory is reused from frame to frame.

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
    /// The frame; valid until the next call.
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
    /// Fills `raw`. False: not a frame of that many bytes.
    bool unpack(std::span<const std::byte> frame, std::span<std::byte> raw);

  private:
    struct Free {
        void operator()(ZSTD_DCtx_s* context) const;
    };
    std::unique_ptr<ZSTD_DCtx_s, Free> context_;
};

/// `head` followed by the frame.
Bytes packedFrame(std::span<const std::byte> head, std::span<const std::byte> raw, int level);
/// Compressed size of the frame at the start of `bytes`; 0: there is none.
std::size_t firstFrameBytes(std::span<const std::byte> bytes);
/// Whether `frame` is exactly one frame that states that size. Check this before allocating.
bool isFrameOf(std::span<const std::byte> frame, std::size_t rawBytes);

/// Puts the bytes at even places first and those at odd ones behind, and back. The low bytes of int16 voxels are noise,
/// the high ones mostly alike: so they pack four times as fast, and smaller. Both spans are of one size.
void splitBytes(std::span<const std::byte> raw, std::span<std::byte> halves);
void joinBytes(std::span<const std::byte> halves, std::span<std::byte> raw);

}  // namespace pdr::wire
