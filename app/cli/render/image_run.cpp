#include "app/cli/render/image_run.h"

#include <cstdio>
#include <new>
#include <optional>
#include <utility>

#include "app/cli/failed.h"
#include "app/cli/prepared_work.h"
#include "app/cli/progress_line.h"
#include "app/cli/render/annotating.h"
#include "app/cli/render/film_room.h"
#include "app/output/final_image.h"
#include "render/accuracy/quality.h"
#include "render/base/errors.h"
#include "ui/annotation/image_painter.h"

namespace pdr::app {
namespace {

struct Finished {
    StopReason reason;
    FilmStatus film;
    bool allInPlace;  ///< true: every image was written to its path
};

ui::Annotate annotateOf(const RenderOptions& options) {
    return anyPng(options.outputs) ? options.annotate : ui::Annotate::none;
}

FinalOrder orderOf(const RenderOptions& options, const LoadedScene& work, std::optional<ui::Annotations> annotations) {
    return {work.scene, work.display.withDenoised(options.denoised), options.stops, WhenStopped::keep, options.outputs,
            // Mark the image as a preview until it meets the requested error, or the one for planning.
            ui::imagePainter(std::move(annotations), options.stops.levels.value_or(kPlanningLevels))};
}

/// Returns the callbacks of the render. Before the first sample, memory is checked and nodes are awaited; after the
/// last, what the nodes have done is reported.
FinalSteps stepsOf(const LoadedScene& work, const Device& device, CommandNodes* crew, ProgressLine& line,
                   const std::stop_token& stop) {
    return {[&work, &device, crew, stop]() -> Result<void> {
                if (auto room = roomForFilm(work.scene.film, device.info()); !room)
                    return room;
                return crew ? crew->await(stop) : Result<void>();
            },
            [&line](const BatchState& state) { line.show(state); },
            [&line, crew] {
                line.finish();
                if (!crew)
                    return NodeChecks();
                std::fputs(crew->report().c_str(), stderr);
                return crew->checks();
            }};
}

/// Returns that the samples are uneven, if they are.
std::string unevenText(const FilmStatus& film) {
    if (film.mostSamplesPerPixel <= film.samplesPerPixel)
        return {};
    return ", in finished tiles more than in others: " + std::to_string(film.samplesPerPixel) + " to " +
           std::to_string(film.mostSamplesPerPixel) + " in a pixel";
}

/// Writes to standard error what the report does not contain: notes and files that could not be written.
void tellTroubles(const FinalImage& image) {
    if (image.denoisingNote)
        std::fprintf(stderr, "note: %s\n", image.denoisingNote);
    for (const Error& trouble : image.written.troubles)
        failed(trouble);
}

/// Does everything between the options and the exit code.
Result<Finished> renderAll(const RenderOptions& options, const ImageRun& run, const Interrupt& interrupt) {
    if (auto ok = checkFonts(annotateOf(options)); !ok)
        return ok.error();
    ProgressLine line;
    const std::stop_token stop = interrupt.token();
    const auto prepared = prepareWork(options, run.load, line, stop);
    if (!prepared)
        return prepared.error();
    const LoadedScene& work = prepared->loaded;
    Device& device = *prepared->device;
    auto annotations = annotationsOf(work, annotateOf(options));
    if (!annotations)
        return annotations.error();
    FinalOrder order = orderOf(options, work, *std::move(annotations));
    if (run.taken) {
        auto taken = run.taken(work, device);
        if (!taken)
            return taken.error();
        order.taken = *std::move(taken);
    }

    // Render, write the images and print the report
    const auto image = renderFinal(order, device, stepsOf(work, device, prepared->crew.get(), line, stop), stop);
    line.finish();
    if (!image)
        return image.error();
    tellTroubles(*image);
    if (image->biasUnknown)
        return *image->biasUnknown;
    run.say({image->written.files, work.scene.film, work.scene.seed, device.info(), image->result, warnings(work.scene),
             image->biases, image->checks});
    return Finished{image->result.reason, image->result.film, image->written.troubles.empty()};
}

}  // namespace

int renderImages(const RenderOptions& options, const ImageRun& run, const Interrupt& interrupt) {
    try {
        const auto finished = renderAll(options, run, interrupt);
        if (!finished)
            return failed(finished.error());
        if (finished->reason == StopReason::interrupted)
            std::fprintf(stderr, "pdrender-cli: interrupted; the image holds the samples taken until then%s.\n",
                         unevenText(finished->film).c_str());
        return finished->reason != StopReason::interrupted && finished->allInPlace ? 0 : 1;
    } catch (const std::bad_alloc&) {
        return failed(notEnoughMemory("", options.scene.path.string(), "Take a smaller --size or volume."));
    }
}

}  // namespace pdr::app
