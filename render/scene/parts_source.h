#pragma once
/// Where the parts of a patient come from: a label map, or a rule of this program.

#include <filesystem>

#include "render/volume/label_fit.h"

namespace pdr {

/// Parts that the program finds in a scan itself, by rules that may err (segment/vessels.h, segment/shells.h).
enum class FoundParts { none, vessels, shells };

/// One of `labels` and `found` at most is given.
struct PartsSource {
    std::filesystem::path labels;  ///< a label map, or a folder with a mask of each part; empty: there is none
    FoundParts found = FoundParts::none;
    Resampling resampling = Resampling::refused;

    /// Returns whether the program finds the parts in the scan itself.
    bool finds() const { return found != FoundParts::none; }
    bool isGiven() const { return !labels.empty() || finds(); }
    bool operator==(const PartsSource&) const = default;
};

}  // namespace pdr
