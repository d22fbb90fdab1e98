#include "render/film/error/error_classes.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <span>

namespace pdr {
namespace {

/// Returns the number of 1/2 doublings of `value` above 2^from, in [0, bins), along the chords between powers of two.
std::uint8_t halfDoublings(float value, int from, int bins) {
    const int halves = int(std::bit_cast<std::uint32_t>(std::max(value, 0x1p-100f)) >> 22) - 2 * (127 + from);
    return std::uint8_t(std::clamp(halves, 0, bins - 1));
}

/// Pixels below which no class is made: their mean would be mostly noise.
constexpr double kFewest = 100;

/// Joins bins of half a doubling, which hold so many pixels, from first to last. A class has as many pixels as
/// `classes` equal ones would have, or spans a doubling and has an eighth of that, but never too few; nor are so few
/// left over. Calls work(first, behind the last) for each class.
template <class Work>
void eachClass(std::span<const double> pixels, int classes, const Work& work) {
    double left = std::accumulate(pixels.begin(), pixels.end(), 0.0);
    const double enough = left / classes, few = std::max(enough / 8, kFewest);
    for (std::size_t begin = 0, end = 0; begin < pixels.size() && left > 0; begin = end) {
        while (end + 1 < pixels.size() && pixels[end] == 0)
            ++end;
        const std::size_t first = end;
        double joined = 0;
        do
            joined += pixels[end++];
        while (end < pixels.size() && (joined < (end - first < 2 ? enough : few) || left - joined < few));
        left -= joined;
        work(begin, end);
    }
}

}  // namespace

LookBin LookBin::of(float luminance, float low, float high) {
    return {halfDoublings(luminance, -14, kBrightness),
            halfDoublings(high > 0 ? (high - low) / high : 0, 1 - kContrast / 2, kContrast)};
}

void ErrorSums::Bin::add(const Bin& other) {
    pixels += other.pixels;
    errors += other.errors;
    squares += other.squares;
    sums += other.sums;
}

/// Returns the mean squared error, or its standard error where chance has made the mean smaller than that.
dvec3 ErrorSums::Bin::variance() const {
    return glm::max(errors, glm::sqrt(squares)) / pixels;
}

/// Returns the correlation in [0, 1] of the channels' errors, the same for all pairs, that makes the error of their
/// sum.
double ErrorSums::Bin::correlation() const {
    const dvec3 deviation = glm::sqrt(glm::max(errors, dvec3(0)));
    const double pairs = deviation.x * deviation.y + deviation.y * deviation.z + deviation.z * deviation.x;
    return pairs > 0 ? glm::clamp((sums - errors.x - errors.y - errors.z) / (2 * pairs), 0.0, 1.0) : 1;
}

void ErrorSums::add(LookBin bin, vec3 squaredErrors, float squaredSum) {
    const dvec3 squared(squaredErrors);
    bins_[bin.brightness][bin.contrast].add({1, squared, squared * squared, double(squaredSum)});
}

void ErrorSums::add(const ErrorSums& other) {
    for (std::size_t i = 0; i < bins_.size(); ++i)
        for (std::size_t j = 0; j < bins_[i].size(); ++j)
            bins_[i][j].add(other.bins_[i][j]);
}

ErrorClasses::ErrorClasses(const ErrorSums& sums) {
    std::array<double, LookBin::kBrightness> byBrightness{};
    for (std::size_t i = 0; i < byBrightness.size(); ++i)
        for (const ErrorSums::Bin& bin : sums.bins_[i])
            byBrightness[i] += bin.pixels;
    eachClass(byBrightness, kBrightness, [&](std::size_t dark, std::size_t bright) {
        std::array<ErrorSums::Bin, LookBin::kContrast> bins{};
        std::array<double, LookBin::kContrast> byContrast{};
        for (std::size_t j = 0; j < bins.size(); ++j) {
            for (std::size_t i = dark; i < bright; ++i)
                bins[j].add(sums.bins_[i][j]);
            byContrast[j] = bins[j].pixels;
        }
        eachClass(byContrast, kContrast, [&](std::size_t smooth, std::size_t sharp) {
            ErrorSums::Bin joined;
            for (std::size_t j = smooth; j < sharp; ++j)
                joined.add(bins[j]);
            for (std::size_t i = dark; i < bright; ++i)
                std::fill(&errors_[i][smooth], &errors_[i][sharp],
                          ClassError{vec3(joined.variance()), float(joined.correlation())});
        });
    });
}

}  // namespace pdr
