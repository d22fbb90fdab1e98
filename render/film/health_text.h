#pragma once
/// A picture's health in words.

#include <vector>

#include "render/base/health.h"
#include "render/base/text.h"

namespace pdr {

/// What one fault is, for the user: "samples left out: not a number".
const char* faultText(Fault fault);

/// One line for each fault that happened, most serious first: "3 samples left out: not a number". Empty: all is well.
std::vector<Text> healthLines(const Health& health);

}  // namespace pdr
