#pragma once
/// Every connection between the desktop's parts, in the order in which data flows.

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// The parts outlive the connections.
void wire(const DesktopParts& parts);

}  // namespace pdr::app
