#pragma once
/// The parts of a scan, from all their sources, and what is said of each.

#include <memory>
#include <vector>

#include "render/volume/label_map.h"

namespace pdr::app {

/// What is said of a part.
struct PartFacts {
    Text source;          ///< who says that it is there, within a sentence: "a rule of this program"
    bool byRule = false;  ///< whether this program has found it
    double ml = 0;        ///< its volume
};

struct ScanParts {
    std::shared_ptr<const LabelMap> map;  ///< on the grid of the scan
    std::vector<PartFacts> facts;         ///< one for each part
};

}  // namespace pdr::app
