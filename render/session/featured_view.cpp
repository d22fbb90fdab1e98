#include "render/session/featured_view.h"

namespace pdr {

void FeaturedView::find(FilmOnDevice& place, std::uint64_t samples, const std::stop_token& stop) {
    if (sought_ || samples >= kEnoughAlone)
        return;
    const auto guide = place.guide(denoise::Features::kFiner, stop);
    sought_ = guide || !stop.stop_requested();
    if (guide)
        features_ = std::make_shared<const denoise::Features>(*guide);
}

Result<DisplayedImage> FeaturedView::image(FilmOnDevice& place, const Display& display, bool adds,
                                           const std::stop_token& stop) {
    return shown_.image(place, display, adds, stop, [&](const Film& film) -> ShownRadiance::Made {
        const NoisyFilm noisy = noisyFilm(film, stop);
        return {stop.stop_requested() ? noisy.all.mean : smoothRadiance(noisy, stop, features_.get()), noisy.unit};
    });
}

}  // namespace pdr
