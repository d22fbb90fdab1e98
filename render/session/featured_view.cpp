#include "render/session/featured_view.h"

namespace pdr {

void FeaturedView::find(FilmOnDevice& place, std::uint64_t samples, const std::stop_token& stop) {
    if (sought_ || samples >= kEnoughAlone)
        return;
    denoise::Features::Guides guides;
    for (std::size_t i = 0; i < guides.size(); ++i) {
        guides[i] = place.guide({1, denoise::Features::kPlaces[i]}, stop);
        sought_ = guides[i] || !stop.stop_requested();
        if (!guides[i])
            return;
    }
    features_ = std::make_shared<const denoise::Features>(guides);
}

Result<DisplayedImage> FeaturedView::image(FilmOnDevice& place, const Display& display, bool adds,
                                           const std::stop_token& stop) {
    return shown_.image(place, display, adds, stop, [&](const Film& film) -> ShownRadiance::Made {
        const NoisyFilm noisy = noisyFilm(film, stop);
        return {stop.stop_requested() ? noisy.all.mean : smoothRadiance(noisy, stop, features_.get()), noisy.unit};
    });
}

}  // namespace pdr
