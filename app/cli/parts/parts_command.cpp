#include "app/cli/parts/parts_command.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/failed.h"
#include "app/cli/parts/parts_options.h"
#include "app/cli/progress_line.h"
#include "app/cli/run_command.h"
#include "app/cli/scan/scanned_volume.h"
#include "app/program/interrupt.h"
#include "render/volume/file/label_nrrd.h"

namespace pdr::app {
namespace {

using Json = nlohmann::ordered_json;

/// Returns a colour as "#c08040".
std::string hexOf(const LabelColour& colour) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", unsigned(colour[0]), unsigned(colour[1]), unsigned(colour[2]));
    return text;
}

Json reportOf(const LabelMap& map) {
    Json report = {{"source", map.source}, {"notes", Json::array()}, {"parts", Json::array()}};
    for (const Text& note : map.notes)
        report["notes"].push_back(std::string(note));
    const std::vector<double> ml = partsMl(map);
    for (std::size_t n = 0; n < map.parts.size(); ++n)
        report["parts"].push_back(
            {{"label", n + 1}, {"name", map.parts[n].name}, {"ml", ml[n]}, {"colour", hexOf(map.parts[n].colour)}});
    return report;
}

void printText(const Json& report) {
    std::printf("Parts from %s:\n", report["source"].get<std::string>().c_str());
    for (const Json& part : report["parts"])
        std::printf("  %3d  %10.2f ml  %s  %s\n", part["label"].get<int>(), part["ml"].get<double>(),
                    part["colour"].get<std::string>().c_str(), part["name"].get<std::string>().c_str());
    for (const Json& note : report["notes"])
        std::printf("note: %s\n", note.get<std::string>().c_str());
}

Result<LabelMap> readParts(const PartsOptions& options, const ScannedVolume& scanned, const std::stop_token& stop) {
    ProgressLine line;
    Result<LabelMap> map = partsFrom(options.source, *scanned.volume, scanned.series.get(), line.until(stop));
    line.finish();
    return map;
}

int listParts(const PartsOptions& options, const Interrupt& interrupt) {
    const auto scanned = scannedVolume(options.scan, options.seriesUid, Table::shown, interrupt.token());
    if (!scanned)
        return failed(scanned.error());
    const auto map = readParts(options, *scanned, interrupt.token());
    if (!map)
        return failed(map.error());
    const Json report = reportOf(*map);
    if (options.json)
        std::printf("%s\n", report.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
    else
        printText(report);
    if (options.output.empty())
        return 0;
    const auto written = writeLabelFile(*map, options.output);
    return written ? 0 : failed(written.error());
}

}  // namespace

int runParts(const QStringList& arguments) {
    const Interrupt interrupt;
    return runCommand("parts", partsOptions(arguments), partsHelp,
                      [&](const PartsOptions& options) { return listParts(options, interrupt); });
}

}  // namespace pdr::app
