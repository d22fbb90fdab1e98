#pragma once
/// An error in display levels as the user reads it.

#include "render/base/text.h"

namespace pdr {

/// Returns the levels as text, rounded up: "9", "2.4", "0.1" (and less). `levels`: finite.
Text levelsText(double levels);

}  // namespace pdr
