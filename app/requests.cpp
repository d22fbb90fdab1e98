#include "app/requests.h"

#include "app/ledger_content.h"

namespace pdr::app {

void pickTissue(const DesktopParts& parts, QPointF place) {
    if (parts.document.hasVolume())
        parts.study.pick(parts.document.scene(), place);
}

void makePicture(const DesktopParts& parts, const ui::PictureOrder& order) {
    if (!parts.document.hasVolume() || !order.size)
        return;
    Scene scene = parts.document.scene();
    scene.film = {order.size->width(), order.size->height()};
    parts.picture.make({scene, parts.document.display(), parts.bridge.captioned(), order.stop, order.file,
                        parts.bridge.anotherDevice()});
}

void cancelWhatRuns(const DesktopParts& parts) {
    if (parts.import.isRunning())
        parts.import.cancel();
    else if (parts.masks.isRunning())
        parts.masks.cancel();
    else
        parts.picture.cancel();
}

void leaveOutUnseen(const DesktopParts& parts) {
    if (const auto& ledger = parts.bridge.lastLedger(); ledger && parts.document.hasVolume())
        parts.document.setSetup(leanSetup(parts.document, *ledger).setup);
}

}  // namespace pdr::app
