#pragma once
/// The history of setups for undo and redo. One gesture of the user (moving, ..., moving, at rest) is one step.

#include <deque>
#include <optional>
#include <vector>

#include "render/scene/picture_setup.h"

namespace pdr::app {

/// The kind of gesture that the user makes.
enum class Gesture { none, camera, look, brightness, clip };

class SetupHistory {
  public:
    bool canUndo() const { return !past_.empty(); }
    bool canRedo() const { return !future_.empty(); }
    /// The setup that undo() returns; requires canUndo().
    const PictureSetup& previous() const { return past_.back(); }
    /// The setup that redo() returns; requires canRedo().
    const PictureSetup& next() const { return future_.back(); }
    /// The gesture in progress.
    Gesture gesture() const { return gesture_; }

    /// Records `now`, which is about to change, as a step, unless `gesture` continues the one in progress. `moving`:
    /// the gesture goes on.
    void remember(const PictureSetup& now, Gesture gesture, bool moving);
    /// Ends the gesture in progress. Returns whether it was `gesture`.
    bool end(Gesture gesture);
    /// Ends the gesture in progress, removes its step and returns the setup from before it; none if no gesture is in
    /// progress.
    std::optional<PictureSetup> giveUpGesture();
    /// Returns the setup before `now`; requires canUndo().
    PictureSetup undo(const PictureSetup& now);
    /// Returns the setup that was undone to `now`; requires canRedo().
    PictureSetup redo(const PictureSetup& now);
    /// Sets the brightness [stops] in earlier setups with the unchanged look `lookName` and a brightness of 0.
    void brighten(const std::string& lookName, double stops);
    /// Removes the last step if undoing it leads to `now`.
    void forgetStepTo(const PictureSetup& now);
    void forget();

  private:
    /// Maximum number of steps: more than anyone goes back, and little memory.
    static constexpr std::size_t kSteps = 300;

    std::deque<PictureSetup> past_;
    std::vector<PictureSetup> future_;
    Gesture gesture_ = Gesture::none;
};

}  // namespace pdr::app
