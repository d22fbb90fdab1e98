#include "render/scene/not_shown.h"

#include <algorithm>
#include <vector>

#include "render/scene/part_styles.h"
#include "render/scene/scene.h"
#include "render/segment/found_parts.h"

namespace pdr {
namespace {

using Names = std::vector<Text>;

/// Returns how a part with that curve is shown.
PartState stateOf(const TransferFunction& curve) {
    const bool isEmpty = std::ranges::all_of(curve.nodes, [](const TransferNode& node) { return node.opacity == 0; });
    if (isEmpty)
        return PartState::hidden;
    return curve.extinctionPerMm <= kGhostPerMm ? PartState::ghost : PartState::shown;
}

/// Returns the names of what is in `state`, each once: the rest of the body first, then parts in their order.
Names namesIn(PartState state, const Scene& scene) {
    Names names;
    if (stateOf(scene.transferFunction) == state)
        names.push_back(phrase("rest of the body"));
    const std::vector<PartCurve>& curves = scene.parts.curves;
    auto next = curves.begin();
    for (std::size_t n = 0; n < scene.parts.map->parts.size(); ++n) {
        const bool isOwn = next != curves.end() && next->label == n + 1;
        if (stateOf(isOwn ? (next++)->transferFunction : scene.transferFunction) != state)
            continue;
        const Text name = segment::partTitle(scene.parts.map->parts[n].name);
        if (std::ranges::find(names, name) == names.end())
            names.push_back(name);
    }
    return names;
}

/// Returns the names as a list; of many a few, and the number of the others.
Text listOf(const Names& names) {
    constexpr std::size_t kMost = 5;
    const std::size_t named = names.size() <= kMost ? names.size() : kMost - 1;
    Text list = names.front();
    for (std::size_t n = 1; n < named; ++n)
        list = phrase("%1, %2", list, names[n]);
    return named == names.size() ? list : phrase("%1 and %2 more", list, names.size() - named);
}

}  // namespace

Text notShown(const Scene& scene) {
    Text masked = scene.mask ? scene.mask->hidden() : Text();
    if (!scene.parts.map || !showsParts(scene.model))
        return masked;
    const Names hidden = namesIn(PartState::hidden, scene), ghosts = namesIn(PartState::ghost, scene);
    const Text withoutThem = hidden.empty() ? Text() : phrase("Hidden: %1.", listOf(hidden));
    const Text through = ghosts.empty() ? Text() : phrase("Ghost: %1.", listOf(ghosts));
    return joined(masked, joined(withoutThem, through));
}

}  // namespace pdr
