#pragma once
/// Options of `pdrender-bench scale`.

#include <filesystem>
#include <optional>
#include <string>

#include "app/bench/commands.h"
#include "render/base/result.h"
#include "render/timing/scaling.h"

namespace pdr::bench::scale {

struct Settings {
    std::string sceneFile;  ///< path of the scene file; empty: the head
    std::string device = "cpu";
    int threads = 0;           ///< CPU threads; 0: one per core
    double seconds = 0.1;      ///< time for which each kind of frame is measured
    ScalingFacts facts;        ///< work, link and bytes; nodeOf() gives the times of the node
    bool measuresNode = true;  ///< false: all four times of a node were given
    std::optional<double> launch, sample, pixel, serial;  ///< given T0, alpha, beta, T_c [s]; null: measured
    double mostNodes = 100'000;
    bool json = false;
    std::optional<std::filesystem::path> plots;     ///< existing folder for plots; null: none
    std::optional<std::filesystem::path> measured;  ///< file with runs of real nodes; null: none

    /// Returns `fitted` with the given times in place of the measured ones.
    FrameTimeModel nodeOf(FrameTimeModel fitted) const;
};

/// Parses `arguments`. Errors: an unknown word, a value out of its range, a folder that does not exist and cannot be
/// made.
Result<Settings> settingsFrom(const Arguments& arguments);

}  // namespace pdr::bench::scale
