#pragma once
/// Report of `pdrender-bench scale`, for people and for programs.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/scale/measured_runs.h"
#include "render/timing/node_limits.h"

namespace pdr::bench::scale {

/// Figures of one number of nodes.
struct Row {
    ScaledFrames told;
    std::optional<ScaledFrames> played;  ///< from the event simulation; null if the way is not a star
};

/// Time until all of a number of nodes have the scan.
struct ScanRow {
    double nodes = 1;
    double seconds = 0;
};

struct Report {
    std::string node;  ///< description of the node that the times are of
    ScalingFacts facts;
    std::array<std::vector<Row>, kDistributions> rows;  ///< for each way, by number of nodes
    std::vector<LimitedNodes> limits;                   ///< the lowest first
    std::vector<ScanRow> scan;                          ///< by number of nodes
    std::string machine;                                ///< machine of the runs
    std::vector<ComparedRun> runs;
};

/// Name of a way, such as "sort-first: tiles", and the source of its formula.
struct Way {
    const char* name;
    const char* source;
};
const Way& wayOf(Distribution how);
/// Describes a limit, such as "results fill the link".
const char* limitText(NodeLimit limit);

/// Makes a report for 1, 2, 4, ... 64 nodes, whole decades from 100 on, and `mostNodes`, which is the largest.
Report reportOf(const std::string& node, const ScalingFacts& facts, double mostNodes);

std::string tables(const Report& report);
/// Returns the report as JSON; times in seconds; unknown values are null.
std::string json(const Report& report);
/// Writes rate.svg, latency.svg, efficiency.svg and bytes.svg, each whole or not at all.
Result<void> writePlots(const Report& report, const std::filesystem::path& folder);

}  // namespace pdr::bench::scale
