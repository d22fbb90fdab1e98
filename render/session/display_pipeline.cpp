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
    larger_ = nullptr;
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
        guide_ = place.guide({finer}, stop);
        guideSought_ = guide_ || !stop.stop_requested();
    }
    return guide_ != nullptr;
}

Result<DisplayPipeline::Images> DisplayPipeline::makeOnGuide(FilmOnDevice& place, const Display& asked, bool adds) {
    return enlarge(place, asked, adds, [this](std::shared_ptr<const Film> film) {
        return EnlargedFilm::onGuide(std::move(film), *guide_);
    });
}

Result<DisplayPipeline::Images> DisplayPipeline::makeLarger(FilmOnDevice& place, const Display& asked, bool adds,
                                                            const std::function<denoise::Colours()>& radiance) {
    return enlarge(place, asked, adds,
                   [&](std::shared_ptr<const Film> film) { return EnlargedFilm(std::move(film), radiance()); });
}

Result<DisplayPipeline::Images> DisplayPipeline::enlarge(FilmOnDevice& place, const Display& asked, bool adds,
                                                         const Enlarge& enlarge) {
    if (adds || !larger_) {
        Result<std::shared_ptr<const Film>> film = place.film()->film();
        if (!film)
            return film.error();
        larger_ = std::make_shared<const EnlargedFilm>(enlarge(*std::move(film)));
    }
    Images images;
    images.push_back({larger_->image(asked), asked, larger_->size()});
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
    coarser_ = Coarser{std::move(film), larger_, {}};
}

std::optional<std::uint64_t> DisplayPipeline::coarserSamples() const {
    return coarser_ ? std::optional(coarser_->film->samplesPerPixel()) : std::nullopt;
}

std::optional<DisplayedImage> DisplayPipeline::coarserImage(const Display& asked, const Display& display,
                                                            const std::stop_token& stop) {
    const bool isLarger = display.denoised && coarser_->larger;
    Image image = isLarger ? coarser_->larger->image(display) : coarser_->images.image(*coarser_->film, display, stop);
    if (stop.stop_requested())
        return std::nullopt;
    return DisplayedImage{std::move(image), asked, isLarger ? coarser_->larger->size() : coarser_->film->size()};
}

}  // namespace pdr
