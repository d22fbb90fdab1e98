#pragma once
/// The way back to earlier setups of a picture, and forth again. One gesture of the user (moving, ..., moving, at
/// rest) is one step.

#include <deque>
#include <optional>
#include <vector>

#include "render/scene/picture_setup.h"

namespace pdr::app {

/// What the hand is at.
enum class Gesture { none, camera, look, brightness, clip };

class SetupHistory {
  public:
    bool canUndo() const { return !past_.empty(); }
    bool canRedo() const { return !future_.empty(); }
    /// Where undo() leads; only where it can.
    const PictureSetup& previous() const { return past_.back(); }
    /// Where redo() leads; only where it can.
    const PictureSetup& next() const { return future_.back(); }
    /// The gesture in progress.
    Gesture gesture() const { return gesture_; }

    /// `now`, which is about to change, becomes a step, unless `gesture` goes on. `moving`: it will.
    void remember(const PictureSetup& now, Gesture gesture, bool moving);
    /// Whether `gesture` was in progress. No gesture is any more.
    bool end(Gesture gesture);
    /// What was set up when the gesture in progress began, if one is.
    std::optional<PictureSetup> giveUpGesture();
    /// What was set up before `now`; only where it can.
    PictureSetup undo(const PictureSetup& now);
    /// What `now` was undone from; only where it can.
    PictureSetup redo(const PictureSetup& now);
    /// Steps back to a picture that is named `lookName` and has no brightness of its own lead to that brightness.
    void brighten(const std::string& lookName, double stops);
    /// Where the last step back leads to `now` there is no such step any more.
    void forgetStepTo(const PictureSetup& now);
    void forget();

  private:
    /// More than anyone goes back, and little memory.
    static constexpr std::size_t kSteps = 300;

    std::deque<PictureSetup> past_;
    std::vector<PictureSetup> future_;
    Gesture gesture_ = Gesture::none;
};

}  // namespace pdr::app
