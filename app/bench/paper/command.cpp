#include <cstdio>

#include "app/bench/commands.h"
#include "app/bench/held_signals.h"
#include "app/bench/load_scene.h"
#include "app/bench/paper/head_scene.h"
#include "app/bench/paper/machine.h"
#include "app/bench/paper/progress.h"
#include "app/bench/paper/report.h"
#include "app/bench/paper/settings.h"
#include "render/base/version.h"
#include "render/device/device_list.h"
#include "render/scene/scene.h"

namespace pdr::bench {

namespace paper {
namespace {

Result<ShownScene> sceneOfFile(const std::string& path) {
    const Result<Scene> scene = loadScene(path);
    if (!scene)
        return scene.error();
    return ShownScene{*scene, {}, path + ", " + modelName(scene->model)};
}

Result<ShownScene> sceneFor(const Settings& settings) {
    Result<ShownScene> shown = settings.sceneFile.empty() ? headScene() : sceneOfFile(settings.sceneFile);
    if (shown && settings.estimator)
        shown->scene.estimator = *settings.estimator;
    return shown;
}

Setup setupOf(const Device& device, const DeviceLoad& load, const ShownScene& shown) {
    const bool unbiased = shown.scene.estimator == Estimator::unbiased;
    return {dateNow(),     PDR_VERSION,   processorName(),   processorCores(),
            device.info(), load.source(), shown.description, unbiased ? "unbiased" : "kroesMarch"};
}

/// Fills the report with what is measured, also if an error ends the measurement.
Result<void> run(Device& device, const Settings& settings, const ShownScene& shown, std::stop_token stop,
                 Report& report) {
    const std::unique_ptr<DeviceLoad> load = loadOf(device.info().name, settings.threads);
    report.setup = setupOf(device, *load, shown);
    report.plan = settings.plan;
    report.plan.onGpu = !device.info().hostMemory;
    Progress progress;
    const OnMeasurement onMeasurement = [&](const Cell& cell, int round, double secondsLeft) {
        progress.show("round " + std::to_string(round) + " of " + std::to_string(settings.plan.rounds) + ": " +
                          text(cell.size) + " " + kWays[cell.way].title(),
                      secondsLeft);
    };
    return measure(device, shown.scene, shown.display, settings.plan, clockOf(settings.plan.time, settings.threads),
                   *load, onMeasurement, stop, report.measured);
}

int tell(Report& report, const Settings& settings, const Result<void>& ran) {
    if (report.measured.cells.empty())
        return fail(ran.error());
    report.figures = figuresOf(report.measured, report.plan);
    std::fputs(markdown(report).c_str(), stdout);
    if (settings.out) {
        if (const Result<void> written = write(report, *settings.out); !written)
            return fail(written.error());
        std::printf("\nWritten: %s, paper.csv, paper.json\n", (*settings.out / "paper.md").c_str());
    }
    if (!ran)
        return fail(ran.error());
    return report.measured.complete ? 0 : 1;
}

}  // namespace
}  // namespace paper

int paperExperiment(const Arguments& arguments) {
    const Result<paper::Settings> settings = paper::settingsFrom(arguments);
    if (!settings) {
        fail(settings.error());
        return kExplained;
    }
    HeldSignals signals;
    const StopOnSignal stop(signals);
    const Result<std::unique_ptr<Device>> device = openDevice(settings->device, settings->threads);
    if (!device) {
        fail(device.error());
        return kExplained;
    }
    const Result<paper::ShownScene> shown = paper::sceneFor(*settings);
    if (!shown)
        return fail(shown.error());
    paper::Report report;
    const Result<void> ran = paper::run(**device, *settings, *shown, stop.token(), report);
    return paper::tell(report, *settings, ran);
}

}  // namespace pdr::bench
