#include "render/session/featured_view.h"

#include <optional>
#include <utility>

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
    std::optional<DisplayedImage> made;
    const Result<void> looked = place.film()->look([&](const Film& film) {
        if (adds || !shown_) {
            const NoisyFilm noisy = noisyFilm(film, stop);
            shown_ = std::make_shared<const Shown>(Shown{
                noisy.unit, stop.stop_requested() ? noisy.all.mean : smoothRadiance(noisy, stop, features_.get())});
        }
        made = DisplayedImage{denoisedImageOf(film, shown_->radiance, shown_->unit, display), display, place.size()};
    });
    if (!looked)
        return looked.error();
    if (stop.stop_requested())
        shown_ = nullptr;
    return *std::move(made);
}

}  // namespace pdr
