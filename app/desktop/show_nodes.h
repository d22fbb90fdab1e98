#pragma once
/// What the window shows of render nodes, and what is kept of them.

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// Which there are, what each does, and where they bent the error's curve.
void showNodes(const DesktopParts& parts);
/// What was asked for.
void showWantedNodes(const DesktopParts& parts);
/// Asks for the nodes of the last time.
void wantNodesAgain(const DesktopParts& parts);
/// For the next time.
void keepNodes(const DesktopParts& parts);

}  // namespace pdr::app
