#include "app/rendering/battery_rest.h"

#include <chrono>
#include <utility>

#include "app/rendering/power_supply.h"
#include "app/rendering/render_bridge.h"

namespace pdr::app {

BatteryRest::BatteryRest(RenderBridge& bridge, std::filesystem::path supplies)
    : bridge_(bridge), supplies_(std::move(supplies)) {
    connect(&bridge, &RenderBridge::pausedChanged, this, [this](bool paused) {
        if (!paused)
            setRests(false);
    });
    if (supplies_.empty())
        return;
    timer_.setInterval(std::chrono::seconds(10));
    connect(&timer_, &QTimer::timeout, this, &BatteryRest::look);
    timer_.start();
    look();
}

/// Pauses or resumes rendering if the power supply has changed. A pause by the user is left alone.
void BatteryRest::look() {
    const bool now = onBattery(supplies_);
    if (std::exchange(onBattery_, now) == now)
        return;
    if (now && !bridge_.paused()) {
        bridge_.setPaused(true);
        setRests(true);
    } else if (!now && rests_) {
        bridge_.setPaused(false);
    }
}

void BatteryRest::setRests(bool rests) {
    if (std::exchange(rests_, rests) != rests)
        emit restsChanged();
}

}  // namespace pdr::app
