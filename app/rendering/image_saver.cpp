#include "app/rendering/image_saver.h"

#include <QPointer>

#include "app/output/image_writing.h"
#include "app/rendering/render_bridge.h"

namespace pdr::app {

void ImageSaver::save(const QString& file, const std::optional<ui::Annotations>& annotations) {
    if (auto named = checkImageName(file); !named) {
        emit failed(named.error());
        return;
    }
    if (!bridge_.lastFrame()) {
        emit failed(notSaved(file, {phrase("there is no image"), "", phrase("Wait until there is one.")}));
        return;
    }
    bridge_.lookAtImage(
        [self = QPointer(this), file, annotations, display = bridge_.display(),
         checks = bridge_.devices().nodeChecks()](const Result<FilmView>& view) -> std::function<void()> {
            Result<void> written =
                view ? writeImage(*view, display, annotations, file, checks()) : notSaved(file, view.error());
            return [self, file, written = std::move(written)] {
                if (self && written)
                    emit self->saved(file);
                else if (self)
                    emit self->failed(written.error());
            };
        });
}

}  // namespace pdr::app
