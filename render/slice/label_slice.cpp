#include "render/slice/label_slice.h"

namespace pdr {

std::vector<std::uint8_t> labelsOnPlane(const LabelMap& map, const SlicePlane& plane) {
    const dmat4 indexFromPatient = glm::inverse(map.geometry.patientFromIndex);
    const auto indexOf = [&](dvec2 pixel) { return dvec3(indexFromPatient * dvec4(plane.mmAt(pixel), 1)); };
    const ivec3 size = map.geometry.size;
    const dvec3 step = indexOf({1, 0}) - indexOf({0, 0});
    std::vector<std::uint8_t> labels(std::size_t(plane.size.x) * std::size_t(plane.size.y));
    std::uint8_t* label = labels.data();
    for (int y = 0; y < plane.size.y; ++y) {
        const dvec3 first = indexOf({0, y}) + 0.5;
        for (int x = 0; x < plane.size.x; ++x, ++label) {
            const ivec3 at(glm::floor(first + double(x) * step));
            if (glm::all(glm::greaterThanEqual(at, ivec3(0))) && glm::all(glm::lessThan(at, size)))
                *label =
                    map.labels[(std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
                               std::size_t(at.x)];
        }
    }
    return labels;
}

}  // namespace pdr
