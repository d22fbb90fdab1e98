#pragma once
/// The order of blocks in which lanes that have parted meet again as early as they can.

#include <vector>

#include "tests/ptx/code/program.h"

namespace pdr::ptx {

/// Returns the reachable blocks so that all of a loop comes before what is behind it, and either side of a branch
/// before where the sides join: the reverse postorder of a search that leaves loops first.
std::vector<u32> meetingOrder(const std::vector<Block>& blocks);

}  // namespace pdr::ptx
