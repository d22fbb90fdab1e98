#include "app/bench/scale/measured_runs.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/bench/scale/played_pool.h"
#include "render/base/image_size.h"

namespace pdr::bench::scale {

namespace {

using Json = nlohmann::json;

/// Returns a finite number of at least `least`. Throws an exception that measuredRunsFrom() catches.
double number(const Json& json, const char* name, double least) {
    const double value = json.at(name).get<double>();
    if (!std::isfinite(value) || value < least)
        throw std::invalid_argument(std::string(name) + " is out of its range");
    return value;
}

std::optional<double> ifThere(const Json& json, const char* name) {
    return json.contains(name) ? std::optional(number(json, name, 0)) : std::nullopt;
}

int side(const Json& json, const char* name) {
    return int(std::min(number(json, name, 1), double(kLongestSide)));
}

MeasuredRun runFrom(const Json& json) {
    constexpr double kLeastRate = 1e-9;
    MeasuredRun run;
    run.nodes = int(std::min(number(json, "nodes", 1), 1e6));
    run.iterations = std::uint32_t(std::min(number(json, "iterations", 1), 4e9));
    run.iterationsPerSecond = number(json, "iterationsPerSecond", kLeastRate);
    run.messages = ifThere(json, "messages");
    run.bytes = ifThere(json, "bytes");
    return run;
}

MeasuredRuns runsFrom(const Json& json) {
    if (json.at("format") != "pdrender-scale-runs" || json.at("formatVersion") != 1)
        throw std::invalid_argument("the format is not pdrender-scale-runs, version 1");
    MeasuredRuns runs;
    runs.size = {side(json, "width"), side(json, "height")};
    runs.machine = json.value("machine", "");
    runs.byProcessor = json.value("clock", "wall") == "processor";
    runs.cores = ifThere(json, "cores");
    runs.leaseSeconds = ifThere(json, "leaseSeconds");
    for (const Json& run : json.at("runs"))
        runs.runs.push_back(runFrom(run));
    if (std::ranges::find(runs.runs, 1, &MeasuredRun::nodes) == runs.runs.end())
        throw std::invalid_argument("there is no run of one node");
    return runs;
}

/// Bytes of a result beside those of its pixels: the frame's header and its map.
constexpr double kResultBytes = 150;
/// Bytes of a pixel of tissue as it is sent, packed: of sums and of moments. Others take next to none.
constexpr double kSumBytes = 44, kMomentBytes = 48;
/// Least part of an image that shows tissue.
constexpr double kLeastTissue = 0.01;

/// Returns what part of the image shows tissue, from what one node has sent of it; all, if that is not known.
double tissueIn(const MeasuredRuns& runs) {
    const std::optional<double> bytes = runs.ofOne().bytes;
    return bytes ? std::clamp(*bytes / (kMomentBytes * runs.pixels()), kLeastTissue, 1.0) : 1;
}

/// Returns what the nodes of a run send, played with those times of a sample and of a launch.
PlayedResults playedAs(const MeasuredRun& run, const MeasuredRuns& runs, double sample, double launch) {
    const double crowd = runs.cores ? std::max(1.0, run.nodes / std::max(*runs.cores, 1.0)) : 1;
    return playedResults(runs.size, run.iterations, {run.nodes, crowd * sample, crowd * launch, tissueIn(runs)});
}

/// Returns the bytes of the pixels of all results.
double pixelBytesOf(const PlayedResults& results) {
    return results.sumPixels * kSumBytes + results.deepPixels * kMomentBytes;
}

}  // namespace

const MeasuredRun& MeasuredRuns::ofOne() const {
    return *std::ranges::find(runs, 1, &MeasuredRun::nodes);
}

Result<MeasuredRuns> measuredRunsFrom(const std::string& text, const std::string& name) {
    try {
        return runsFrom(Json::parse(text));
    } catch (const std::exception& wrong) {
        return Error{std::string("this says nothing about runs of nodes (") + wrong.what() + ")", name,
                     "resources/manual/nodes-scaling.md has the format."};
    }
}

Result<MeasuredRuns> readMeasuredRuns(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return Error{"the file cannot be opened", path.string(), ""};
    return measuredRunsFrom({std::istreambuf_iterator<char>(file), {}}, path.string());
}

std::vector<ComparedRun> compared(const MeasuredRuns& runs, ScalingFacts facts) {
    const double launch = facts.node.launch;  // T0 of the runs also has what nodes lose to each other on busy cores
    facts.work.pixels = runs.pixels();
    facts.node.launch = runs.leaseSeconds.value_or(facts.node.launch);
    if (runs.byProcessor) {
        facts.link = {0, std::numeric_limits<double>::infinity(), 0};
        facts.tiles = {};  // what nodes wait for the last one is none of their processors' time
    }
    // Predict a run
    const auto rate = [&](const MeasuredRun& run) {
        ScalingFacts its = facts;
        its.work.iterations = run.iterations;
        if (run.messages) {  // as many tiles as in the run, each a launch
            its.work.perLaunch = run.iterations;
            its.tilesPerNode = std::max(1.0, std::round(*run.messages / 2 / run.nodes));
            its.leastTilePixels = runs.pixels() / (its.tilesPerNode * run.nodes) / 2;
        }
        return run.iterations * scaled(its, Distribution::sortFirst, run.nodes).framesPerSecond;
    };
    // Scale alpha until the run of one node is predicted as it was measured
    constexpr int kSteps = 60;  // nearly proportional, so a few would do
    for (int step = 0; step < kSteps; ++step)
        facts.node.sample *= rate(runs.ofOne()) / runs.ofOne().iterationsPerSecond;
    // Scale the bytes of a pixel until the run of one node has as many as were measured
    const PlayedResults one = playedAs(runs.ofOne(), runs, facts.node.sample, launch);
    const auto fixed = [](const PlayedResults& results) { return results.sent * kResultBytes; };
    std::optional<double> scale;
    if (runs.ofOne().bytes)
        scale = std::max(*runs.ofOne().bytes - fixed(one), 0.0) / pixelBytesOf(one);
    std::vector<ComparedRun> all;
    for (const MeasuredRun& run : runs.runs) {
        const PlayedResults played = playedAs(run, runs, facts.node.sample, launch);
        const auto bytes = [&](double scaled) { return fixed(played) + scaled * pixelBytesOf(played); };
        all.push_back({run, rate(run), 2 * played.merged, scale ? std::optional(bytes(*scale)) : std::nullopt});
    }
    return all;
}

}  // namespace pdr::bench::scale
