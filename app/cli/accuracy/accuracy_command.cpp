#include "app/cli/accuracy/accuracy_command.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <new>

#include "app/cli/accuracy/accuracy_page.h"
#include "app/cli/accuracy/measure_accuracy.h"
#include "app/cli/progress_line.h"
#include "app/cli/render/film_room.h"
#include "app/cli/render/render_options.h"
#include "app/cli/run_command.h"
#include "app/output/image_files.h"
#include "app/program/interrupt.h"
#include "render/base/errors.h"
#include "render/base/replacing_file.h"
#include "render/base/version.h"
#include "render/device/device_list.h"

namespace pdr::app {
namespace {

namespace fs = std::filesystem;

/// Share of the time for the reference that all images are compared with: its error is then about half that of the
/// best.
constexpr double kReferenceShare = 0.6;
/// Share of the time for the scene itself; the rest is for other images of its anatomy.
constexpr double kSceneShare = 0.7;

Result<void> makeFolder(const fs::path& folder) {
    std::error_code trouble;
    fs::create_directories(folder, trouble);
    if (trouble || !fs::is_directory(folder, trouble))
        return Error{"this folder cannot be made", folder.string(), "Name one with -o that can be written to."};
    return {};
}

/// Arguments that all measurements share.
struct Work {
    const AccuracyOptions& options;
    const Display& display;
    Device& device;
    const std::stop_token& stop;
    AccuracyProgress progress;
};

/// Renders the reference of `scene`. If `folder` is not empty, continues from the film that an earlier run saved there,
/// and saves its own, even after an interrupt.
Result<KeptFilm> reference(const Scene& scene, double seconds, const fs::path& folder, const Work& work) {
    const fs::path file = folder / "reference.film";
    if (folder.empty())
        return referenceFor(scene, seconds, {}, work.device, work.stop, work.progress);
    const auto origin = filmOrigin(scene, work.device, 1, 1);
    if (!origin)
        return origin.error();
    const auto before = keptFilm(*origin, scene.revision, file);
    auto film = referenceFor(scene, seconds, before, work.device, work.stop, work.progress);
    if (!film || (before && film->seconds <= before->seconds))
        return film;
    if (auto written = keepFilm(*film, *origin, file); !written)
        return written.error();
    return film;
}

/// Renders the reference, then each way in turn, in `seconds` of rendering time in all.
Result<AccuracyImage> measured(const std::string& name, const std::vector<AccuracyWay>& ways, double seconds,
                               const fs::path& folder, const Work& work) {
    const auto truth = reference(referenceScene(ways.front().scene), kReferenceShare * seconds, folder, work);
    if (!truth)
        return truth.error();
    AccuracyImage image{name, truth->film->samplesPerPixel()};
    if (const auto judgement = SmoothingJudgement::of(*truth->film))
        image.referenceError = judgement->overAll(work.display);
    // Give each way the same time: a crossing of two curves shows only in the time that both cover.
    const double each = (1 - kReferenceShare) * seconds / double(ways.size());
    for (std::size_t i = 0; i < ways.size() && !work.stop.stop_requested(); ++i) {
        const AccuracyPlan plan{each, work.display, folder, work.device.info().name};
        auto curves = measureAccuracy(ways[i], *truth->film, plan, work.device, work.stop, work.progress);
        if (!curves)
            return curves.error();
        std::ranges::move(*curves, std::back_inserter(image.curves));
    }
    return image;
}

Result<AccuracyReport> measured(const Scene& scene, const Work& work) {
    const DeviceInfo device = work.device.info();
    AccuracyReport report{.size = scene.film,
                          .model = modelName(scene.model),
                          .device = device.name,
                          .program = "PD-Render " PDR_VERSION,
                          .seed = scene.seed};
    auto own = measured("the scene", accuracyWays(scene, device.name), kSceneShare * work.options.seconds,
                        work.options.folder, work);
    if (!own)
        return own.error();
    report.scene = *std::move(own);
    const std::vector<AccuracyWay> others = otherImages(scene);
    for (const AccuracyWay& other : others) {
        if (work.stop.stop_requested())
            break;
        const double seconds = (1 - kSceneShare) * work.options.seconds / double(others.size());
        auto image = measured(other.name, {{"as it is", "", other.scene}}, seconds, {}, work);
        if (!image)
            return image.error();
        report.others.push_back(*std::move(image));
    }
    report.complete = !work.stop.stop_requested();
    return report;
}

Result<bool> report(const AccuracyOptions& options, const Interrupt& interrupt) {
    // Check that all outputs can be written before time is spent on rendering
    if (auto ok = makeFolder(options.folder); !ok)
        return ok.error();
    Paths outputs;
    for (const char* name : {"reference.film", "accuracy.csv", "accuracy.json", "accuracy.html", "accuracy.svg"})
        outputs.push_back(options.folder / name);
    if (auto ok = checkWritable(outputs); !ok)
        return ok.error();
    // Open the device and load the scene
    const auto opened = openDeviceToTheEnd(options.device, options.threads, tellOfCpu, tellOfPreparation);
    if (!opened)
        return opened.error();
    auto loaded = loadSceneShown(options.scene);
    if (!loaded)
        return loaded.error();
    if (auto room = roomForFilm(loaded->scene.film, (*opened)->info()); !room)
        return room.error();
    // Measure all ways
    ProgressLine line;
    const std::stop_token stop = interrupt.token();
    const auto found =
        measured(loaded->scene, {options, loaded->display, **opened, stop,
                                 [&](double fraction, const std::string& what) { line.show(fraction, what); }});
    line.finish();
    if (!found)
        return found.error();
    // Write the report
    for (const auto& [text, name] :
         {std::pair(csvText(*found), "accuracy.csv"), std::pair(jsonText(*found), "accuracy.json"),
          std::pair(pageText(*found, options.folder), "accuracy.html"),
          std::pair(plotText(found->scene), "accuracy.svg")})
        if (auto written = writeWhole(text, options.folder / name, FileAccess::owner); !written)
            return written.error();
    for (const AccuracyCurve& curve : found->scene.curves)
        std::printf("%s: %s\n", curve.name.c_str(), ladderText(curve).c_str());
    std::printf("%s\n", (options.folder / "accuracy.html").c_str());
    return found->complete;
}

}  // namespace

int runAccuracy(const QStringList& arguments) {
    const Interrupt interrupt;
    return runCommand("accuracy", accuracyOptions(arguments), accuracyHelp, [&](const AccuracyOptions& options) {
        try {
            const auto complete = report(options, interrupt);
            if (!complete)
                return failed(complete.error());
            if (!*complete)
                std::fprintf(stderr, "pdrender-cli: interrupted; the report holds what was measured until then.\n");
            return *complete ? 0 : 1;
        } catch (const std::bad_alloc&) {
            return failed(notEnoughMemory("", options.scene.path.string(), "Take a smaller --size or volume."));
        }
    });
}

}  // namespace pdr::app
