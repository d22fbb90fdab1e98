#include "app/picture_job.h"

#include <cmath>

#include "app/film_memory.h"
#include "app/picture_writing.h"
#include "render/base/errors.h"
#include "render/base/replacing_file.h"
#include "render/film/levels_text.h"
#include "render/session/batch_render.h"
#include "render/session/bias_measurements.h"
#include "ui/accuracy_text.h"
#include "ui/language.h"
#include "ui/to_qt.h"

namespace pdr::app {
namespace {

/// Of the time that the picture took, for what its bias is measured by.
constexpr double kBiasShare = 0.1;

Stops stopsOf(const StopRule& rule) {
    Stops stops;
    stops.levels = rule.levels;
    if (std::isfinite(rule.seconds))
        stops.seconds = rule.seconds;
    if (rule.samples > 0)
        stops.samples = rule.samples;
    return stops;
}

/// "making the picture: 80 samples in 25 s, within ±12 levels, 40 s left", as far as that is known.
std::string progressText(const BatchState& state) {
    QString text = PictureJob::tr("making the picture: %1 samples in %2")
                       .arg(state.film.samplesPerPixel)
                       .arg(ui::durationText(state.seconds));
    if (std::isfinite(state.film.displayError))
        text += PictureJob::tr(", within ±%1 levels").arg(ui::localNumber(levelsText(state.film.displayError)));
    if (state.secondsLeft)
        text += PictureJob::tr(", %1 left").arg(ui::durationText(*state.secondsLeft));
    return text.toStdString();
}

/// What can be known before hours are spent.
Result<void> checkBefore(const PictureTask& task) {
    if (auto named = checkPictureName(task.file); !named)
        return named;
    if (auto sound = task.scene.check(); !sound)
        return notSaved(task.file, sound.error());
    if (auto file = ReplacingFile::open(ui::fromQt(task.file), FileAccess::owner); !file)
        return file.error();
    return {};
}

Result<void> renderAndWrite(const PictureTask& task, Device& device, const Progress& progress,
                            const std::stop_token& stop) {
    const Scene& scene = task.scene;
    if (auto ok = device.upload(scene); !ok)
        return ok;
    if (auto fits = checkFilmFits(scene.film, device.info(), phrase("Choose a smaller size.")); !fits)
        return fits;
    const auto film = device.film(scene.film, scene.revision, scene.schedule);
    if (!film)
        return film.error();
    BatchRender batch(**film, stopsOf(task.stop), Display{task.display.exposure}, WhenStopped::discard);
    const auto made = batch.run(stop, [&](const BatchState& state) { progress(state.fraction, progressText(state)); });
    if (!made)
        return made.error();
    if (stop.stop_requested())
        return cancelled();
    const auto picture = (*film)->film();
    if (!picture)
        return picture.error();
    progress(1, PictureJob::tr("writing the picture").toStdString());
    // The device holds another scene then.
    const auto bias = measureBias(scene, double(task.display.exposure), device, kBiasShare * made->seconds, stop);
    if (!bias)
        return bias.error();
    const std::string name = device.info().name;
    return writePicture({**picture, scene, made->seconds, name, *bias, task.stop}, task.display, task.annotations,
                        task.file, stop);
}

Result<void> checkAndMake(const PictureTask& task, const Progress& progress, const std::stop_token& stop) {
    if (auto ready = checkBefore(task); !ready)
        return ready;
    progress(0, PictureJob::tr("making the picture").toStdString());
    const auto device = task.device();
    if (!device)
        return notSaved(task.file, device.error());
    auto written = renderAndWrite(task, **device, progress, stop);
    return written ? written : notSaved(task.file, written.error());
}

}  // namespace

void PictureJob::make(const PictureTask& task) {
    if (isRunning()) {
        emit failed(
            notSaved(task.file, {phrase("another picture is being made"), "", phrase("Wait for it, or cancel it.")}));
        return;
    }
    start([this, task](const Progress& progress, const std::stop_token& stop) -> std::function<void()> {
        if (auto made = checkAndMake(task, progress, stop); !made)
            return failure(made.error());
        return [this, file = task.file] { emit saved(file); };
    });
}

}  // namespace pdr::app
