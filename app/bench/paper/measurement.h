#pragma once
/// The cells of the experiment, each a resolution and a way, and what was measured of them.

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/bench/paper/device_load.h"
#include "app/bench/paper/frame_clock.h"
#include "app/bench/paper/plan.h"
#include "render/device/device.h"
#include "render/scene/scene.h"

namespace pdr::bench::paper {

/// One uninterrupted series of frames.
struct Run {
    Lap lap;
    std::optional<double> load;  ///< of the device, [0, 1]

    double frameSeconds() const { return lap.seconds / double(lap.frames); }
};

/// The middle of the runs, and the quarters to its sides: half of the runs lie between them. Seconds a frame.
struct Spread {
    double low, median, high;
};

struct Cell {
    ivec2 size;
    WayPlace way;
    std::vector<Run> runs;

    bool measured() const { return !runs.empty(); }
    std::uint64_t frames() const;
    double seconds() const;              ///< measured, in all
    Spread spread() const;               ///< no numbers where nothing was measured
    std::optional<double> load() const;  ///< the mean over the time for which it is known
};

struct Measured {
    std::vector<Cell> cells;  ///< by size as in the plan, then by way as in kWays
    int rounds = 0;           ///< that were begun
    bool complete = false;

    const Cell& at(std::size_t size, WayPlace way) const { return cells[size * kWayCount + way]; }
};

/// Called before each run: which cell, in which round, and the seconds that all will still take, about.
using OnMeasurement = std::function<void(const Cell& next, int round, double secondsLeft)>;

/// The cells take turns, round by round, so that whatever else the machine does strikes all of them alike. A cell whose
/// frames are so long that its time is spent early is left out of later rounds; it has one whole frame at least.
/// All times, those of the plan too, are `now`'s. `measured` is right after an error or a stop request too, as far as
/// it goes.
Result<void> measure(Device& device, const Scene& scene, const Display& display, const Plan& plan, const WorkClock& now,
                     DeviceLoad& load, const OnMeasurement& onMeasurement, std::stop_token stop, Measured& measured);

}  // namespace pdr::bench::paper
