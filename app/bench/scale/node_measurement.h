#pragma once
/// Measures the times of one node, this machine, with frames of few pixels, and how much the tiles of its image differ.

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

/// Measures the node. Each of fifteen kinds of frame is repeated for at least `seconds`, in three rounds; a second or
/// two in all on a CPU. Errors: those of the device and of the fit, and a stop request.
Result<MeasuredNode> measureNode(Device& device, Scene scene, const Display& display, double seconds,
                                 const paper::WorkClock& now, std::stop_token stop);

}  // namespace pdr::bench::scale
