#include "dicom/stack_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace pdr::dicom {

namespace {

/// "0.793", "5", "2.37": up to three decimals, no trailing zeros.
std::string inMm(double value) {
    char text[64];
    std::snprintf(text, sizeof text, "%.3f", value);
    std::string result = text;
    result.erase(result.find_last_not_of('0') + 1);
    if (result.back() == '.')
        result.pop_back();
    return (result == "-0" ? "0" : result) + " mm";
}

double largest(const dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Empty if the slice says all that is needed to place it; else a sentence.
std::string missingGeometry(const SlicePlane& slice) {
    std::string missing;
    const auto name = [&](bool there, const char* what) {
        if (!there)
            missing += (missing.empty() ? "" : ", ") + std::string(what);
    };
    name(slice.position.has_value(), "position");
    name(slice.rowDirection && slice.columnDirection, "orientation");
    name(slice.spacingMm.has_value(), "pixel spacing");
    if (!missing.empty())
        return slice.name + " does not say its " + missing;
    if (slice.spacingMm->x <= 0 || slice.spacingMm->y <= 0)
        return slice.name + " states a pixel spacing of " + inMm(slice.spacingMm->x) + " x " + inMm(slice.spacingMm->y);
    const double row = glm::length(*slice.rowDirection), column = glm::length(*slice.columnDirection);
    const double cosine = glm::dot(*slice.rowDirection, *slice.columnDirection);
    if (std::abs(row - 1) > kUnitTolerance || std::abs(column - 1) > kUnitTolerance ||
        std::abs(cosine) > kUnitTolerance)
        return slice.name + " states an orientation that is no pair of perpendicular directions";
    return {};
}

bool hasGeometry(const SlicePlane& slice) {
    return missingGeometry(slice).empty();
}

bool sameSize(const SlicePlane& a, const SlicePlane& b) {
    return a.size == b.size;
}

bool sameSpacing(const SlicePlane& a, const SlicePlane& b) {
    const dvec2 difference = glm::abs(*a.spacingMm - *b.spacingMm);
    return difference.x <= 1e-4 * a.spacingMm->x && difference.y <= 1e-4 * a.spacingMm->y;
}

bool sameDirection(const SlicePlane& a, const SlicePlane& b) {
    return largest(*a.rowDirection - *b.rowDirection) <= kDirectionTolerance &&
           largest(*a.columnDirection - *b.columnDirection) <= kDirectionTolerance;
}

bool sameGrid(const SlicePlane& a, const SlicePlane& b) {
    if (!sameSize(a, b) || hasGeometry(a) != hasGeometry(b))
        return false;
    return !hasGeometry(a) || (sameSpacing(a, b) && sameDirection(a, b));
}

std::string sizeText(const SlicePlane& slice) {
    std::string result = std::to_string(slice.size.x) + " x " + std::to_string(slice.size.y) + " pixels";
    if (slice.spacingMm)
        result += " of " + inMm(slice.spacingMm->x) + " x " + inMm(slice.spacingMm->y);
    return result;
}

/// One stack of slices that share a grid, sorted.
class SortedStack {
  public:
    SortedStack(const std::vector<SlicePlane>& slices) : slices_(slices), order_(slices.size()) {
        const SlicePlane& first = slices.front();
        row_ = glm::normalize(*first.rowDirection);
        column_ = glm::normalize(*first.columnDirection);
        normal_ = glm::normalize(glm::cross(row_, column_));
        std::iota(order_.begin(), order_.end(), 0);
        std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) { return heightOf(a) < heightOf(b); });
    }

    const std::vector<int>& order() const { return order_; }
    int count() const { return int(order_.size()); }
    double height(int k) const { return heightOf(order_[k]); }
    const std::string& name(int k) const { return slices_[order_[k]].name; }
    dvec3 position(int k) const { return *slices_[order_[k]].position; }
    double gap() const { return (height(count() - 1) - height(0)) / (count() - 1); }

    /// How far slice k lies sideways of slice 0: along the row, along the column.
    dvec2 drift(int k) const {
        const dvec3 step = position(k) - position(0);
        return {glm::dot(step, row_), glm::dot(step, column_)};
    }

    VolumeGeometry geometry() const {
        const SlicePlane& first = slices_[order_[0]];
        dmat4 map(1.0);
        map[0] = dvec4(row_ * first.spacingMm->x, 0.0);
        map[1] = dvec4(column_ * first.spacingMm->y, 0.0);
        map[2] = dvec4(normal_ * gap(), 0.0);
        map[3] = dvec4(position(0), 1.0);
        return {ivec3(first.size, count()), map};
    }

  private:
    double heightOf(int index) const { return glm::dot(*slices_[index].position, normal_); }

    const std::vector<SlicePlane>& slices_;
    dvec3 row_, column_, normal_;
    std::vector<int> order_;
};

std::vector<std::pair<int, int>> findSamePlace(const SortedStack& stack) {
    std::vector<std::pair<int, int>> pairs;
    int first = 0;
    for (int k = 1; k < stack.count(); ++k) {
        if (glm::distance(stack.position(k), stack.position(first)) <= kPositionToleranceMm)
            pairs.emplace_back(stack.order()[first], stack.order()[k]);
        else
            first = k;
    }
    return pairs;
}

