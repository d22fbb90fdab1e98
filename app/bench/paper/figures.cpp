#include "app/bench/paper/figures.h"

#include <algorithm>
#include <cmath>

#include "render/accuracy/error_against_time.h"
#include "render/timing/efficiency.h"
#include "render/timing/frame_budget.h"
#include "render/timing/iterations.h"

namespace pdr::bench::paper {

namespace {

using PerWay = std::array<std::optional<double>, kWayCount>;

bool isPd(int way) {
    return kWays[std::size_t(way)].schedule.kind == Schedule::Kind::pd;
}

/// Returns the way with n = 1 that gives the other times of `way`.
WayPlace ofOne(int way) {
    return isPd(way) ? kPd1 : WayPlace(way);
}

SizeFigures sizeFigures(const Measured& measured, std::size_t place, ivec2 size) {
    SizeFigures figures{.size = size};
    for (int way = 0; way < kWayCount; ++way)
        if (const Cell& cell = measured.at(place, WayPlace(way)); cell.measured()) {
            figures.framesPerSecond[way] = 1 / cell.spread().median;
            figures.load[way] = cell.load();
        }
    if (const Cell& cell = measured.at(place, kPd100); cell.measured())
        if (const double noise = cell.runs.back().lap.sampleNoise; std::isfinite(noise))
            figures.sampleNoise = noise;
    if (const auto rate = figures.framesPerSecond[kPd100])
        figures.iteration = iterationFromFrameRate(kWays[kPd100].iterations, *rate);
    for (int way = 0; way < kWayCount; ++way)
        if (const auto rate = figures.framesPerSecond[ofOne(way)]; rate && figures.iteration) {
            figures.other[way] = otherFromFrameRate(*rate, *figures.iteration);
            figures.efficiency[way] = efficiency(kWays[way].iterations, {*figures.iteration, *figures.other[way]});
        }
    return figures;
}

PerWay communicationOf(const SizeFigures& smallest) {
    PerWay found;
    for (int way = 0; way < kWayCount; ++way)
        if (const auto rate = smallest.framesPerSecond[ofOne(way)]; rate && smallest.iteration)
            found[way] = communicationFromFrameRate(*rate, *smallest.iteration);
    return found;
}

std::vector<TimedFrame> timedFrames(const Measured& measured, const Plan& plan) {
    std::vector<TimedFrame> frames;
    for (const Cell& cell : measured.cells)
        if (isPd(cell.way) && cell.measured()) {
            const Way& way = kWays[cell.way];
            const FrameWork work{double(cell.size.x) * cell.size.y, way.iterations,
                                 plan.samplesPerLaunch(way, cell.size)};
            frames.push_back({work, cell.spread().median});
        }
    return frames;
}

std::vector<TileEfficiency> tilesOf(const Figures& figures) {
    std::vector<TileEfficiency> tiles;
    for (const SizeFigures& size : figures.sizes)
        for (const WayPlace way : {kPd1, kPd10, kPd100}) {
            const auto rate = size.framesPerSecond[way];
            const auto communication = figures.communication[way];
            if (!rate || !communication)
                continue;
            const double perSecond = kWays[way].iterations * size.pixels() * *rate;
            const ConfidenceInterval sample = figures.fit->sample();
            tiles.push_back({size.size,
                             way,
                             efficiencyOfManyNodes(*rate, *communication),
                             figures.fit->model().sample * perSecond,
                             {sample.low * perSecond, sample.high * perSecond}});
        }
    return tiles;
}

std::optional<double> ratio(std::optional<double> above, std::optional<double> below) {
    if (!above || !below || *below == 0)
        return std::nullopt;
    return *above / *below;
}

const SizeFigures* find(const Figures& figures, ivec2 size) {
    const auto found = std::ranges::find(figures.sizes, size, &SizeFigures::size);
    return found == figures.sizes.end() ? nullptr : &*found;
}

std::optional<double> gain(const SizeFigures* size) {
    if (size == nullptr)
        return std::nullopt;
    return ratio(size->iterationsPerSecond(kPd100), size->iterationsPerSecond(kK0));
}

/// Returns E with as many iterations per frame as automatic pacing chooses for this goal.
Goal automaticEfficiency(const SizeFigures* tile) {
    constexpr double kWanted = 0.995;
    const std::string what = "E, pd n=";
    if (tile == nullptr || !tile->iteration || !tile->other[kPd1])
        return {what + "automatic, at 60x34", std::nullopt, kWanted, std::nullopt};
    const FrameParts parts{*tile->iteration, *tile->other[kPd1]};
    const std::uint32_t n = iterationsPerFrame(kWanted, FrameBudget().framesPerSecond, parts.iteration, parts.other);
    return {what + std::to_string(n) + ", automatic, at 60x34", std::nullopt, kWanted, efficiency(n, parts)};
}

}  // namespace

std::optional<double> SizeFigures::iterationsPerSecond(WayPlace way) const {
    if (!framesPerSecond[way])
        return std::nullopt;
    return kWays[way].iterations * *framesPerSecond[way];
}

std::optional<double> SizeFigures::samplesToError() const {
    if (!sampleNoise)
        return std::nullopt;
    return std::max(1.0, std::ceil(samplesForError(kError, *sampleNoise * *sampleNoise)));
}

std::optional<double> SizeFigures::secondsToError(WayPlace way) const {
    if (!samplesToError() || !framesPerSecond[way])
        return std::nullopt;
    return secondsForSamples(*samplesToError(), kWays[way].iterations, 1 / *framesPerSecond[way]);
}

Figures figuresOf(const Measured& measured, const Plan& plan) {
    Figures figures;
    for (std::size_t size = 0; size < plan.sizes.size(); ++size)
        figures.sizes.push_back(sizeFigures(measured, size, plan.sizes[size]));
    figures.communication = communicationOf(figures.sizes.back());
    const Result<FrameTimeFit> fit = FrameTimeFit::of(timedFrames(measured, plan));
    if (fit) {
        figures.fit = *fit;
        figures.tiles = tilesOf(figures);
    } else {
        figures.whyNoFit = fit.error().text();
    }
    return figures;
}

std::vector<Goal> goalsOf(const Figures& figures) {
    const SizeFigures* tile = find(figures, kSizes.back());
    const SizeFigures* whole = find(figures, kSizes.front());
    const std::optional<double> iterations = whole ? whole->iterationsPerSecond(kPd100) : std::nullopt;
    return {
        {"IPS, pd n=100 over K0, at 60x34", 10.96, 20, gain(tile)},
        {"IPS, pd n=100 over K0, at 1920x1080", 1.38, 1.4, gain(whole)},
        {"T_c, K0 over pd, at 60x34", 4.3, 4,
         tile ? ratio(figures.communication[kK0], figures.communication[kPd1]) : std::nullopt},
        automaticEfficiency(tile),
        {"E, pd n=100, at 60x34", 0.977, std::nullopt, tile ? tile->efficiency[kPd100] : std::nullopt},
        {"million samples/s, pd n=100, at 1920x1080", 22.4, std::nullopt,
         iterations ? std::optional(1e-6 * *iterations * whole->pixels()) : std::nullopt},
    };
}

}  // namespace pdr::bench::paper
