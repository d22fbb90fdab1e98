#pragma once
/// Denoising by regression on features (NFOR: Bitterli et al. 2016): around each pixel the image is taken as a linear
/// function of features that have no noise, fitted to the pixels that look alike (patch_weights.h), and the pixel
/// becomes what that function is there. Texture and edges that the features have then stay sharp, however few the
/// samples.

#include <array>
#include <memory>

#include "render/denoise/guided.h"
#include "render/denoise/patch_weights.h"

namespace pdr::denoise {

/// Planes of one size, of numbers about 1: of the pixels of an image, what is known of them without noise.
class Features {
  public:
    static constexpr int kCount = 6;

    /// Guides as fine as the image, each with rays at another of kPlaces.
    using Guides = std::array<std::shared_ptr<const Guide>, 2>;
    /// Places in a pixel between which what the film averages over all of it is interpolated: on a diagonal, so that
    /// edges along rows and along columns have both sides.
    static constexpr std::array<vec2, 2> kPlaces{vec2(0.25f), vec2(0.75f)};

    /// Averages the guides: their brightness, the normal, the depth and the opacity.
    explicit Features(const Guides& guides);

    ivec2 size() const { return planes_[0].size(); }
    const Plane& operator[](int i) const { return planes_[std::size_t(i)]; }

  private:
    std::array<Plane, kCount> planes_;
};

/// Returns the denoised image, which is constant where `image` is, to the bit; it may be below 0. Where the features
/// are constant it is that of non-local means. Worthless after a stop request.
Colours regressed(const NoisyImage& image, const Features& features, const std::stop_token& stop);

}  // namespace pdr::denoise
