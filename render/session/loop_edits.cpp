/// How images are made with more than their film: the image before an edit, or features of the scene.

#include "render/session/loop.h"

namespace pdr {
namespace {

/// Takes the first samples of an empty coarse film, whose scene has that guide; null: none. Worthless after a stop
/// request. Errors: the device's.
Result<FirstSamples> firstSamplesOf(Accumulator& film, const std::shared_ptr<const denoise::Guide>& guide,
                                    const std::stop_token& stop) {
    FirstSamples first;
    if (guide)
        first.keepUnshadowed(*guide);
    for (std::uint64_t samples = 0; samples < ResolutionLadder::kSamples;) {
        const std::uint64_t n = FirstSamples::leftToMark(samples);
        if (Result<void> accumulated = film.accumulate(std::uint32_t(n), stop); !accumulated)
            return accumulated.error();
        if (Result<void> looked = film.look([&](const Film& content) { first.keep(content); }); !looked)
            return looked.error();
        samples += n;
    }
    return first;
}

}  // namespace

/// Renders the coarse film of the scene before the edit, with the random numbers of the one to come, unless there is
/// one of that size already. Errors: the device's.
Result<void> Session::Loop::renderBefore() {
    const Scene before = divided(edits_.oldScene());
    if (edits_.hasCoarse(before.film))
        return {};
    if (Result<void> begun = place_.begin(before); !begun)
        return begun;
    const auto guide = place_.guide({EditedView::kCoarseFiner}, {});
    Result<FirstSamples> first = firstSamplesOf(*place_.film(), guide, {});
    if (!first)
        return first.error();
    edits_.keepCoarse(before.film, *std::move(first));
    return {};
}

/// Returns the divider of the first film after an edit: one whose film of the scene before is at hand, if there is one
/// near. Without a drag the film may be finer, unless that of the scene before would have to be rendered first.
int Session::Loop::dividerForEdit() const {
    const auto nearest = [this](bool moving) {
        return edits_.nearestCoarse(scene_.film, scheduler_.dividerForEdit(scene_.film, moving));
    };
    const int divider = nearest(moving_);
    return divider == 1 || edits_.hasCoarse(dividedFilm(scene_.film, divider)) ? divider : nearest(true);
}

/// Renders such films of the scene at rest, each once, so that the first image of the next edit, in a drag or alone,
/// does not wait for it. Without it, renderBefore() does. Errors: the device no longer has the scene.
Result<void> Session::Loop::prepareEdit(const std::stop_token& stop) {
    for (const bool moving : {true, false}) {
        const int divider = scheduler_.dividerForEdit(scene_.film, moving);
        if (divider > 1 && !stop.stop_requested() && edits_.awaitsNext(scene_.film, divider))
            if (Result<void> prepared = prepareEdit(divider, stop); !prepared)
                return prepared;
    }
    return {};
}

Result<void> Session::Loop::prepareEdit(int divider, const std::stop_token& stop) {
    const Scene coarse = dividedBy(divider, scene_, scene_.revision);
    return place_.lend([&](Device& device) -> Result<void> {
        if (!device.upload(coarse))
            return {};
        const auto film = device.film(coarse.film, coarse.revision, coarse.schedule);
        if (!film)
            return {};
        const auto guide = device.guide({EditedView::kCoarseFiner}, stop);
        Result<FirstSamples> first = firstSamplesOf(**film, guide, stop);
        if (first && !stop.stop_requested())
            edits_.keepNext(coarse.film, *std::move(first));
        return {};
    });
}

/// Returns the images in flight, and the image made with the one before the edit or on features.
Result<DisplayPipeline::Images> Session::Loop::makeHelped(const Display& asked, const Display& display, bool adds,
                                                          const std::stop_token& stop) {
    if (adds && showsEdit(display))
        edits_.findGuide(place_, stop);
    if (scheduler_.isCoarseEdit())
        return display_.makeLarger(place_, asked, adds,
                                   [this] { return edits_.coarseRadiance(place_.size(), scheduler_.samples().least); });
    Result<DisplayPipeline::Images> images = display_.takeAllBut(place_, 0);
    if (!images)
        return images;
    Result<DisplayedImage> made =
        showsEdit(display) ? edits_.image(place_, display, adds, stop) : features_.image(place_, display, adds, stop);
    if (!made)
        return made.error();
    made->display = asked;
    images->push_back(*std::move(made));
    return images;
}

}  // namespace pdr
