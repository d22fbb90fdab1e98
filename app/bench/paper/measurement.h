#pragma once
/// Cells of the experiment, each a resolution and a way, and their measurements.

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
    std::optional<double> load;  ///< load of the device, [0, 1]; null if unknown

    double frameSeconds() const { return lap.seconds / double(lap.frames); }
};

/// Median and quartiles over the runs, in seconds per frame: half of the runs lie between `low` and `high`.
struct Spread {
    double low, median, high;
};

struct Cell {
    ivec2 size;
    WayPlace way;
    std::vector<Run> runs;

    bool measured() const { return !runs.empty(); }
    std::uint64_t frames() const;
    double seconds() const;              ///< measured time of all runs
    Spread spread() const;               ///< NaN where nothing was measured
    std::optional<double> load() const;  ///< mean over the time for which it is known; null if none
};

struct Measured {
    std::vector<Cell> cells;  ///< cells by size as in the plan, then by way as in kWays
    int rounds = 0;           ///< rounds that were begun
    bool complete = false;

    const Cell& at(std::size_t size, WayPlace way) const { return cells[size * kWayCount + way]; }
};

/// Callback before each run, with the next cell, the round, and the approximate seconds left for all runs.
using OnMeasurement = std::function<void(const Cell& next, int round, double secondsLeft)>;

/// Measures all cells. They take turns, round by round, so that other load of the machine affects all of them alike. A
/// cell whose frames are so long that its time is spent early is left out of later rounds; it has at least one whole
/// frame. All times, also those of the plan, are those of `now`. After an error or a stop request, `measured` contains
/// what was measured until then.
Result<void> measure(Device& device, const Scene& scene, const Display& display, const Plan& plan, const WorkClock& now,
                     DeviceLoad& load, const OnMeasurement& onMeasurement, std::stop_token stop, Measured& measured);

}  // namespace pdr::bench::paper
