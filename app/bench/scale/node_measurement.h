#pragma once
/// The times of one node, this machine, by frames of few pixels; and how unlike the tiles of its picture are.

#include <stop_token>

#include "app/bench/paper/work_clock.h"
#include "render/device/device.h"
#include "render/film/display.h"
#include "render/scene/scene.h"
#include "render/timing/frame_time_fit.h"
#include "render/timing/tile_costs.h"

namespace pdr::bench::scale {

struct MeasuredNode {
    FrameTimeFit fit;
    TileCosts tiles;
};

/// Each of fifteen kinds of frame is repeated for `seconds` at least, in three rounds; a second or two in all on a CPU.
/// Errors: the device's, the fit's, a stop request.
Result<MeasuredNode> measureNode(Device& device, Scene scene, const Display& display, double seconds,
                                 const paper::WorkClock& now, std::stop_token stop);

}  // namespace pdr::bench::scale
