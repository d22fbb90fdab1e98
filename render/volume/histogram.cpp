#include "render/volume/histogram.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "render/volume/volume.h"

namespace pdr {
namespace {

constexpr int kLowestHu = -32768;
constexpr std::size_t kUnits = 65536;
constexpr std::size_t kGrain = std::size_t(1) << 20;

using Counts = std::vector<std::uint64_t>;

/// Returns a count for each value that a voxel can have, from kLowestHu on.
Counts countsOf(const Volume& volume) {
    const std::span<const std::int16_t> voxels = volume.voxels();
    const bool padded = volume.paddingCount() > 0;
    tbb::combinable<Counts> ofThreads([] { return Counts(kUnits); });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, voxels.size(), kGrain), [&](const auto& some) {
        Counts& counts = ofThreads.local();
        for (std::size_t i = some.begin(); i < some.end(); ++i)
            if (!padded || !volume.isPadding(i))
                ++counts[std::size_t(voxels[i] - kLowestHu)];
    });
    Counts all(kUnits);
    ofThreads.combine_each([&](const Counts& counts) {
        std::transform(all.begin(), all.end(), counts.begin(), all.begin(), std::plus());
    });
    return all;
}

}  // namespace

Histogram::Histogram(const Volume& volume) {
    const Counts counts = countsOf(volume);
    const auto isCounted = [](std::uint64_t count) { return count > 0; };
    const auto first = std::find_if(counts.begin(), counts.end(), isCounted);
    if (first == counts.end())
        return;
    const auto end = std::find_if(counts.rbegin(), counts.rend(), isCounted).base();
    lowest_ = kLowestHu + int(first - counts.begin());
    below_.push_back(0);
    for (auto count = first; count != end; ++count)
        below_.push_back(below_.back() + *count);
}

double Histogram::below(double hu) const {
    const double place = std::clamp(hu - lowest_ + 0.5, 0.0, double(below_.size() - 1));
    const auto whole = std::min(std::size_t(place), below_.size() - 2);
    const double here = double(below_[whole]), next = double(below_[whole + 1]);
    return here + (place - double(whole)) * (next - here);
}

double Histogram::count(double lowHu, double highHu) const {
    return below_.empty() ? 0 : std::max(below(highHu) - below(lowHu), 0.0);
}

double Histogram::percentile(double fraction) const {
    if (below_.empty())
        return 0;
    const double wanted = std::clamp(fraction, 0.0, 1.0) * total();
    const auto reached = std::find_if(below_.begin() + 1, below_.end(),
                                      [&](std::uint64_t count) { return double(count) >= wanted && count > 0; });
    const double before = double(*(reached - 1)), step = double(*reached) - before;
    return lowest_ - 0.5 + double(reached - 1 - below_.begin()) + std::max(wanted - before, 0.0) / step;
}

}  // namespace pdr
