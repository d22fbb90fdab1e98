#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/bench/paper/report.h"
#include "app/bench/text_file.h"

namespace pdr::bench::paper {

namespace {

using Json = nlohmann::ordered_json;

Json number(std::optional<double> value) {
    return value && std::isfinite(*value) ? Json(*value) : Json();
}

std::string field(std::optional<double> value) {
    if (!value || !std::isfinite(*value))
        return "";
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", *value);
    return text;
}

std::optional<double> scaled(double factor, std::optional<double> value) {
    return value ? std::optional(factor * *value) : std::nullopt;
}

/// Returns the figures of the size that `cell` belongs to.
const SizeFigures& figuresOf(const Report& report, std::size_t cell) {
    return report.figures.sizes[cell / kWayCount];
}

bool isPd(const Cell& cell) {
    return kWays[cell.way].schedule.kind == Schedule::Kind::pd;
}

Json cellJson(const Report& report, std::size_t place) {
    const Cell& cell = report.measured.cells[place];
    const SizeFigures& size = figuresOf(report, place);
    Json runs = Json::array();
    for (const Run& run : cell.runs)
        runs.push_back({{"frames", run.lap.frames}, {"seconds", run.lap.seconds}, {"load", number(run.load)}});
    return {{"width", cell.size.x},
            {"height", cell.size.y},
            {"way", kWays[cell.way].name},
            {"iterations", kWays[cell.way].iterations},
            {"samplesPerLaunch", report.plan.samplesPerLaunch(kWays[cell.way], cell.size)},
            {"framesPerSecond", number(size.framesPerSecond[cell.way])},
            {"iterationsPerSecond", number(size.iterationsPerSecond(cell.way))},
            {"load", number(size.load[cell.way])},
            {"iterationSeconds", number(size.iteration)},
            {"otherSeconds", number(size.other[cell.way])},
            {"efficiency", number(size.efficiency[cell.way])},
            {"sampleNoise", number(isPd(cell) ? size.sampleNoise : std::nullopt)},
            {"secondsToOnePercent", number(isPd(cell) ? size.secondsToError(cell.way) : std::nullopt)},
            {"runs", runs}};
}

Json parameter(double value, const ConfidenceInterval& interval) {
    return {{"value", value}, {"low", interval.low}, {"high", interval.high}};
}

Json fitJson(const Figures& figures) {
    if (!figures.fit)
        return {};
    const FrameTimeFit& fit = *figures.fit;
    Json json{{"launchIsKnown", fit.launchIsKnown()},
              {"launchSeconds", fit.launchIsKnown() ? parameter(fit.model().launch, fit.launch()) : Json()},
              {"sampleSeconds", parameter(fit.model().sample, fit.sample())},
              {"pixelSeconds", parameter(fit.model().pixel, fit.pixel())},
              {"communicationSeconds", parameter(fit.model().communication, fit.communication())},
              {"scatter", fit.scatter()},
              {"tiles", Json::array()}};
    for (const TileEfficiency& tile : figures.tiles)
        json["tiles"].push_back({{"width", tile.size.x},
                                 {"height", tile.size.y},
                                 {"iterations", kWays[tile.way].iterations},
                                 {"manyNodes", tile.manyNodes},
                                 {"share", parameter(tile.fraction, tile.interval)}});
    return json;
}

}  // namespace

std::string csv(const Report& report) {
    std::string text =
        "width,height,way,iterations,frames_per_second,iterations_per_second,load,frame_ms,half_of_runs_from_ms,"
        "half_of_runs_to_ms,frames,runs,iteration_ms,other_ms,efficiency\n";
    for (std::size_t place = 0; place < report.measured.cells.size(); ++place) {
        const Cell& cell = report.measured.cells[place];
        const SizeFigures& size = figuresOf(report, place);
        const Spread spread = cell.spread();
        text += std::to_string(cell.size.x) + "," + std::to_string(cell.size.y) + "," + kWays[cell.way].name + "," +
                std::to_string(kWays[cell.way].iterations) + "," + field(size.framesPerSecond[cell.way]) + "," +
                field(size.iterationsPerSecond(cell.way)) + "," + field(size.load[cell.way]) + "," +
                field(1e3 * spread.median) + "," + field(1e3 * spread.low) + "," + field(1e3 * spread.high) + "," +
                std::to_string(cell.frames()) + "," + std::to_string(cell.runs.size()) + "," +
                field(scaled(1e3, size.iteration)) + "," + field(scaled(1e3, size.other[cell.way])) + "," +
                field(size.efficiency[cell.way]) + "\n";
    }
    return text;
}

std::string json(const Report& report) {
    const Setup& setup = report.setup;
    Json json{{"format", "pdrender-paper"},
              {"formatVersion", 1},
              {"complete", report.measured.complete},
              {"date", setup.date},
              {"version", setup.version},
              {"processor", setup.processor},
              {"cores", setup.cores},
              {"device", {{"name", setup.device.name}, {"details", setup.device.details}}},
              {"scene", setup.scene},
              {"estimator", setup.estimator},
              {"secondsPerCell", report.plan.seconds},
              {"rounds", report.plan.rounds},
              {"clock", report.plan.time == TimeOf::wall ? "wall" : "processor"},
              {"cells", Json::array()},
              {"communicationSeconds",
               {{"K0", number(report.figures.communication[kK0])},
                {"K1", number(report.figures.communication[kK1])},
                {"pd", number(report.figures.communication[kPd1])}}},
              {"fit", fitJson(report.figures)},
              {"goals", Json::array()}};
    for (std::size_t place = 0; place < report.measured.cells.size(); ++place)
        json["cells"].push_back(cellJson(report, place));
    for (const Goal& goal : goalsOf(report.figures))
        json["goals"].push_back({{"figure", goal.what},
                                 {"here", number(goal.here)},
                                 {"goal", number(goal.wanted)},
                                 {"paper", number(goal.paper)}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<void> write(const Report& report, const std::filesystem::path& folder) {
    for (const auto& [name, text] : {std::pair("paper.md", markdown(report)), std::pair("paper.csv", csv(report)),
                                     std::pair("paper.json", json(report))})
        if (Result<void> written = writeText(folder / name, text); !written)
            return written;
    return {};
}

}  // namespace pdr::bench::paper
