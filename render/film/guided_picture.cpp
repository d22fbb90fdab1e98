#include "render/film/guided_picture.h"

#include "render/film/noisy_film.h"

namespace pdr {

Picture guidedPicture(const Film& film, const denoise::Guide& guide, const Display& display) {
    const NoisyFilm noisy = noisyFilm(film);
    return smoothedPictureOf(film, denoise::guided(noisy.all.mean, guide), noisy.unit, display);
}

}  // namespace pdr
