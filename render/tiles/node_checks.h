#pragma once
/// How many samples of workers were rendered a second time, and what that would have caught.

#include <cmath>
#include <cstdint>

#include "render/base/text.h"

namespace pdr {

struct NodeChecks {
    std::uint64_t results = 0;  ///< results of workers in the film: tiles
    double work = 0;            ///< pixels times samples of these results
    double checked = 0;         ///< part of `work` that another machine rendered again, and found the same
    std::uint64_t wrong = 0;    ///< results that were found to be wrong

    NodeChecks& operator+=(const NodeChecks& more) {
        results += more.results;
        work += more.work;
        checked += more.checked;
        wrong += more.wrong;
        return *this;
    }

    /// Returns the fraction of the workers' samples that was checked; 1 where there are none.
    double share() const { return work > 0 ? checked / work : 1; }
    /// Returns the probability that a worker with all of these results would have been caught if it had falsified a
    /// pixel of every `oneIn`th: each of results / oneIn cells is checked with the probability share().
    double foundWith(double oneIn) const { return 1 - std::pow(1 - share(), double(results) / oneIn); }
};

/// Returns that as a phrase, with the probability for one false tile in 200; empty: no tile is a worker's.
Text checksText(const NodeChecks& checks);

}  // namespace pdr
