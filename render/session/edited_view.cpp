#include "render/session/edited_view.h"

#include <algorithm>
#include <utility>

#include "render/session/resolution_ladder.h"

namespace pdr {
namespace {

/// Samples from which a film is good enough alone, and from which an image is the old one whatever came before.
constexpr std::uint64_t kEnoughAlone = 256, kEnoughToReplace = 64;
/// Samples from which on a coarse film for the next edit takes a small part of the time.
constexpr std::uint64_t kEnoughToPrepare = 4;
/// Pixels above which no images are kept: they take 300 bytes a pixel.
constexpr double kMostPixels = 0x1p21;

/// Returns whether images of both scenes show the same place in each pixel, and meet the same random numbers.
bool showSameView(const Scene& a, const Scene& b) {
    return a.volume == b.volume && a.camera == b.camera && a.film == b.film && a.seed == b.seed &&
           a.estimator == b.estimator && a.schedule == b.schedule;
}

/// Returns the nearest to `divider`, at most `furthest` away, of the dividers for which has(divider) holds.
template <class Has>
std::optional<int> nearestTo(int divider, int furthest, const Has& has) {
    for (int away = 0; away <= furthest; ++away)
        for (const int near : {divider - away, divider + away})
            if (has(near))
                return near;
    return std::nullopt;
}

}  // namespace

bool EditedView::canKeep(const Scene& scene) {
    return scene.schedule.kind == Schedule::Kind::pd && canBeDenoised(scene) &&
           double(scene.film.x) * scene.film.y <= kMostPixels;
}

void EditedView::follow(const Scene& current, const Scene& next) {
    if (!showSameView(current, next) || !canKeep(current) || !canKeep(next))
        return forget();
    if (replacesOld()) {
        edited_.emplace(newest_);
        oldScene_ = current;
        coarse_.clear();
        for (Coarse& next : next_)
            keepCoarse(next.size, std::move(next.first));
    } else if (edited_)
        edited_.emplace(edited_->shareOld());
    startOver();
}

/// Returns whether the image of the current scene is a better old image for the next edit than the old one.
bool EditedView::replacesOld() const {
    const bool hasFirst = newest_ && newest_->first.at(FirstSamples::kMarks.front());
    return hasFirst &&
           (!edited_ || newest_->samples >= kEnoughToReplace || 2 * newest_->samples >= edited_->old().samples);
}

bool EditedView::awaitsNext(ivec2 size, int divider) const {
    const auto hasNext = [&](int near) {
        return std::ranges::find(next_, dividedFilm(size, near), &Coarse::size) != next_.end();
    };
    return replacesOld() && newest_->samples >= kEnoughToPrepare && !nearestTo(divider, divider / 4, hasNext);
}

void EditedView::startOver() {
    newest_ = nullptr;
    next_.clear();
    first_.clear();
    shown_.forget();
}

bool EditedView::letGo(std::uint64_t samples) {
    if (!edited_ || samples < std::min(edited_->old().samples, kEnoughAlone))
        return false;
    dropOld();
    return true;
}

void EditedView::dropOld() {
    edited_.reset();
    oldScene_.reset();
    coarse_.clear();
    shown_.forget();
}

std::size_t EditedView::ForNext::bytes() const {
    return first.bytes() + (image ? image->bytes() : 0);
}

void EditedView::comeBack(const ForNext& kept) {
    first_ = kept.first;
    newest_ = kept.image;
    if (newest_)
        dropOld();
}

const CoarseEdit* EditedView::coarseOf(ivec2 size) const {
    const auto found = std::ranges::find(coarse_, size, &CoarseEdit::size);
    return found == coarse_.end() ? nullptr : &*found;
}

int EditedView::nearestCoarse(ivec2 size, int divider) const {
    // With half the divider, one sample of each pixel makes as many in all as kSamples do with the whole
    const auto has = [&](int near) { return hasCoarse(dividedFilm(size, near)); };
    return nearestTo(divider, divider / 2, has).value_or(divider);
}

bool EditedView::helpsCoarse(ivec2 size, std::uint64_t samples) const {
    const CoarseEdit* coarse = coarseOf(size);
    return coarse != nullptr && coarse->lastMark(first_, samples) > 0;
}

denoise::Colours EditedView::coarseRadiance(ivec2 size, std::uint64_t samples) const {
    const CoarseEdit& coarse = *coarseOf(size);
    return coarse.radiance(first_, coarse.lastMark(first_, samples));
}

void EditedView::findGuide(FilmOnDevice& place, const std::stop_token& stop) {
    if (first_.unshadowed())
        return;
    const bool isFull = !edited_ || place.size() == edited_->old().all[0].size();
    if (const auto guide = place.guide({isFull ? 1 : kCoarseFiner}, stop))
        first_.keepUnshadowed(*guide);
}

void EditedView::keepFirst(FilmOnDevice& place, const SampleCounts& samples) {
    if (samples.least == samples.most && FirstSamples::isMark(samples.least))
        (void)place.film()->look([&](const Film& film) { first_.keep(film); });  // a lost device fails at its next call
}

HalfSmoother EditedView::smoother(std::uint64_t samples, HalfSmoother alone) {
    return [this, samples, alone = std::move(alone)](const NoisyFilm& noisy, const std::stop_token& stop) {
        SmoothHalves denoised = helps(samples) ? denoisedHalves(noisy, stop) : alone(noisy, stop);
        if (stop.stop_requested())
            return denoised;
        newest_ = keptImage(noisy, denoised, samples, first_);
        shown_.forget();  // from now on images are mixed as the halves say
        return helps(samples) ? edited_->halves(noisy, denoised, samples, first_) : denoised;
    };
}

Result<DisplayedImage> EditedView::image(FilmOnDevice& place, const Display& display, bool adds,
                                         const std::stop_token& stop) {
    return shown_.image(place, display, adds, stop, [&](const Film& film) -> ShownRadiance::Made {
        return {edited_->radiance(film, first_, stop), 1};
    });
}

}  // namespace pdr
