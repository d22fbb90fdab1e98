#include "app/show_message.h"

namespace pdr::app {

void showFailure(const DesktopParts& parts, const Error& error) {
    parts.window.message().showError(error);
}

void showSaved(const DesktopParts& parts, const QString& file) {
    parts.window.status().showForAWhile(ui::MainWindow::tr("saved as %1").arg(file));
}

void showNotice(const DesktopParts& parts, const QString& sentences) {
    parts.window.message().showError({sentences.toStdString(), "", ""});
}

}  // namespace pdr::app
