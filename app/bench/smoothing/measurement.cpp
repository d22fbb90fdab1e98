#include "app/bench/smoothing/measurement.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "render/base/processor_time.h"
#include "render/film/display/tone_map.h"

namespace pdr::bench {
namespace {

template <class Make>
Seconds timed(const Make& make) {
    const auto start = std::chrono::steady_clock::now();
    const double processor = processorSeconds();
    make();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            processorSeconds() - processor};
}

Seconds medianOf(std::vector<Seconds> rounds) {
    const auto median = [&](double Seconds::*part) {
        std::ranges::sort(rounds, {}, part);
        return rounds[rounds.size() / 2].*part;
    };
    return {median(&Seconds::wall), median(&Seconds::processor)};
}

}  // namespace

Costs costsOf(const Film& film, const Display& display, int rounds) {
    std::vector<Seconds> raw, denoised, judgement;
    for (int round = 0; round < rounds; ++round) {
        raw.push_back(timed([&] { imageOf(film, display.withDenoised(false)); }));
        denoised.push_back(timed([&] { imageOf(film, display.withDenoised(true)); }));
        judgement.push_back(timed([&] { SmoothingJudgement::of(film); }));
    }
    return {medianOf(raw), medianOf(denoised), medianOf(judgement)};
}

}  // namespace pdr::bench
