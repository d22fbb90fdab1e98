#pragma once
/// Compresses bytes to exactly one zstd frame that states their number. Packers and unpackers reuse their memory from
/// frame to frame.

#include <memory>
#include <span>

#include "app/wire/messages.h"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace pdr::wire {

class FramePacker {
  public:
    /// `level`: compression level of zstd; the lower, the faster.
    explicit FramePacker(int level);
    /// Returns the compressed frame; valid until the next call.
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
    /// Decompresses `frame` into `raw`. False: it is not a frame of that many bytes.
    bool unpack(std::span<const std::byte> frame, std::span<std::byte> raw);

  private:
    struct Free {
        void operator()(ZSTD_DCtx_s* context) const;
    };
    std::unique_ptr<ZSTD_DCtx_s, Free> context_;
};

/// Returns `head` followed by the compressed frame of `raw`.
Bytes packedFrame(std::span<const std::byte> head, std::span<const std::byte> raw, int level);
/// Returns the compressed size of the frame at the start of `bytes`; 0: there is none.
std::size_t firstFrameBytes(std::span<const std::byte> bytes);
/// Whether `frame` is exactly one frame that states that size. Check this before allocating.
bool isFrameOf(std::span<const std::byte> frame, std::size_t rawBytes);

/// Puts the bytes at even positions first and those at odd positions behind them. The low bytes of int16 voxels are
/// noise and the high bytes mostly alike: separated, they compress four times as fast, and smaller. Both spans have the
/// same size.
void splitBytes(std::span<const std::byte> raw, std::span<std::byte> halves);
/// Restores the order of the bytes: the inverse of splitBytes().
void joinBytes(std::span<const std::byte> halves, std::span<std::byte> raw);

}  // namespace pdr::wire
