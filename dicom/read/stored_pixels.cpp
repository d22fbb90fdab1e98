#include "dicom/read/stored_pixels.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <type_traits>

namespace pdr::dicom {

namespace {

/// Value that some GE scanners store outside the round field of view without declaring it, or while they declare
/// another.
constexpr int kGeOutsideField = -2000;
constexpr double kGeIntercept = -1024.0;

/// Converts the raw bits of a pixel to the number that they store. `Number` holds any of them: int, or std::int64_t for
/// pixels of 32 bits.
template <class Number>
class StoredValue {
  public:
    explicit StoredValue(const PixelFormat& format)
        : shift_(format.highBit + 1 - format.bitsStored),
          mask_(~0u >> (32 - format.bitsStored)),
          signBit_(format.isSigned ? Number(1) << (format.bitsStored - 1) : 0) {}

    Number of(unsigned raw) const { return (Number(raw >> shift_ & mask_) ^ signBit_) - signBit_; }

    /// Converts a padding value, which is written as a number, not as bits of a pixel, and often with the other
    /// signedness.
    Number ofPadding(int sixteenBits) const {
        if (signBit_ == 0)
            return sixteenBits;
        const int asSigned = std::int16_t(sixteenBits);
        if (asSigned >= -signBit_ && asSigned < signBit_)
            return asSigned;
        // These are the bits of a pixel, then, and not a number; what is wider than a pixel stays so and matches none.
        return (Number(sixteenBits) ^ signBit_) - signBit_;
    }

  private:
    int shift_;
    unsigned mask_;
    Number signBit_;
};

/// The stored values that mean "nothing measured here".
class PaddingRule {
  public:
    template <class Number>
    PaddingRule(const ValueMeaning& meaning, const StoredValue<Number>& stored, Padding padding) {
        if (meaning.paddingValue) {
            const auto first = int(stored.ofPadding(*meaning.paddingValue));
            const auto last = meaning.paddingLimit ? int(stored.ofPadding(*meaning.paddingLimit)) : first;
            lowest_ = std::min(first, last);
            highest_ = std::max(first, last);
        }
        geOutside_ = padding == Padding::maskAsAir && meaning.intercept == kGeIntercept && meaning.slope == 1.0;
    }

    template <class Number>
    bool matches(Number stored) const {
        return (stored >= lowest_ && stored <= highest_) || (geOutside_ && stored == kGeOutsideField);
    }

  private:
    int lowest_ = 1, highest_ = 0;
    bool geOutside_ = false;
};

/// Computes HU = stored * slope + intercept, rounded to the nearest.
class Rescale {
  public:
    explicit Rescale(const ValueMeaning& meaning)
        : slope_(meaning.slope.value_or(1.0)), intercept_(meaning.intercept.value_or(0.0)) {}

    /// Returns the whole number that is added to every stored value; none if there is more to it. True for nearly every
    /// CT: no rounding is needed, which takes most of the time.
    std::optional<int> shift() const {
        if (slope_ == 1.0 && std::abs(intercept_) < 1e6 && intercept_ == std::floor(intercept_))
            return int(intercept_);
        return {};
    }

    /// Returns HU, clamped to a million: far beyond what a slice can hold, and nowhere near the end of int. What is no
    /// number is air.
    int of(double stored) const {
        const double hu = std::round(valueOf(stored));
        return std::isnan(hu) ? Volume::kAirHu : int(std::clamp(hu, -1e6, 1e6));
    }

    double valueOf(double stored) const { return stored * slope_ + intercept_; }

  private:
    double slope_, intercept_;
};

/// The value in a table for each stored number.
class Lookup {
  public:
    /// `table` must outlive this.
    explicit Lookup(const ValueTable& table) : values_(table.values), first_(table.first) {}

    double of(double stored) const {
        return values_[std::size_t(std::clamp(stored - first_, 0.0, double(values_.size() - 1)))];
    }

