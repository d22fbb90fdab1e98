#include "dicom/read/rle_stream.h"

#include <algorithm>

namespace pdr::dicom {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kHeaderBytes = 64;
/// Number of equal bytes, coded one by one, that is damage. The standard allows two; an encoder that codes runs does
/// not come near this.
constexpr int kSpelledOut = 12;

std::uint32_t number(Bytes bytes, std::size_t at) {
    return std::uint32_t(bytes[at]) | std::uint32_t(bytes[at + 1]) << 8 | std::uint32_t(bytes[at + 2]) << 16 |
           std::uint32_t(bytes[at + 3]) << 24;
}

/// The result of one walk through a segment.
struct Segment {
    std::size_t decoded = 0;  ///< bytes that it decodes to
    std::size_t used = 0;     ///< bytes that were read for them
    int spelledOut = 0;       ///< the longest stretch of equal bytes that is not coded as a run
    bool gathers = false;     ///< whether the encoder codes runs at all
    bool cutOff = false;      ///< whether it ends inside a run
};

Segment walk(Bytes coded, std::size_t pixels) {
    Segment seen;
    int same = 0, last = -1;
    while (seen.decoded < pixels && seen.used < coded.size()) {
        const int head = std::int8_t(coded[seen.used++]);
        if (head == -128)
            continue;
        const std::size_t count = std::size_t(head < 0 ? 1 - head : 1 + head), taken = head < 0 ? 1 : count;
        if (taken > coded.size() - seen.used) {
            seen.cutOff = true;
            return seen;
        }
        seen.gathers |= head < -2;
        for (std::size_t i = 0; i < taken && head >= 0; ++i) {
            same = coded[seen.used + i] == last ? same + 1 : 1;
            last = coded[seen.used + i];
            seen.spelledOut = std::max(seen.spelledOut, same);
        }
        if (head < 0)
            last = -1;
        seen.used += taken;
        seen.decoded += count;
    }
    return seen;
}

/// Returns whether `rest` is padding. Segments are of even length; encoders of whole words leave one more byte.
bool isPadding(Bytes rest) {
    return rest.size() <= 2 &&
           std::all_of(rest.begin(), rest.end(), [](auto byte) { return byte == 0 || byte == 128; });
}

}  // namespace

Text rleDamage(Bytes stream, std::size_t pixels, int segments) {
    if (stream.size() < kHeaderBytes)
        return phrase("it is shorter than its header");
    if (number(stream, 0) != std::uint32_t(segments))
        return phrase("it holds %1 segments instead of %2", number(stream, 0), segments);
    for (int i = 0; i < segments; ++i) {
        const std::uint32_t start = number(stream, 4 + 4 * std::size_t(i));
        if (i == 0 ? start != kHeaderBytes : start <= number(stream, 4 * std::size_t(i)) || start >= stream.size())
            return phrase("its header places segments where none can be");
    }
    for (int i = 0; i < segments; ++i) {
        const std::size_t start = number(stream, 4 + 4 * std::size_t(i));
        const std::size_t end = i + 1 < segments ? number(stream, 8 + 4 * std::size_t(i)) : stream.size();
        const Bytes coded = stream.subspan(start, end - start);
        const Segment seen = walk(coded, pixels);
        if (seen.cutOff || seen.decoded < pixels)
            return phrase("a segment of it ends before its last pixel");
        if (seen.decoded > pixels || !isPadding(coded.subspan(seen.used)))
            return phrase("a segment of it goes on behind its last pixel");
        if (seen.gathers && seen.spelledOut >= kSpelledOut)
            return phrase("a run of equal bytes is spelled out");
    }
    return {};
}

}  // namespace pdr::dicom
