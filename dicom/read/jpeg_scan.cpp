#include "dicom/read/jpeg_scan.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "dicom/read/coded_bits.h"

namespace pdr::dicom {

namespace {

constexpr const char* kNoCode = "it holds bits that are no code";
constexpr const char* kBeyondBlock = "a run of it goes beyond its block";
constexpr const char* kZeros = "a run of zeros stands where tissue changes";
constexpr const char* kMean = "it holds a value that its samples cannot have";

/// Number of zeros in a row that is damage. The last bit of a mean that changes is one or zero by chance: so many zeros
/// occur once in 1e9.
constexpr int kZeroBits = 30;

/// One part of a scan, from a restart marker to the next. Each walk reads `units` pixels or blocks.
class Walk {
  public:
    /// Prepares the walk. `changes`: for each block of a progressive image, whether its mean differs from that of the
    /// block before. It is written by the scan that brings the means, and read from `unit` on by those that refine
    /// them.
    Walk(const JpegStream& stream, const JpegScan& scan, const HuffmanDecoder* dc, const HuffmanDecoder* ac,
         std::span<const std::uint8_t> part, std::vector<bool>& changes, std::size_t unit)
        : stream_(stream), scan_(scan), dc_(dc), ac_(ac), bits_(part), changes_(changes), unit_(unit) {}

    /// Returns the damage as a phrase, or null.
    const char* over(std::int64_t units) {
        for (std::int64_t i = 0; i < units && !damage_ && !bits_.overrun(); i += step(units - i)) {
        }
        if (damage_)
            return damage_;
        if (bits_.overrun())
            return "it ends before its last pixel";
        return bits_.bytesLeft() > 0 ? "bytes are left over behind its last pixel" : nullptr;
    }

  private:
    /// Reads what comes next and returns how many units it stands for.
    std::int64_t step(std::int64_t unitsLeft) {
        if (stream_.kind == JpegStream::Kind::lossless)
            return pixel();
        if (stream_.kind == JpegStream::Kind::sequential)
            return block();
        if (scan_.first > 0)
            return band(unitsLeft);
        return scan_.high > 0 ? meanBit() : mean();
    }

    void damaged(const char* phrase) {
        if (!damage_)
            damage_ = phrase;
    }

    /// Reads a difference of `category` bits (ISO 10918-1, F.1.2.1).
    int difference(int category) {
        if (category == 0)
            return 0;
        if (category == 16)
            return 32768;
        const int written = int(bits_.take(category));
        return written < 1 << (category - 1) ? written - (1 << category) + 1 : written;
    }

    int codedDifference(int mostBits) {
        const std::size_t from = bits_.at();
        const int category = dc_->take(bits_);
        if (category < 0 || category > mostBits)
            return damaged(kNoCode), 0;
        const int value = difference(category);
        if (value != 0 && bits_.withinZeroRun(from))
            damaged(kZeros);
        return value;
    }

    std::int64_t pixel() {
        codedDifference(16);
        return 1;
    }

    std::int64_t mean() {
        // Eight times the sample's range; the sum of a block's samples is what the coefficient holds.
        const int range = 1 << (stream_.precision + 2);
        const int change = codedDifference(15);
        mean_ += change;
        if (stream_.kind == JpegStream::Kind::progressive)
            changes_.push_back(change != 0);
        if (std::abs(std::int64_t(mean_) << scan_.low) * scan_.dcStep > range + (scan_.dcStep << scan_.low))
            damaged(kMean);
        return 1;
    }

    std::int64_t meanBit() {
        const bool isZero = bits_.take(1) == 0;
        if (unit_ < changes_.size() && changes_[unit_])
            zeros_ = isZero ? zeros_ + 1 : 0;
        if (zeros_ >= kZeroBits)
            damaged(kZeros);
        ++unit_;
        return 1;
    }

    std::int64_t block() {
        mean();
        coefficients(1, 63);
        return 1;
    }

    /// Reads the first bits of a band of a progressive image, or that it is empty in several blocks.
    std::int64_t band(std::int64_t unitsLeft) {
        const std::int64_t blocks = coefficients(scan_.first, scan_.last);
        if (blocks > unitsLeft)
            damaged(kBeyondBlock);
        return blocks;
    }

