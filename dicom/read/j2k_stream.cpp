#include "dicom/read/j2k_stream.h"

#include <algorithm>
#include <array>
#include <optional>

namespace pdr::dicom {

namespace {

using Bytes = std::span<const std::uint8_t>;

// Markers (table A.2)
constexpr unsigned kStart = 0xFF4F, kSize = 0xFF51, kCoding = 0xFF52, kComponentCoding = 0xFF53, kTilePart = 0xFF90,
                   kData = 0xFF93, kEnd = 0xFFD9;
constexpr std::size_t kTilePartBytes = 12;  ///< length of the segment that begins a tile part, with its marker
constexpr std::size_t kLengthInTilePart = 6;
/// A slice of 512 x 512 pixels has some hundred code blocks; OpenJPEG spends some hundred bytes on each.
constexpr std::int64_t kMostBlocks = 1 << 20;
constexpr std::int64_t kMostTiles = 4096;
constexpr int kMostLevels = 32;

unsigned word(Bytes bytes, std::size_t at) {
    return unsigned(bytes[at]) << 8 | bytes[at + 1];
}
std::uint32_t longWord(Bytes bytes, std::size_t at) {
    return std::uint32_t(word(bytes, at)) << 16 | word(bytes, at + 2);
}

std::int64_t quotientUp(std::int64_t a, std::int64_t b) {
    return (a + b - 1) / b;
}

/// A marker segment: its marker, and what follows its length.
struct Segment {
    unsigned marker;
    Bytes content;
};

/// Reads the segments of a header one after the other.
class Segments {
  public:
    Segments(Bytes stream, std::size_t at) : stream_(stream), at_(at) {}

    /// Returns the next segment; none at a marker of `ends`, or if the header is broken.
    std::optional<Segment> next(std::initializer_list<unsigned> ends) {
        if (at_ + 4 > stream_.size())
            return std::nullopt;
        const unsigned marker = word(stream_, at_), length = word(stream_, at_ + 2);
        atEnd_ = std::ranges::find(ends, marker) != ends.end();
        if (atEnd_ || marker < 0xFF00 || length < 2 || at_ + 2 + length > stream_.size())
            return std::nullopt;
        const Segment segment{marker, stream_.subspan(at_ + 4, length - 2)};
        at_ += 2 + length;
        return segment;
    }
    /// Whether the last call of next() has met a marker of `ends`.
    bool atEnd() const { return atEnd_; }
    std::size_t at() const { return at_; }

  private:
    Bytes stream_;
    std::size_t at_;
    bool atEnd_ = false;
};

/// The part of a coding style that COD and COC share (tables A.15 and A.20): from the number of levels on.
struct CodingStyle {
    int levels;
    int blockWidth, blockHeight;  ///< as exponents of 2
    bool isReversible;
    Bytes precincts;  ///< their sizes by resolution, as exponents of 2 in four bits each; empty: as large as can be
};

std::optional<CodingStyle> codingStyle(const Segment& segment) {
    const bool ofComponent = segment.marker == kComponentCoding;
    const std::size_t style = ofComponent ? 1 : 0, first = ofComponent ? 2 : 5;
    const Bytes content = segment.content;
    if (content.size() < first + 5)
        return std::nullopt;
    const CodingStyle found{content[first], content[first + 1] + 2, content[first + 2] + 2, content[first + 4] == 1,
                            (content[style] & 1) ? content.subspan(first + 5) : Bytes()};
    const bool isSound = found.levels <= kMostLevels && found.blockWidth <= 10 && found.blockHeight <= 10 &&
                         ((content[style] & 1) == 0 || found.precincts.size() > std::size_t(found.levels));
    return isSound ? std::optional(found) : std::nullopt;
}

/// Returns how many code blocks and precincts an image of that size is divided into, at most.
std::int64_t blocksOf(const CodingStyle& style, ivec2 size, std::int64_t tiles) {
    std::int64_t blocks = 0;
    for (int resolution = 0; resolution <= style.levels; ++resolution) {
        const int halvings = style.levels - resolution;
        const auto sizes = style.precincts.empty() ? 0xFFu : unsigned(style.precincts[std::size_t(resolution)]);
        const auto count = [&](int pixels, unsigned precinct, int block) {
            const int exponent = std::min(int(precinct), block);
            return quotientUp(quotientUp(pixels, std::int64_t(1) << halvings), std::int64_t(1) << exponent);
        };
        blocks += count(size.x, sizes & 15, style.blockWidth) * count(size.y, sizes >> 4, style.blockHeight);
    }
    return blocks + tiles * (style.levels + 1);
}

/// Reads the headers of a stream into what is known of it.
class Headers {
  public:
    explicit Headers(Bytes stream) : stream_(stream) {}

