#include "render/measure/edge.h"

#include <algorithm>
#include <cmath>

#include "render/measure/edge_profile.h"

namespace pdr::measure {
namespace {

constexpr double kFaintSigmas = 5;
constexpr std::size_t kFewestVoxels = 20;

/// Radius of the cylinder about the profile in which noise is measured, and the deviation of a voxel that is other
/// tissue, in standard deviations.
constexpr double kNoiseRadiusMm = 6, kOutlierSigmas = 3.5;

/// A plateau nearer to its edge than this holds more blur than noise.
constexpr double kFlatFromMm = 1.9;

/// The scale of the gradient that gives the direction: Gaussian weights of this standard deviation along each axis of
/// the grid, in mm and in voxels, whichever is wider. Below 0.8 voxels, weights depend on where a place lies in a
/// voxel.
constexpr double kGradientMm = 1, kGradientVoxels = 0.8;

/// Returns the gradient of the HU, smoothed along the axes of the grid [HU/mm]. Any smoothing leaves the gradient of a
/// plane edge perpendicular to it.
dvec3 gradientAt(const Volume& volume, const GridPlace& grid, dvec3 mm) {
    const dvec3 sigma = glm::max(kGradientMm / volume.geometry().spacingMm(), dvec3(kGradientVoxels));
    const dvec3 at = grid.index(mm);
    const ivec3 low(glm::floor(at - 3.0 * sigma)), high(glm::ceil(at + 3.0 * sigma));
    dvec3 byIndex(0);
    double sum = 0;
    for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j)
            for (int i = low.x; i <= high.x; ++i) {
                const dvec3 away = (dvec3(i, j, k) - at) / sigma;
                const double weight = std::exp(-0.5 * glm::dot(away, away));
                const ivec3 voxel = glm::clamp(ivec3(i, j, k), ivec3(0), grid.size - 1);
                byIndex += weight * double(volume.voxels()[grid.offset(voxel)]) * away / sigma;
                sum += weight;
            }
    return glm::transpose(dmat3(grid.indexFromPatient)) * (byIndex / sum);
}

/// Voxels on one side of an edge.
struct Side {
    Stretch stretch;
    std::vector<ivec3> voxels;
    std::vector<double> hu;
};

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Calls visit(voxel, mm along the line) for the voxels in the cylinder about a line, `reach` mm to both ends.
template <class Visit>
void eachVoxelAbout(const GridPlace& grid, const ThroughEdge& line, double reach, Visit&& visit) {
    const double radius = std::hypot(reach, kNoiseRadiusMm);
    const dvec3 at = grid.index(line.mm);
    dvec3 half;
    for (int axis = 0; axis < 3; ++axis)
        half[axis] = radius * glm::length(dvec3(glm::transpose(grid.indexFromPatient)[axis]));
    const ivec3 low(glm::max(glm::ceil(at - half), dvec3(0))),
        high(glm::min(glm::floor(at + half), dvec3(grid.size - 1)));
    for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j)
            for (int i = low.x; i <= high.x; ++i) {
                const dvec3 away = grid.mm({i, j, k}) - line.mm;
                const double along = glm::dot(away, line.direction);
                if (glm::length(away - along * line.direction) <= kNoiseRadiusMm)
                    visit(ivec3(i, j, k), along);
            }
}

/// Returns the noise of the plateaus on the sides of an edge, without voxels that are other tissue. A side whose
/// plateau is short holds more blur than noise, and is left out where the other one is free.
std::optional<Noise> noiseBeside(const Volume& volume, const GridPlace& grid, const ThroughEdge& line,
                                 const Crossing& edge) {
    std::vector<Side> sides;
    const bool lowIsFlat = edge.atMm - edge.low.to >= kFlatFromMm,
               highIsFlat = edge.high.from - edge.atMm >= kFlatFromMm;
    if (lowIsFlat || !highIsFlat)
        sides.push_back({edge.low, {}, {}});
    if (highIsFlat || !lowIsFlat)
        sides.push_back({edge.high, {}, {}});
    ivec3 low(grid.size), high(0);
    eachVoxelAbout(grid, line, std::max(-edge.low.from, edge.high.to), [&](ivec3 voxel, double along) {
        for (Side& side : sides)
            if (along >= side.stretch.from && along <= side.stretch.to && !volume.isPadding(grid.offset(voxel))) {
                side.voxels.push_back(voxel);
                side.hu.push_back(volume.voxels()[grid.offset(voxel)]);
                low = glm::min(low, voxel);
                high = glm::max(high, voxel);
            }
    });
    Residuals residuals(low, glm::max(low, high), noiseLags(volume.geometry().spacingMm()));
    for (const Side& side : sides) {
        if (side.hu.size() < 2)
            continue;
        const double middle = medianOf(side.hu);
        std::vector<double> away;
        for (const double hu : side.hu)
            away.push_back(std::abs(hu - middle));
        const double sigma =
            std::max(1.4826 * medianOf(away), 0.5);  // the median of a normal deviation is 0.6745 sigma
        double sum = 0, count = 0;
        for (std::size_t n = 0; n < side.hu.size(); ++n)
            if (away[n] <= kOutlierSigmas * sigma) {
                sum += side.hu[n];
                ++count;
            }
        for (std::size_t n = 0; n < side.hu.size(); ++n)
            if (away[n] <= kOutlierSigmas * sigma)
                residuals.add(side.voxels[n], side.hu[n] - sum / count);
    }
    return residuals.count() < kFewestVoxels ? std::nullopt : std::optional(residuals.noise(int(sides.size())));
}

