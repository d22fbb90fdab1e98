#pragma once
/// Linear radiance to display levels: 1 - exp(-L / exposure) per channel, then the sRGB curve (IEC 61966-2-1), rounded.

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/denoise/plane.h"
#include "render/film/display.h"
#include "render/film/film.h"

namespace pdr {

/// One channel: 0 for L <= 0, 255 for +infinity, monotone in L.
std::uint8_t displayLevel(double radiance, const Display& display);

/// What a screen shows of a film.
struct Picture {
    std::vector<std::uint8_t> rgba;  ///< 4 bytes a pixel, row by row from the top
    FilmStatus status;               ///< of the film, as it is without smoothing, when it was shown
    bool smoothed = false;           ///< the pixels are not the film's own
    bool surveyed = true;            ///< else the status holds the film's counts alone
};

/// The whole film as it is now. The same bits for any number of threads. After a stop request a smoothed one is
/// worthless.
Picture pictureOf(const Film& film, const Display& display, const std::stop_token& stop = {});

/// A film's radiance without its noise, in units of `unit`, as a picture of the film; it may be finer than that.
Picture smoothedPictureOf(const Film& film, const denoise::Colours& smooth, double unit, const Display& display);

/// Pictures of a film in the making, one after the other. What was smoothed last is kept, since that takes many times
/// as long as the tone curve.
class Development {
  public:
    /// As pictureOf(), to the bit; but where a smoothed picture is asked for on another exposure than before, it shows
    /// what was smoothed last, though the film may hold more by now: so that it follows a slider. The same exposure
    /// again shows all of it. After a stop request what was smoothed last stays.
    Picture picture(const Film& film, const Display& display, const std::stop_token& stop = {});

  private:
    struct SmoothedFilm {
        std::uint64_t revision;
        TileProgress progress;
        double unit;  ///< radiance
        denoise::Colours radiance;
        float exposure;  ///< that it was shown on last
        bool shows(const Film& film, float wanted) const {
            return revision == film.revision() && radiance[0].size() == film.size() &&
                   (exposure != wanted || progress == film.progress());
        }
    };

    std::optional<SmoothedFilm> smoothed_;
};

/// Its pixels alone: the whole film as RGBA8 bytes (alpha 255), row by row from the top.
std::vector<std::uint8_t> toneMap(const Film& film, const Display& display);

}  // namespace pdr
