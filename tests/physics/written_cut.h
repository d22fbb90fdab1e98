#pragma once
/// The faces that planes cut into tissue, once more and in double precision; nothing is shared with render/kernel.

#include "tests/physics/written_volume.h"

namespace pdr::test::written {

/// Number of the nearest plane that cuts tissue less than a voxel from `place`; -1: none.
inline int faceNear(const Grid& grid, const std::vector<ClipPlane>& planes, const std::vector<TransferNode>& nodes,
                    dvec3 place) {
    int near = -1;
    double nearest = 1;
    dvec3 foot(0);
    for (int i = 0; i < int(planes.size()); ++i) {
        const dvec3 at = grid.index(place), onPlane = grid.index(planes[i].pointMm);
        const dvec3 across = glm::normalize(grid.acrossIndex(planes[i].normal));
        const double distance = glm::dot(across, onPlane - at);
        if (distance >= nearest)
            continue;
        near = i;
        nearest = distance;
        foot = at + across * distance;
    }
    return near >= 0 && tissueAt(nodes, grid.hu(foot)).opacity > 0 ? near : -1;
}

/// Where another face, or none, begins to be near: ascending, between the line's ends.
template <class FaceAt>
std::vector<double> stepsOf(const Line& line, FaceAt&& faceAt) {
    constexpr int kParts = 512;
    std::vector<double> steps;
    for (int part = 0; part < kParts; ++part) {
        double low = line.from + (line.to - line.from) * part / kParts;
        double high = line.from + (line.to - line.from) * (part + 1) / kParts;
        const int face = faceAt(line.at(low));
        if (faceAt(line.at(high)) == face)
            continue;
        for (int halving = 0; halving < 48; ++halving) {
            const double middle = (low + high) / 2;
            (faceAt(line.at(middle)) == face ? low : high) = middle;
        }
        steps.push_back((low + high) / 2);
    }
    return steps;
}

}  // namespace pdr::test::written
