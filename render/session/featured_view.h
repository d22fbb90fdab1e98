#pragma once
/// The image of a film of few samples, denoised on features of its scene (denoise/regression.h), until the film has
/// enough of them. The film itself never knows of it.

#include <cstdint>
#include <memory>
#include <stop_token>

#include "render/film/error/smoothing_judgement.h"
#include "render/session/shown_radiance.h"

namespace pdr {

class FeaturedView {
  public:
    /// Samples per pixel from which on features bring nothing.
    static constexpr std::uint64_t kEnoughAlone = 64;

    /// Forgets what is known of the current scene and its film.
    void startOver() { *this = {}; }
    /// Asks the device for the features of its scene, once, if a film of so many samples is helped by any. It is asked
    /// again only if it was interrupted.
    void find(FilmOnDevice& place, std::uint64_t samples, const std::stop_token& stop);

    /// Returns whether images of a film of so many samples are made on features.
    bool helps(std::uint64_t samples) const { return features_ && samples < kEnoughAlone; }
    /// Returns what makes the smooth halves of such a film.
    HalfSmoother smoother(std::uint64_t samples) const { return smootherOn(helps(samples) ? features_ : nullptr); }
    /// Returns the current film's image. `adds`: the film has samples that the last image did not show. Errors: the
    /// device's. Worthless after a stop request.
    Result<DisplayedImage> image(FilmOnDevice& place, const Display& display, bool adds, const std::stop_token& stop);

  private:
    std::shared_ptr<const denoise::Features> features_;  ///< null: none, or not yet
    bool sought_ = false;                                ///< the device has been asked
    ShownRadiance shown_;
};

}  // namespace pdr
