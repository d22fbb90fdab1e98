#include "render/film/display/enlarged_film.h"

#include <utility>

#include "render/film/error/noisy_film.h"

namespace pdr {

EnlargedFilm::EnlargedFilm(std::shared_ptr<const Film> film, denoise::Colours radiance, double unit)
    : film_(std::move(film)), radiance_(std::move(radiance)), unit_(unit) {}

EnlargedFilm::EnlargedFilm(std::shared_ptr<const Film> film, denoise::Colours radiance)
    : EnlargedFilm(std::move(film), std::move(radiance), 1) {}

EnlargedFilm EnlargedFilm::onGuide(std::shared_ptr<const Film> film, const denoise::Guide& guide) {
    const NoisyFilm noisy = noisyFilm(*film);
    return {std::move(film), denoise::guided(noisy.all.mean, guide), noisy.unit};
}

Image EnlargedFilm::image(const Display& display) const {
    return denoisedImageOf(*film_, radiance_, unit_, display);
}

}  // namespace pdr
