#include "render/scene/visible_mask.h"

#include <new>

#include "render/base/errors.h"

namespace pdr {
namespace {

using segment::Labels, segment::PartMask, segment::Use;

/// Returns the mask of all that lies in one of `labels`; null if there are none.
PartMask maskOfShown(const segment::BodyParts& parts, const Labels& labels, const VolumeGeometry& on,
                     const Progress& progress) {
    std::shared_ptr<const Mask> all;
    double done = 0;
    for (const std::string& label : labels) {
        const double next = done + 1.0 / double(labels.size());
        PartMask one = parts.labelled(label, Use::shown, on, partOf(progress, done, next));
        if (!one)
            return one;
        all = all ? united(*all, **one, phrase("Only %1 are shown.", segment::partNames(labels))) : *one;
        done = next;
    }
    return all;
}

/// Returns the mask of all that lies in none of `labels`; null if there are none.
PartMask maskWithout(const segment::BodyParts& parts, const Labels& labels, const VolumeGeometry& on,
                     const Progress& progress) {
    std::shared_ptr<const Mask> all;
    double done = 0;
    for (const std::string& label : labels) {
        const double next = done + 1.0 / double(labels.size());
        PartMask one = parts.labelled(label, Use::hidden, on, partOf(progress, done, next));
        if (!one)
            return one;
        all = combined(all, *one);
        done = next;
    }
    return all;
}

}  // namespace

PartMask visibleMask(const segment::BodyParts& parts, const Visible& visible, const VolumeGeometry& on,
                     const Progress& progress) {
    try {
        const double steps = double(!visible.shown.empty()) + double(!visible.hidden.empty()) + (visible.peelMm > 0);
        const double shownUntil = visible.shown.empty() ? 0 : 1 / steps;
        const double hiddenUntil = visible.peelMm > 0 ? 1 - 1 / steps : 1;
        PartMask shown = maskOfShown(parts, visible.shown, on, partOf(progress, 0, shownUntil));
        if (!shown)
            return shown;
        const PartMask rest = maskWithout(parts, visible.hidden, on, partOf(progress, shownUntil, hiddenUntil));
        if (!rest || !(visible.peelMm > 0))
            return rest ? combined(*shown, *rest) : rest;
        const PartMask within = parts.peeled(visible.peelMm, on, partOf(progress, hiddenUntil, 1));
        return within ? combined(combined(*shown, *rest), *within) : within;
    } catch (const std::bad_alloc&) {
        return notEnoughMemory(phrase("to tell parts of the body apart"), "",
                               phrase("Close other programs, or show everything."));
    }
}

}  // namespace pdr
