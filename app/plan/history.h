#pragma once
/// The history of plans for undo and redo. One gesture of the user (moving, ..., moving, at rest) is one step.

#include <deque>
#include <optional>
#include <vector>

#include "app/plan/plan.h"

namespace pdr::app {

class History {
  public:
    bool canUndo() const { return !past_.empty(); }
    bool canRedo() const { return !future_.empty(); }
    /// The plan that undo() returns; requires canUndo().
    const Plan& previous() const { return past_.back(); }
    /// The plan that redo() returns; requires canRedo().
    const Plan& next() const { return future_.back(); }
    /// What the gesture in progress edits; Changes::none if there is none.
    Changes gesture() const { return gesture_; }

    /// Records `now`, which is about to change, as a step, unless `gesture` continues the one in progress. `moving`:
    /// the gesture goes on.
    void remember(const Plan& now, Changes gesture, bool moving);
    /// Ends the gesture in progress. Returns whether it was `gesture`.
    bool end(Changes gesture);
    /// Ends the gesture in progress, removes its step and returns the plan from before it; none if no gesture is in
    /// progress.
    std::optional<Plan> giveUpGesture();
    /// Returns the plan before `now`; requires canUndo().
    Plan undo(const Plan& now);
    /// Returns the plan that was undone to `now`; requires canRedo().
    Plan redo(const Plan& now);
    /// Sets the brightness [stops] in earlier plans with the unchanged look `lookName` and a brightness of 0.
    void brighten(const std::string& lookName, double stops);
    /// Removes the last step if undoing it leads to `now`.
    void forgetStepTo(const Plan& now);
    void forget();

  private:
    /// Maximum number of steps: more than anyone goes back, and little memory.
    static constexpr std::size_t kSteps = 300;

    std::deque<Plan> past_;
    std::vector<Plan> future_;
    Changes gesture_ = Changes::none;
};

}  // namespace pdr::app
