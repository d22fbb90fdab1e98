#include "app/desktop/requests.h"

#include "app/desktop/annotating.h"
#include "app/desktop/ledger_content.h"
#include "app/document/background_colour.h"

namespace pdr::app {

void pickTissue(const DesktopParts& parts, QPointF place) {
    if (parts.document.hasVolume())
        parts.study.pick(parts.document.scene(), place);
}

void pickFocus(const DesktopParts& parts, QPointF place) {
    if (parts.document.hasVolume())
        parts.study.measureDepth(parts.document.scene(), place);
}

void setBackground(const DesktopParts& parts, const std::optional<QColor>& colour) {
    const Display display = parts.document.display();
    parts.document.setBackground(colour ? std::optional(radianceShownAs(*colour, display)) : std::nullopt);
}

void chooseModel(const DesktopParts& parts, Model model) {
    const Model before = parts.document.setup().model;
    parts.document.setModel(model);
    if (parts.document.hasVolume() && model != before)
        parts.modelTrial.measure(parts.document.scene(), before, parts.document.display());
}

void makePicture(const DesktopParts& parts, const ui::PictureOrder& order) {
    if (!parts.document.hasVolume() || !order.size)
        return;
    Scene scene = parts.document.scene();
    scene.film = {order.size->width(), order.size->height()};
    parts.picture.make({scene, parts.document.display(), leaving(annotationsOf(parts, scene), order.annotate),
                        order.stop, order.file, parts.bridge.finalRenderDevice()});
}

void savePicture(const DesktopParts& parts, const QString& file, ui::Annotate annotate) {
    const auto& frame = parts.bridge.lastFrame();
    parts.bridge.save(file, frame ? leaving(annotationsOf(parts, *frame), annotate) : std::nullopt);
}

void cancelWhatRuns(const DesktopParts& parts) {
    if (parts.import.isRunning())
        parts.import.cancel();
    else if (parts.masks.isRunning())
        parts.masks.cancel();
    else if (parts.sky.isRunning())
        parts.sky.cancel();
    else
        parts.picture.cancel();
}

void keepOrFitFilm(const DesktopParts& parts) {
    const QSize view = parts.window.viewport().sizeInPixels();
    const auto& frame = parts.bridge.lastFrame();
    if (frame && !frame->coarse)
        parts.document.setNextFilm({view.width(), view.height()});
    else
        parts.document.setViewSize({view.width(), view.height()});
}

void fitFilm(const DesktopParts& parts) {
    const QSize view = parts.window.viewport().sizeInPixels();
    parts.document.setViewSize({view.width(), view.height()});
}

void leaveOutUnseen(const DesktopParts& parts) {
    if (const auto& ledger = parts.bridge.lastLedger(); ledger && parts.document.hasVolume())
        parts.document.setSetup(leanSetup(parts.document, *ledger).setup);
}

}  // namespace pdr::app
