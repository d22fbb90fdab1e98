#include "app/plan/setup_history.h"

#include <utility>

namespace pdr::app {
namespace {

PictureSetup taken(auto& steps) {
    PictureSetup setup = std::move(steps.back());
    steps.pop_back();
    return setup;
}

}  // namespace

void SetupHistory::remember(const PictureSetup& now, Gesture gesture, bool moving) {
    const bool continues = gesture != Gesture::none && gesture == gesture_;
    gesture_ = moving ? gesture : Gesture::none;
    if (continues)
        return;
    past_.push_back(now);
    if (past_.size() > kSteps)
        past_.pop_front();
    future_.clear();
}

bool SetupHistory::end(Gesture gesture) {
    return std::exchange(gesture_, Gesture::none) == gesture && gesture != Gesture::none;
}

std::optional<PictureSetup> SetupHistory::giveUpGesture() {
    if (std::exchange(gesture_, Gesture::none) == Gesture::none || past_.empty())
        return std::nullopt;
    return taken(past_);
}

PictureSetup SetupHistory::undo(const PictureSetup& now) {
    gesture_ = Gesture::none;
    future_.push_back(now);
    return taken(past_);
}

PictureSetup SetupHistory::redo(const PictureSetup& now) {
    gesture_ = Gesture::none;
    past_.push_back(now);
    return taken(future_);
}

void SetupHistory::brighten(const std::string& lookName, double stops) {
    for (PictureSetup& earlier : past_)
        if (earlier.lookName == lookName && !earlier.lookChanged && earlier.stops == 0)
            earlier.stops = stops;
}

void SetupHistory::forgetStepTo(const PictureSetup& now) {
    if (canUndo() && previous() == now)
        past_.pop_back();
}

void SetupHistory::forget() {
    *this = {};
}

}  // namespace pdr::app
