#include "render/scene/visible_mask.h"

#include <new>

#include "render/base/errors.h"

namespace pdr {
namespace {

segment::PartMask maskOfPart(const segment::BodyParts& parts, BodyPart part, const VolumeGeometry& on,
                             const Progress& progress) {
    switch (part) {
        case BodyPart::lungs:
            return parts.lungs(on, progress);
        case BodyPart::bones:
            return parts.bones(segment::Bones::shown, on, progress);
        case BodyPart::withoutBones:
            return parts.bones(segment::Bones::hidden, on, progress);
        case BodyPart::everything:
            break;
    }
    return std::shared_ptr<const Mask>();
}

}  // namespace

segment::PartMask visibleMask(const segment::BodyParts& parts, const Visible& visible, const VolumeGeometry& on,
                              const Progress& progress) {
    try {
        const double half = visible.peelMm > 0 ? 0.5 : 1;
        segment::PartMask part = maskOfPart(parts, visible.part, on, partOf(progress, 0, half));
        if (!part || !(visible.peelMm > 0))
            return part;
        const segment::PartMask within = parts.peeled(visible.peelMm, on, partOf(progress, half, 1));
        return within ? combined(*part, *within) : within;
    } catch (const std::bad_alloc&) {
        return notEnoughMemory(phrase("to tell parts of the body apart"), "",
                               phrase("Close other programs, or show everything."));
    }
}

}  // namespace pdr
