#include "dicom/stack/slice_plane.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render/volume/volume.h"

namespace pdr::dicom {

namespace {

double largest(const dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

bool hasGeometry(const SlicePlane& slice) {
    return missingGeometry(slice).empty();
}

}  // namespace

Text inMm(double value) {
    char text[64];
    std::snprintf(text, sizeof text, "%.3f", value);
    std::string result = text;
    result.erase(result.find_last_not_of('0') + 1);
    if (result.back() == '.')
        result.pop_back();
    return Text::number(result == "-0" ? "0" : result);
}

/// Returns a sentence that says what is missing or unusable to place the slice; empty if nothing is.
Text missingGeometry(const SlicePlane& slice) {
    Text missing;
    const auto name = [&](bool there, const Text& what) {
        if (!there)
            missing = missing.empty() ? what : phrase("%1, %2", missing, what);
    };
    name(slice.position.has_value(), phrase("position"));
    name(slice.rowDirection && slice.columnDirection, phrase("orientation"));
    name(slice.spacingMm.has_value(), phrase("pixel spacing"));
    if (!missing.empty())
        return phrase("%1 does not say its %2", slice.name, missing);
    if (!(slice.spacingMm->x >= kLowestSpacingMm && slice.spacingMm->y >= kLowestSpacingMm))
        return phrase("%1 states a pixel spacing of %2 mm x %3 mm", slice.name, numberOf(slice.spacingMm->x),
                      numberOf(slice.spacingMm->y));
    const double row = glm::length(*slice.rowDirection), column = glm::length(*slice.columnDirection);
    const double cosine = glm::dot(*slice.rowDirection, *slice.columnDirection);
    if (std::abs(row - 1) > kUnitTolerance || std::abs(column - 1) > kUnitTolerance ||
        std::abs(cosine) > kUnitTolerance)
        return phrase("%1 states an orientation that is no pair of perpendicular directions", slice.name);
    return {};
}

double gridDeviationMm(const SlicePlane& a, const SlicePlane& b) {
    const dvec3 column = *b.columnDirection * b.spacingMm->y - *a.columnDirection * a.spacingMm->y;
    const dvec3 row = *b.rowDirection * b.spacingMm->x - *a.rowDirection * a.spacingMm->x;
    const dvec2 last = dvec2(b.size) - 1.0;
    return std::max(
        {glm::length(row * last.x), glm::length(column * last.y), glm::length(row * last.x + column * last.y)});
}

bool sameDirection(const SlicePlane& a, const SlicePlane& b) {
    return largest(*a.rowDirection - *b.rowDirection) <= kGridTolerance &&
           largest(*a.columnDirection - *b.columnDirection) <= kGridTolerance;
}

bool sameSpacing(const SlicePlane& a, const SlicePlane& b) {
    const dvec2 difference = glm::abs(*a.spacingMm - *b.spacingMm);
    return difference.x <= kGridTolerance * a.spacingMm->x && difference.y <= kGridTolerance * a.spacingMm->y;
}

bool sameGrid(const SlicePlane& a, const SlicePlane& b) {
    if (a.size != b.size || hasGeometry(a) != hasGeometry(b))
        return false;
    return !hasGeometry(a) || (sameSpacing(a, b) && sameDirection(a, b) && gridDeviationMm(a, b) <= kGridToleranceMm);
}

Text sizeText(const SlicePlane& slice) {
    if (!slice.spacingMm)
        return phrase("%1 x %2 pixels", slice.size.x, slice.size.y);
    return phrase("%1 x %2 pixels of %3 mm x %4 mm", slice.size.x, slice.size.y, inMm(slice.spacingMm->x),
                  inMm(slice.spacingMm->y));
}

}  // namespace pdr::dicom
