#pragma once
/// What `pdrender-bench scale` is asked for.

#include <filesystem>
#include <optional>
#include <string>

#include "app/bench/commands.h"
#include "render/base/result.h"
#include "render/timing/scaling.h"

namespace pdr::bench::scale {

struct Settings {
    std::string sceneFile;  ///< empty: the head
    std::string device = "cpu";
    int threads = 0;           ///< of the CPU; 0 = one per core
    double seconds = 0.1;      ///< that each kind of frame is measured for
    ScalingFacts facts;        ///< work, link and bytes; the node's times where `node` has them
    bool measuresNode = true;  ///< false: all four times of a node were given
    std::optional<double> launch, sample, pixel, serial;  ///< given: T0, alpha, beta, T_c [s]
    double mostNodes = 100'000;
    bool json = false;
    std::optional<std::filesystem::path> plots;  ///< an existing folder
    std::optional<std::filesystem::path> measured;

    /// `fitted` with what was given in its place.
    FrameTimeModel nodeOf(FrameTimeModel fitted) const;
};

/// Errors: a word that is none of the command's, a value out of its range, no such folder and none to be made.
Result<Settings> settingsFrom(const Arguments& arguments);

}  // namespace pdr::bench::scale
