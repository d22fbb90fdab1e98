#include "dicom/segmentation/frame_grid.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pdr::dicom {

namespace {

constexpr double kOffMm = 0.2, kOffSteps = 0.2;  ///< how far a frame may lie beside its place
constexpr double kMostSlices = 65535;

bool isPlaced(const SliceHeader& frame) {
    return frame.position && frame.rowDirection && frame.columnDirection && frame.spacingMm;
}

/// Returns whether the pixels of two frames lie in one direction, equally far apart.
bool isAlike(const SliceHeader& a, const SliceHeader& b) {
    constexpr double kSame = 1e-4;
    return glm::length(*a.rowDirection - *b.rowDirection) < kSame &&
           glm::length(*a.columnDirection - *b.columnDirection) < kSame &&
           glm::length(*a.spacingMm - *b.spacingMm) < kSame;
}

/// Returns the numbers of the frames along `step` from the first one on; none if they do not lie on such places.
std::optional<std::vector<int>> numbersAlong(const dvec3& step, const std::vector<SliceHeader>& frames) {
    std::vector<int> numbers;
    const double length = glm::length(step);
    for (const SliceHeader& frame : frames) {
        const dvec3 way = *frame.position - *frames.front().position;
        const double number = std::round(glm::dot(way, step) / (length * length));
        const double off = glm::length(way - number * step);
        if (!(std::abs(number) < kMostSlices && off <= std::min(kOffMm, kOffSteps * length)))
            return {};
        numbers.push_back(int(number));
    }
    return numbers;
}

/// Returns the way between those two frames that are nearest to each other along `normal`, but not in one place; none
/// if all are.
std::optional<dvec3> shortestStep(const dvec3& normal, const std::vector<SliceHeader>& frames) {
    constexpr double kOnePlace = 1e-3;
    std::vector<dvec3> places;
    places.reserve(frames.size());
    for (const SliceHeader& frame : frames)
        places.push_back(*frame.position);
    const auto height = [&](const dvec3& place) { return glm::dot(place, normal); };
    std::ranges::sort(places, {}, height);
    std::optional<dvec3> shortest;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const dvec3 step = places[i] - places[i - 1];
        if (height(step) > kOnePlace && (!shortest || height(step) < height(*shortest)))
            shortest = step;
    }
    return shortest;
}

/// The steps by which slices may lie apart, the likeliest first: those of the scan, then that of the frames.
std::vector<dvec3> possibleSteps(const std::vector<SliceHeader>& frames, const VolumeGeometry& scan) {
    constexpr double kAcross = 0.5;
    const dvec3 normal = glm::normalize(glm::cross(*frames.front().rowDirection, *frames.front().columnDirection));
    std::vector<dvec3> steps;
    for (const int axis : {2, 1, 0}) {
        const dvec3 step(scan.patientFromIndex[axis]);
        if (std::abs(glm::dot(step, normal)) > kAcross * glm::length(step))
            steps.push_back(step);
    }
    if (const auto own = shortestStep(normal, frames))
        steps.push_back(*own);
    return steps;
}

FrameGrid gridAlong(const dvec3& step, std::vector<int> numbers, const SliceHeader& first) {
    const auto [lowest, highest] = std::ranges::minmax(numbers);
    FrameGrid grid;
    grid.geometry.size = {first.columns, first.rows, highest - lowest + 1};
    grid.geometry.patientFromIndex[0] = dvec4(*first.rowDirection * first.spacingMm->x, 0);
    grid.geometry.patientFromIndex[1] = dvec4(*first.columnDirection * first.spacingMm->y, 0);
    grid.geometry.patientFromIndex[2] = dvec4(step, 0);
    grid.geometry.patientFromIndex[3] = dvec4(*first.position + double(lowest) * step, 1);
    for (int& number : numbers)
        number -= lowest;
    grid.slice = std::move(numbers);
    return grid;
}

}  // namespace

Result<FrameGrid> gridOfFrames(const std::vector<SliceHeader>& frames, const VolumeGeometry& scan) {
    if (frames.empty() || !std::ranges::all_of(frames, isPlaced))
        return Error{phrase("its frames do not say where they lie in the patient"), "", "", ErrorKind::refused};
    const SliceHeader& first = frames.front();
    if (!std::ranges::all_of(frames, [&](const SliceHeader& frame) { return isAlike(frame, first); }))
        return Error{phrase("its frames lie in several directions, or their pixels differ in size"), "", "",
                     ErrorKind::refused};
    for (const dvec3& step : possibleSteps(frames, scan))
        if (auto numbers = numbersAlong(step, frames))
            return gridAlong(step, *std::move(numbers), first);
    return Error{phrase("its frames are not evenly spaced"), "", "", ErrorKind::refused};
}

}  // namespace pdr::dicom
