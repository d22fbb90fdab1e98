#pragma once
/// The image that a screen shows of a coarse film during interaction: the light of the film on a finer guide image
/// (denoise/guided.h).

#include <memory>

#include "render/denoise/guided.h"
#include "render/film/display/tone_map.h"

namespace pdr {

/// A film shown through its guide image, which is computed once for all displays because it takes several times as long
/// as the tone curve. Immutable.
class GuidedFilm {
  public:
    /// Combines `film` with `guide`, a guide image of the same scene. The result has the same bits for any number of
    /// threads.
    GuidedFilm(std::shared_ptr<const Film> film, const denoise::Guide& guide);

    /// Returns the size of the guide image [pixels].
    ivec2 size() const { return radiance_[0].size(); }
    /// Returns the image with `denoised` set, whether or not `display` requests denoising.
    Image image(const Display& display) const;

  private:
    std::shared_ptr<const Film> film_;
    double unit_;  ///< radiance per unit of radiance_
    denoise::Colours radiance_;
};

}  // namespace pdr
