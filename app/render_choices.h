#pragma once
/// What the user chose in the rendering panel, in the renderer's terms.

#include "render/session/session.h"
#include "ui/render_panel.h"

namespace pdr::app {

inline FrameBudget paceOf(const ui::FrameBudgetChoice& choice) {
    return {choice.automatic, choice.iterations, choice.framesPerSecond};
}

inline Schedule scheduleOf(const ui::ScheduleChoice& choice) {
    using Way = ui::ScheduleChoice::Way;
    if (choice.way == Way::ours)
        return {};
    return {.kind = Schedule::Kind::kroes, .redundant = choice.way == Way::k0, .filter = choice.filter};
}

inline ui::ScheduleChoice choiceOf(const Schedule& schedule) {
    using Way = ui::ScheduleChoice::Way;
    if (schedule.kind == Schedule::Kind::pd)
        return {};
    return {schedule.redundant ? Way::k0 : Way::k1, schedule.filter};
}

}  // namespace pdr::app
