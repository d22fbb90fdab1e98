#include "app/bench/scale/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "app/bench/scale/plot.h"
#include "app/bench/scale/star_simulation.h"
#include "app/bench/text_file.h"

namespace pdr::bench::scale {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<Way, kDistributions> kWays{{
    {"sort-first: tiles",
     "Perez Monte et al., eq. 2, with a floor for each launch; last node: Blom 1958, Feller vol. 2, XI.4"},
    {"sample-first: blocks of 64, sent", "the same of whole images; sums through one link"},
    {"sample-first, summed on the way", "the same; reduce: Thakur, Rabenseifner & Gropp 2005"},
    {"alternate frames", "m / T until the link is full; waiting: Little's law"},
    {"sort-last: bricks", "R / m^(2/3) pixels a brick; binary swap: Ma et al. 1994; 28 bytes a sample"},
}};

constexpr std::array kLimits{"results fill the link", "requests fill the link",
                             "messages take all of the coordinator's time", "no tile is left"};

std::vector<double> nodeCounts(double most) {
    std::set<double> counts{1, most};
    for (double n = 2; n <= std::min(most, 64.0); n *= 2)
        counts.insert(n);
    for (double n = 100; n <= most; n *= 10)
        counts.insert(n);
    return {counts.begin(), counts.end()};
}

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

Json framesJson(const ScaledFrames& frames) {
    return {{"nodes", frames.nodes},
            {"busy", frames.busy},
            {"framesPerSecond", frames.framesPerSecond},
            {"latencySeconds", frames.latency},
            {"efficiency", frames.efficiency},
            {"efficiencyByPaper", frames.paper},
            {"bytesPerFrame", frames.bytes},
            {"messagesPerFrame", frames.messages}};
}

Json factsJson(const ScalingFacts& facts) {
    return {{"pixels", facts.work.pixels},
            {"iterations", facts.work.iterations},
            {"samplesPerLaunch", facts.work.perLaunch},
            {"launchSeconds", facts.node.launch},
            {"sampleSeconds", facts.node.sample},
            {"pixelSeconds", facts.node.pixel},
            {"serialSeconds", facts.node.communication},
            {"tileDeviation", facts.tiles.deviation()},
            {"tilesPerNode", facts.tilesPerNode},
            {"latencySeconds", facts.link.latency},
            {"bytesPerSecond", facts.link.bytesPerSecond},
            {"messageSeconds", facts.link.messageSeconds},
            {"pixelBytes", facts.pixelBytes},
            {"orderBytes", facts.orderBytes},
            {"sumBytes", facts.sumBytes},
            {"checkedPart", facts.checkedPart},
            {"relays", facts.relays},
            {"scanBytes", facts.scanBytes}};
}

Json limitsJson(const Report& report) {
    Json json = Json::array();
    for (const auto& [limit, nodes] : report.limits)
        json.push_back({{"limit", limitText(limit)}, {"nodes", number(nodes)}});
    return json;
}

Json scanJson(const Report& report) {
    Json json = Json::array();
    for (const auto& [nodes, seconds] : report.scan)
        json.push_back({{"nodes", nodes}, {"seconds", seconds}});
    return json;
}

Json runJson(const ComparedRun& run) {
    Json json{{"nodes", run.run.nodes},
              {"iterations", run.run.iterations},
              {"iterationsPerSecond", run.run.iterationsPerSecond},
              {"foretold", run.foretold}};
    json["messages"] = run.run.messages ? Json(*run.run.messages) : Json();
    json["foretoldMessages"] = run.foretoldMessages;
    json["bytes"] = run.run.bytes ? Json(*run.run.bytes) : Json();
    json["foretoldBytes"] = run.foretoldBytes ? Json(*run.foretoldBytes) : Json();
    return json;
}

/// Returns a plot with a colour for each way. The efficiency that the paper's eq. 5 claims is dashed.
Plot plotOf(const Report& report, const char* title, double ScaledFrames::*figure) {
    Plot plot{title, figure == &ScaledFrames::efficiency, {}};
    for (std::size_t way = 0; way < kDistributions; ++way) {
        Curve curve{kWays[way].name, {}, false, way};
        for (const Row& row : report.rows[way])
            curve.points.emplace_back(row.told.nodes, row.told.*figure);
        plot.curves.push_back(std::move(curve));
    }
    if (!plot.share)
        return plot;
    Curve paper{"eq. 5 of sort-first", {}, true, std::size_t(Distribution::sortFirst)};
    for (const Row& row : report.rows[paper.colour])
        paper.points.emplace_back(row.told.nodes, row.told.paper);
    plot.curves.push_back(std::move(paper));
    return plot;
}

}  // namespace

const Way& wayOf(Distribution how) {
    return kWays[std::size_t(how)];
}

const char* limitText(NodeLimit limit) {
    return kLimits[std::size_t(limit)];
}

Report reportOf(const std::string& node, const ScalingFacts& facts, double mostNodes) {
    Report report{node, facts, {}, limitsOf(facts), {}, {}, {}};
    for (const double nodes : nodeCounts(mostNodes))
        report.scan.push_back({nodes, scanSeconds(facts, nodes)});
    for (std::size_t way = 0; way < kDistributions; ++way)
        for (const double nodes : nodeCounts(mostNodes))
            report.rows[way].push_back(
                {scaled(facts, Distribution(way), nodes), simulated(facts, Distribution(way), std::int64_t(nodes))});
    return report;
}

std::string json(const Report& report) {
    Json json{{"format", "pdrender-scale"},
              {"formatVersion", 1},
              {"node", report.node},
              {"facts", factsJson(report.facts)},
              {"floorPixels", number(floorPixels(report.facts.node, report.facts.work))},
              {"floorNodes", number(floorNodes(report.facts))},
              {"limits", limitsJson(report)},
              {"scan", scanJson(report)},
              {"ways", Json::array()},
              {"runs", Json::array()}};
    for (std::size_t way = 0; way < kDistributions; ++way) {
        Json rows = Json::array();
        for (const Row& row : report.rows[way]) {
            rows.push_back(framesJson(row.told));
            rows.back()["played"] = row.played ? framesJson(*row.played) : Json();
        }
        json["ways"].push_back({{"name", kWays[way].name}, {"source", kWays[way].source}, {"rows", rows}});
    }
    for (const ComparedRun& run : report.runs)
        json["runs"].push_back(runJson(run));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<void> writePlots(const Report& report, const std::filesystem::path& folder) {
    const std::pair<const char*, Plot> plots[] = {
        {"rate.svg", plotOf(report, "frames per second", &ScaledFrames::framesPerSecond)},
        {"latency.svg", plotOf(report, "latency [s]", &ScaledFrames::latency)},
        {"efficiency.svg", plotOf(report, "efficiency", &ScaledFrames::efficiency)},
        {"bytes.svg", plotOf(report, "bytes of a frame", &ScaledFrames::bytes)}};
    for (const auto& [name, plot] : plots)
        if (const auto written = writeText(folder / name, svg(plot)); !written)
            return written.error();
    return {};
}

}  // namespace pdr::bench::scale
