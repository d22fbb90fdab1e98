#pragma once
/// Plan of the paper's experiment: Perez Monte et al., "Estimation of Volume Rendering Efficiency with GPU in a
/// Parallel Distributed Environment", section 5.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/paper/work_clock.h"
#include "render/base/tile.h"
#include "render/device/gpu/launch_size.h"
#include "render/scene/schedule.h"

namespace pdr::bench::paper {

/// A way from samples to displayed frames.
struct Way {
    const char* name;  ///< name of the schedule: "K0"
    Schedule schedule;
    std::uint32_t iterations;  ///< n, iterations of one frame

    std::string title() const { return std::string(name) + " n=" + std::to_string(iterations); }
};

/// Indices into kWays.
enum WayPlace { kK0, kK1, kPd1, kPd10, kPd100, kWayCount };

inline constexpr std::array<Way, kWayCount> kWays{{
    {"K0", {.kind = Schedule::Kind::kroes, .redundant = true}, 1},
    {"K1", {.kind = Schedule::Kind::kroes}, 1},
    {"pd", {}, 1},
    {"pd", {}, 10},
    {"pd", {}, 100},
}};

/// Resolutions of the paper, the largest first.
inline constexpr std::array<ivec2, 6> kSizes{{{1920, 1080}, {960, 540}, {480, 270}, {240, 135}, {120, 67}, {60, 34}}};

struct Plan {
    std::vector<ivec2> sizes{kSizes.begin(), kSizes.end()};  ///< resolutions, the largest first; never empty
    double seconds = 3;                                      ///< time for which a cell is measured, in all rounds; > 0
    int rounds = 5;                                          ///< number of rounds, >= 1
    TimeOf time = TimeOf::wall;
    /// Largest number of samples per pixel in one launch of `pd` on the host: the block of the film. K0 and K1 take
    /// one.
    std::uint32_t perLaunch = kSamplesPerBlock;
    /// True on a GPU: a launch takes as many samples as there is room for. The limit of a hundredth of a second, which
    /// may allow fewer, matters only for images so large that T0 is negligible.
    bool onGpu = false;

    std::uint32_t mostPerLaunch(ivec2 size) const {
        return onGpu ? LaunchSize(std::int64_t(size.x) * size.y).most() : perLaunch;
    }
    /// Returns b of the equation T(R, n, b), see efficiency.h.
    std::uint32_t samplesPerLaunch(const Way& way, ivec2 size) const {
        if (way.schedule.kind != Schedule::Kind::pd)
            return 1;
        return std::min(way.iterations, mostPerLaunch(size));
    }
};

/// Returns a size as text: "240x135".
std::string text(ivec2 size);
/// Parses a size such as "240x135"; null if it is none or a side is 0.
std::optional<ivec2> sizeOf(const std::string& text);

}  // namespace pdr::bench::paper
