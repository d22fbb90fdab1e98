#include "dicom/stack/stack_geometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "dicom/stack/even_fill.h"
#include "dicom/stack/sorted_stack.h"
#include "render/volume/sheared.h"

namespace pdr::dicom {

namespace {

constexpr double kNotedDeviationMm = 0.01;

/// Returns the verdict on slices that cannot share a grid; the reason is empty if they can.
GeometryVerdict judgeAgreement(const std::vector<SlicePlane>& slices) {
    const SlicePlane& first = slices.front();
    for (const SlicePlane& slice : slices) {
        if (slice.size != first.size)
            return {Stack::mixedSize,
                    phrase("%1 has %2, %3 has %4", first.name, sizeText(first), slice.name, sizeText(slice)),
                    {}};
    }
    for (const SlicePlane& slice : slices) {
        if (const Text reason = missingGeometry(slice); !reason.empty())
            return {Stack::noGeometry, reason, {}};
    }
    for (const SlicePlane& slice : slices) {
        if (!sameSpacing(slice, first))
            return {Stack::mixedSize,
                    phrase("%1 has %2, %3 has %4", first.name, sizeText(first), slice.name, sizeText(slice)),
                    {}};
        if (!sameDirection(slice, first))
            return {
                Stack::mixedOrientation, phrase("%1 and %2 look in different directions", first.name, slice.name), {}};
        if (const double off = gridDeviationMm(first, slice); off > kGridToleranceMm)
            return {Stack::mixedSize,
                    phrase("%1 and %2 lie on different grids (%3 mm at a corner)", first.name, slice.name, inMm(off)),
                    {}};
    }
    return {Stack::even, "", {}};
}

Note tiltNote(const VolumeGeometry& geometry) {
    const SliceDrift drift = sliceDrift(geometry);
    return {"tilt", phrase("the gantry was tilted by %1 degrees; the grid follows it (%2 mm a slice)",
                           fixedNumber(drift.degrees(), 1), inMm(glm::length(drift.sidewaysMm)))};
}

Text distancesText(double low, double high) {
    return high - low < 0.05 ? phrase("%1 mm", inMm(high)) : phrase("%1 to %2 mm", inMm(low), inMm(high));
}

/// Returns the note by which measurements across holes are marked.
Note holesNote(const std::vector<HoleHeights>& holes) {
    const HoleHeights& widest =
        *std::ranges::max_element(holes, {}, [](const HoleHeights& hole) { return hole.toMm - hole.fromMm; });
    const Text from = inMm(widest.fromMm), to = inMm(widest.toMm);
    return {holesRemark(holes),
            holes.size() == 1
                ? phrase("slices are interpolated across a hole from %1 to %2 mm above the lowest slice; what is "
                         "measured there is marked",
                         from, to)
                : phrase("slices are interpolated across %3 holes, the widest from %1 to %2 mm above the lowest slice; "
                         "what is measured there is marked",
                         from, to, holes.size())};
}

/// Returns even slices between those of an uneven stack; none if that has holes that are too wide.
std::optional<ResampledStack> resampled(const SortedStack& stack) {
    std::vector<double> heights;
    heights.reserve(std::size_t(stack.count()));
    for (int k = 0; k < stack.count(); ++k)
        heights.push_back(stack.height(k));
    std::optional<EvenFill> fill = evenFill(heights, stack.toleranceMm());
    if (!fill)
        return std::nullopt;
    const int count = int(fill->slices.size());
    ResampledStack made{std::move(fill->slices), stack.geometryOf(count), {}};
    made.notes.push_back(
        {"resampled", phrase("%1 slices, %2 apart, were resampled to %3 every %4 mm; a slice lies up to %5 mm from "
                             "where anything was measured",
                             stack.count(), distancesText(fill->closestMm, fill->widestMm), count, inMm(fill->gapMm),
                             inMm(fill->furthestMm))});
    if (!stack.isUpright())
        made.notes.push_back(tiltNote(made.geometry));
    if (!fill->holes.empty())
        made.notes.push_back(holesNote(fill->holes));
    return made;
}

/// Returns the notes on a stack that is an even grid, but not exactly an upright one.
std::vector<Note> notesOn(const SortedStack& stack, const VolumeGeometry& geometry) {
    std::vector<Note> notes;
    if (!stack.isUpright())
        notes.push_back(tiltNote(geometry));
    if (const double off = stack.unevennessMm(); off > kSamePlaceMm)
        notes.push_back(
            {"uneven", phrase("a slice lies %1 mm from an even grid; the slices are taken as even", inMm(off))});
    if (const double off = stack.gridDeviationMm(); off > kNotedDeviationMm)
        notes.push_back({"grid", phrase("spacing or direction changes on the way; a pixel lies up to "
                                        "%1 mm from where the first slice would put it",
                                        inMm(off))});
    return notes;
}

/// Returns the unit vector across the slices of a volume.
dvec3 normalOf(const VolumeGeometry& geometry) {
    const dmat3 steps(geometry.patientFromIndex);
    return glm::normalize(glm::cross(steps[0], steps[1]));
}

}  // namespace

StackAnalysis analyseStack(const std::vector<SlicePlane>& slices) {
    StackAnalysis analysis;
    analysis.order.resize(slices.size());
    std::iota(analysis.order.begin(), analysis.order.end(), 0);
    analysis.verdict = judgeAgreement(slices);
    const auto sizeOfFirst = [&](const SlicePlane& slice) { return slice.size == slices.front().size; };
    if (std::all_of(slices.begin(), slices.end(), sizeOfFirst))
        analysis.geometry.size = ivec3(slices.front().size, int(slices.size()));
    if (!std::all_of(slices.begin(), slices.end(),
                     [](const SlicePlane& slice) { return missingGeometry(slice).empty(); }))
        return analysis;
    // Sort the slices along their normal
    const SortedStack stack(slices);
    analysis.order = stack.order();
    if (!analysis.verdict.loadable())
        return analysis;
    // Judge an agreeing stack, and note small deviations
    analysis.samePlace = findSamePlace(stack);
    analysis.verdict = judge(stack);
    if (analysis.verdict.stack == Stack::gap)
        analysis.resampled = resampled(stack);
    if (!analysis.verdict.loadable())
        return analysis;
    analysis.geometry = stack.geometry();
    analysis.verdict.notes = notesOn(stack, analysis.geometry);
    return analysis;
}

bool continues(const VolumeGeometry& a, const VolumeGeometry& b) {
    constexpr double kParallel = 0.9998;  // one degree
    const dvec3 normal = normalOf(a);
    if (glm::dot(normal, normalOf(b)) < kParallel)
        return false;
    const double gapA = glm::dot(normal, dvec3(a.patientFromIndex[2])),
                 gapB = glm::dot(normal, dvec3(b.patientFromIndex[2]));
    // Heights along the normal, from a's first slice.
    const double endA = gapA * (a.size.z - 1);
    const double startB = glm::dot(normal, dvec3(b.patientFromIndex[3] - a.patientFromIndex[3]));
    const double endB = startB + gapB * (b.size.z - 1);
    const double overlap = std::min(endA, endB) - std::max(0.0, startB);
    if (overlap <= 0.5 * std::min(endA, endB - startB))
        return overlap >= -3 * std::max(gapA, gapB);
    const double phase = std::abs(std::remainder(startB, gapA));
    return std::abs(gapA - gapB) <= 0.1 * gapA && phase > 0.1 * gapA;
}

std::vector<std::vector<int>> splitByGrid(const std::vector<SlicePlane>& slices) {
    std::vector<std::vector<int>> parts;
    for (int i = 0; i < int(slices.size()); ++i) {
        const auto home = std::find_if(parts.begin(), parts.end(),
                                       [&](const auto& part) { return sameGrid(slices[part.front()], slices[i]); });
        if (home == parts.end())
            parts.push_back({i});
        else
            home->push_back(i);
    }
    std::vector<int> singles;
    std::erase_if(parts, [&](const std::vector<int>& part) {
        if (part.size() == 1)
            singles.push_back(part.front());
        return part.size() == 1;
    });
    if (!singles.empty())
        parts.push_back(singles);
    return parts;
}

}  // namespace pdr::dicom