    /// Reads the coefficients of a block and returns the number of blocks that end here.
    std::int64_t coefficients(int first, int last) {
        for (int k = first; k <= last && !damage_ && !bits_.overrun(); ++k) {
            const std::size_t from = bits_.at();
            const int symbol = ac_->take(bits_);
            if (symbol < 0)
                return damaged(kNoCode), 1;
            const int run = symbol >> 4, category = symbol & 0x0F;
            if (category == 0 && run < 15)
                return endOfBlocks(run);
            k += run;
            if (k > last)
                return damaged(kBeyondBlock), 1;
            if (category > stream_.precision + 2)
                return damaged(kMean), 1;
            if (category > 0) {
                difference(category);
                if (bits_.withinZeroRun(from))
                    return damaged(kZeros), 1;
            }
        }
        return 1;
    }

    std::int64_t endOfBlocks(int run) {
        if (run == 0)
            return 1;
        if (stream_.kind == JpegStream::Kind::sequential)
            return damaged(kNoCode), 1;
        return (std::int64_t(1) << run) + std::int64_t(bits_.take(run));
    }

    const JpegStream& stream_;
    const JpegScan& scan_;
    const HuffmanDecoder *dc_, *ac_;
    CodedBits bits_;
    std::vector<bool>& changes_;
    std::size_t unit_;
    int mean_ = 0, zeros_ = 0;
    const char* damage_ = nullptr;
};

std::int64_t unitsOf(const JpegStream& stream) {
    const std::int64_t x = stream.size.x, y = stream.size.y;
    return stream.kind == JpegStream::Kind::lossless ? x * y : ((x + 7) / 8) * ((y + 7) / 8);
}

/// Returns whether a scan refines a band. Its bits depend on those before; constant tissue takes none of them, so long
/// zeros are damage.
bool refinesBand(const JpegStream& stream, const JpegScan& scan) {
    return stream.kind == JpegStream::Kind::progressive && scan.first > 0 && scan.high > 0;
}

const char* refinementDamage(const JpegScan& scan) {
    for (const auto& part : scan.parts) {
        CodedBits bits(part);
        while (bits.bytesLeft() > 0) {
            const std::size_t from = bits.at();
            bits.take(8);
            if (bits.withinZeroRun(from))
                return kZeros;
        }
    }
    return nullptr;
}

const char* scanDamage(const JpegStream& stream, const JpegScan& scan, std::vector<bool>& changes) {
    if (refinesBand(stream, scan))
        return refinementDamage(scan);
    // Check that the scan has its code tables
    const bool needsDc = scan.first == 0 || stream.kind != JpegStream::Kind::progressive;
    const bool refinesMean = stream.kind == JpegStream::Kind::progressive && scan.first == 0 && scan.high > 0;
    const bool needsAc = stream.kind == JpegStream::Kind::sequential || !needsDc;
    if ((needsDc && !refinesMean && !scan.dc) || (needsAc && !scan.ac))
        return "a code table is missing";
    if (scan.last > 63)
        return "a scan of it does not fit its frame";
    const std::optional<HuffmanDecoder> dc = scan.dc ? std::optional<HuffmanDecoder>(*scan.dc) : std::nullopt;
    const std::optional<HuffmanDecoder> ac = scan.ac ? std::optional<HuffmanDecoder>(*scan.ac) : std::nullopt;
    // Walk the parts between restart markers
    const std::int64_t all = unitsOf(stream);
    std::int64_t left = all;
    for (const auto& part : scan.parts) {
        const std::int64_t units = scan.restartInterval > 0 ? std::min<std::int64_t>(scan.restartInterval, left) : left;
        if (units == 0)
            return "it holds more restart markers than pixels";
        Walk walk(stream, scan, dc ? &*dc : nullptr, ac ? &*ac : nullptr, part, changes, std::size_t(all - left));
        if (const char* damage = walk.over(units))
            return damage;
        left -= units;
    }
    return left > 0 ? "it ends before its last pixel" : nullptr;
}

}  // namespace

Text jpegDamage(const JpegStream& stream) {
    using Kind = JpegStream::Kind;
    if (!stream.damage.empty())
        return stream.damage;
    if (stream.kind == Kind::jpegLs || stream.kind == Kind::other || stream.components != 1)
        return {};
    if (stream.precision < 2 || stream.precision > 16)
        return phrase("it states an impossible precision");
    std::vector<bool> changes;
    for (const JpegScan& scan : stream.scans) {
        if (const char* damage = scanDamage(stream, scan, changes))
            return damage;
    }
    return {};
}

}  // namespace pdr::dicom
