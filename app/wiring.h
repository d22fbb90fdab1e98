#pragma once
/// Every connection between the desktop's parts, in the order in which data flows.

#include "app/window_content.h"

namespace pdr::app {

/// The parts outlive the connections.
void wire(const DesktopParts& parts);

}  // namespace pdr::app
