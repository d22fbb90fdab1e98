#pragma once
/// Checks the results of workers: whether they answer the lease and report plausible faults, and whether an audit
/// confirms them.

#include <string>

#include "render/tiles/shared_request.h"

namespace pdr {

/// Returns why `result` cannot be that of `portion`; empty: it can. A sample has each fault once at most, and the first
/// one lies in the portion. `imageWidth`: pixels.
std::string whatIsImpossible(const LeaseResult& result, const Portion& portion, int imageWidth);

/// Whether `found`, another machine's result for the audit's samples, is what the worker claimed: the sums to the last
/// bit, and the faults. An audit of a part detects faults that were hidden, but not faults that were added outside of
/// the part.
bool confirms(const LeaseResult& found, const Audit& audit);

/// Whether both hold the same sums, to the last bit, and the same faults.
bool isSame(const LeaseResult& a, const LeaseResult& b);

/// Whether both report the same faults.
bool sameHealth(const Health& a, const Health& b);

}  // namespace pdr
