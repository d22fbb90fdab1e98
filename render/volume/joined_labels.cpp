#include "render/volume/joined_labels.h"

#include <algorithm>
#include <utility>

namespace pdr {

Result<void> JoinedLabels::add(LabelMap map) {
    const std::size_t before = joined_.parts.size();
    if (before + map.parts.size() > LabelMap::kMostParts)
        return Error{phrase("the masks have more than %1 labels", int(LabelMap::kMostParts)), "",
                     phrase("Choose a folder with fewer masks."), ErrorKind::refused};
    const bool isFirst = joined_.labels.empty();
    if (!isFirst && (map.geometry.size != joined_.geometry.size ||
                     map.geometry.patientFromIndex != joined_.geometry.patientFromIndex))
        return Error{phrase("the mask has other voxels than those before it"), "",
                     phrase("Choose a folder with masks of one scan."), ErrorKind::refused};
    std::vector<std::size_t> voxels(map.parts.size() + 1);
    for (const std::uint8_t label : map.labels)
        ++voxels[label];
    voxels_.insert(voxels_.end(), voxels.begin() + 1, voxels.end());
    joined_.parts.insert(joined_.parts.end(), map.parts.begin(), map.parts.end());
    joined_.notes.insert(joined_.notes.end(), map.notes.begin(), map.notes.end());
    joined_.source = map.source;
    if (!isFirst) {
        lay(map, before);
        return {};
    }
    joined_.geometry = map.geometry;
    joined_.labels = std::move(map.labels);
    return {};
}

void JoinedLabels::lay(const LabelMap& map, std::size_t partsBefore) {
    const auto sizeOf = [&](std::uint8_t label) { return voxels_[label - 1]; };
    for (std::size_t i = 0; i < map.labels.size(); ++i) {
        if (map.labels[i] == 0)
            continue;
        const auto label = std::uint8_t(partsBefore + map.labels[i]);
        std::uint8_t& kept = joined_.labels[i];
        if (kept != 0) {
            isShared_.resize(map.labels.size());
            isShared_[i] = true;
        }
        if (kept == 0 || sizeOf(label) < sizeOf(kept))
            kept = label;
    }
}

LabelMap JoinedLabels::take() {
    if (const auto several = std::ranges::count(isShared_, true))
        joined_.notes.push_back(
            phrase("voxels that lie in several parts, of which the smallest keeps them: %1", std::int64_t(several)));
    return std::move(joined_);
}

}  // namespace pdr
