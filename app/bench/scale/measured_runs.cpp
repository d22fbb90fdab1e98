#include "app/bench/scale/measured_runs.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

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
    runs.pixels = number(json, "width", 1) * number(json, "height", 1);
    runs.machine = json.value("machine", "");
    runs.byProcessor = json.value("clock", "wall") == "processor";
    runs.leaseSeconds = ifThere(json, "leaseSeconds");
    for (const Json& run : json.at("runs"))
        runs.runs.push_back(runFrom(run));
    if (std::ranges::find(runs.runs, 1, &MeasuredRun::nodes) == runs.runs.end())
        throw std::invalid_argument("there is no run of one node");
    return runs;
}

/// Returns the bytes of a run whose messages are as large as those of one node.
std::optional<double> bytesOf(const MeasuredRun& run, const MeasuredRun& one) {
    if (!run.bytes || !run.messages || !one.bytes || !one.messages || *one.messages == 0)
        return std::nullopt;
    return *one.bytes * *run.messages / *one.messages;
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
    facts.work.pixels = runs.pixels;
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
            its.leastTilePixels = runs.pixels / (its.tilesPerNode * run.nodes) / 2;
        }
        return run.iterations * scaled(its, Distribution::sortFirst, run.nodes).framesPerSecond;
    };
    // Scale alpha until the run of one node is predicted as it was measured
    constexpr int kSteps = 60;  // nearly proportional, so a few would do
    for (int step = 0; step < kSteps; ++step)
        facts.node.sample *= rate(runs.ofOne()) / runs.ofOne().iterationsPerSecond;
    std::vector<ComparedRun> all;
    for (const MeasuredRun& run : runs.runs)
        all.push_back({run, rate(run), bytesOf(run, runs.ofOne())});
    return all;
}

}  // namespace pdr::bench::scale
