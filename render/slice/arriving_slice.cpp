#include "render/slice/arriving_slice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pdr {
namespace {

using Parts = std::span<const ArrivedSlices>;

/// Puts kNotArrived where `image` has no value although it lies in the box of the volume, next to none of `parts`.
void markGaps(const VolumeGeometry& geometry, Parts parts, SliceImage& image) {
    const dmat4 indexFromPatient = glm::inverse(geometry.patientFromIndex);
    const dvec3 last = dvec3(geometry.size - 1);
    const auto isGap = [&](dvec3 index) {
        const dvec3 inside = glm::clamp(index, dvec3(0), last);
        const int nearest = int(std::floor(inside.z + 0.5));
        const auto holds = [&](const ArrivedSlices& part) {
            return nearest >= part.first && nearest < part.first + part.geometry.size.z;
        };
        return glm::all(glm::lessThanEqual(glm::abs(index - inside), dvec3(0.5))) && std::ranges::none_of(parts, holds);
    };
    const ivec2 size = image.plane.size;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            float& hu = image.hu[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
            if (std::isnan(hu) && isGap(dvec3(indexFromPatient * dvec4(image.plane.mmAt({x, y}), 1))))
                hu = kNotArrived;
        }
}

/// Returns the slice of `parts`, without what has not arrived. None: a stop was requested.
std::optional<SliceImage> resliceParts(Parts parts, const SlicePlane& plane, const std::stop_token& stop,
                                       std::vector<float> memory) {
    SliceImage image{plane, {}, std::move(memory)};
    image.hu.assign(std::size_t(plane.size.x) * std::size_t(plane.size.y), std::numeric_limits<float>::quiet_NaN());
    std::vector<float> partMemory;
    for (const ArrivedSlices& part : parts) {
        auto one = reslice(part.geometry, part.voxels, plane, {}, stop, std::move(partMemory));
        if (!one)
            return std::nullopt;
        std::ranges::transform(one->hu, image.hu, image.hu.begin(),
                               [](float here, float before) { return std::isnan(here) ? before : here; });
        partMemory = std::move(one->hu);
    }
    return image;
}

}  // namespace

std::optional<SliceImage> reslice(const ArrivingVolume& volume, const SlicePlane& plane, const std::stop_token& stop,
                                  std::vector<float> memory) {
    std::optional<SliceImage> image;
    volume.look([&](Parts parts) {
        image = resliceParts(parts, plane, stop, std::move(memory));
        if (image)
            markGaps(volume.geometry(), parts, *image);
    });
    return image;
}

}  // namespace pdr
