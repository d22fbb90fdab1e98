#include "app/cli/render_command.h"

#include <cstdio>
#include <new>

#include "app/cli/batch_render.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress_line.h"
#include "app/cli/render_options.h"
#include "app/cli/render_report.h"
#include "app/presets.h"
#include "app/scene_volume.h"
#include "render/base/replacing_file.h"
#include "render/device/device.h"
#include "render/film/image_file.h"
#include "render/scene/fit_view.h"
#include "render/scene/flatten.h"

namespace pdr::app {
namespace {

constexpr ivec2 kFolderFilm{1024, 1024};

/// A scene with its voxels, and how to show it.
struct Work {
    Scene scene;
    Display display;
};

int failed(const Error& error) {
    std::fprintf(stderr, "pdrender-cli: %s\n", error.text().c_str());
    return 1;
}

/// Nobody should wait for a picture that cannot be written.
Result<void> checkOutputs(const RenderOptions& options) {
    for (const auto& path : options.outputs)
        if (auto file = ReplacingFile::open(path); !file)
            return file.error();
    return {};
}

bool isFile(const RenderOptions& options) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(options.input, ignored);
}

/// What the input says, before the voxels are there.
Result<SceneFile> readInput(const RenderOptions& options) {
    SceneFile file;
    if (isFile(options) && options.input.extension() != ".json")
        return Error{"this is a file, but neither a folder nor a scene file (.json)", options.input.string(),
                     "Give the folder that holds the DICOM files."};
    if (isFile(options)) {
        auto read = readSceneFile(options.input);
        if (!read)
            return read.error();
        file = *std::move(read);
    } else {
        file.source.dicomFolder = options.input;
        file.scene.film = kFolderFilm;
    }
    if (!options.seriesUid.empty() && file.source.dicomFolder.empty())
        return Error{"--series chooses among the series of a DICOM folder, this scene has a raw file",
                     options.input.string(), "Leave it out."};
    if (!options.seriesUid.empty())
        file.source.seriesUid = options.seriesUid;
    file.scene.film = options.size.value_or(file.scene.film);
    file.scene.seed = options.seed.value_or(file.scene.seed);
    return file;
}

Camera cameraFrom(StandardView view, const Scene& scene) {
    const VolumeGeometry& geometry = scene.volume->geometry();
    const double aspect = double(scene.film.x) / double(scene.film.y);
    return fittedView(standardView(view, geometry.centreMm(), geometry.radiusMm(), aspect), geometry, aspect, 0.95);
}

/// The preset that was asked for; a folder, which has no look of its own, gets the first one.
Result<std::optional<Preset>> chosenPreset(const RenderOptions& options) {
    if (options.preset || isFile(options))
        return options.preset;
    auto presets = bundledPresets();
    if (!presets)
        return presets.error();
    return std::optional(presets->front());
}

Result<Work> loadWork(const RenderOptions& options, const Progress& progress) {
    auto file = readInput(options);
    if (!file)
        return file.error();
    const auto preset = chosenPreset(options);
    if (!preset)
        return preset.error();
    auto volume = fetchVolume(file->source, progress);
    if (!volume)
        return volume.error();

    Work work{std::move(file->scene), {}};
    work.scene.volume = *std::move(volume);
    if (options.view || !isFile(options))
        work.scene.camera = cameraFrom(options.view.value_or(StandardView::anterior), work.scene);
    if (*preset) {
        work.display = (*preset)->display;
        work.scene = withPreset(std::move(work.scene), **preset);
    }
    if (options.exposure)
        work.display.exposure = float(*options.exposure);
    return work;
}

Provenance provenance(const Scene& scene, const BatchResult& result) {
    return {result.film.samplesPerPixel,
            result.seconds,
            result.film.relativeError,
            result.film.rejectedSamples,
            scene.seed,
            modelName(scene.model),
            scene.transferFunction.extinctionPerMm,
            "PD-Render " PDR_VERSION};
}

Result<void> writeAll(const RenderOptions& options, const Work& work, const Film& film, const BatchResult& result) {
    const Provenance facts = provenance(work.scene, result);
    for (const auto& path : options.outputs) {
        const auto ok =
            path.extension() == ".png" ? writePng(film, work.display, facts, path) : writeExr(film, facts, path);
        if (!ok)
            return ok;
    }
    return {};
}

/// Everything between the options and the exit code.
Result<StopReason> renderAll(const RenderOptions& options, const Interrupt& interrupt) {
    if (auto ok = checkOutputs(options); !ok)
        return ok.error();
    ProgressLine line;
    const std::stop_token stop = interrupt.token();
    auto work = loadWork(options, [&](double fraction, std::string_view step) {
        line.show(fraction, step);
        return !stop.stop_requested();
    });
    if (!work)
        return work.error();
    if (auto ok = work->scene.check(); !ok)
        return ok.error();

    const auto device = makeCpuDevice(options.threads);
    if (auto ok = device->upload(Flattener().prepare(work->scene)); !ok)
        return ok.error();
    Film film(work->scene.film, work->scene.revision);
    const auto result =
        BatchRender(*device, film, options.stops).run(stop, [&](const BatchState& state) { line.show(state); });
    line.finish();
    if (!result)
        return result.error();
    if (film.samplesPerPixel() == 0)
        return Error{"ended before the first sample: nothing was written", "", ""};
    if (auto ok = writeAll(options, *work, film, *result); !ok)
        return ok.error();
    const RenderReport report{options.outputs, film.size(), work->scene.seed, device->info(), *result};
    std::fputs((options.json ? jsonText(report) : plainText(report)).c_str(), stdout);
    return result->reason;
}

}  // namespace

int runRender(const QStringList& arguments) {
    const Interrupt interrupt;
    const auto options = renderOptions(arguments);
    if (!options) {
        failed(options.error());
        std::fprintf(stderr, "\"pdrender-cli render --help\" lists all options.\n");
        return 2;
    }
    if (options->help) {
        std::fputs(renderHelp().c_str(), stdout);
        return 0;
    }
    try {
        const auto reason = renderAll(*options, interrupt);
        if (!reason)
            return failed(reason.error());
        if (*reason != StopReason::interrupted)
            return 0;
        std::fprintf(stderr, "pdrender-cli: interrupted; the picture holds the samples taken until then.\n");
        return 1;
    } catch (const std::bad_alloc&) {
        return failed({"there is not enough memory", options->input.string(), "Take a smaller --size or volume."});
    }
}

}  // namespace pdr::app
