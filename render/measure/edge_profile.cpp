#include "render/measure/edge_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace pdr::measure {
namespace {

constexpr double kHalfMm = 12.5, kStepMm = 0.1;
constexpr int kSamples = int(2 * kHalfMm / kStepMm) + 1;

constexpr double kDiscMm = 1;

/// Plateaus behind an edge [mm].
constexpr double kPlateauFrom = 2, kPlateauTo = 5, kHalfPlateau = 0.5;

/// Share of a step by which a profile turns back where it ends.
constexpr double kTurned = 0.25;

/// Half of the lengths over which slopes are measured [mm]: where the edge is sought, and at the edge.
constexpr double kRiseMm = 0.5, kSlopeMm = 0.25;

/// Returns the places of a hexagonal pattern in the disc across `direction`.
std::vector<dvec3> discAcross(dvec3 direction) {
    const dvec3 least = std::abs(direction.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 u = glm::normalize(glm::cross(direction, least)), v = glm::cross(direction, u);
    std::vector<dvec3> places;
    const double step = kDiscMm / 2, row = step * std::numbers::sqrt3 / 2;
    for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i)
            if (std::abs(i + j) <= 2)
                places.push_back((i + 0.5 * j) * step * u + j * row * v);
    return places;
}

double mmOf(int sample) {
    return sample * kStepMm - kHalfMm;
}

int sampleAt(double mm) {
    return std::clamp(int(std::lround((mm + kHalfMm) / kStepMm)), 0, kSamples - 1);
}

/// Returns the plateau on one side of an edge: `way` is -1 or 1, `next` the distance to the next edge on that side.
Stretch plateau(double edge, int way, double next) {
    const double from = std::max(std::min(kPlateauFrom, next / 2 - kHalfPlateau), 0.0),
                 to = std::min(kPlateauTo, next / 2 + kHalfPlateau);
    return way > 0 ? Stretch{edge + from, edge + to} : Stretch{edge - to, edge - from};
}

}  // namespace

EdgeProfile::EdgeProfile(const Volume& volume, const GridPlace& grid, const ThroughEdge& line)
    : grid_(grid), line_(line), disc_(discAcross(line.direction)), hu_(kSamples) {
    for (int n = 0; n < kSamples; ++n) {
        for (const dvec3 offset : disc_)
            hu_[std::size_t(n)] += huAt(volume, grid, line.mm + mmOf(n) * line.direction + offset);
        hu_[std::size_t(n)] /= double(disc_.size());
    }
}

double EdgeProfile::at(double mm) const {
    const double sample = std::clamp((mm + kHalfMm) / kStepMm, 0.0, kSamples - 1.001);
    const double share = sample - std::floor(sample);
    return std::lerp(hu_[std::size_t(sample)], hu_[std::size_t(sample) + 1], share);
}

/// Returns the level of a plateau: the median, which other tissue at its end does not move. Of a plateau that is short
/// since another edge is near, it is the mean: the median of so few voxels is little more than one of them.
double EdgeProfile::level(Stretch stretch, bool free) const {
    std::vector<double> values(hu_.begin() + sampleAt(stretch.from), hu_.begin() + sampleAt(stretch.to) + 1);
    if (!free)
        return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Returns the highest HU on the way up (`way` 1), or the lowest on the way down (-1), before the profile turns back.
double EdgeProfile::extreme(double from, int way) const {
    const double begin = at(from);
    double reached = at(from + way * kRiseMm);
    for (int n = sampleAt(from), left = int(kPlateauTo / kStepMm); left > 0 && n > 0 && n < kSamples - 1; --left) {
        const double hu = hu_[std::size_t(n += way)];
        reached = way > 0 ? std::max(reached, hu) : std::min(reached, hu);
        if (std::abs(reached - hu) > kTurned * std::abs(reached - begin))
            if (std::abs(mmOf(n) - from) > kRiseMm)
                break;
    }
    return reached;
}

/// Returns the place nearest to `from` at which the profile rises through `level`.
std::optional<double> EdgeProfile::rising(double from, double level) const {
    std::optional<double> nearest;
    for (int n = 0; n + 1 < kSamples; ++n) {
        const double here = hu_[std::size_t(n)], there = hu_[std::size_t(n) + 1];
        if (here >= level || there < level)
            continue;
        const double mm = mmOf(n) + kStepMm * (level - here) / (there - here);
        if (!nearest || std::abs(mm - from) < std::abs(*nearest - from))
            nearest = mm;
    }
    return nearest;
}

/// Returns how far from `edge` the profile comes back to `level`; infinity: nowhere.
double EdgeProfile::nextEdge(double edge, int way, double level) const {
    for (int n = sampleAt(edge + way * kStepMm); n >= 0 && n < kSamples; n += way)
        if ((hu_[std::size_t(n)] >= level) != (way > 0))
            return std::abs(mmOf(n) - edge);
    return INFINITY;
}

std::optional<Crossing> EdgeProfile::crossing(double reachMm) const {
    const auto rise = [this](double mm) { return at(mm + kRiseMm) - at(mm - kRiseMm); };
    double steepest = 0;
    for (double mm = -reachMm; mm <= reachMm; mm += kStepMm)
        steepest = rise(mm) > rise(steepest) ? mm : steepest;
    if (rise(steepest) <= 0)
        return {};
    Crossing found{.atMm = steepest, .lowHu = extreme(steepest, -1), .highHu = extreme(steepest, 1)};
    for (int pass = 0; pass < 3; ++pass) {
        const double half = (found.lowHu + found.highHu) / 2;
        const std::optional<double> edge = rising(found.atMm, half);
        if (!edge || std::abs(*edge) > reachMm)
            return {};
        found.atMm = *edge;
        const double below = nextEdge(*edge, -1, half), above = nextEdge(*edge, 1, half);
        found.low = plateau(*edge, -1, below);
        found.high = plateau(*edge, 1, above);
        found.lowFree = below >= 2 * (kPlateauTo - kHalfPlateau);
        found.highFree = above >= 2 * (kPlateauTo - kHalfPlateau);
        found.roomMm = std::min(below, above);
        found.lowHu = level(found.low, found.lowFree);
        found.highHu = level(found.high, found.highFree);
    }
    found.slopeHuPerMm = (at(found.atMm + kSlopeMm) - at(found.atMm - kSlopeMm)) / (2 * kSlopeMm);
    return found.slopeHuPerMm > 0 ? std::optional(found) : std::nullopt;
}

void EdgeProfile::add(WeightedVoxels& voxels, double mm, double weight) const {
    for (const dvec3 offset : disc_)
        voxels.add(line_.mm + mm * line_.direction + offset, weight / double(disc_.size()));
}

double EdgeProfile::variance(const Crossing& crossing, const Noise& noise) const {
    WeightedVoxels voxels(grid_);
    add(voxels, crossing.atMm, 1);
    const auto addLevel = [&](Stretch stretch, bool free) {
        // A plateau between two edges makes the level of both: its noise moves them apart, and does not average out.
        const double weight = free ? 0.5 : 0.5 * std::numbers::sqrt2;
        const int steps = 2 + int((stretch.to - stretch.from) / 0.5);
        for (int n = 0; n < steps; ++n)
            add(voxels, std::lerp(stretch.from, stretch.to, double(n) / (steps - 1)), -weight / steps);
    };
    addLevel(crossing.low, crossing.lowFree);
    addLevel(crossing.high, crossing.highFree);
    return voxels.variance(noise);
}

}  // namespace pdr::measure
