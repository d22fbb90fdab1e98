#pragma once
/// Images of a film: linear radiance mapped to display levels by the display's tone curve (tone_curve.h), rounded.

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/denoise/plane.h"
#include "render/film/display.h"
#include "render/film/film.h"

namespace pdr {

/// Returns the level of a grey, which is that of one channel alone too where the tone curve is perChannel: 0 for L <=
/// 0, 255 for +infinity, monotone in L.
std::uint8_t displayLevel(double radiance, const Display& display);

/// The image that a screen shows of a film.
struct Image {
    std::vector<std::uint8_t> rgba;  ///< 4 bytes per pixel, row by row from the top
    FilmStatus status;               ///< status of the raw film when it was shown
    bool denoised = false;           ///< the pixels are denoised
    bool surveyed = true;            ///< false: the status holds the film's counts alone
};

/// Returns the image of the whole film as it is now. The same bits for any number of threads. After a stop request a
/// denoised image is worthless.
Image imageOf(const Film& film, const Display& display, const std::stop_token& stop = {});

/// Returns the image of a film made from its denoised radiance `smooth`, which is in units of `unit` and may be finer
/// than the film.
Image denoisedImageOf(const Film& film, const denoise::Colours& smooth, double unit, const Display& display);

/// Shows a film again and again while it is rendered. The last denoised radiance is cached, since denoising takes many
/// times as long as the tone curve.
class Development {
  public:
    /// Returns the same bits as imageOf(), with one exception: where a denoised image is requested at another
    /// tone than before, the cached radiance is shown even if the film has gained samples since, so that the image
    /// follows a slider. The next request at the same tone shows all samples. A stop request leaves the cached
    /// radiance as it is.
    Image image(const Film& film, const Display& display, const std::stop_token& stop = {});

  private:
    struct DenoisedFilm {
        std::uint64_t revision;
        TileProgress progress;
        double unit;  ///< radiance per unit of `radiance`
        denoise::Colours radiance;
        Tone tone;  ///< tone of the display that showed it last
        bool shows(const Film& film, const Tone& wanted) const {
            return revision == film.revision() && radiance[0].size() == film.size() &&
                   (tone != wanted || progress == film.progress());
        }
    };

    std::optional<DenoisedFilm> denoised_;
};

/// Returns the pixels of imageOf() alone: the whole film as RGBA8 bytes (alpha 255), row by row from the top.
std::vector<std::uint8_t> toneMap(const Film& film, const Display& display);

}  // namespace pdr
