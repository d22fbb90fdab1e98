#pragma once
/// An error in display levels as people are told it.

#include "render/base/text.h"

namespace pdr {

/// Rounded up: "9", "2.4", "0.1" (and less). `levels`: finite.
Text levelsText(double levels);

}  // namespace pdr
