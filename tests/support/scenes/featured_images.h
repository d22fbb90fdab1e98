#pragma once
/// The image of a film that is denoised on features of its scene.

#include "render/device/device.h"
#include "render/film/display/tone_map.h"
#include "render/film/error/noisy_film.h"
#include "render/scene/scene.h"

namespace pdr::test {

/// Returns the features of a scene for which the CPU has a guide.
inline denoise::Features featuresOf(const Scene& scene) {
    const std::unique_ptr<Device> device = makeCpuDevice();
    (void)device->upload(scene);
    denoise::Features::Guides guides;
    for (std::size_t i = 0; i < guides.size(); ++i)
        guides[i] = device->guide({1, denoise::Features::kPlaces[i]}, {});
    return denoise::Features(guides);
}

/// Returns the image of `film`, a film of such a scene.
inline Image featuredImageOf(const Film& film, const Scene& scene, const Display& display) {
    const denoise::Features features = featuresOf(scene);
    const NoisyFilm noisy = noisyFilm(film);
    return denoisedImageOf(film, smoothRadiance(noisy, {}, &features), noisy.unit, display);
}

}  // namespace pdr::test
