/// How films of earlier scenes are put away and come back.

#include <utility>

#include "render/session/known_bias.h"
#include "render/session/loop.h"

namespace pdr {

KeptScene Session::Loop::keptScene() const {
    return {scene_, texturesFilter(scene_, place_.info().name)};
}

/// Puts the film away if it is worth it, before another scene takes its place. A device that does not return it is not
/// reported here: it will refuse the next scene, too.
void Session::Loop::keepFilm() {
    if (!isWorthKeeping())
        return;
    if (Result<AttestedFilm> film = place_.putAway())
        kept_.keep(std::make_shared<const KeptFilm>(KeptFilm{
            keptScene(), *std::move(film), shown_, std::exchange(quality_, QualityTracker(clock_)), edits_.putAway()}));
    quality_.chooseRegion(commands.region());
}

/// Continues the film of the scene that was put away; returns whether there is one that can be trusted. Its last image
/// is shown at once: the device may need longer to take the scene and the samples. Measured biases and the costs of
/// effects are measured anew. After a stop request, since another scene is waiting already, the device is left alone,
/// and the film stays where it is kept.
bool Session::Loop::comeBack(const std::stop_token& stop) {
    const std::shared_ptr<const KeptFilm> kept = kept_.find(keptScene());
    if (!kept)
        return false;
    if (!place_.trusts(kept->film)) {
        kept_.drop(kept->scene);
        return false;
    }
    scheduler_.chooseFull();
    goOnFrom(kept->film.film);
    edits_.comeBack(kept->edits);
    quality_ = kept->quality;
    if (kept->edits.helped)
        quality_.denoised().clear();  // it was the image made with an old one
    quality_.chooseRegion(commands.region());
    returning_ = kept->frame;
    display_.markReturned();
    showReturning();
    if (stop.stop_requested())
        place_.tearFilm();
    else if (const Result<void> begun = place_.begin(scene_, kept->film); !begun)
        failedOnDevice(begun.error());
    else if (place_.info().hostMemory)
        checkpoint_.reset(nullptr);  // lost only with this program: no use for a second copy
    return true;
}

/// Shows the last image of a film that has come back, once the display is that of the image: undo may bring back both,
/// one after the other. Returns whether it did.
bool Session::Loop::showReturning() {
    if (!returning_ || returning_->display != commands.display())
        return false;
    auto frame = std::make_shared<Frame>(*std::exchange(returning_, nullptr));
    label(*frame);
    if (!commands.errorMap())
        frame->errorMap = nullptr;
    frame->region = quality_.region().status(frame->stop.levels);
    display_.markShownBefore();
    shown_ = frame;
    sink_(std::move(frame));
    return true;
}

}  // namespace pdr
