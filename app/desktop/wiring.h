#pragma once
/// Connects the desktop's parts, in the order in which data flows.

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// Makes all connections. The parts must outlive them.
void wire(const DesktopParts& parts);

}  // namespace pdr::app
