#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/bench/paper/text_table.h"
#include "app/bench/scale/report.h"

namespace pdr::bench::scale {

namespace {

using paper::digits;
using paper::fraction;
using paper::milliseconds;
using paper::plain;

/// Returns a number of bytes as "8.3 MB".
std::string bytes(double count) {
    constexpr const char* kUnits[] = {"B", "kB", "MB", "GB", "TB", "PB"};
    std::size_t unit = 0;
    for (; count >= 1000 && unit + 1 < std::size(kUnits); ++unit)
        count /= 1000;
    char text[32];
    std::snprintf(text, sizeof text, "%.3g %s", count, kUnits[unit]);
    return text;
}

std::string whole(double value) {
    char text[64];
    std::snprintf(text, sizeof text, "%.0f", value);
    return text;
}

std::string signedPercent(double part) {
    char text[32];
    std::snprintf(text, sizeof text, "%+.1f %%", 100 * part);
    return text;
}

std::string wayTable(const std::vector<Row>& rows) {
    const bool played = rows.front().played.has_value();
    std::vector<std::string> head{"nodes", "busy",       "frames/s",    "latency ms",
                                  "E",     "1 - FPS Tc", "bytes/frame", "messages/frame"};
    if (played)
        head.insert(head.end(), {"played frames/s", "played latency ms"});
    paper::TextTable table(head, 0);
    for (const auto& [told, simulated] : rows) {
        std::vector<std::string> cells{
            whole(told.nodes),          whole(told.busy),          digits(told.framesPerSecond),
            milliseconds(told.latency), fraction(told.efficiency), fraction(told.paper),
            bytes(told.bytes),          whole(told.messages)};
        if (played)
            cells.insert(cells.end(), {digits(simulated->framesPerSecond), milliseconds(simulated->latency)});
        table.add(std::move(cells));
    }
    return table.text();
}

std::string factsText(const Report& report) {
    const ScalingFacts& facts = report.facts;
    return "A node: " + report.node + "\n  T0 " + milliseconds(facts.node.launch) + " ms a launch, alpha " +
           digits(1e9 * facts.node.sample) + " ns a sample, beta " + digits(1e9 * facts.node.pixel) +
           " ns a pixel, Tc " + milliseconds(facts.node.communication) + " ms a frame; tiles differ by " +
           fraction(facts.tiles.deviation()) + " of their mean\nA frame: " + whole(facts.work.pixels) + " pixels, " +
           whole(facts.work.iterations) + " samples each, " + whole(facts.work.perLaunch) + " in a launch; up to " +
           whole(facts.tilesPerNode) + " tiles a node\nThe link: " + milliseconds(facts.link.latency) +
           " ms one way, " + bytes(facts.link.bytesPerSecond) + "/s, " + milliseconds(facts.link.messageSeconds) +
           " ms a message; " + plain(facts.pixelBytes) + " bytes a finished pixel, " + plain(facts.sumBytes) +
           " of sums; " + plain(facts.orderBytes) +
           " bytes of requests for each\nChecks: " + plain(100 * facts.checkedPart) +
           " % of the samples, by another node; " + whole(facts.relays) + " relays; a scan of " +
           bytes(facts.scanBytes) + "\n";
}

/// Returns sentences about where the paper's limit for many nodes is wrong, and why.
std::string floorText(const Report& report) {
    const double pixels = floorPixels(report.facts.node, report.facts.work), nodes = floorNodes(report.facts);
    const auto& rows = report.rows[std::size_t(Distribution::sortFirst)];
    const Row& worst =
        *std::ranges::max_element(rows, {}, [](const Row& row) { return row.told.paper - row.told.efficiency; });
    std::string text = "No launch floor was found.\n";
    if (pixels > 0)
        text = "A tile of fewer than " + digits(pixels) + " pixels takes longer to launch than to sample" +
               (std::isfinite(nodes) ? ": with tiles, from " + whole(std::ceil(nodes)) + " nodes on.\n"
                                     : ", and no tile is as small.\n");
    if (report.facts.tiles.deviation() > 1)
        text += "Tiles differ so much that the formula of sort-first is good to 5 % from 16 tiles a node on only.\n";
    return text +
           "With many nodes E tends to 1 - FPS Tc (Perez Monte et al., eq. 5), which has no launch floor, no link and "
           "no "
           "node without work: with " +
           whole(worst.told.nodes) + " nodes it promises " + fraction(worst.told.paper) + ", and " +
           fraction(worst.told.efficiency) + " of the time goes into samples.\n";
}

/// Returns what ends the gain of more nodes with tiles, and when all have the scan.
std::string limitsText(const Report& report) {
    paper::TextTable limits({"more nodes than these gain nothing", "nodes"});
    for (const auto& [limit, nodes] : report.limits)
        limits.add({limitText(limit), std::isfinite(nodes) ? digits(nodes) : "never"});
    paper::TextTable scan({"nodes", "seconds until all have the scan"}, 0);
    for (const auto& [nodes, seconds] : report.scan)
        scan.add({whole(nodes), digits(seconds)});
    return limits.text() + "\n" + scan.text();
}

std::string runsText(const Report& report) {
    paper::TextTable table({"nodes", "iterations", "measured it/s", "foretold it/s", "off", "messages", "foretold",
                            "bytes", "foretold bytes", "off"},
                           0);
    for (const ComparedRun& run : report.runs)
        table.add({whole(run.run.nodes), whole(run.run.iterations), digits(run.run.iterationsPerSecond),
                   digits(run.foretold), signedPercent(run.off()), run.run.messages ? whole(*run.run.messages) : "-",
                   whole(run.foretoldMessages), run.run.bytes ? bytes(*run.run.bytes) : "-",
                   run.foretoldBytes ? bytes(*run.foretoldBytes) : "-",
                   run.bytesOff() ? signedPercent(*run.bytesOff()) : "-"});
    return "\nRuns of real nodes" + (report.machine.empty() ? "" : ", " + report.machine) +
           "; foretold from the one of one node\n\n" + table.text();
}

}  // namespace

std::string tables(const Report& report) {
    std::string text = factsText(report);
    for (std::size_t way = 0; way < kDistributions; ++way) {
        const auto& [name, source] = wayOf(Distribution(way));
        text.append("\n").append(name).append("\n  after: ").append(source).append("\n\n");
        text += wayTable(report.rows[way]);
    }
    text.append("\n").append(limitsText(report)).append("\n").append(floorText(report));
    return report.runs.empty() ? text : text + runsText(report);
}

}  // namespace pdr::bench::scale
