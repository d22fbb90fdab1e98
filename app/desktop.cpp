#include "app/desktop.h"

#include <utility>

#include "app/wiring.h"

namespace pdr::app {

Desktop::Desktop(std::vector<Preset> presets, std::unique_ptr<Device> device, const QString& settingsFile)
    : settings_(settingsFile), document_(std::move(presets)), bridge_(std::move(device)) {
    QStringList names;
    for (const Preset& preset : document_.presets())
        names << QString::fromStdString(preset.name);
    window_.look().setPresets(names);
    window_.resize(1360, 860);
    window_.restoreGeometry(settings_.windowGeometry());
    window_.restoreState(settings_.windowState());
    wire(parts());
    showNothing(parts());
}

Desktop::~Desktop() {
    settings_.keepWindow(window_.saveGeometry(), window_.saveState());
}

}  // namespace pdr::app
