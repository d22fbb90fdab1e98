#pragma once
/// Where the parts of a scan come from that a plan shows. The voxels of the parts are not kept, and no name of a file.

#include <string>

#include "render/segment/part_rules.h"
#include "render/volume/label_map.h"

namespace pdr::app {

/// Versions of the rules that find parts in a scan; a rule that finds other voxels gets another one.
inline constexpr int kVesselsRule = 1, kShellsRule = 1, kMirrorRule = 1, kMetalRule = 1;

using segment::PartRule;

struct PartSources {
    std::string labels;  ///< labelsHash() of a label map from outside; empty: none
    int vessels = 0;     ///< version of the rule that found vessels; 0: none were wanted
    int shells = 0;      ///< version of the rule for skin and muscle; 0: none
    int mirror = 0;      ///< version of the rule for bone that the other side has; 0: none
    int metal = 0;       ///< version of the rule for implants; 0: none

    bool empty() const { return *this == PartSources{}; }
    bool operator==(const PartSources&) const = default;
};

/// Returns the rules whose parts are wanted.
segment::PartRules rulesOf(const PartSources& sources);
/// Returns `sources` with what the present version of `rule` finds.
PartSources withRule(PartSources sources, PartRule rule);

/// Returns 32 digits by which a label map on the grid of a scan is recognised: of its labels and names.
std::string labelsHash(const LabelMap& map);

}  // namespace pdr::app
