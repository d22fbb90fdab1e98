#include "app/plan/history.h"

#include <utility>

namespace pdr::app {
namespace {

Plan taken(auto& steps) {
    Plan plan = std::move(steps.back());
    steps.pop_back();
    return plan;
}

}  // namespace

void History::remember(const Plan& now, Changes gesture, bool moving) {
    const bool continues = gesture != Changes::none && gesture == gesture_;
    gesture_ = moving ? gesture : Changes::none;
    if (continues)
        return;
    past_.push_back(now);
    if (past_.size() > kSteps)
        past_.pop_front();
    future_.clear();
}

bool History::end(Changes gesture) {
    return std::exchange(gesture_, Changes::none) == gesture && gesture != Changes::none;
}

std::optional<Plan> History::giveUpGesture() {
    if (std::exchange(gesture_, Changes::none) == Changes::none || past_.empty())
        return std::nullopt;
    return taken(past_);
}

Plan History::undo(const Plan& now) {
    gesture_ = Changes::none;
    future_.push_back(now);
    return taken(past_);
}

Plan History::redo(const Plan& now) {
    gesture_ = Changes::none;
    past_.push_back(now);
    return taken(future_);
}

void History::brighten(const std::string& lookName, double stops) {
    for (Plan& earlier : past_) {
        ImageSetup& image = earlier.image;
        if (image.lookName == lookName && !image.lookChanged && image.stops == 0)
            image.stops = stops;
    }
}

void History::forgetStepTo(const Plan& now) {
    if (canUndo() && previous() == now)
        past_.pop_back();
}

void History::forget() {
    *this = {};
}

}  // namespace pdr::app
