#pragma once
/// Reads the bits of entropy-coded JPEG data, one Huffman code at a time.

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "dicom/read/jpeg_stream.h"

namespace pdr::dicom {

/// The bits between two markers, without byte stuffing.
class CodedBits {
  public:
    explicit CodedBits(std::span<const std::uint8_t> stuffed);

    /// Returns the next 16 bits; zeros behind the end.
    unsigned next16() const;
    /// Moves on by `count` bits, in [0, 16], and returns them.
    unsigned take(int count);

    std::size_t at() const { return at_; }
    bool overrun() const { return at_ > bits_; }
    /// Returns the number of whole bytes that were not read.
    std::size_t bytesLeft() const { return overrun() ? 0 : (bits_ - at_) / 8; }
    /// Returns whether all bits from `from` to here lie in one long run of zero bytes.
    bool withinZeroRun(std::size_t from);

  private:
    std::vector<std::uint8_t> bytes_;  ///< the bytes, and four more, so that reading needs no test
    std::size_t bits_ = 0, at_ = 0;
    std::vector<std::pair<std::size_t, std::size_t>> zeroRuns_;  ///< [first, last) in bits
    std::size_t run_ = 0;
};

/// Decodes Huffman codes with a table.
class HuffmanDecoder {
  public:
    explicit HuffmanDecoder(const HuffmanCode& code);

    /// Returns the next symbol, or -1 if the bits are no code.
    int take(CodedBits& bits) const;

  private:
    static constexpr int kFastBits = 9;
    std::vector<std::uint8_t> symbols_;
    std::array<std::uint16_t, 1 << kFastBits> fast_{};  ///< length << 8 | symbol; 0: a longer code
    std::array<int, 17> firstCode_{}, firstSymbol_{}, counts_{};
};

}  // namespace pdr::dicom
