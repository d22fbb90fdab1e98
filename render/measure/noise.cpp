#include "render/measure/noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pdr::measure {
namespace {

/// Smallest share of the noise that is taken for visible when nearly all pairs of voxels are neighbours.
constexpr double kLeastVisible = 0.2;

}  // namespace

ivec3 noiseLags(dvec3 spacingMm) {
    return glm::max(ivec3(3, 3, 1), ivec3(glm::round(dvec3(2.5, 2.5, 1.25) / spacingMm)));
}

Noise::Noise(ivec3 lags)
    : lags_(lags),
      covariance_(std::size_t(2 * lags.x + 1) * std::size_t(2 * lags.y + 1) * std::size_t(2 * lags.z + 1)) {}

std::size_t Noise::cell(ivec3 lag) const {
    const ivec3 at = lag + lags_, size = 2 * lags_ + 1;
    return std::size_t(at.x) + std::size_t(size.x) * (std::size_t(at.y) + std::size_t(size.y) * std::size_t(at.z));
}

double Noise::covariance(ivec3 lag) const {
    return glm::all(glm::lessThanEqual(glm::abs(lag), lags_)) ? covariance_[cell(lag)] : 0;
}

Residuals::Residuals(ivec3 low, ivec3 high, ivec3 lags)
    : lags_(lags),
      low_(low - lags),
      size_(high - low + 1 + 2 * lags),
      hu_(std::size_t(size_.x) * std::size_t(size_.y) * std::size_t(size_.z), std::numeric_limits<float>::quiet_NaN()) {
}

std::size_t Residuals::offset(ivec3 voxel) const {
    const ivec3 at = voxel - low_;
    return std::size_t(at.x) + std::size_t(size_.x) * (std::size_t(at.y) + std::size_t(size_.y) * std::size_t(at.z));
}

void Residuals::add(ivec3 voxel, double hu) {
    hu_[offset(voxel)] = float(hu);
    voxels_.push_back(voxel);
}

Noise Residuals::noise(int means) const {
    const double count = double(voxels_.size()), part = means / (count * count);
    Noise noise(lags_);
    double allSums = 0, allPairs = 0;
    noise.eachLag([&](ivec3 lag) {
        double sum = 0, pairs = 0;
        for (const ivec3 voxel : voxels_) {
            const float other = hu_[offset(voxel + lag)];
            if (std::isnan(other))
                continue;
            sum += double(hu_[offset(voxel)]) * double(other);
            ++pairs;
        }
        noise.covariance_[noise.cell(lag)] = pairs > 0 ? sum / pairs : 0;
        allSums += sum;
        allPairs += pairs;
    });
    const double visible = std::max(1 - allPairs * part, kLeastVisible);
    const double independent = noise.variance() / (count / means - 1);
    noise.varianceOfMean_ = std::max(allSums * part / visible, independent);
    for (double& each : noise.covariance_)
        each += noise.varianceOfMean_;
    return noise;
}

}  // namespace pdr::measure
