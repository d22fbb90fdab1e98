#pragma once
/// The image that a screen shows of a coarse film during interaction: it has more pixels than the film.

#include <memory>

#include "render/denoise/guided.h"
#include "render/film/display/tone_map.h"

namespace pdr {

/// A film and its radiance in more pixels, which is computed once for all displays because it takes several times as
/// long as the tone curve. Immutable.
class EnlargedFilm {
  public:
    /// `radiance`: the film's image in more pixels; radiance.
    EnlargedFilm(std::shared_ptr<const Film> film, denoise::Colours radiance);
    /// Shows the light of `film` on `guide`, a finer guide image of the same scene (denoise/guided.h). The result has
    /// the same bits for any number of threads.
    static EnlargedFilm onGuide(std::shared_ptr<const Film> film, const denoise::Guide& guide);

    /// Returns the size of the image [pixels].
    ivec2 size() const { return radiance_[0].size(); }
    /// Returns the image with `denoised` set, whether or not `display` requests denoising.
    Image image(const Display& display) const;

  private:
    EnlargedFilm(std::shared_ptr<const Film> film, denoise::Colours radiance, double unit);

    std::shared_ptr<const Film> film_;
    denoise::Colours radiance_;
    double unit_;  ///< radiance per unit of radiance_
};

}  // namespace pdr
