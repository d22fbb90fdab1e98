#include "render/measure/region_statistics.h"

#include <algorithm>
#include <cmath>

#include "render/base/significance.h"
#include "render/measure/measured_voxels.h"
#include "render/measure/noise.h"
#include "render/measure/trilinear.h"
#include "render/volume/holes.h"

namespace pdr::measure {
namespace {

/// Returns the value below which `share` of the sorted values lie, linear between them.
double quantile(const std::vector<double>& sorted, double share) {
    const double at = share * double(sorted.size() - 1);
    const std::size_t below = std::size_t(at), above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], at - double(below));
}

/// Returns the degrees of freedom of the variance of a mean of `count` voxels: no more than as many independent voxels
/// would have. A variance that is a sum over L lags, each a mean of about `count` products, scatters more than that. As
/// simulated with noise that is correlated as in CT, intervals of 3 count / L degrees hold what they say.
int degreesOfFreedom(const Noise& noise, double count) {
    const ivec3 lags = 2 * noise.lags() + 1;
    const double independent = noise.variance() / noise.varianceOfMean(),
                 products = 3 * count / (lags.x * lags.y * lags.z);
    return int(std::clamp(std::min(independent, products), 3.0, 1000.0));
}

/// Returns half of the 95 % interval of the mean, Student's.
double plusMinus(const MeasuredVoxels& region, double mean, dvec3 spacingMm) {
    Residuals residuals(region.low, region.high, noiseLags(spacingMm));
    for (std::size_t n = 0; n < region.hu.size(); ++n)
        residuals.add(region.voxels[n], region.hu[n] - mean);
    const Noise noise = residuals.noise();
    if (noise.varianceOfMean() == 0)
        return 0;
    const int freedom = degreesOfFreedom(noise, double(region.hu.size()));
    return studentT(0.05, freedom) * std::sqrt(noise.varianceOfMean());
}

/// Returns how many voxels lie in a hole of the scan.
std::size_t interpolatedOf(const std::vector<ivec3>& voxels, const Volume& volume) {
    const std::vector<Hole> holes = holesOf(volume);
    if (holes.empty())
        return 0;
    const GridPlace grid(volume.geometry());
    const auto isInterpolated = [&](ivec3 voxel) { return reachesInto(holes, grid.mm(voxel), grid.mm(voxel)); };
    return std::size_t(std::ranges::count_if(voxels, isInterpolated));
}

}  // namespace

Result<RegionStatistics> regionStatistics(const Volume& volume, const MeasuredShape& shape) {
    const MeasuredVoxels region = voxelsIn(volume, shape);
    const std::size_t count = region.hu.size();
    if (count == 0)
        return Error{region.padding > 0 ? phrase("the scanner measured nothing in this region")
                                        : phrase("no voxel's centre lies in this region"),
                     "", phrase("Move it, or make it larger."), ErrorKind::refused};
    RegionStatistics statistics{.count = count, .padding = region.padding, .cut = region.cut};
    statistics.interpolated = interpolatedOf(region.voxels, volume);
    const dmat3 step(volume.geometry().patientFromIndex);
    statistics.millilitres = double(count) * std::abs(glm::determinant(step)) / 1000;
    double sum = 0, squares = 0;
    for (const double hu : region.hu)
        sum += hu;
    statistics.meanHu = sum / double(count);
    for (const double hu : region.hu)
        squares += (hu - statistics.meanHu) * (hu - statistics.meanHu);
    statistics.sdHu = count > 1 ? std::sqrt(squares / double(count - 1)) : 0;
    std::vector<double> sorted = region.hu;
    std::ranges::sort(sorted);
    statistics.lowestHu = sorted.front();
    statistics.highestHu = sorted.back();
    statistics.medianHu = quantile(sorted, 0.5);
    statistics.percentile5 = quantile(sorted, 0.05);
    statistics.percentile95 = quantile(sorted, 0.95);
    if (count >= kFewestForMean)
        statistics.meanPlusMinus = plusMinus(region, statistics.meanHu, volume.geometry().spacingMm());
    return statistics;
}

}  // namespace pdr::measure
