#include "app/cli/accuracy_command.h"

#include <cstdio>
#include <fstream>
#include <new>

#include "app/cli/accuracy/accuracy_page.h"
#include "app/cli/film_room.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress_line.h"
#include "app/cli/render_options.h"
#include "app/cli/run_command.h"
#include "render/base/errors.h"
#include "render/base/replacing_file.h"
#include "render/base/version.h"
#include "render/device/device_list.h"

namespace pdr::app {
namespace {

namespace fs = std::filesystem;

/// Of the time, for the picture that all others are compared with: half of its error is then about that of the best.
constexpr double kReferenceShare = 0.6;

Result<void> makeFolder(const fs::path& folder) {
    std::error_code trouble;
    fs::create_directories(folder, trouble);
    if (trouble || !fs::is_directory(folder, trouble))
        return Error{"this folder cannot be made", folder.string(), "Name one with -o that can be written to."};
    return {};
}

Result<void> writeText(const std::string& text, const fs::path& path) {
    auto file = ReplacingFile::open(path, FileAccess::owner);
    if (!file)
        return file.error();
    file->write(text.data(), text.size());
    return file->commit();
}

/// Renders the reference, then each way in turn.
Result<AccuracyReport> measured(const AccuracyOptions& options, const LoadedScene& loaded, Device& device,
                                const std::stop_token& stop, ProgressLine& line) {
    const auto progress = [&](double fraction, const std::string& what) { line.show(fraction, what); };
    const Scene& scene = loaded.scene;
    const auto reference = referenceFor(scene, kReferenceShare * options.seconds, device, stop, progress);
    if (!reference)
        return reference.error();
    AccuracyReport report{scene.film,
                          modelName(scene.model),
                          device.info().name,
                          "PD-Render " PDR_VERSION,
                          scene.seed,
                          (*reference)->samplesPerPixel(),
                          {},
                          {},
                          true};
    if (const auto judgement = SmoothingJudgement::of(**reference))
        report.referenceError = judgement->overAll(loaded.display.exposure);
    const std::vector<AccuracyWay> ways = accuracyWays(scene);
    const AccuracyPlan plan{(1 - kReferenceShare) * options.seconds / double(ways.size()), loaded.display,
                            options.folder};
    for (const AccuracyWay& way : ways) {
        if (stop.stop_requested())
            break;
        auto curves = measureAccuracy(way, **reference, plan, device, stop, progress);
        if (!curves)
            return curves.error();
        for (AccuracyCurve& curve : *curves)
            report.curves.push_back(std::move(curve));
    }
    report.complete = !stop.stop_requested();
    line.finish();
    return report;
}

Result<bool> report(const AccuracyOptions& options, const Interrupt& interrupt) {
    if (auto ok = makeFolder(options.folder); !ok)
        return ok.error();
    const auto opened = openDevice(options.device, options.threads);
    if (!opened)
        return opened.error();
    auto loaded = loadSceneShown(options.scene);
    if (!loaded)
        return loaded.error();
    if (auto room = roomForFilm(loaded->scene.film, (*opened)->info()); !room)
        return room.error();
    ProgressLine line;
    const auto found = measured(options, *loaded, **opened, interrupt.token(), line);
    if (!found)
        return found.error();
    for (const auto& [text, name] :
         {std::pair(csvText(*found), "accuracy.csv"), std::pair(jsonText(*found), "accuracy.json"),
          std::pair(pageText(*found, options.folder), "accuracy.html")})
        if (auto written = writeText(text, options.folder / name); !written)
            return written.error();
    for (const AccuracyCurve& curve : found->curves)
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
