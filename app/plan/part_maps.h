#pragma once
/// Makes the parts of a scan from their sources. Window and command line make them through this class.

#include <map>
#include <memory>
#include <string>

#include "app/plan/part_sources.h"
#include "app/plan/scan_parts.h"
#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/volume.h"

namespace pdr::app {

/// The parts of one scan, each source by itself, so that none is searched for twice.
class PartMaps {
  public:
    /// Takes a label map from outside, on the grid of the scan, in place of the one before.
    void setLabels(LabelMap map);
    /// labelsHash() of that map; empty: there is none.
    const std::string& hash() const { return hash_; }

    /// Returns the parts of all `sources`, of which the label map is the one that was set. Parts that rules find are
    /// searched for in `scan`, which has no table, unless they are known. Errors: those of the rules and of
    /// JoinedLabels; cancelled().
    Result<std::shared_ptr<const ScanParts>> make(const PartSources& sources, const Volume& scan,
                                                  const Progress& progress);

  private:
    using SharedMap = std::shared_ptr<const LabelMap>;

    SharedMap labels_;
    std::map<PartRule, SharedMap> found_;
    std::string hash_;
};

}  // namespace pdr::app
