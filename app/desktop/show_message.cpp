#include "app/desktop/show_message.h"

#include <algorithm>

#include "render/scene/edit/tissue_channels.h"

namespace pdr::app {
namespace {

/// Returns whether the boundary between air and skin stops light: its opacity exceeds a hundredth of the maximum.
bool showsSkin(const TransferFunction& function) {
    constexpr float kSkin[] = {-250, -200, -150, -100};  // [HU] of voxels that skin and air share, and of fat below
    const Curve opacity = curveOf(function, TissueChannel::opacity);
    const float most = heightOf(opacity);
    return std::ranges::any_of(kSkin, [&](float hu) { return valueAt(opacity, hu) > 0.01f * most; });
}

}  // namespace

void showFailure(const DesktopParts& parts, const Error& error) {
    parts.window.message().showError(error);
}

void showSaved(const DesktopParts& parts, const QString& file) {
    parts.window.status().showForAWhile(ui::MainWindow::tr("Saved as %1").arg(file));
    showWhoCanBeKnown(parts);
}

void showWhoCanBeKnown(const DesktopParts& parts) {
    if (parts.said.skin || !showsSkin(parts.document.setup().look.transferFunction))
        return;
    parts.said.skin = true;
    showNotice(parts, ui::MainWindow::tr("This image shows skin: share it like a photograph of the patient."));
}

void showNotice(const DesktopParts& parts, const QString& sentences) {
    parts.window.message().showNotice(sentences);
}

/// Repeats the message below each message of the import, until the series is loaded.
void showOthersLeftOut(const DesktopParts& parts) {
    auto* meanwhile = new QObject(&parts.window);
    const auto say = [parts] {
        parts.window.message().add(ui::MainWindow::tr("Only the first of the dropped folders is opened."));
    };
    const auto end = [meanwhile] { meanwhile->deleteLater(); };
    QObject::connect(&parts.import, &ImportJob::scanned, meanwhile, say);
    QObject::connect(&parts.import, &ImportJob::loaded, meanwhile, say);
    QObject::connect(&parts.import, &ImportJob::failed, meanwhile, say);
    QObject::connect(&parts.import, &ImportJob::loaded, meanwhile, end);
    QObject::connect(&parts.import, &ImportJob::failed, meanwhile, end);
    QObject::connect(&parts.import, &ImportJob::cancelled, meanwhile, end);
}

}  // namespace pdr::app
