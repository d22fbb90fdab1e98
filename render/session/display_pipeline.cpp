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

bool DisplayPipeline::findGuide(FilmOnDevice& place, int finer, const std::stop_token& stop) {
    if (!guideSought_ && finer > 1) {
        guide_ = place.guide(finer, stop);
        guideSought_ = guide_ || !stop.stop_requested();
    }
    return guide_ != nullptr;
}

Result<DisplayPipeline::Pictures> DisplayPipeline::makeOnGuide(FilmOnDevice& place, const Display& asked, bool adds) {
    if (adds || !guided_) {
        Result<std::shared_ptr<const Film>> film = place.film()->film();
        if (!film)
            return film.error();
        guided_ = std::make_shared<const GuidedFilm>(*std::move(film), *guide_);
    }
    Pictures pictures;
    pictures.push_back({guided_->picture({asked.exposure, true}), asked, guided_->size()});
    return pictures;
}

Result<DisplayPipeline::Pictures> DisplayPipeline::make(FilmOnDevice& place, const Display& asked,
                                                        const Display& display, bool atOnce,
                                                        const std::stop_token& stop) {
    Accumulator& film = *place.film();
    if (Result<void> requested = film.resolve(display, stop); !requested)
        return requested.error();
    waiting_.push_back(asked);
    const bool brokenOff = display.smoothed && stop.stop_requested();
    Result<Pictures> due = takeAllBut(place, atOnce || brokenOff ? 0 : std::size_t(film.maxInFlight() - 1));
    if (brokenOff && due)
        due->pop_back();
    return due;
}

Result<DisplayPipeline::Pictures> DisplayPipeline::takeAllBut(FilmOnDevice& place, std::size_t left) {
    Pictures pictures;
    while (waiting_.size() > left) {
        Result<Picture> picture = place.film()->readback();
        if (!picture)
            return picture.error();
        pictures.push_back({*std::move(picture), waiting_.front(), place.size()});
        waiting_.pop_front();
    }
    return pictures;
}

void DisplayPipeline::keepCoarser(std::shared_ptr<const Film> film) {
    coarser_ = Coarser{std::move(film), guided_, {}};
}

std::optional<std::uint64_t> DisplayPipeline::coarserSamples() const {
    return coarser_ ? std::optional(coarser_->film->samplesPerPixel()) : std::nullopt;
}

std::optional<DisplayedPicture> DisplayPipeline::coarserPicture(const Display& asked, const Display& display,
                                                                const std::stop_token& stop) {
    const bool isGuided = display.smoothed && coarser_->guided;
    Picture picture =
        isGuided ? coarser_->guided->picture(display) : coarser_->pictures.picture(*coarser_->film, display, stop);
    if (stop.stop_requested())
        return std::nullopt;
    return DisplayedPicture{std::move(picture), asked, isGuided ? coarser_->guided->size() : coarser_->film->size()};
}

}  // namespace pdr
