#include "app/desktop/desktop.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QScreen>
#include <QStyle>
#include <algorithm>
#include <utility>

#include "app/desktop/keep_looks.h"
#include "app/desktop/show_nodes.h"
#include "app/desktop/show_scan.h"
#include "app/desktop/wiring.h"
#include "render/device/device_list.h"
#include "ui/text/status_text.h"

namespace pdr::app {

namespace {

/// Fills the list of devices with those of this machine and the one in use, which may be none of them.
void offerDevices(ui::RenderPanel& panel, const DeviceInfo& inUse) {
    std::vector<DeviceInfo> devices = devicesHere();
    const auto known = std::find_if(devices.begin(), devices.end(),
                                    [&](const DeviceInfo& device) { return device.name == inUse.name; });
    if (known != devices.end())
        *known = inUse;
    else
        devices.push_back(inUse);
    QStringList names, texts;
    for (const DeviceInfo& device : devices) {
        names << QString::fromStdString(device.name);
        texts << ui::deviceText(names.back(), QString::fromStdString(device.details));
    }
    panel.setDevices(names, texts);
    panel.setDevice(QString::fromStdString(inUse.name));
}

/// Returns the folder of the example scan, which `bootstrap run` writes beside the programs that it builds; empty if
/// there is none.
QString exampleFolder() {
    const QDir programs(QCoreApplication::applicationDirPath());
    for (const char* name : {"cranium", "phantom"})
        if (QString folder = QDir::cleanPath(programs.filePath(QString("../../example/") + name));
            QDir(folder).exists())
            return folder;
    return {};
}

/// Shrinks and moves `window` so that it fits its screen: saved geometry may be damaged, or from a larger screen.
void holdOnScreen(QWidget& window) {
    const QRect room = window.screen()->availableGeometry();
    const bool isLarge = window.isMaximized() || window.isFullScreen();
    const QRect kept = isLarge ? window.normalGeometry() : window.geometry();
    const QSize size = kept.size().boundedTo(room.size());
    if (size == kept.size() && room.intersects(kept))
        return;
    const Qt::WindowStates states = window.windowState();
    window.setWindowState(Qt::WindowNoState);
    window.setGeometry(QStyle::alignedRect(Qt::LeftToRight, Qt::AlignCenter, size, room));
    window.setWindowState(states);
}

}  // namespace

Desktop::Desktop(std::vector<NamedLook> looks, std::unique_ptr<Device> device, const QString& settingsFile, int threads,
                 std::filesystem::path powerSupplies)
    : settings_(settingsFile),
      document_(std::move(looks)),
      bridge_(std::move(device), threads),
      ownLooks_(settingsFile.isEmpty() ? OwnLooks::usualFolder() : QFileInfo(settingsFile).path() + "/looks"),
      battery_(bridge_, std::move(powerSupplies)) {
    // Restore the settings
    offerDevices(window_.rendering(), bridge_.firstDevice());
    window_.rendering().setPace(settings_.pace());
    bridge_.setPace(window_.rendering().pace());
    window_.setCaptioned(settings_.captioned());
    bridge_.setCaptioned(settings_.captioned());
    window_.setLanguage(settings_.language());
    window_.setTheme(settings_.theme());
    window_.setKeys(settings_.keys());
    // Place the window
    window_.resize(QSize(1480, 920).boundedTo(window_.screen()->availableSize() * 0.95));
    window_.restoreGeometry(settings_.windowGeometry());
    window_.restoreState(settings_.windowState());
    holdOnScreen(window_);
    // Connect the parts and show the start page
    wire(parts());
    offerOwnLooks(parts());
    bridge_.setTarget(settings_.target());
    showNothing(parts());
    showRecentFolders(parts());
    window_.setExample(exampleFolder());
    wantNodesAgain(parts());
}

Desktop::~Desktop() {
    settings_.keepWindow(window_.saveGeometry(), window_.wantedState());
}

}  // namespace pdr::app
