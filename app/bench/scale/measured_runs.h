#pragma once
/// Runs of real nodes to compare with. A JSON file, as tests/bench/nodes_scaling.py writes it:
///
///   {"format": "pdrender-scale-runs", "formatVersion": 1,
///    "width": 480, "height": 270,             pixels of the picture
///    "machine": "two cores, ...",             for the reader; may be missing
///    "clock": "wall",                         or "processor": of the nodes, so that ways and waits took no time;
///                                             default wall
///    "leaseSeconds": 0.001,                   that a node spends on a piece of work beside its samples, T0; may be
///                                             missing: as of this machine's launches
///    "runs": [{"nodes": 1,                    that took samples, whole number from 1
///              "iterations": 256,             samples of each pixel in the run, from 1
///              "iterationsPerSecond": 12.5,   of the whole picture, > 0
///              "messages": 4096,              orders and results of pieces of work, all nodes; may be missing
///              "bytes": 81920000}]}           from the nodes, >= 0; may be missing
///
/// A run of one node must be among them: it says what one node can do there. Other names are passed over.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/base/result.h"
#include "render/timing/scaling.h"

namespace pdr::bench::scale {

struct MeasuredRun {
    int nodes = 1;
    std::uint32_t iterations = 1;
    double iterationsPerSecond = 0;
    std::optional<double> messages, bytes;
};

struct MeasuredRuns {
    double pixels = 0;
    std::string machine;
    bool byProcessor = false;            ///< the clock
    std::optional<double> leaseSeconds;  ///< T0
    std::vector<MeasuredRun> runs;       ///< one of one node at least

    const MeasuredRun& ofOne() const;
};

/// Errors: no such file, no such JSON, a number that cannot be, no run of one node.
Result<MeasuredRuns> readMeasuredRuns(const std::filesystem::path& path);
Result<MeasuredRuns> measuredRunsFrom(const std::string& text, const std::string& name);

/// A run, and what is foretold of it from the run of one node.
struct ComparedRun {
    MeasuredRun run;
    double foretold = 0;  ///< iterations per second

    double off() const { return foretold / run.iterationsPerSecond - 1; }
};

/// The picture is one frame of as many iterations as each run has, shared out as tiles: half as many as there were
/// messages, where that is known. `facts` as of this machine; alpha is scaled until one node takes as long as there.
std::vector<ComparedRun> compared(const MeasuredRuns& runs, ScalingFacts facts);

}  // namespace pdr::bench::scale
