#include "render/accuracy/bias_estimate.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "render/film/display_transform.h"

namespace pdr {
namespace {

constexpr int kDraws = 400;  ///< random selections of the tiles

/// Sums over pixels.
struct Sums {
    double pixels = 0;
    double biased = 0, exact = 0;  ///< luminance
    dvec3 squares{0.0};            ///< squared bias per channel [levels^2]; correct only on average

    void add(const Sums& other) {
        pixels += other.pixels;
        biased += other.biased;
        exact += other.exact;
        squares += other.squares;
    }
    double brightness() const { return exact > 0 ? biased / exact - 1 : 0; }
    double worstSquare() const { return glm::max(squares.x, glm::max(squares.y, squares.z)) / pixels; }
};

Sums sumsOf(const BiasTile& tile, const DisplayTransform& transform) {
    Sums sums{.pixels = double(tile.size())};
    for (const auto& [biased, exact] : tile) {
        sums.biased += luminance(biased.even + biased.odd);
        sums.exact += luminance(exact.even + exact.odd);
        const auto levels = [&](const dvec3& radiance) { return dvec3(transform.exactLevels(radiance)); };
        sums.squares += (levels(biased.even) - levels(exact.even)) * (levels(biased.odd) - levels(exact.odd));
    }
    return sums;
}

Between between(double value, std::vector<double> draws) {
    std::ranges::sort(draws);
    const auto end = std::size_t(0.025 * double(draws.size()));
    return {value, std::min(value, draws[end]), std::max(value, draws[draws.size() - 1 - end])};
}

double levelsOf(double square) {
    return 2 * std::sqrt(std::max(square, 0.0));
}

}  // namespace

std::optional<MeasuredBias> measuredBias(std::span<const BiasTile> tiles, const Tone& tone) {
    const DisplayTransform transform = displayTransform(tone);
    std::vector<Sums> known;
    Sums all;
    for (const BiasTile& tile : tiles)
        if (!tile.empty())
            all.add(known.emplace_back(sumsOf(tile, transform)));
    if (known.size() < kBiasTiles || !(all.exact > 0))
        return std::nullopt;
    std::mt19937 random(1);  // fixed seed: a stated bias must not flicker
    std::vector<double> brightness, squares;
    for (int draw = 0; draw < kDraws; ++draw) {
        Sums other;
        for (std::size_t i = 0; i < known.size(); ++i)
            other.add(known[random() % known.size()]);
        brightness.push_back(other.brightness());
        squares.push_back(other.worstSquare());
    }
    const Between square = between(all.worstSquare(), std::move(squares));
    return MeasuredBias{between(all.brightness(), std::move(brightness)),
                        {levelsOf(square.value), levelsOf(square.low), levelsOf(square.high)}};
}

}  // namespace pdr
