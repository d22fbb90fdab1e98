#include <cstdio>

#include "app/bench/commands.h"
#include "app/bench/held_signals.h"
#include "app/bench/load_scene.h"
#include "app/bench/paper/head_scene.h"
#include "app/bench/scale/node_measurement.h"
#include "app/bench/scale/report.h"
#include "app/bench/scale/settings.h"
#include "render/device/device_list.h"

namespace pdr::bench {

namespace scale {
namespace {

Result<paper::ShownScene> sceneFor(const Settings& settings) {
    if (settings.sceneFile.empty())
        return paper::headScene();
    const Result<Scene> scene = loadScene(settings.sceneFile);
    if (!scene)
        return scene.error();
    return paper::ShownScene{*scene, {}, settings.sceneFile};
}

/// Returns a description of the node, and stores its times in `facts`.
Result<std::string> node(const Settings& settings, ScalingFacts& facts) {
    facts.node = settings.nodeOf({});
    if (!settings.measuresNode)
        return std::string("as given");
    HeldSignals signals;
    const StopOnSignal stop(signals);
    const auto device = openDevice(settings.device, settings.threads);
    if (!device)
        return device.error();
    const auto shown = sceneFor(settings);
    if (!shown)
        return shown.error();
    const DeviceInfo info = (*device)->info();
    // On a CPU, the load of other programs must not count as the node's time.
    const auto time = info.name == "cpu" ? paper::TimeOf::processor : paper::TimeOf::wall;
    const auto measured = measureNode(**device, shown->scene, shown->display, settings.seconds,
                                      paper::clockOf(time, settings.threads), stop.token());
    if (!measured)
        return measured.error();
    facts.node = settings.nodeOf(measured->fit.model());
    facts.tiles = measured->tiles;
    return info.name + ", " + info.details + "; " + shown->description;
}

Result<void> run(const Settings& settings) {
    std::optional<MeasuredRuns> runs;
    if (settings.measured) {
        auto read = readMeasuredRuns(*settings.measured);
        if (!read)
            return read.error();
        runs = *std::move(read);
    }
    ScalingFacts facts = settings.facts;
    const Result<std::string> described = node(settings, facts);
    if (!described)
        return described.error();
    Report report = reportOf(*described, facts, settings.mostNodes);
    if (runs) {
        report.machine = runs->machine;
        report.runs = compared(*runs, facts);
    }
    std::fputs((settings.json ? json(report) : tables(report)).c_str(), stdout);
    return settings.plots ? writePlots(report, *settings.plots) : Result<void>();
}

}  // namespace
}  // namespace scale

int scaleOut(const Arguments& arguments) {
    const Result<scale::Settings> settings = scale::settingsFrom(arguments);
    if (!settings) {
        fail(settings.error());
        return kExplained;
    }
    const Result<void> done = scale::run(*settings);
    return done ? 0 : fail(done.error());
}

}  // namespace pdr::bench
