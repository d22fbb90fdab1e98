#pragma once
/// Shows render nodes in the window, and saves and restores the requested ones.

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// Shows the nodes, what each does, and when they joined or left, in the error plot.
void showNodes(const DesktopParts& parts);
/// Shows the requested port, certificates and split.
void showWantedNodes(const DesktopParts& parts);
/// Requests the nodes, port, certificates and split of the last run.
void wantNodesAgain(const DesktopParts& parts);
/// Saves the requested nodes, port, certificates and split for the next run.
void keepNodes(const DesktopParts& parts);

}  // namespace pdr::app
