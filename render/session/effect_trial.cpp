#include "render/session/effect_trial.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/base/processor_time.h"
#include "render/film/tone_map.h"

namespace pdr {

namespace {

constexpr std::uint32_t kMostIterations = 64;  ///< in one measurement
constexpr int kFewestPixels = 16;              ///< on a trial picture's longest side

/// Seconds that `iterations` rounds over all pictures take, as the first round showed.
std::uint32_t iterationsFor(double secondsOfARound, double budgetSeconds) {
    const double fitting = budgetSeconds / (kBandMeasurements * std::max(secondsOfARound, 1e-9));
    return std::uint32_t(std::clamp(fitting, 1.0, double(kMostIterations)));
}

/// Milliseconds per iteration: [measurement][picture].
using Measured = std::vector<std::vector<double>>;

Result<Measured> measured(const std::vector<Iterate>& pictures, double budgetSeconds) {
    double first = 0;
    for (const Iterate& picture : pictures) {
        const auto seconds = picture(1);
        if (!seconds)
            return seconds.error();
        first += *seconds;
    }
    const std::uint32_t n = iterationsFor(first, budgetSeconds - first);
    Measured rounds(kBandMeasurements, std::vector<double>(pictures.size()));
    for (std::size_t round = 0; round < rounds.size(); ++round)
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            const std::size_t turn = round % 2 == 0 ? i : pictures.size() - 1 - i;
            const auto seconds = pictures[turn](n);
            if (!seconds)
                return seconds.error();
            rounds[round][turn] = 1e3 * *seconds / n;
        }
    return rounds;
}

/// Mean over pixels and colours; both pictures are made with the same random numbers.
double changedLevels(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(int(a[i]) - int(b[i]));
    return sum / (double(a.size()) * 3 / 4);  // alpha never changes
}

}  // namespace

Result<std::vector<CostBand>> costsInTurn(const std::vector<Iterate>& pictures, double budgetSeconds) {
    const auto rounds = measured(pictures, budgetSeconds);
    if (!rounds)
        return rounds.error();
    std::vector<CostBand> bands;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        std::vector<double> milliseconds;
        for (const std::vector<double>& round : *rounds)
            milliseconds.push_back(round[i]);
        bands.push_back(bandOf(std::move(milliseconds)));
    }
    return bands;
}

Result<CostBand> addedCost(const Iterate& with, const Iterate& without, double budgetSeconds) {
    const auto rounds = measured({with, without}, budgetSeconds);
    if (!rounds)
        return rounds.error();
    std::vector<double> differences;
    for (const std::vector<double>& round : *rounds)
        differences.push_back(round[0] - round[1]);
    return bandOf(std::move(differences));
}

Result<void> TrialPicture::begin() {
    if (auto ok = device_.upload(scene_); !ok || film_)
        return ok;
    auto film = device_.film(scene_.film, scene_.revision, scene_.schedule);
    if (!film)
        return film.error();
    film_ = *std::move(film);
    return {};
}

Result<double> TrialPicture::accumulate(std::uint32_t n) {
    if (auto ok = begin(); !ok)
        return ok.error();
    const double start = processorSeconds();
    if (auto ok = film_->accumulate(n, {}); !ok)
        return ok.error();
    return processorSeconds() - start;
}

Result<EffectTrial> tryEffect(const Effect& effect, const Scene& scene, const Display& display, Device& device,
                              double budgetSeconds) {
    Scene lean = scene;
    effect.leaveOut(lean);
    TrialPicture with(scene, device), without(std::move(lean), device);
    const auto added = addedCost([&](std::uint32_t n) { return with.accumulate(n); },
                                 [&](std::uint32_t n) { return without.accumulate(n); }, budgetSeconds);
    if (!added)
        return added.error();
    const auto a = with.film(), b = without.film();
    if (!a || !b)
        return a ? b.error() : a.error();
    return EffectTrial{*added, changedLevels(toneMap(**a, display), toneMap(**b, display))};
}

Result<ivec2> trialFilm(const Scene& scene, Device& device, int longestSide, double seconds) {
    Scene small = scene;
    const auto shrink = [&](int side) {
        small.film = glm::max(scene.film * side / std::max({scene.film.x, scene.film.y, side}), ivec2(1));
    };
    shrink(longestSide);
    TrialPicture picture(small, device);
    const auto first = picture.accumulate(1);
    if (!first)
        return first.error();
    if (*first > seconds)
        shrink(std::max(kFewestPixels, int(std::max(small.film.x, small.film.y) * std::sqrt(seconds / *first))));
    return small.film;
}

}  // namespace pdr
