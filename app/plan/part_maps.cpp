#include "app/plan/part_maps.h"

#include <utility>
#include <vector>

#include "render/volume/joined_labels.h"

namespace pdr::app {
namespace {

using SharedMap = std::shared_ptr<const LabelMap>;

/// A map, and whether a rule has found its parts.
struct Layer {
    SharedMap map;
    bool byRule = false;
};

/// Returns one map of all layers.
Result<SharedMap> joined(const std::vector<Layer>& layers) {
    if (layers.size() == 1)
        return layers.front().map;
    JoinedLabels all;
    for (const Layer& layer : layers)
        if (auto ok = all.add(*layer.map); !ok)
            return ok.error();
    return std::make_shared<const LabelMap>(all.take());
}

}  // namespace

void PartMaps::setLabels(LabelMap map) {
    hash_ = labelsHash(map);
    labels_ = std::make_shared<const LabelMap>(std::move(map));
}

Result<std::shared_ptr<const ScanParts>> PartMaps::make(const PartSources& sources, const Volume& scan,
                                                        const Progress& progress) {
    std::vector<Layer> layers;  // what others have marked comes first
    if (!sources.labels.empty())
        layers.push_back({labels_, false});
    for (const PartRule rule : rulesOf(sources)) {
        SharedMap& map = found_[rule];
        if (!map) {
            Result<LabelMap> found = segment::findParts(rule, scan, progress);
            if (!found)
                return found.error();
            map = std::make_shared<const LabelMap>(*std::move(found));
        }
        layers.push_back({map, true});
    }
    Result<SharedMap> map = joined(layers);
    if (!map)
        return map.error();
    ScanParts parts{*std::move(map), {}};
    for (const Layer& layer : layers)
        parts.facts.insert(parts.facts.end(), layer.map->parts.size(), {layer.map->source, layer.byRule});
    const std::vector<double> ml = partsMl(*parts.map);
    for (std::size_t i = 0; i < ml.size(); ++i)
        parts.facts[i].ml = ml[i];
    return std::make_shared<const ScanParts>(std::move(parts));
}

}  // namespace pdr::app
