#include "render/session/shown_radiance.h"

#include <optional>
#include <utility>

namespace pdr {

Result<DisplayedImage> ShownRadiance::image(FilmOnDevice& place, const Display& display, bool adds,
                                            const std::stop_token& stop, const std::function<Made(const Film&)>& make) {
    std::optional<DisplayedImage> shown;
    const Result<void> looked = place.film()->look([&](const Film& film) {
        if (adds || !made_)
            made_ = std::make_shared<const Made>(make(film));
        shown = DisplayedImage{denoisedImageOf(film, made_->radiance, made_->unit, display), display, place.size()};
    });
    if (!looked)
        return looked.error();
    if (stop.stop_requested())
        forget();
    return *std::move(shown);
}

}  // namespace pdr
