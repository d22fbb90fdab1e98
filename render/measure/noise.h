#pragma once
/// The noise of a scan: how its voxels deviate together. Reconstruction filters CT noise, so that neighbours in a slice
/// deviate alike and a mean of n voxels is far less sure than 1 / sqrt(n) says.

#include <cstddef>
#include <vector>

#include "render/base/portable.h"

namespace pdr::measure {

/// Returns the largest distance of two voxels that are known to deviate together, along i, j and across slices (k): 3
/// voxels and 1, or 2.5 mm and 1.25 mm on finer grids.
ivec3 noiseLags(dvec3 spacingMm);

/// The autocovariance of some voxels [HU^2].
class Noise {
  public:
    explicit Noise(ivec3 lags);

    ivec3 lags() const { return lags_; }
    /// Returns the covariance of two voxels that lie `lag` apart. Beyond lags() it is 0.
    double covariance(ivec3 lag) const;
    double variance() const { return covariance(ivec3(0)); }
    /// Returns the variance of the mean of the voxels from which the noise was found, or of one of their parts: at
    /// least what it would be if they were independent.
    double varianceOfMean() const { return varianceOfMean_; }

    /// Calls visit(lag) for all lags.
    template <class Visit>
    void eachLag(Visit&& visit) const {
        for (int k = -lags_.z; k <= lags_.z; ++k)
            for (int j = -lags_.y; j <= lags_.y; ++j)
                for (int i = -lags_.x; i <= lags_.x; ++i)
                    visit(ivec3(i, j, k));
    }

  private:
    friend class Residuals;
    std::size_t cell(ivec3 lag) const;

    ivec3 lags_;
    std::vector<double> covariance_;
    double varianceOfMean_ = 0;
};

/// What is left of some voxels without their mean.
class Residuals {
  public:
    /// Creates residuals of voxels in the box from `low` to `high`, both included.
    Residuals(ivec3 low, ivec3 high, ivec3 lags);

    void add(ivec3 voxel, double hu);
    std::size_t count() const { return voxels_.size(); }
    /// Returns their noise. `means`: of how many equal parts the means were taken away. That hides the part of the
    /// noise which the voxels of a part have in common; it is added again. Needs at least two voxels in each part.
    Noise noise(int means = 1) const;

  private:
    std::size_t offset(ivec3 voxel) const;

    ivec3 lags_, low_, size_;  ///< the box is widened by the lags
    std::vector<float> hu_;    ///< NaN where no voxel was added
    std::vector<ivec3> voxels_;
};

}  // namespace pdr::measure
