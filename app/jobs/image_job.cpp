#include "app/jobs/image_job.h"

#include <cmath>

#include "app/output/film_memory.h"
#include "app/output/final_image.h"
#include "app/output/image_writing.h"
#include "render/film/levels_text.h"
#include "ui/annotation/image_painter.h"
#include "ui/text/accuracy_text.h"
#include "ui/text/language.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

Stops stopsOf(const StopRule& rule) {
    Stops stops;
    stops.levels = rule.levels;
    if (std::isfinite(rule.seconds))
        stops.seconds = rule.seconds;
    if (rule.samples > 0)
        stops.samples = rule.samples;
    return stops;
}

/// Returns the progress as far as it is known: "rendering the image: 80 samples in 25 s, within ±12 levels, 40 s left".
std::string progressText(const BatchState& state) {
    QString text = ImageJob::tr("rendering the image: %1 samples in %2")
                       .arg(std::llround(state.film.meanSamplesPerPixel))
                       .arg(ui::durationText(state.seconds));
    if (std::isfinite(state.film.displayError))
        text += ImageJob::tr(", within ±%1 levels").arg(ui::localNumber(levelsText(state.film.displayError)));
    if (state.secondsLeft)
        text += ImageJob::tr(", %1 left").arg(ui::durationText(*state.secondsLeft));
    return text.toStdString();
}

/// Checks the file name, the scene and that the file can be written, before hours are spent on rendering.
Result<void> checkBefore(const ImageTask& task) {
    if (auto named = checkImageName(task.file); !named)
        return named;
    if (auto sound = task.scene.check(); !sound)
        return notSaved(task.file, sound.error());
    return checkWritable({ui::fromQt(task.file)});
}

FinalOrder orderOf(const ImageTask& task) {
    return {task.scene,
            task.display,
            stopsOf(task.stop),
            WhenStopped::discard,
            {ui::fromQt(task.file)},
            ui::imagePainter(task.annotations, task.stop.levels)};
}

FinalSteps stepsOf(const ImageTask& task, const Device& device, const Progress& progress) {
    return {[&] { return checkFilmFits(task.scene.film, device.info(), phrase("Choose a smaller size.")); },
            [&](const BatchState& state) { progress(state.fraction, progressText(state)); },
            [&] {
                progress(1, ImageJob::tr("writing the image").toStdString());
                return task.checks ? task.checks() : NodeChecks();
            }};
}

/// Returns the error of an image that was rendered, if any.
Result<void> troubleOf(const FinalImage& image, const QString& file) {
    if (image.written.files.empty())
        return notSaved(file, image.written.troubles.front());
    if (!image.written.troubles.empty())
        return image.written.troubles.front();
    if (image.biasUnknown)
        return Error{phrase("saved, but its bias could not be measured: %1", image.biasUnknown->what),
                     file.toStdString(), image.biasUnknown->hint};
    return {};
}

Result<void> checkAndMake(const ImageTask& task, const Progress& progress, const std::stop_token& stop) {
    if (auto ready = checkBefore(task); !ready)
        return ready;
    progress(0, ImageJob::tr("rendering the image").toStdString());
    const auto device = task.device();
    if (!device)
        return notSaved(task.file, device.error());
    const auto image = renderFinal(orderOf(task), **device, stepsOf(task, **device, progress), stop);
    return image ? troubleOf(*image, task.file) : notSaved(task.file, image.error());
}

}  // namespace

void ImageJob::make(const ImageTask& task) {
    if (isRunning()) {
        emit failed(
            notSaved(task.file, {phrase("another image is being rendered"), "", phrase("Wait for it, or cancel it.")}));
        return;
    }
    start([this, task](const Progress& progress, const std::stop_token& stop) -> std::function<void()> {
        if (auto made = checkAndMake(task, progress, stop); !made)
            return failure(made.error());
        return [this, file = task.file] { emit saved(file); };
    });
}

}  // namespace pdr::app
