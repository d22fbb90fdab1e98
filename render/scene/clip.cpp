#include "render/scene/clip.h"

#include "render/scene/field_check.h"
#include "render/scene/fields/clip_fields.h"

namespace pdr {

ClipBox boxAround(const VolumeGeometry& volume) {
    ClipBox box{dvec3(1e300), dvec3(-1e300)};
    for (int i = 0; i < 8; ++i) {
        const dvec3 end(i & 1, (i >> 1) & 1, i >> 2);
        const dvec3 corner(volume.patientFromIndex * dvec4(end * dvec3(volume.size) - 0.5, 1.0));
        box = {glm::min(box.lowMm, corner), glm::max(box.highMm, corner)};
    }
    return box;
}

std::vector<ClipPlane> Clip::allPlanes() const {
    std::vector<ClipPlane> all = planes;
    for (int axis = 0; box && axis < 3; ++axis) {
        dvec3 normal(0);
        normal[axis] = 1;
        all.push_back({box->highMm, normal});
        all.push_back({box->lowMm, -normal});
    }
    return all;
}

std::vector<ClipPlane> Clip::planesThrough(const VolumeGeometry& volume) const {
    const dvec3 low(-0.5), high = dvec3(volume.size) - 0.5;  // the volume's box, index space
    std::vector<ClipPlane> through;
    for (const ClipPlane& plane : allPlanes()) {
        const dvec3 normal = glm::normalize(plane.normal);
        const dvec3 inIndex = glm::transpose(glm::dmat3(volume.patientFromIndex)) * normal;
        const double offset = glm::dot(normal, plane.pointMm - dvec3(volume.patientFromIndex[3]));
        const dvec3 farthest = glm::mix(low, high, glm::greaterThan(inIndex, dvec3(0)));
        const double beyond = glm::dot(inIndex, farthest) - offset;  // mm
        if (beyond > 1e-9 * glm::dot(glm::abs(inIndex), high - low))
            through.push_back(plane);
    }
    return through;
}

Result<void> Clip::check() const {
    if (auto ok = FieldCheck::check(*this); !ok)
        return ok;
    if (box && !glm::all(glm::lessThan(box->lowMm, box->highMm)))
        return Error{phrase("must lie above lowMm along every axis"), "box.highMm", ""};
    for (std::size_t i = 0; i < freehand.size(); ++i) {
        const std::string where = "freehand[" + std::to_string(i) + "]";
        if (auto ok = freehand[i].camera.check(); !ok)
            return below(where, ok.error());
        if (freehand[i].outline.size() < 3)
            return Error{phrase("must have three points at least"), where + ".outline", ""};
    }
    return {};
}

std::string cutText(const Clip& clip) {
    std::string text = clip.box ? "box" : "";
    const auto add = [&](std::size_t count, const char* one, const char* several) {
        if (count > 0)
            text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + (count == 1 ? one : several);
    };
    add(clip.planes.size(), "plane", "planes");
    add(clip.freehand.size(), "freehand", "freehand");
    return text;
}

}  // namespace pdr