  private:
    std::span<const std::uint16_t> values_;
    double first_;
};

/// Returns the range of values that were measured, before they are rounded; see sliceOf().
template <class NumberOf, class IsPadding, class ValueOf>
ValueRange measuredRange(const NumberOf numberOf, const IsPadding isPadding, const ValueOf valueOf, std::size_t count) {
    ValueRange range = ValueRange::none();
    for (std::size_t i = 0; i < count; ++i)
        if (const double number = numberOf(i); !isPadding(number))
            range.include(valueOf(number));
    return range;
}

/// Converts the pixels of `slice`, whose HU and padding flags have their final size: `numberOf(i)` is the number of
/// pixel i, `isPadding` tells those that mean "nothing measured here", and `huOf` is the rescale. Without
/// branches, and with rules that no flag can overwrite, it becomes vector instructions.
template <class NumberOf, class IsPadding, class HuOf>
void convert(const NumberOf numberOf, const IsPadding isPadding, const HuOf huOf, Padding padding,
             DecodedSlice& slice) {
    const bool masksAsAir = padding == Padding::maskAsAir;
    std::int16_t* hu = slice.hu.data();
    std::uint8_t* flags = slice.padding.data();
    unsigned padded = 0, beyond = 0;
    int lowest = INT16_MAX, highest = INT16_MIN, lowestMeasured = lowest, highestMeasured = highest;
    for (std::size_t i = 0, count = slice.hu.size(); i < count; ++i) {
        const auto number = numberOf(i);
        const int value = huOf(number), held = std::clamp(value, -32768, 32767);
        const bool isNone = isPadding(number);
        const int seen = isNone && masksAsAir ? Volume::kAirHu : held;
        hu[i] = std::int16_t(seen);
        flags[i] = isNone;
        padded += unsigned(isNone);
        beyond += unsigned(held != value && !isNone);
        // By bits, since a choice would become a branch
        const int none = -int(isNone);
        lowest = std::min(lowest, seen);
        highest = std::max(highest, seen);
        lowestMeasured = std::min(lowestMeasured, (seen & ~none) | (INT16_MAX & none));
        highestMeasured = std::max(highestMeasured, (seen & ~none) | (INT16_MIN & none));
    }
    slice.clipped = beyond;
    slice.ranges = {{std::int16_t(lowest), std::int16_t(highest)},
                    {std::int16_t(lowestMeasured), std::int16_t(highestMeasured)},
                    padded};
}

/// Makes a slice of numbers, as int or double; see convert(). The functions must hold what they need by value.
template <class NumberOf, class IsPadding>
DecodedSlice sliceOf(const SliceHeader& header, const Decoding& decoding, Padding padding, NumberOf numberOf,
                     IsPadding isPadding) {
    DecodedSlice slice;
    slice.size = {header.columns, header.rows};
    slice.hasLost = decoding.hasLost && !header.isLossy;
    slice.isMended = decoding.isMended;
    slice.hu.resize(std::size_t(header.columns) * std::size_t(header.rows));
    slice.padding.resize(slice.hu.size());
    const auto convertBy = [&](auto huOf) { convert(numberOf, isPadding, huOf, padding, slice); };
    const auto measureBy = [&](auto valueOf) {
        slice.values = measuredRange(numberOf, isPadding, valueOf, slice.hu.size());
    };
    const Rescale rescale(header.meaning);
    constexpr bool kIsWhole = std::is_same_v<decltype(numberOf(0)), int>;
    if (header.meaning.table) {
        const Lookup table(*header.meaning.table);
        convertBy([=](auto number) { return rescale.of(table.of(number)); });
        if (!kIsWhole)
            measureBy([=](double number) { return rescale.valueOf(table.of(number)); });
    } else if (const std::optional<int> shift = rescale.shift(); kIsWhole && shift) {
        convertBy([add = *shift](auto number) { return int(number) + add; });
    } else {
        convertBy([rescale](auto number) { return rescale.of(number); });
        if (!kIsWhole)
            measureBy([rescale](double number) { return rescale.valueOf(number); });
    }
    if (slice.ranges.padding == 0)
        slice.padding = {};
    return slice;
}

}  // namespace

template <class Raw>
DecodedSlice toHu(const Raw* raw, const SliceHeader& header, const Decoding& decoding, Padding padding) {
    constexpr bool kIsWide = sizeof(Raw) == 4;
    const StoredValue<std::conditional_t<kIsWide, std::int64_t, int>> stored(decoding.format);
    const PaddingRule rule(header.meaning, stored, padding);
    using Number = std::conditional_t<kIsWide, double, int>;
    return sliceOf(
        header, decoding, padding, [raw, stored](std::size_t i) { return Number(stored.of(raw[i])); },
        [rule](Number number) { return rule.matches(number); });
}

template <class Real>
DecodedSlice realsToHu(const Real* raw, const SliceHeader& header, Padding padding) {
    const std::optional<double> stated = header.meaning.realPadding;
    return sliceOf(
        header, {}, padding, [raw](std::size_t i) { return double(raw[i]); },
        [stated](double number) { return !std::isfinite(number) || number == stated; });
}

template DecodedSlice toHu(const std::uint8_t*, const SliceHeader&, const Decoding&, Padding);
template DecodedSlice toHu(const std::uint16_t*, const SliceHeader&, const Decoding&, Padding);
template DecodedSlice toHu(const std::uint32_t*, const SliceHeader&, const Decoding&, Padding);
template DecodedSlice realsToHu(const float*, const SliceHeader&, Padding);
template DecodedSlice realsToHu(const double*, const SliceHeader&, Padding);

}  // namespace pdr::dicom