    J2kStream read() {
        if (stream_.size() < 4 || word(stream_, 0) != kStart || word(stream_, 2) != kSize)
            return damaged(phrase("it is no JPEG 2000 codestream"));
        Segments main(stream_, 2);
        bool isCoded = false;
        while (const auto segment = main.next({kTilePart})) {
            if (!take(*segment))
                return found_;
            isCoded = isCoded || segment->marker == kCoding;
        }
        if (!main.atEnd() || !isCoded || found_.components == 0)
            return damaged(phrase("its header is broken"));
        readTileParts(main.at());
        return found_;
    }

  private:
    /// Reads the headers of the tile parts, which may state another coding.
    void readTileParts(std::size_t at) {
        while (at + kTilePartBytes <= stream_.size() && word(stream_, at) == kTilePart) {
            Segments header(stream_, at);
            while (const auto segment = header.next({kData}))
                if (!take(*segment))
                    return;
            if (!header.atEnd()) {
                damaged(phrase("its header is broken"));
                return;
            }
            const std::uint32_t length = longWord(stream_, at + kLengthInTilePart);
            if (length == 0)
                return;  // it is the last one
            at += std::max<std::size_t>(length, kTilePartBytes);
        }
    }

    bool take(const Segment& segment) {
        if (segment.marker == kSize)
            return takeSize(segment.content);
        if (segment.marker != kCoding && segment.marker != kComponentCoding)
            return true;
        const auto style = codingStyle(segment);
        if (!style)
            return fail(phrase("its header is broken"));
        if (blocksOf(*style, found_.size, tiles_) > kMostBlocks)
            return fail(phrase("it is divided into more than %1 blocks", kMostBlocks));
        found_.isReversible = found_.isReversible && style->isReversible;
        return true;
    }

    bool takeSize(Bytes content) {
        if (content.size() < 39 || found_.components > 0)
            return fail(phrase("its header is broken"));
        const auto axis = [&](std::size_t at) {
            return std::array<std::int64_t, 4>{longWord(content, at), longWord(content, at + 8),
                                               longWord(content, at + 16), longWord(content, at + 24)};
        };
        const auto [right, left, tileWidth, tileLeft] = axis(2);
        const auto [bottom, top, tileHeight, tileTop] = axis(6);
        constexpr std::int64_t kMost = 1 << 30;
        if (right <= left || bottom <= top || right > kMost || bottom > kMost || tileWidth == 0 || tileHeight == 0 ||
            tileLeft > left || tileTop > top)
            return fail(phrase("its header is broken"));
        tiles_ = quotientUp(right - tileLeft, tileWidth) * quotientUp(bottom - tileTop, tileHeight);
        if (tiles_ > kMostTiles)
            return fail(phrase("it is divided into more than %1 blocks", kMostTiles));
        found_.size = {int(right - left), int(bottom - top)};
        found_.components = int(word(content, 34));
        found_.precision = (content[36] & 0x7F) + 1;
        found_.isSigned = (content[36] & 0x80) != 0;
        return found_.components > 0 || fail(phrase("its header is broken"));
    }

    bool fail(Text what) {
        found_.damage = std::move(what);
        return false;
    }
    J2kStream damaged(Text what) {
        fail(std::move(what));
        return found_;
    }

    Bytes stream_;
    J2kStream found_;
    std::int64_t tiles_ = 0;
};

}  // namespace

J2kStream readJ2k(Bytes stream) {
    return Headers(stream).read();
}

void trimToCodestream(std::vector<std::uint8_t>& stream) {
    constexpr std::array<std::uint8_t, 4> kBegins{0xFF, 0x4F, 0xFF, 0x51};
    constexpr std::ptrdiff_t kMostBoxBytes = 1 << 16;
    const auto last = stream.begin() + std::min(std::ptrdiff_t(stream.size()), kMostBoxBytes);
    if (const auto begin = std::search(stream.begin(), last, kBegins.begin(), kBegins.end()); begin != last)
        stream.erase(stream.begin(), begin);
    std::size_t end = stream.size();
    while (end > 2 && stream[end - 1] == 0)
        --end;
    if (end > 2 && word(stream, end - 2) == kEnd)
        stream.resize(end);
}

bool mendLastLength(std::vector<std::uint8_t>& stream) {
    if (stream.size() < 4 || word(stream, stream.size() - 2) != kEnd)
        return false;
    Segments main(stream, 2);
    while (main.next({kTilePart})) {
    }
    std::size_t at = main.at();
    while (at + kTilePartBytes <= stream.size() && word(stream, at) == kTilePart) {
        const std::size_t length = longWord(stream, at + kLengthInTilePart), end = stream.size() - 2;
        if (length == 0 || at + length == end)
            return false;
        if (at + length > end) {
            std::fill_n(stream.begin() + std::ptrdiff_t(at + kLengthInTilePart), 4, std::uint8_t(0));
            return true;
        }
        if (length < kTilePartBytes)
            return false;
        at += length;
    }
    return false;
}

}  // namespace pdr::dicom
