#pragma once
/// How iterations become displayed frames: this program's way, and the one that it replaces, kept to be compared with.

namespace pdr {

struct Schedule {
    enum class Kind {
        pd,    ///< n iterations, added up as they are made; then one tone map and one copy, behind the next iterations
        kroes  ///< Exposure Render's (Kroes, Post & Botha 2012): all stages for each iteration, one after the other
    };
    Kind kind = Kind::pd;

    // Of `kroes` alone:
    bool redundant = false;  ///< K0: everything is uploaded and allocated anew for each iteration; else K1
    bool filter = true;  ///< each iteration is blurred, 3 x 3 pixels, before it is added. BIASED: it never averages out
    /// The average: Exposure Render's running mean in single precision, whose second iteration replaces the first; or
    /// (false) the sums of the film, which make the picture that of `pd` bit by bit where nothing is filtered.
    bool runningMean = true;

    bool operator==(const Schedule&) const = default;
};

}  // namespace pdr
