#pragma once
/// What a screen shows of a coarse film while the hand moves: the film's light on a guide that is finer than it.

#include <memory>

#include "render/denoise/guided.h"
#include "render/film/display/tone_map.h"

namespace pdr {

/// A film drawn on its guide, once for all displays: that takes several times as long as the tone curve. Immutable.
class GuidedFilm {
  public:
    /// `guide`: of the film's own scene. The same bits for any number of threads.
    GuidedFilm(std::shared_ptr<const Film> film, const denoise::Guide& guide);

    /// As large as the guide.
    ivec2 size() const { return radiance_[0].size(); }
    /// `smoothed`, whatever was asked for.
    Picture picture(const Display& display) const;

  private:
    std::shared_ptr<const Film> film_;
    double unit_;  ///< radiance
    denoise::Colours radiance_;
};

}  // namespace pdr
