#include "render/scene/clip.h"

#include <string>

#include "render/scene/range.h"

namespace pdr {

namespace {

constexpr Range kPlaceRange{-1e9, 1e9};

Result<void> check(const ClipBox& box) {
    for (const auto& ok : {checkRange(box.lowMm, kPlaceRange, "lowMm"), checkRange(box.highMm, kPlaceRange, "highMm")})
        if (!ok)
            return ok;
    if (!glm::all(glm::lessThan(box.lowMm, box.highMm)))
        return Error{"must lie above lowMm along every axis", "highMm", ""};
    return {};
}

Result<void> check(const ClipPlane& plane) {
    if (auto ok = checkRange(plane.pointMm, kPlaceRange, "pointMm"); !ok)
        return ok;
    return checkDirection(plane.normal, "normal");
}

}  // namespace

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
    if (box)
        if (auto ok = pdr::check(*box); !ok)
            return below("box", ok.error());
    for (std::size_t i = 0; i < planes.size(); ++i)
        if (auto ok = pdr::check(planes[i]); !ok)
            return below("planes[" + std::to_string(i) + "]", ok.error());
    return {};
}

}  // namespace pdr
