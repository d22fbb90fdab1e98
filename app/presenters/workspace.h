#pragma once
/// What the window's features work on together.

#include "app/document/document.h"
#include "app/presenters/settings.h"
#include "app/rendering/render_bridge.h"
#include "ui/window/main_window.h"

namespace pdr::app {

/// References that all presenters share. Their owner outlives the presenters.
struct Workspace {
    Document& document;
    RenderBridge& bridge;
    ui::MainWindow& window;
    Settings& settings;
};

}  // namespace pdr::app