std::string doubledReason(const SortedStack& stack) {
    int doubled = 0, example = 0;
    for (int k = 1; k < stack.count(); ++k) {
        if (stack.height(k) - stack.height(k - 1) > kPositionToleranceMm)
            continue;
        ++doubled;
        example = k;
    }
    if (doubled == 0)
        return {};
    std::string reason = stack.name(example - 1) + " and " + stack.name(example) +
                         " lie at the same height along the normal (" + inMm(stack.height(example)) + ") but differ";
    if (doubled > 1)
        reason += "; " + std::to_string(doubled) + " heights are taken twice";
    return reason;
}

std::string tiltReason(const SortedStack& stack) {
    const int last = stack.count() - 1;
    const dvec2 step = stack.drift(last) / double(last);
    for (int k = 1; k <= last; ++k) {
        const double tolerance = kPositionToleranceMm + kDriftTolerance * (stack.height(k) - stack.height(0));
        const double drift = glm::length(stack.drift(k));
        if (drift <= tolerance)
            continue;
        if (glm::distance(stack.drift(k), step * double(k)) > tolerance)
            return stack.name(k) + " lies " + inMm(drift) + " sideways of " + stack.name(0) +
                   ", and not in one line with the others";
        char degrees[32];
        std::snprintf(degrees, sizeof degrees, "%.1f",
                      std::atan2(glm::length(step), stack.gap()) * 180.0 / 3.14159265358979);
        return "the slices drift sideways by " + inMm(glm::length(step)) + " for each " + inMm(stack.gap()) +
               " of height (gantry tilt of " + degrees + " degrees), from " + stack.name(0) + " to " + stack.name(last);
    }
    return {};
}

std::string gapReason(const SortedStack& stack) {
    const int last = stack.count() - 1;
    std::vector<double> gaps(last);
    for (int k = 0; k < last; ++k)
        gaps[k] = stack.height(k + 1) - stack.height(k);
    std::vector<double> sorted = gaps;
    std::nth_element(sorted.begin(), sorted.begin() + last / 2, sorted.end());
    const double usual = sorted[last / 2];
    int worst = 0;
    for (int k = 1; k < last; ++k) {
        if (std::abs(gaps[k] - usual) > std::abs(gaps[worst] - usual))
            worst = k;
    }
    for (int k = 0; k <= last; ++k) {
        const double off = std::abs(stack.height(k) - stack.height(0) - k * stack.gap());
        if (off <= kPositionToleranceMm)
            continue;
        if (std::abs(gaps[worst] - usual) > kPositionToleranceMm)
            return stack.name(worst) + " and " + stack.name(worst + 1) + " are " + inMm(gaps[worst]) +
                   " apart, the others " + inMm(usual);
        return stack.name(k) + " lies " + inMm(off) + " from where slices every " + inMm(stack.gap()) + " would put it";
    }
    return {};
}

GeometryVerdict judge(const SortedStack& stack) {
    if (stack.count() == 1)
        return {Stack::singleSlice, stack.name(0) + " is one slice; a volume needs at least two", {}};
    if (std::string reason = doubledReason(stack); !reason.empty())
        return {Stack::doubled, reason, {}};
    if (std::string reason = tiltReason(stack); !reason.empty())
        return {Stack::tilted, reason, {}};
    if (std::string reason = gapReason(stack); !reason.empty())
        return {Stack::gap, reason, {}};
    return {Stack::even, "", {}};
}

/// The verdict on slices that cannot share a grid; empty reason if they can.
GeometryVerdict judgeAgreement(const std::vector<SlicePlane>& slices) {
    const SlicePlane& first = slices.front();
    for (const SlicePlane& slice : slices) {
        if (!sameSize(slice, first))
            return {Stack::mixedSize,
                    first.name + " has " + sizeText(first) + ", " + slice.name + " has " + sizeText(slice),
                    {}};
    }
    for (const SlicePlane& slice : slices) {
        if (std::string reason = missingGeometry(slice); !reason.empty())
            return {Stack::noGeometry, reason, {}};
    }
    for (const SlicePlane& slice : slices) {
        if (!sameSpacing(slice, first))
            return {Stack::mixedSize,
                    first.name + " has " + sizeText(first) + ", " + slice.name + " has " + sizeText(slice),
                    {}};
        if (!sameDirection(slice, first))
            return {Stack::mixedOrientation, first.name + " and " + slice.name + " look in different directions", {}};
    }
    return {Stack::even, "", {}};
}

}  // namespace

StackAnalysis analyseStack(const std::vector<SlicePlane>& slices) {
    StackAnalysis analysis;
    analysis.order.resize(slices.size());
    std::iota(analysis.order.begin(), analysis.order.end(), 0);
    analysis.verdict = judgeAgreement(slices);
    const auto sizeOfFirst = [&](const SlicePlane& slice) { return sameSize(slice, slices.front()); };
    if (std::all_of(slices.begin(), slices.end(), sizeOfFirst))
        analysis.geometry.size = ivec3(slices.front().size, int(slices.size()));
    if (!std::all_of(slices.begin(), slices.end(), hasGeometry))
        return analysis;
    const SortedStack stack(slices);
    analysis.order = stack.order();
    if (!analysis.verdict.loadable())
        return analysis;
    analysis.samePlace = findSamePlace(stack);
    analysis.verdict = judge(stack);
    if (analysis.verdict.loadable())
        analysis.geometry = stack.geometry();
    return analysis;
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
