#pragma once
/// What a worker's result is checked for, beside the bits of its sums: what it says of faults.

#include <string>

#include "render/tiles/shared_order.h"

namespace pdr {

/// Why `result` cannot be that of `portion`; empty: it can. A sample has each fault once at most, and the first one
/// lies in the portion. `imageWidth`: pixels.
std::string whatIsImpossible(const LeaseResult& result, const Portion& portion, int imageWidth);

/// Whether `truth`, the own device's result for the audit's samples, is what the worker claimed: the sums to the last
/// bit, and the faults. An audit of a part finds faults that were hidden, but none that were added outside of it.
bool confirms(const LeaseResult& truth, const Audit& audit);

bool sameHealth(const Health& a, const Health& b);

}  // namespace pdr
