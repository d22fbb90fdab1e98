#include "render/segment/labels.h"

#include <cassert>

namespace pdr::segment {

Text partName(std::string_view label) {
    if (label == kBones)
        return phrase("bones");
    if (label == kLungs)
        return phrase("the lungs");
    return std::string(label);
}

Text partNames(const Labels& labels) {
    assert(!labels.empty());
    auto label = labels.begin();
    Text names = partName(*label);
    while (++label != labels.end())
        names = phrase("%1 and %2", names, partName(*label));
    return names;
}

}  // namespace pdr::segment
