#pragma once
/// Where the parts of a patient come from: a label map, or a rule of this program.

#include <filesystem>

#include "render/segment/part_rules.h"
#include "render/volume/label_fit.h"

namespace pdr {

/// One of `labels` and `rules` at most is given.
struct PartsSource {
    std::filesystem::path labels;  ///< a label map, or a folder with a mask of each part; empty: there is none
    segment::PartRules rules;      ///< those that find parts in the scan itself
    Resampling resampling = Resampling::refused;

    /// Returns whether the program finds the parts in the scan itself.
    bool finds() const { return !rules.empty(); }
    bool isGiven() const { return !labels.empty() || finds(); }
    bool operator==(const PartsSource&) const = default;
};

}  // namespace pdr
