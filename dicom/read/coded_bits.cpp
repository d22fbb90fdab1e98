#include "dicom/read/coded_bits.h"

namespace pdr::dicom {

namespace {

/// Smallest number of zero bytes in a row that only constant tissue is coded as.
constexpr std::size_t kLongRun = 12;

}  // namespace

CodedBits::CodedBits(std::span<const std::uint8_t> stuffed) {
    bytes_.reserve(stuffed.size() + 4);
    for (std::size_t i = 0; i < stuffed.size(); ++i) {
        bytes_.push_back(stuffed[i]);
        if (stuffed[i] == 0xFF)
            ++i;  // a zero follows
    }
    bits_ = 8 * bytes_.size();
    std::size_t zeros = 0;
    for (std::size_t i = 0; i <= bytes_.size(); ++i) {
        if (i < bytes_.size() && bytes_[i] == 0) {
            ++zeros;
            continue;
        }
        if (zeros >= kLongRun)
            zeroRuns_.emplace_back(8 * (i - zeros), 8 * i);
        zeros = 0;
    }
    bytes_.resize(bytes_.size() + 4, 0);
}

unsigned CodedBits::next16() const {
    if (at_ >= bits_)
        return 0;
    const std::uint8_t* from = &bytes_[at_ / 8];
    const unsigned three = unsigned(from[0]) << 16 | unsigned(from[1]) << 8 | unsigned(from[2]);
    return three >> (8 - at_ % 8) & 0xFFFF;
}

unsigned CodedBits::take(int count) {
    const unsigned taken = next16() >> (16 - count);
    at_ += std::size_t(count);
    return taken;
}

bool CodedBits::withinZeroRun(std::size_t from) {
    while (run_ < zeroRuns_.size() && zeroRuns_[run_].second < at_)
        ++run_;
    return run_ < zeroRuns_.size() && from >= zeroRuns_[run_].first && at_ <= zeroRuns_[run_].second;
}

HuffmanDecoder::HuffmanDecoder(const HuffmanCode& code) : symbols_(code.symbols), counts_(code.counts) {
    int next = 0, symbol = 0;
    for (int length = 1; length <= 16; ++length) {
        firstCode_[length] = next;
        firstSymbol_[length] = symbol;
        for (int i = 0; i < code.counts[length]; ++i, ++next, ++symbol) {
            const int spare = kFastBits - length;
            for (int k = 0; spare >= 0 && k < 1 << spare; ++k)
                fast_[std::size_t(next << spare | k)] = std::uint16_t(length << 8 | symbols_[std::size_t(symbol)]);
        }
        next <<= 1;
    }
}

int HuffmanDecoder::take(CodedBits& bits) const {
    const unsigned ahead = bits.next16();
    if (const unsigned found = fast_[ahead >> (16 - kFastBits)]; found != 0) {
        bits.take(int(found >> 8));
        return int(found & 0xFF);
    }
    for (int length = kFastBits + 1; length <= 16; ++length) {
        const int code = int(ahead >> (16 - length)) - firstCode_[length];
        if (code >= 0 && code < counts_[length]) {
            bits.take(length);
            return symbols_[std::size_t(firstSymbol_[length]) + std::size_t(code)];
        }
    }
    return -1;
}

}  // namespace pdr::dicom
