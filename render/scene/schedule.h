#pragma once
/// How iterations become displayed frames: this program's schedule, and the one it replaces, kept for comparison.

namespace pdr {

struct Schedule {
    enum class Kind {
        pd,    ///< n iterations, accumulated as they run; then one tone map and one copy, behind the next iterations
        kroes  ///< Exposure Render's (Kroes, Post & Botha 2012): all stages for each iteration, one after the other
    };
    Kind kind = Kind::pd;

    // Options of `kroes` alone:
    bool redundant = false;  ///< K0: everything is uploaded and allocated anew for each iteration; false: K1
    bool filter = true;  ///< each iteration is blurred, 3 x 3 pixels, before it is added. BIASED: it never averages out
    /// True: Exposure Render's running mean in single precision, whose second iteration replaces the first. False: the
    /// sums of the film, which make the image equal to that of `pd`, bit by bit, where nothing is filtered.
    bool runningMean = true;

    bool operator==(const Schedule&) const = default;
};

}  // namespace pdr
