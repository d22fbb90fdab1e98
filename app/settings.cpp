#include "app/settings.h"

namespace pdr::app {
namespace {

constexpr auto kGeometry = "window/geometry";
constexpr auto kState = "window/state";

QString ownFile() {
    return QSettings(QSettings::IniFormat, QSettings::UserScope, "pd-render", "pdrender").fileName();
}

}  // namespace

Settings::Settings(const QString& file) : store_(file.isEmpty() ? ownFile() : file, QSettings::IniFormat) {}

QByteArray Settings::windowGeometry() const {
    return store_.value(kGeometry).toByteArray();
}

QByteArray Settings::windowState() const {
    return store_.value(kState).toByteArray();
}

void Settings::keepWindow(const QByteArray& geometry, const QByteArray& state) {
    store_.setValue(kGeometry, geometry);
    store_.setValue(kState, state);
}

}  // namespace pdr::app
