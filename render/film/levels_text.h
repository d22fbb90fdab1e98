#pragma once
/// An error in display levels as people are told it.

#include <string>

namespace pdr {

/// Rounded up: "9", "2.4", "0.1" (and less). `levels`: finite.
std::string levelsText(double levels);

}  // namespace pdr
