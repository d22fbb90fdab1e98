#include "app/desktop/show_document.h"

#include "app/desktop/ledger_content.h"
#include "app/desktop/look_text.h"
#include "app/document/background_colour.h"
#include "ui/text/room_text.h"

namespace pdr::app {
namespace {

/// Returns the background's colour on the screen; none if the environment is visible.
std::optional<QColor> backgroundOf(const Document& document) {
    const PictureSetup& setup = document.setup();
    if (!setup.background && setup.look.environment.visible)
        return std::nullopt;
    return shownColour(setup.background.value_or(vec3(0)), document.display());
}

/// Returns what the mask hides, in sentences, or that the mask of the chosen part is still being made.
QString notShownText(const Scene& scene) {
    if (scene.maskAwaited)
        return ui::MainWindow::tr("Still being separated; everything is shown until then.");
    return scene.mask ? ui::inWords(scene.mask->hidden()) : QString();
}

}  // namespace

void showDocument(const DesktopParts& parts) {
    const Document& document = parts.document;
    const auto camera = document.hasVolume() ? std::optional(document.setup().camera) : std::nullopt;
    parts.window.viewport().setCamera(camera);
    if (document.setup().table == Table::shown)
        parts.window.message().withdraw();
    parts.window.setTable(document.setup().table == Table::shown, document.hasTable());
    parts.window.look().setLook(document.look());
    parts.window.look().setDoesNotShow(doesNotShowText(document.looks(), document.setup()));
    parts.window.look().setBrightness(document.setup().stops);
    parts.window.visible().setChoice(document.setup().look.visible);
    parts.window.visible().setNotShown(notShownText(document.scene()));
    parts.window.tissue().setTransferFunction(document.setup().look.transferFunction);
    parts.window.cut().setCuts(document.setup().clip, document.uncut());
    parts.window.light().setLighting(parts.light.lighting(), document.setup().camera);
    parts.window.camera().setEnabled(document.hasVolume());
    parts.window.camera().setCamera(document.setup().camera);
    parts.window.camera().setBackground(backgroundOf(document));
    parts.window.light().model().setModel(document.setup().model);
    parts.window.rendering().setEstimator(document.setup().estimator);
    parts.window.rendering().setSchedule(document.setup().schedule);
    parts.window.setSmoothed(document.smoothed());
    parts.window.setUndoAvailable(document.canUndo(), document.canRedo());
    parts.window.setVolumeAvailable(document.hasVolume());
    parts.window.setUndoTexts(undoText(document.undoable()), redoText(document.redoable()));
}

void showEffects(const DesktopParts& parts) {
    const auto& ledger = parts.bridge.lastLedger();
    if (!ledger || !parts.document.hasVolume())
        return parts.window.effects().setRows({});
    parts.window.effects().setRows(effectRows(*ledger, leanSetup(parts.document, *ledger).leftOut));
}

}  // namespace pdr::app
