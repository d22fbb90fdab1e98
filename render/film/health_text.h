#pragma once
/// The health of an image in words.

#include <vector>

#include "render/base/health.h"
#include "render/base/text.h"

namespace pdr {

/// Returns a fault's description for the user: "samples left out: not a number".
const char* faultText(Fault fault);

/// Returns one line for each fault that happened, most serious first: "3 samples left out: not a number". Empty: there
/// was none.
std::vector<Text> healthLines(const Health& health);

}  // namespace pdr
