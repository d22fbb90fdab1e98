#include "render/scene/edit/curve.h"

#include <algorithm>
#include <iterator>

namespace pdr {
namespace {

bool isSelected(const CurveSelection& selection, std::size_t index) {
    return std::binary_search(selection.begin(), selection.end(), index);
}

/// Returns how far the selected points can move in hu, `by` at most, without passing another point or an end.
float possibleShift(const Curve& curve, const CurveSelection& selection, float by) {
    for (const std::size_t i : selection) {
        if (by < 0 && !(i > 0 && isSelected(selection, i - 1)))
            by = std::max(by, (i > 0 ? curve[i - 1].hu : kLowestHu) - curve[i].hu);
        if (by > 0 && !isSelected(selection, i + 1))
            by = std::min(by, (i + 1 < curve.size() ? curve[i + 1].hu : kHighestHu) - curve[i].hu);
    }
    return by;
}

/// Returns the value just left of `hu`.
float valueBefore(const Curve& curve, float hu) {
    const auto next = std::lower_bound(curve.begin(), curve.end(), hu,
                                       [](const CurvePoint& point, float at) { return point.hu < at; });
    if (next == curve.begin() || next == curve.end())
        return next == curve.begin() ? curve.front().value : curve.back().value;
    const CurvePoint &a = *std::prev(next), &b = *next;
    return a.value + (b.value - a.value) * (hu - a.hu) / (b.hu - a.hu);
}

/// Returns where both curves cross between `begin` and `end`, between which neither has a point; `end` if they do not.
float crossing(const Curve& a, const Curve& b, float begin, float end) {
    const float before = valueAt(a, begin) - valueAt(b, begin), after = valueBefore(a, end) - valueBefore(b, end);
    return before * after < 0 ? begin + (end - begin) * before / (before - after) : end;
}

}  // namespace

float valueAt(const Curve& curve, float hu) {
    const auto next = std::upper_bound(curve.begin(), curve.end(), hu,
                                       [](float at, const CurvePoint& point) { return at < point.hu; });
    if (next == curve.begin() || next == curve.end())
        return next == curve.begin() ? curve.front().value : curve.back().value;
    const CurvePoint &a = *std::prev(next), &b = *next;
    return a.value + (b.value - a.value) * (hu - a.hu) / (b.hu - a.hu);
}

float heightOf(const Curve& curve) {
    return std::ranges::max_element(curve, {}, &CurvePoint::value)->value;
}

float firstAt(const Curve& curve, float value) {
    for (std::size_t i = 0; i < curve.size(); ++i)
        if (curve[i].value >= value) {
            if (i == 0 || curve[i].value == curve[i - 1].value)
                return curve[i].hu;
            const CurvePoint &a = curve[i - 1], &b = curve[i];
            return a.hu + (b.hu - a.hu) * (value - a.value) / (b.value - a.value);
        }
    return curve.back().hu;
}

std::size_t insertPoint(Curve& curve, const CurvePoint& point) {
    const auto place = std::upper_bound(curve.begin(), curve.end(), point.hu,
                                        [](float hu, const CurvePoint& other) { return hu < other.hu; });
    const std::ptrdiff_t index = place - curve.begin();
    curve.insert(place, point);
    return std::size_t(index);
}

/// Clamps the moved points to the neighbours that stay, because the rounding of a sum could make them pass.
Curve moved(Curve curve, const CurveSelection& selection, CurvePoint by, float top) {
    const float shift = possibleShift(curve, selection, by.hu);
    for (const std::size_t i : selection) {
        curve[i].hu += shift;
        curve[i].value = std::clamp(curve[i].value + by.value, 0.0f, top);
    }
    float below = kLowestHu, above = kHighestHu;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        if (isSelected(selection, i))
            curve[i].hu = std::max(curve[i].hu, below);
        below = curve[i].hu;
    }
    for (std::size_t i = curve.size(); i-- > 0;) {
        if (isSelected(selection, i))
            curve[i].hu = std::min(curve[i].hu, above);
        above = curve[i].hu;
    }
    return curve;
}

Curve without(const Curve& curve, const CurveSelection& selection) {
    Curve rest;
    for (std::size_t i = 0; i < curve.size(); ++i)
        if (!isSelected(selection, i))
            rest.push_back(curve[i]);
    return rest.empty() ? Curve{curve.front()} : rest;
}

Curve larger(const Curve& a, const Curve& b) {
    std::vector<float> places;
    for (const Curve* curve : {&a, &b})
        for (const CurvePoint& point : *curve)
            places.push_back(point.hu);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    Curve result;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const float hu = places[i];
        const float left = std::max(valueBefore(a, hu), valueBefore(b, hu));
        const float right = std::max(valueAt(a, hu), valueAt(b, hu));
        if (left != right)
            result.push_back({hu, left});
        result.push_back({hu, right});
        const float next = i + 1 < places.size() ? places[i + 1] : hu;
        if (const float cross = crossing(a, b, hu, next); cross > hu && cross < next)
            result.push_back({cross, valueAt(a, cross)});
    }
    return result;
}

}  // namespace pdr
