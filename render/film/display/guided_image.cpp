#include "render/film/display/guided_image.h"

#include <utility>

#include "render/film/error/noisy_film.h"

namespace pdr {

GuidedFilm::GuidedFilm(std::shared_ptr<const Film> film, const denoise::Guide& guide) : film_(std::move(film)) {
    const NoisyFilm noisy = noisyFilm(*film_);
    unit_ = noisy.unit;
    radiance_ = denoise::guided(noisy.all.mean, guide);
}

Image GuidedFilm::image(const Display& display) const {
    return denoisedImageOf(*film_, radiance_, unit_, display);
}

}  // namespace pdr
