#pragma once
/// The weights of non-local means: how alike the 5 x 5 patches of luminance around two pixels are, as far as noise lets
/// tell. After Buades, Coll & Morel 2005; subtracting the noise from the distance is after Rousselle, Knaus & Zwicker
/// 2012.

#include <utility>

#include "render/denoise/plane.h"

namespace pdr::denoise {

/// An image and its noise: planes of one size, not owned.
struct NoisyImage {
    const Colours& mean;
    const Plane& luminance;  ///< luminance of the mean
    const Plane& variance;   ///< variance of that luminance; > 0, in images whose radiances are about 1
};

/// The weights of the pixels of some rows, for one neighbour of each at a time.
class PatchWeights {
  public:
    /// The rows [begin, end) of `image`, which must outlive it.
    PatchWeights(const NoisyImage& image, int begin, int end);

    /// Returns the neighbours whose weights are not 0 everywhere, the pixel itself among them, in a fixed order.
    static const std::vector<ivec2>& neighbours();

    /// Compares the pixels with their neighbours at that distance.
    void compare(ivec2 apart);
    /// Writes the weights of row `y`, counted from `begin`, to `weights`, which has the image's width.
    void write(int y, float* weights) const;

  private:
    void measure(int y);
    void weigh(int y);
    float* acrossRow(int y);
    float* sharedRow(int y) { return &shared_[std::size_t(y + kSpread) * std::size_t(width_)]; }
    const float* sharedRow(int y) const { return &shared_[std::size_t(y + kSpread) * std::size_t(width_)]; }

    static constexpr int kPatch = 2;   ///< radius of a patch
    static constexpr int kSpread = 1;  ///< radius in which pixels share their weights
    static constexpr int kReach = kPatch + kSpread;

    const Plane &luminance_, &variance_;
    int begin_, rows_, width_;
    ivec2 apart_{0};
    std::vector<float> distances_, likenesses_;  ///< values of one row
    std::vector<float> across_, shared_;
};

}  // namespace pdr::denoise
