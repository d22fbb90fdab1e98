#include "app/cli/render_command.h"

#include <algorithm>
#include <cstdio>
#include <new>

#include "app/cli/annotating.h"
#include "app/cli/film_room.h"
#include "app/cli/picture_files.h"
#include "app/cli/progress_line.h"
#include "app/cli/render_options.h"
#include "app/cli/render_report.h"
#include "app/cli/run_command.h"
#include "app/program/interrupt.h"
#include "app/provenance.h"
#include "render/accuracy/quality.h"
#include "render/base/errors.h"
#include "render/device/device_list.h"
#include "render/film/picture_format.h"
#include "render/film/smoothed_view.h"
#include "render/prepare/flatten.h"
#include "render/session/batch_render.h"
#include "render/session/bias_measurements.h"
#include "ui/accuracy_text.h"

namespace pdr::app {
namespace {

struct Finished {
    StopReason reason;
    bool allInPlace;  ///< every picture is where it was asked for
};

/// Of the time that the picture took, for what its bias is measured by.
constexpr double kBiasShare = 0.1;

bool writesPng(const RenderOptions& options) {
    return std::ranges::any_of(options.outputs,
                               [](const auto& path) { return pictureFormat(path) == PictureFormat::png; });
}

bool wantsSmoothed(const RenderOptions& options, const Scene& scene) {
    return options.smoothed && canBeSmoothed(scene) && writesPng(options);
}

ui::Annotate annotateOf(const RenderOptions& options) {
    return writesPng(options) ? options.annotate : ui::Annotate::none;
}

/// What paints over PNG files; the picture is a preview until it is as good as was asked for, or for planning.
PaintOver painterOf(std::optional<ui::Annotations> annotations, const Stops& stops, const ShownStatus& shown) {
    if (!annotations)
        return {};
    annotations->texts << ui::previewText(shown, stops.levels.value_or(kPlanningLevels));
    return
        [all = *std::move(annotations)](ivec2 size, std::vector<std::uint8_t>& rgba) { ui::annotate(all, size, rgba); };
}

/// Where the files are not what `--smoothed` promises, or it is not known that they are better; null: nothing is to be
/// said.
const char* denoisingNote(const RenderOptions& options, const Scene& scene, SmoothedView& view, const Display& wanted) {
    if (!options.smoothed)
        return nullptr;
    if (!canBeSmoothed(scene))
        return "the image is not denoised: this model has no noise but at the pixels' edges.";
    if (!wanted.smoothed)
        return "nothing is denoised: OpenEXR files hold the film as it is.";
    if (!view.better(wanted).smoothed)
        return "the image is not denoised, since it is not known to be better for it.";
    return view.error(double(wanted.exposure)) ? nullptr
                                               : "how far the denoised image is off is not known: too few samples, too "
                                                 "little tissue, or light that few samples have found.";
}

/// Of the pictures as they are written.
std::vector<Bias> biasesOf(const LoadedScene& work, const Rendered& rendered, SmoothedView& view, bool smoothed) {
    BiasFacts facts = biasFactsOf(work.scene, rendered);
    facts.isSmoothed = smoothed;
    if (smoothed)
        facts.smoothed = view.error(rendered.exposure);
    return biases(facts);
}

/// Everything between the options and the exit code.
Result<Finished> renderAll(const RenderOptions& options, const Interrupt& interrupt) {
    if (auto ok = checkWritable(options.outputs); !ok)
        return ok.error();
    if (auto ok = checkFonts(annotateOf(options)); !ok)
        return ok.error();
    auto opened = openDeviceToTheEnd(options.device, options.threads, tellOfCpu);
    if (!opened)
        return opened.error();
    std::unique_ptr<NodeCrew> crew;
    if (options.nodes.any()) {
        auto gathered = NodeCrew::gather(options.nodes, *opened);
        if (!gathered)
            return gathered.error();
        crew = *std::move(gathered);
    }
    Device& device = **opened;
    ProgressLine line;
    const std::stop_token stop = interrupt.token();
    auto work = loadScene(options.scene, [&](double fraction, std::string_view step) {
        line.show(fraction, step);
        return !stop.stop_requested();
    });
    if (!work)
        return work.error();
    line.finish();
    tellNotes(*work);
    if (auto ok = checkSpared(work->files, options.outputs); !ok)
        return ok.error();

    auto annotations = annotationsOf(*work, annotateOf(options));
    if (!annotations)
        return annotations.error();
    if (auto ok = device.upload(work->scene); !ok)
        return ok.error();
    if (auto room = roomForFilm(work->scene.film, device.info()); !room)
        return room.error();
    if (crew)
        if (auto ready = crew->await(stop); !ready)
            return ready.error();
    const auto film = device.film(work->scene.film, work->scene.revision, work->scene.schedule);
    if (!film)
        return film.error();
    const auto result =
        BatchRender(**film, options.stops, work->display).run(stop, [&](const BatchState& state) { line.show(state); });
    line.finish();
    if (!result)
        return result.error();
    if (crew)
        std::fputs(crew->report().c_str(), stderr);
    if (result->film.samplesPerPixel == 0)
        return Error{"ended before the first sample: nothing was written", "", ""};
    const auto picture = (*film)->film();
    if (!picture)
        return picture.error();
    const Display display{work->display.exposure, wantsSmoothed(options, work->scene)};
    SmoothedView view;
    if (display.smoothed)
        view.judge(**picture, (*picture)->samplesPerPixel(), {});
    const bool smoothed = view.better(display).smoothed;
    if (const char* note = denoisingNote(options, work->scene, view, display))
        std::fprintf(stderr, "note: %s\n", note);
    // The device holds another scene then.
    const auto measured =
        measureBias(work->scene, double(display.exposure), device, kBiasShare * result->seconds, stop);
    Rendered rendered{result->film, display.exposure, result->seconds, device.info().name, {}};
    if (measured)
        rendered.bias = *measured;
    const WrittenFiles written =
        writePictures(**picture, display, view, provenanceOf(work->scene, rendered),
                      painterOf(*std::move(annotations), options.stops,
                                shownStatus(result->film, smoothed, view.error(double(display.exposure)))),
                      options.outputs);
    for (const Error& trouble : written.troubles)
        failed(trouble);
    if (!measured)
        return measured.error();
    const RenderReport report{written.files,
                              work->scene.film,
                              work->scene.seed,
                              device.info(),
                              *result,
                              warnings(work->scene),
                              biasesOf(*work, rendered, view, smoothed)};
    std::fputs((options.json ? jsonText(report) : plainText(report)).c_str(), stdout);
    return Finished{result->reason, written.troubles.empty()};
}

}  // namespace

int runRender(const QStringList& arguments) {
    const Interrupt interrupt;
    return runCommand("render", renderOptions(arguments), renderHelp, [&](const RenderOptions& options) {
        try {
            const auto finished = renderAll(options, interrupt);
            if (!finished)
                return failed(finished.error());
            if (finished->reason == StopReason::interrupted)
                std::fprintf(stderr, "pdrender-cli: interrupted; the picture holds the samples taken until then.\n");
            return finished->reason != StopReason::interrupted && finished->allInPlace ? 0 : 1;
        } catch (const std::bad_alloc&) {
            return failed(notEnoughMemory("", options.scene.path.string(), "Take a smaller --size or volume."));
        }
    });
}

}  // namespace pdr::app