/// Returns the standard deviation of the half level by linear interpolation between voxels that are `step` mm apart as
/// seen along the normal, for an edge of `width` mm at any place between them: a fit to Gaussian edges, within 5 % for
/// widths of 1.2 to 3.2 steps, and at most that of a uniform distribution over a step.
double interpolationSigma(double step, double width) {
    constexpr double kScale = 0.0715, kNarrowest = 1.05;
    const double ratio = width / step;
    const double most = 1 / std::sqrt(12.0), beyond = ratio * ratio - kNarrowest;
    return step * (beyond * most > kScale ? kScale / beyond : most);
}

double interpolationSigma(const VolumeGeometry& geometry, dvec3 normal, double width) {
    const dvec3 steps = glm::abs(glm::transpose(gridAxes(geometry)) * normal) * geometry.spacingMm();
    double variance = 0;
    for (int axis = 0; axis < 3; ++axis)
        if (steps[axis] > 0)
            variance += std::pow(interpolationSigma(steps[axis], width), 2);
    return std::sqrt(variance);
}

bool touchesPadding(const Volume& volume, const GridPlace& grid, const ThroughEdge& line, const Crossing& edge) {
    bool touches = false;
    for (const double along : {edge.low.from, edge.low.to, edge.atMm, edge.high.from, edge.high.to})
        eachCorner(grid.size, grid.index(line.mm + along * line.direction),
                   [&](ivec3 voxel, double) { touches |= volume.isPadding(grid.offset(voxel)); });
    return touches;
}

}  // namespace

EdgeSearch edgeNear(const Volume& volume, dvec3 mm, std::optional<dvec3> inPlane) {
    const GridPlace grid(volume.geometry());
    if (!grid.contains(mm))
        return {{}, NoEdge::outside};
    ThroughEdge line{mm, {}};
    std::optional<EdgeProfile> profile;
    std::optional<Crossing> crossing;
    // The first line ends on the edge, where the gradient is surest. The second starts there.
    for (const double reach : {kEdgeReachMm, 1.0}) {
        dvec3 gradient = gradientAt(volume, grid, line.mm);
        if (inPlane)
            gradient -= glm::dot(gradient, *inPlane) * *inPlane;
        if (glm::length(gradient) == 0)
            return {{}, NoEdge::far};
        line.direction = glm::normalize(gradient);
        crossing = profile.emplace(volume, grid, line).crossing(reach);
        if (!crossing)
            return {{}, NoEdge::far};
        if (reach == kEdgeReachMm)
            line.mm += crossing->atMm * line.direction;
    }
    const dvec3 found = line.mm + crossing->atMm * line.direction;
    if (glm::distance(found, mm) > kEdgeReachMm)
        return {{}, NoEdge::far};
    if (touchesPadding(volume, grid, line, *crossing))
        return {{}, NoEdge::padding};
    if (!grid.contains(line.mm + crossing->low.from * line.direction) ||
        !grid.contains(line.mm + crossing->high.to * line.direction))
        return {{}, NoEdge::outside};
    const std::optional<Noise> noise = noiseBeside(volume, grid, line, *crossing);
    if (!noise)
        return {{}, NoEdge::cramped};
    const double step = crossing->highHu - crossing->lowHu, width = step / crossing->slopeHuPerMm;
    if (step < kFaintSigmas * std::sqrt(noise->variance()))
        return {{}, NoEdge::faint};
    const double sigma = std::sqrt(profile->variance(*crossing, *noise)) / crossing->slopeHuPerMm;
    return {Edge{found, line.direction, crossing->lowHu, crossing->highHu, std::sqrt(noise->variance()), width, sigma,
                 interpolationSigma(volume.geometry(), line.direction, width),
                 crossing->roomMm < resolvedMm(volume.geometry(), line.direction, width)},
            {}};
}

Place atEdge(const Place& place, const Edge& edge) {
    Place moved = movedToEdge(place, edge.mm, edge.normal, edge.edgeSigma, edge.gridSigma, edge.blurMm);
    moved.thin = edge.thin;
    return moved;
}

Text noEdgeText(NoEdge why) {
    switch (why) {
        case NoEdge::outside:
            return phrase("no edge: too close to the border of the scan");
        case NoEdge::far:
            return phrase("no edge within %1 mm", fixedNumber(kEdgeReachMm, 1));
        case NoEdge::faint:
            return phrase("no edge: the sides differ by less than five times the noise");
        case NoEdge::padding:
            return phrase("no edge: the scanner measured nothing on one side");
        case NoEdge::cramped:
            return phrase("no edge: too few voxels on either side to know the noise");
    }
    return {};
}

}  // namespace pdr::measure
