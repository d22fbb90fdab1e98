/// Measures how long slices take: HU of a plane, and its grey pixels.
///   reslicing [REPEATS]
/// On a made-up volume of 512 x 512 x 600 voxels, on one thread. Prints the median and the 95th percentile in
/// milliseconds of the thread's processor time, and the median of the window alone.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "render/base/processor_time.h"
#include "render/slice/grey_window.h"
#include "render/slice/reslice.h"
#include "render/slice/slice_stack.h"

namespace pdr {
namespace {

constexpr ivec3 kSize(512, 512, 600);
const dvec3 kSpacingMm(0.898438, 0.898438, 2.5 * 99 / 599);

/// A body's worth of texture: waves of tissue with noise, so that no two lines of voxels are alike.
Volume made() {
    Voxels voxels(std::size_t(kSize.x) * kSize.y * kSize.z);
    std::uint32_t state = 1;
    for (std::int16_t& hu : voxels) {
        state = state * 1664525 + 1013904223;
        hu = std::int16_t(int(state >> 21) - 1024);
    }
    return Volume(VolumeGeometry::aligned(kSize, kSpacingMm, {0, 0, 0}), std::move(voxels));
}

struct Direction {
    const char* name;
    dvec3 right, down;
    Slab slab;
};

std::vector<Direction> directions() {
    const dvec3 oblique = glm::normalize(dvec3(0.86, 0.5, -0.1));
    const dvec3 across = glm::normalize(glm::cross(oblique, dvec3(0.4, -0.5, 0.77)));
    return {{"axial", {1, 0, 0}, {0, 1, 0}, {}},
            {"coronal", {1, 0, 0}, {0, 0, -1}, {}},
            {"sagittal", {0, 1, 0}, {0, 0, -1}, {}},
            {"oblique", oblique, across, {}},
            {"oblique MIP 10 mm", oblique, across, {10, SlabKind::maximum}},
            {"oblique mean 10 mm", oblique, across, {10, SlabKind::mean}}};
}

double at(std::vector<double>& values, double share) {
    std::ranges::sort(values);
    return values[std::size_t(share * double(values.size() - 1))];
}

void measure(const Volume& volume, const Direction& direction, int edge, int repeats) {
    const double mm = kSpacingMm.x * 512 / edge;
    std::vector<double> slice, window;
    std::vector<float> hu;
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < repeats; ++i) {
        SlicePlane plane =
            SlicePlane::around(volume.geometry().centreMm(), direction.right, direction.down, mm, ivec2(edge))
                .behind(i - repeats / 2);
        const double start = processorSeconds();
        auto image = reslice(volume, plane, direction.slab, {}, std::move(hu));
        const double sliced = processorSeconds();
        pixels.resize(4 * image->hu.size());
        paintGrey({40, 400}, image->hu, {}, pixels);
        const double seen = processorSeconds();
        hu = std::move(image->hu);
        slice.push_back(1e3 * (sliced - start));
        window.push_back(1e3 * (seen - sliced));
    }
    std::printf("%4d x %-4d  %-20s %7.2f %7.2f %7.2f\n", edge, edge, direction.name, at(slice, 0.5), at(slice, 0.95),
                at(window, 0.5));
    std::fflush(stdout);
}

}  // namespace
}  // namespace pdr

int main(int argc, char** argv) {
    using namespace pdr;
    const int repeats = argc > 1 ? std::max(1, std::atoi(argv[1])) : 30;
    const Volume volume = made();
    std::printf("512 x 512 x 600 voxels, %d lanes; ms of processor time on one thread\n", kLanes);
    std::printf("pixels       plane                 median     p95  window\n");
    for (const int edge : {512, 1024, 2048})
        for (const Direction& direction : directions())
            if (edge < 2048 || direction.slab.thicknessMm == 0)
                measure(volume, direction, edge, direction.slab.thicknessMm > 0 ? std::max(1, repeats / 5) : repeats);
}
