#pragma once
/// Runs of real nodes, to compare predictions with, from a JSON file as tools/measure/nodes_scaling.py writes it:
///
///   {"format": "pdrender-scale-runs", "formatVersion": 1,
///    "width": 480, "height": 270,             pixels of the image
///    "machine": "two cores, ...",             description for the reader; may be missing
///    "clock": "wall",                         or "processor": processor time of the nodes, which excludes transfers
///                                             and waits; default wall
///    "cores": 2,                              processor cores that all nodes share; may be missing: one for each
///    "leaseSeconds": 0.001,                   T0, time of a piece of work beside its samples; may be
///                                             missing: that of this machine's launches
///    "runs": [{"nodes": 1,                    nodes that took samples, whole number from 1
///              "iterations": 256,             samples of each pixel in the run, from 1
///              "iterationsPerSecond": 12.5,   of the whole image, > 0
///              "messages": 4096,              requests and results of pieces of work, all nodes; may be missing
///              "bytes": 81920000}]}           sent by the nodes, >= 0; may be missing
///
/// A run of one node must be among them: it shows what one node can do there. Other names are ignored.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/base/portable.h"
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
    ivec2 size{0};  ///< pixels
    std::string machine;
    bool byProcessor = false;            ///< true: times are processor time
    std::optional<double> cores;         ///< cores that all nodes share; null: each has its own
    std::optional<double> leaseSeconds;  ///< T0; null: unknown
    std::vector<MeasuredRun> runs;       ///< at least one is of one node

    double pixels() const { return double(size.x) * size.y; }
    const MeasuredRun& ofOne() const;
};

/// Reads runs from a file; measuredRunsFrom() parses its text. Errors: no such file, not such JSON, a number out of its
/// range, no run of one node.
Result<MeasuredRuns> readMeasuredRuns(const std::filesystem::path& path);
Result<MeasuredRuns> measuredRunsFrom(const std::string& text, const std::string& name);

/// A run, and its prediction from the run of one node.
struct ComparedRun {
    MeasuredRun run;
    double foretold = 0;                  ///< predicted iterations per second
    double foretoldMessages = 0;          ///< predicted
    std::optional<double> foretoldBytes;  ///< predicted; null without the bytes of one node

    double off() const { return foretold / run.iterationsPerSecond - 1; }
    std::optional<double> bytesOff() const {
        return foretoldBytes && run.bytes && *run.bytes > 0 ? std::optional(*foretoldBytes / *run.bytes - 1)
                                                            : std::nullopt;
    }
};

/// Predicts all runs. The image is one frame of as many iterations as each run has, divided into tiles: half as many as
/// there were messages, where that is known. `facts`: those of this machine; alpha is scaled until one node takes as
/// long as in the run of one node. Messages and bytes are those of played nodes (played_pool.h), bytes of a pixel those
/// of one node.
std::vector<ComparedRun> compared(const MeasuredRuns& runs, ScalingFacts facts);

}  // namespace pdr::bench::scale
