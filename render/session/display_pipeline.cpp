/// How images of a film are requested and read back.

#include "render/session/display_pipeline.h"

#include <utility>

namespace pdr {

void DisplayPipeline::reset(bool isEmpty) {
    first_ = first_ || isEmpty;
    fresh_ = true;
    broken_ = false;
    waiting_.clear();
    guide_ = nullptr;
    guideSought_ = false;
    guided_ = nullptr;
}

void DisplayPipeline::markShown() {
    first_ = fresh_ = broken_ = false;
    coarser_.reset();
}

void DisplayPipeline::markReturned() {
    markShown();
    fresh_ = broken_ = true;
}

bool DisplayPipeline::findGuide(FilmOnDevice& place, int finer, const std::stop_token& stop) {
    if (!guideSought_ && finer > 1) {
        guide_ = place.guide(finer, stop);
        guideSought_ = guide_ || !stop.stop_requested();
    }
    return guide_ != nullptr;
}

Result<DisplayPipeline::Images> DisplayPipeline::makeOnGuide(FilmOnDevice& place, const Display& asked, bool adds) {
    if (adds || !guided_) {
        Result<std::shared_ptr<const Film>> film = place.film()->film();
        if (!film)
            return film.error();
        guided_ = std::make_shared<const GuidedFilm>(*std::move(film), *guide_);
    }
    Images images;
    images.push_back({guided_->image({asked.exposure, true}), asked, guided_->size()});
    return images;
}

Result<DisplayPipeline::Images> DisplayPipeline::make(FilmOnDevice& place, const Display& asked, const Display& display,
                                                      bool atOnce, const std::stop_token& stop) {
    Accumulator& film = *place.film();
    if (Result<void> requested = film.resolve(display, stop); !requested)
        return requested.error();
    waiting_.push_back(asked);
    const bool brokenOff = display.denoised && stop.stop_requested();
    Result<Images> due = takeAllBut(place, atOnce || brokenOff ? 0 : std::size_t(film.maxInFlight() - 1));
    if (brokenOff && due)
        due->pop_back();
    return due;
}

Result<DisplayPipeline::Images> DisplayPipeline::takeAllBut(FilmOnDevice& place, std::size_t left) {
    Images images;
    while (waiting_.size() > left) {
        Result<Image> image = place.film()->readback();
        if (!image)
            return image.error();
        images.push_back({*std::move(image), waiting_.front(), place.size()});
        waiting_.pop_front();
    }
    return images;
}

void DisplayPipeline::keepCoarser(std::shared_ptr<const Film> film) {
    coarser_ = Coarser{std::move(film), guided_, {}};
}

std::optional<std::uint64_t> DisplayPipeline::coarserSamples() const {
    return coarser_ ? std::optional(coarser_->film->samplesPerPixel()) : std::nullopt;
}

std::optional<DisplayedImage> DisplayPipeline::coarserImage(const Display& asked, const Display& display,
                                                            const std::stop_token& stop) {
    const bool isGuided = display.denoised && coarser_->guided;
    Image image = isGuided ? coarser_->guided->image(display) : coarser_->images.image(*coarser_->film, display, stop);
    if (stop.stop_requested())
        return std::nullopt;
    return DisplayedImage{std::move(image), asked, isGuided ? coarser_->guided->size() : coarser_->film->size()};
}

}  // namespace pdr
