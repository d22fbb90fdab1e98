#include "dicom/stack/sorted_stack.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pdr::dicom {

namespace {

/// Returns how far slices that are `gap` apart may lie from an even grid [mm].
double toleranceOf(double gap) {
    return std::max(0.02, std::min(0.1 * gap, 0.15));
}

/// Returns the slices without those that repeat the height of the one before.
std::vector<int> differentHeights(const SortedStack& stack) {
    std::vector<int> kept{0};
    for (int k = 1; k < stack.count(); ++k) {
        if (stack.height(k) - stack.height(kept.back()) > kSamePlaceMm)
            kept.push_back(k);
    }
    return kept;
}

Text doubledReason(const SortedStack& stack) {
    int doubled = 0, example = 0;
    for (int k = 1; k < stack.count(); ++k) {
        if (stack.height(k) - stack.height(k - 1) > kSamePlaceMm)
            continue;
        ++doubled;
        example = k;
    }
    if (doubled == 0)
        return {};
    const Text reason = phrase("%1 and %2 lie at the same height along the normal (%3 mm) but differ",
                               stack.name(example - 1), stack.name(example), inMm(stack.height(example)));
    return doubled > 1 ? phrase("%1; %2 heights are taken twice", reason, doubled) : reason;
}

/// Returns how far slice k lies beside the straight line from the first slice to the last [mm].
double besideTheLine(const SortedStack& stack, int k) {
    const int last = stack.count() - 1;
    const double fraction = (stack.height(k) - stack.height(0)) / (stack.height(last) - stack.height(0));
    return glm::distance(stack.drift(k), stack.drift(last) * fraction);
}

/// Returns which slice lies farthest sideways of the straight line from the first to the last, beyond what rounding
/// explains; 0: all lie on it.
int mostCrooked(const SortedStack& stack) {
    int crooked = 0;
    double most = 0;
    for (int k = 1; k < stack.count(); ++k)
        if (const double beyond = besideTheLine(stack, k) - stack.sidewaysToleranceMm(k); beyond > most) {
            crooked = k;
            most = beyond;
        }
    return crooked;
}

/// Returns why the slices do not lie above each other as even a tilted gantry takes them; empty if they do.
Text tiltReason(const SortedStack& stack) {
    const int last = stack.count() - 1;
    if (stack.isUpright())
        return {};
    if (const int crooked = mostCrooked(stack); crooked != 0)
        return phrase("%1 lies %2 mm sideways of the straight line from %3 to %4", stack.name(crooked),
                      inMm(besideTheLine(stack, crooked)), stack.name(0), stack.name(last));
    const double drift = glm::length(stack.drift(last)), height = stack.height(last) - stack.height(0);
    const double degrees = std::atan2(drift, height) * 180.0 / 3.14159265358979;
    if (degrees <= kMostTiltDegrees)
        return {};
    const Text how =
        phrase("the slices drift sideways by %1 mm for each %2 mm of height (gantry tilt of %3 degrees), from %4 to %5",
               inMm(drift / last), inMm(stack.gap()), fixedNumber(degrees, 1), stack.name(0), stack.name(last));
    return phrase("%1; no gantry tilts by more than %2 degrees", how, int(kMostTiltDegrees));
}

Text gapReason(const SortedStack& stack) {
    const std::vector<int> at = differentHeights(stack);
    const std::size_t last = at.size() - 1;
    if (last < 1)
        return {};
    // Find the usual gap, and the even grid
    std::vector<double> gaps(last), heights{stack.height(at[0])};
    for (std::size_t k = 0; k < last; ++k) {
        heights.push_back(stack.height(at[k + 1]));
        gaps[k] = heights[k + 1] - heights[k];
    }
    std::vector<double> sorted = gaps;
    std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(last / 2), sorted.end());
    const double usual = sorted[last / 2];
    const EvenHeights even = evenHeightsAt(heights);
    // Find the worst gap, and the slice furthest from an even position
    std::size_t worst = 0, furthest = 0;
    const auto off = [&](std::size_t k) { return std::abs(heights[k] - even.at(int(k))); };
    for (std::size_t k = 0; k <= last; ++k) {
        if (k < last && std::abs(gaps[k] - usual) > std::abs(gaps[worst] - usual))
            worst = k;
        if (off(k) > off(furthest))
            furthest = k;
    }
    const double tolerance = toleranceOf(usual);
    if (off(furthest) <= tolerance)
        return {};
    if (std::abs(gaps[worst] - usual) > tolerance)
        return phrase("%1 and %2 are %3 mm apart, the others %4 mm", stack.name(at[worst]), stack.name(at[worst + 1]),
                      inMm(gaps[worst]), inMm(usual));
    return phrase("%1 lies %2 mm from where slices every %3 mm would put it", stack.name(at[furthest]),
                  inMm(off(furthest)), inMm(even.gap));
}

Text withGaps(const Text& reason, const SortedStack& stack) {
    const Text gaps = gapReason(stack);
    return gaps.empty() ? reason : phrase("%1; besides, %2", reason, gaps);
}

}  // namespace

