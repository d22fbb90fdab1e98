#pragma once
/// The parts of one scan that were read or found last, and those that are shown.

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>

#include "app/plan/part_sources.h"
#include "app/plan/scan_parts.h"

namespace pdr::app {

class KnownParts {
  public:
    /// Takes the parts from `sources`. Only the newest are kept, for undo.
    void add(const PartSources& sources, std::shared_ptr<const ScanParts> parts) {
        constexpr std::size_t kMost = 4;
        std::erase_if(known_, [&](const Known& one) { return one.sources == sources; });
        known_.push_back({sources, std::move(parts)});
        if (known_.size() > kMost)
            known_.pop_front();
    }
    /// Shows the parts from `sources` if they are known or if there are none; otherwise those shown so far stay.
    void show(const PartSources& sources) {
        const auto known = std::ranges::find(known_, sources, &Known::sources);
        if (sources.empty())
            shown_ = {};
        else if (known != known_.end())
            shown_ = *known;
    }
    /// Where the parts come from that are shown.
    const PartSources& shown() const { return shown_.sources; }
    /// The parts that are shown; null: none.
    const std::shared_ptr<const ScanParts>& parts() const { return shown_.parts; }

  private:
    struct Known {
        PartSources sources;
        std::shared_ptr<const ScanParts> parts;
    };

    std::deque<Known> known_;  ///< the newest last
    Known shown_;
};

}  // namespace pdr::app
