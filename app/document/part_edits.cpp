#include "app/document/part_edits.h"

#include <algorithm>
#include <utility>

namespace pdr::app {

/// Returns the styles after change(style) has been called for each of the parts that the scan has.
template <class Change>
PartStyles PartEdits::changed(const PartNumbers& parts, const Change& change) const {
    PartStyles styles = document_.setup().look.parts;
    if (!document_.scanParts())
        return styles;
    const std::vector<MappedPart>& all = document_.scanParts()->map->parts;
    for (const int part : parts)
        if (part > 0 && part <= int(all.size())) {
            PartStyle style = styleOf(styles, all[std::size_t(part) - 1].name);
            change(style);
            styles = withStyle(std::move(styles), std::move(style));
        }
    return styles;
}

void PartEdits::set(PartStyles styles) {
    Look look = document_.setup().look;
    look.parts = std::move(styles);
    document_.setLook(look);
}

void PartEdits::setParts(const PartSources& sources, const std::shared_ptr<const ScanParts>& parts) {
    if (!document_.hasVolume())
        return;
    if (parts)
        document_.takeParts(sources, parts);
    Plan plan = document_.plan();
    plan.partSources = sources;
    document_.edit(std::move(plan));
}

void PartEdits::keepParts() {
    fallBackTo(document_.shownSources());
}

void PartEdits::dropLabels() {
    PartSources sources = document_.plan().partSources;
    sources.labels.clear();
    fallBackTo(sources);
}

void PartEdits::fallBackTo(const PartSources& sources) {
    Plan plan = document_.plan();
    plan.partSources = sources;
    document_.fallBackTo(std::move(plan));
}

void PartEdits::setState(const PartNumbers& parts, PartState state) {
    PartStyles styles = changed(parts, [state](PartStyle& style) { style.state = state; });
    if (document_.scanParts() && std::ranges::find(parts, 0) != parts.end())
        styles.rest = state;
    set(std::move(styles));
}

void PartEdits::setColour(const PartNumbers& parts, const std::optional<vec3>& albedo) {
    set(changed(parts, [&](PartStyle& style) { style.colour = albedo; }));
}

void PartEdits::setLook(const PartNumbers& parts, int index) {
    const bool isLook = document_.looks().holds(index);
    set(changed(parts, [&](PartStyle& style) {
        style.colour.reset();
        style.transferFunction = isLook ? std::optional(document_.looks()[index].look.transferFunction) : std::nullopt;
        style.look = isLook ? document_.looks()[index].name : std::string();
    }));
}

}  // namespace pdr::app
