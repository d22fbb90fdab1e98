#include "app/picture_writing.h"

#include "app/provenance.h"
#include "render/film/picture_format.h"
#include "render/scene/scene.h"
#include "ui/accuracy_text.h"
#include "ui/to_qt.h"

namespace pdr::app {

Result<void> checkPictureName(const QString& file) {
    if (pictureFormat(ui::fromQt(file)))
        return {};
    return Error{phrase("the name says no format that pictures are saved in"), file.toStdString(),
                 phrase("Choose a name that ends in .png or .exr.")};
}

PaintOver painterOf(const std::optional<ui::Annotations>& annotations, const QString& state) {
    if (!annotations)
        return {};
    return [all = *annotations, state](ivec2 size, std::vector<std::uint8_t>& rgba) mutable {
        all.texts << state;
        ui::annotate(all, size, rgba);
    };
}

Result<void> writePicture(const FilmView& view, Display display, const std::optional<ui::Annotations>& annotations,
                          const QString& file, const std::stop_token& stop) {
    display.smoothed = display.smoothed && canBeSmoothed(view.scene);
    const Film& film = view.film;
    const Rendered rendered{film.status(display.exposure), display.exposure, view.seconds, view.device, view.bias};
    const Provenance provenance = provenanceOf(view.scene, rendered);
    const std::filesystem::path path = ui::fromQt(file);
    if (pictureFormat(path) == PictureFormat::exr)
        return writeExr(film, provenance, path, stop);
    SmoothedView own;
    SmoothedView& smoothed = view.denoised ? *view.denoised : own;  // so that the screen and the file say the same
    if (display.smoothed && smoothed.isStale(film.samplesPerPixel()))
        smoothed.judge(film, film.samplesPerPixel(), stop);
    const bool denoised = smoothed.better(display).smoothed;
    const ShownStatus shown = shownStatus(rendered.status, denoised, smoothed.error(display.exposure));
    const QString state = ui::previewText(shown, view.stop.levels);
    return writePng(film, display, smoothed, provenance, path, painterOf(annotations, state), stop);
}

Error notSaved(const QString& file, const Error& reason) {
    const Text what = reason.where.empty() ? reason.what : phrase("%1: %2", reason.where, reason.what);
    const Text hint = reason.hint.empty() ? phrase("Change that.") : Text::sentence(reason.hint);
    return {phrase("not saved, because %1", what), file.toStdString(), joined(hint, phrase("Then save again."))};
}

}  // namespace pdr::app
