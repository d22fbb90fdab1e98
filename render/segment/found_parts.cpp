#include "render/segment/found_parts.h"

namespace pdr::segment {

Text partTitle(const std::string& part) {
    if (part == kVessels)
        return phrase("vessels");
    if (part == kSkin)
        return phrase("skin");
    if (part == kMuscle)
        return phrase("muscle");
    if (part == kMirroredBone)
        return phrase("mirrored bone");
    return part == kImplant ? phrase("implant") : Text(part);
}

}  // namespace pdr::segment
