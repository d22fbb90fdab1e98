#pragma once
/// What `pdrender-bench scale` says, for people and for programs.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/scale/measured_runs.h"
#include "render/timing/scaling.h"

namespace pdr::bench::scale {

/// Of one number of nodes.
struct Row {
    ScaledFrames told;
    std::optional<ScaledFrames> played;  ///< event by event, of what is a star
};

struct Report {
    std::string node;  ///< what the times of a node are of
    ScalingFacts facts;
    std::array<std::vector<Row>, kDistributions> rows;  ///< of each way, by nodes
    std::string machine;                                ///< of the runs
    std::vector<ComparedRun> runs;
};

/// "sort-first (tiles)", and where its formula is from.
struct Way {
    const char* name;
    const char* source;
};
const Way& wayOf(Distribution how);

/// 1, 2, 4, 8, ... and whole decades, up to `mostNodes`.
Report reportOf(const std::string& node, const ScalingFacts& facts, double mostNodes);

std::string tables(const Report& report);
/// Times in seconds; what is not known is null.
std::string json(const Report& report);
/// rate.svg, latency.svg, efficiency.svg and bytes.svg, each whole or not at all.
Result<void> writePlots(const Report& report, const std::filesystem::path& folder);

}  // namespace pdr::bench::scale
