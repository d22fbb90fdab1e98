#include "render/scene/visible_mask.h"

#include <new>

#include "render/base/errors.h"
#include "render/segment/body_parts.h"

namespace pdr {
namespace {

segment::PartMask maskOfPart(const Volume& volume, BodyPart part, const Progress& progress) {
    switch (part) {
        case BodyPart::lungs:
            return segment::lungs(volume, progress);
        case BodyPart::bones:
            return segment::bones(volume, segment::Bones::shown, progress);
        case BodyPart::withoutBones:
            return segment::bones(volume, segment::Bones::hidden, progress);
        case BodyPart::everything:
            break;
    }
    return std::shared_ptr<const Mask>();
}

}  // namespace

Result<std::shared_ptr<const Mask>> visibleMask(const Volume& volume, const Visible& visible,
                                                const Progress& progress) {
    try {
        const double half = visible.peelMm > 0 ? 0.5 : 1;
        segment::PartMask part = maskOfPart(volume, visible.part, partOf(progress, 0, half));
        if (!part || !(visible.peelMm > 0))
            return part;
        const segment::PartMask within = segment::peeled(volume, visible.peelMm, partOf(progress, half, 1));
        return within ? combined(*part, *within) : within;
    } catch (const std::bad_alloc&) {
        return notEnoughMemory(" to tell parts of the body apart", "", "Close other programs, or show everything.");
    }
}

}  // namespace pdr
