#include "app/output/image_writing.h"

#include "app/output/image_files.h"
#include "app/output/judged_image.h"
#include "render/film/file/image_format.h"
#include "ui/annotation/image_painter.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

Result<void> checkImageName(const QString& file) {
    if (imageFormat(ui::fromQt(file)))
        return {};
    return Error{phrase("the name says no format that images are saved in"), file.toStdString(),
                 phrase("Choose a name that ends in .png or .exr.")};
}

Result<void> writeImage(const FilmView& view, Display display, const std::optional<ui::Annotations>& annotations,
                        const QString& file, const NodeChecks& checks, const std::stop_token& stop) {
    const std::filesystem::path path = ui::fromQt(file);
    display.denoised = display.denoised && anyPng({path});
    const Rendered rendered{view.film.status(display), display, view.seconds, view.device, view.bias, checks};
    JudgedImage image(view.film, view.scene, display, rendered, stop, view.denoised);
    return image.write(path, ui::imagePainter(annotations, view.stop.levels)(image.shown()), stop);
}

Error notSaved(const QString& file, const Error& reason) {
    const Text what = reason.where.empty() ? reason.what : phrase("%1: %2", reason.where, reason.what);
    const Text hint = reason.hint.empty() ? phrase("Change that.") : Text::sentence(reason.hint);
    return {phrase("not saved, because %1", what), file.toStdString(), joined(hint, phrase("Then save again."))};
}

}  // namespace pdr::app
