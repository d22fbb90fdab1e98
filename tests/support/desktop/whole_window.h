#pragma once
/// The window with all its panels, without a volume: nothing is rendered.

#include <QTemporaryDir>

#include "app/desktop/desktop.h"
#include "app/looks/looks.h"
#include "render/device/device_list.h"
#include "tests/support/desktop/the.h"

namespace pdr::test {

struct WholeWindow {
    QTemporaryDir folder;  ///< for the settings
    app::Desktop desktop{*app::bundledLooks(), makeCpuDevice(1), folder.filePath("settings.ini"), 1};
    ui::MainWindow& window = desktop.window();
};

}  // namespace pdr::test
