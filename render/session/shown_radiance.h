#pragma once
/// The radiance of the image that is shown of a film, made once for all displays until the film has other samples.

#include <functional>
#include <memory>
#include <stop_token>

#include "render/session/display_pipeline.h"

namespace pdr {

class ShownRadiance {
  public:
    struct Made {
        denoise::Colours radiance;
        double unit;  ///< radiance per unit of `radiance`
    };

    void forget() { made_ = nullptr; }
    /// Returns the image of the film in `place`, whose radiance `make` makes of it. `adds`: the film has samples that
    /// the last image did not show. Errors: the device's. Worthless after a stop request.
    Result<DisplayedImage> image(FilmOnDevice& place, const Display& display, bool adds, const std::stop_token& stop,
                                 const std::function<Made(const Film&)>& make);

  private:
    std::shared_ptr<const Made> made_;  ///< radiance of the image shown last; null: none
};

}  // namespace pdr
