/// How images are made with more than their film: the image before an edit, or features of the scene.

#include "render/session/loop.h"

namespace pdr {

/// Renders the coarse film of the scene before the edit, with the random numbers of the one to come, unless there is
/// one of that size already. Errors: the device's.
Result<void> Session::Loop::renderBefore() {
    const Scene before = divided(edits_.oldScene());
    if (edits_.hasCoarse(before.film))
        return {};
    if (Result<void> begun = place_.begin(before); !begun)
        return begun;
    Accumulator& film = *place_.film();
    FirstSamples first;
    for (std::uint64_t samples = 0; samples < ResolutionLadder::kSamples;) {
        const std::uint64_t n = FirstSamples::leftToMark(samples);
        if (Result<void> accumulated = film.accumulate(std::uint32_t(n), {}); !accumulated)
            return accumulated;
        if (Result<void> looked = film.look([&](const Film& content) { first.keep(content); }); !looked)
            return looked;
        samples += n;
    }
    edits_.keepCoarse(before.film, std::move(first));
    return {};
}

/// Returns the images in flight, and the image made with the one before the edit or on features.
Result<DisplayPipeline::Images> Session::Loop::makeHelped(const Display& asked, const Display& display, bool adds,
                                                          const std::stop_token& stop) {
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
