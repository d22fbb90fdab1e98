#include "app/cli/render_command.h"

#include <cstdio>
#include <new>

#include "app/cli/batch_render.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress_line.h"
#include "app/cli/render_options.h"
#include "app/cli/render_report.h"
#include "app/cli/run_command.h"
#include "app/provenance.h"
#include "render/base/replacing_file.h"
#include "render/device/device_list.h"
#include "render/film/image_file.h"
#include "render/scene/flatten.h"

namespace pdr::app {
namespace {

/// Nobody should wait for a picture that cannot be written.
Result<void> checkOutputs(const RenderOptions& options) {
    for (const auto& path : options.outputs)
        if (auto file = ReplacingFile::open(path); !file)
            return file.error();
    return {};
}

Result<void> writeAll(const RenderOptions& options, const LoadedScene& work, const Film& film,
                      const BatchResult& result) {
    const Provenance facts = provenanceOf(work.scene, result.film, result.seconds);
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
    const auto opened = openDevice(options.device, options.threads);
    if (!opened)
        return opened.error();
    Device& device = **opened;
    ProgressLine line;
    const std::stop_token stop = interrupt.token();
    auto work = loadScene(options.scene, [&](double fraction, std::string_view step) {
        line.show(fraction, step);
        return !stop.stop_requested();
    });
    if (!work)
        return work.error();

    if (auto ok = device.upload(Flattener().prepare(work->scene, boundsFor(device.info()))); !ok)
        return ok.error();
    const auto film = device.film(work->scene.film, work->scene.revision, {});
    if (!film)
        return film.error();
    const auto result = BatchRender(**film, options.stops).run(stop, [&](const BatchState& state) { line.show(state); });
    line.finish();
    if (!result)
        return result.error();
    if (result->film.samplesPerPixel == 0)
        return Error{"ended before the first sample: nothing was written", "", ""};
    const auto picture = (*film)->film();
    if (!picture)
        return picture.error();
    if (auto ok = writeAll(options, *work, **picture, *result); !ok)
        return ok.error();
    const RenderReport report{options.outputs, work->scene.film, work->scene.seed,
                              device.info(),   *result,          warnings(work->scene)};
    std::fputs((options.json ? jsonText(report) : plainText(report)).c_str(), stdout);
    return result->reason;
}

}  // namespace

int runRender(const QStringList& arguments) {
    const Interrupt interrupt;
    return runCommand("render", renderOptions(arguments), renderHelp, [&](const RenderOptions& options) {
        try {
            const auto reason = renderAll(options, interrupt);
            if (!reason)
                return failed(reason.error());
            if (*reason != StopReason::interrupted)
                return 0;
            std::fprintf(stderr, "pdrender-cli: interrupted; the picture holds the samples taken until then.\n");
            return 1;
        } catch (const std::bad_alloc&) {
            return failed(
                {"there is not enough memory", options.scene.path.string(), "Take a smaller --size or volume."});
        }
    });
}

}  // namespace pdr::app