EvenHeights evenHeightsAt(const std::vector<double>& heights) {
    const int last = int(heights.size()) - 1;
    if (last < 1)
        return {heights[0], 0};
    EvenHeights even{heights[0], (heights[std::size_t(last)] - heights[0]) / last};
    double furthest = 0, sum = 0, moment = 0, squares = 0;
    for (int k = 0; k <= last; ++k) {
        const double off = heights[std::size_t(k)] - even.at(k), fromMiddle = k - 0.5 * last;
        furthest = std::max(furthest, std::abs(off));
        sum += off;
        moment += fromMiddle * off;
        squares += fromMiddle * fromMiddle;
    }
    if (furthest <= kSamePlaceMm)
        return even;
    const double wider = moment / squares;
    return {even.start + sum / (last + 1) - 0.5 * last * wider, even.gap + wider};
}

SortedStack::SortedStack(const std::vector<SlicePlane>& slices) : slices_(slices), order_(slices.size()) {
    const SlicePlane& first = slices.front();
    row_ = glm::normalize(*first.rowDirection);
    column_ = glm::normalize(*first.columnDirection);
    normal_ = glm::normalize(glm::cross(row_, column_));
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) { return heightOf(a) < heightOf(b); });
    std::vector<double> heights;
    for (const int index : order_)
        heights.push_back(heightOf(index));
    even_ = evenHeightsAt(heights);
    followDrift();
}

/// Fits an even drift to the slices, where they do not lie upright above each other.
void SortedStack::followDrift() {
    for (int k = 0; k < count(); ++k)
        isUpright_ = isUpright_ && glm::length(drift(k)) <= sidewaysToleranceMm(k);
    if (isUpright_)
        return;
    std::vector<double> alongRow, alongColumn;
    for (int k = 0; k < count(); ++k) {
        alongRow.push_back(drift(k).x);
        alongColumn.push_back(drift(k).y);
    }
    evenRow_ = evenHeightsAt(alongRow);
    evenColumn_ = evenHeightsAt(alongColumn);
}

double SortedStack::toleranceMm() const {
    return toleranceOf(gap());
}

double SortedStack::sidewaysToleranceMm(int k) const {
    return toleranceMm() + kDriftTolerance * (height(k) - height(0));
}

double SortedStack::unevennessMm() const {
    double worst = 0;
    for (int k = 0; k < count(); ++k)
        worst = std::max(worst, glm::length(dvec3(drift(k) - evenDrift(k), height(k) - evenHeight(k))));
    return worst;
}

dvec2 SortedStack::drift(int k) const {
    const dvec3 step = position(k) - position(0);
    return {glm::dot(step, row_), glm::dot(step, column_)};
}

VolumeGeometry SortedStack::geometry() const {
    const SlicePlane& first = slices_[order_[0]];
    dmat4 map(1.0);
    map[0] = dvec4(row_ * first.spacingMm->x, 0.0);
    map[1] = dvec4(column_ * first.spacingMm->y, 0.0);
    map[2] = dvec4(normal_ * gap(), 0.0);
    map[3] = dvec4(position(0) + (evenHeight(0) - height(0)) * normal_, 1.0);
    if (!isUpright_) {
        const dvec2 step = evenDrift(1) - evenDrift(0), start = evenDrift(0);
        map[2] += dvec4(step.x * row_ + step.y * column_, 0.0);
        map[3] += dvec4(start.x * row_ + start.y * column_, 0.0);
    }
    return {ivec3(first.size, count()), map};
}

VolumeGeometry SortedStack::geometryOf(int slices) const {
    VolumeGeometry grid = geometry();
    const dvec3 across = position(count() - 1) - position(0);
    grid.size.z = slices;
    grid.patientFromIndex[2] =
        dvec4((isUpright_ ? glm::dot(across, normal_) * normal_ : across) / double(slices - 1), 0.0);
    grid.patientFromIndex[3] = dvec4(position(0), 1.0);
    return grid;
}

double SortedStack::gridDeviationMm() const {
    double worst = 0;
    for (const SlicePlane& slice : slices_)
        worst = std::max(worst, dicom::gridDeviationMm(slices_[order_[0]], slice));
    return worst;
}

std::vector<std::pair<int, int>> findSamePlace(const SortedStack& stack) {
    std::vector<std::pair<int, int>> pairs;
    int first = 0;
    for (int k = 1; k < stack.count(); ++k) {
        if (glm::distance(stack.position(k), stack.position(first)) <= kSamePlaceMm)
            pairs.emplace_back(stack.order()[first], stack.order()[k]);
        else
            first = k;
    }
    return pairs;
}

GeometryVerdict judge(const SortedStack& stack) {
    if (stack.count() == 1)
        return {Stack::singleSlice, phrase("%1 is one slice; a volume needs at least two", stack.name(0)), {}};
    if (const Text reason = doubledReason(stack); !reason.empty())
        return {Stack::doubled, withGaps(reason, stack), {}};
    if (const Text reason = tiltReason(stack); !reason.empty())
        return {Stack::tilted, withGaps(reason, stack), {}};
    if (const Text reason = gapReason(stack); !reason.empty())
        return {Stack::gap, reason, {}};
    return {Stack::even, "", {}};
}

}  // namespace pdr::dicom
