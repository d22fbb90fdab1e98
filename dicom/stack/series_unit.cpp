#include "dicom/stack/series_unit.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "dicom/read/refusal.h"

namespace pdr::dicom {

namespace {

using Slices = std::vector<const SliceHeader*>;

/// Slope and intercept of one slice, or of all.
using Scale = std::pair<double, double>;

struct Range {
    double lowest = 0, highest = 0;
};

Scale scaleOf(const SliceHeader& slice) {
    return {slice.meaning.slope.value_or(1), slice.meaning.intercept.value_or(0)};
}

/// Returns the numbers that a pixel of `format` can store.
Range storedRange(const PixelFormat& format) {
    const double count = std::exp2(format.bitsStored);
    return format.isSigned ? Range{-count / 2, count / 2 - 1} : Range{0, count - 1};
}

bool haveOneScale(const Slices& slices) {
    return std::ranges::all_of(slices, [&](const auto* each) { return scaleOf(*each) == scaleOf(*slices.front()); });
}

/// Returns the numbers that a pixel of any slice can store.
Range storedRange(const Slices& slices) {
    Range all = storedRange(slices.front()->format);
    for (const SliceHeader* slice : slices) {
        const Range range = storedRange(slice->format);
        all = {std::min(all.lowest, range.lowest), std::max(all.highest, range.highest)};
    }
    return all;
}

/// Returns the values that a pixel of any slice can stand for.
Range valueRange(const Slices& slices) {
    Range all{INFINITY, -INFINITY};
    for (const SliceHeader* slice : slices) {
        const auto [slope, intercept] = scaleOf(*slice);
        const Range stored = storedRange(slice->format);
        const double a = slope * stored.lowest + intercept, b = slope * stored.highest + intercept;
        all = {std::min({all.lowest, a, b}), std::max({all.highest, a, b})};
    }
    return all;
}

/// Returns how far voxels that are stored numbers, or their negatives, must move to lie within 16 bits.
double shiftOf(const Range& voxels) {
    if (voxels.highest > INT16_MAX)
        return voxels.highest - INT16_MAX;
    return voxels.lowest < INT16_MIN ? voxels.lowest - INT16_MIN : 0;
}

/// Returns the name that clinicians know instead of a PET unit (PS3.3, C.8.9.1.1.3), or the name as it is.
std::string knownName(const std::string& name) {
    if (name == "BQML")
        return "Bq/ml";
    return name == "GML" ? "g/ml" : name == "CNTS" ? "counts" : name;
}

/// Returns the name of the slices' unit; empty if none is stated, or several are. "US" stands for unspecified.
std::string nameOf(const Slices& slices) {
    std::set<std::string> names;
    for (const SliceHeader* slice : slices) {
        const ValueMeaning& meaning = slice->meaning;
        const bool isByType = meaning.name.empty() && meaning.unit != "US" && meaning.unit != "HU";
        names.insert(isByType ? meaning.unit : meaning.name);
    }
    return names.size() == 1 ? knownName(*names.begin()) : std::string();
}

}  // namespace

ValueUnit seriesUnit(const Slices& slices) {
    if (std::ranges::all_of(slices, [](const auto* slice) { return isInHu(*slice); }))
        return {};
    if (!haveOneScale(slices)) {
        const Range values = valueRange(slices);
        const double step = (values.highest - values.lowest) / UINT16_MAX;
        return ValueUnit::other(nameOf(slices), step, values.lowest - INT16_MIN * step);
    }
    const auto [slope, intercept] = scaleOf(*slices.front());
    Range voxels = storedRange(slices);
    if (slope < 0)
        voxels = {-voxels.highest, -voxels.lowest};
    const double step = std::abs(slope);
    if (step == 0)
        return ValueUnit::other(nameOf(slices));  // of images that are refused for it
    const bool areWhole = step == 1 && intercept == std::floor(intercept);
    if (areWhole && voxels.lowest + intercept >= INT16_MIN && voxels.highest + intercept <= INT16_MAX)
        return ValueUnit::other(nameOf(slices));
    return ValueUnit::other(nameOf(slices), step, intercept + shiftOf(voxels) * step);
}

void noteUnit(const Slices& slices, const ValueUnit& unit, std::vector<Note>& notes) {
    if (unit.isHu)
        return;
    const std::string& quantity = slices.front()->meaning.quantity;
    const std::string& what = quantity.empty() ? unit.name : quantity;
    notes.push_back(
        {std::string(kNoHu),
         what.empty() ? phrase("the files do not say that the values are HU: looks, windows and parts of the body that "
                               "need HU are not offered")
                      : phrase("the values are no HU but another quantity (%1): looks, windows and parts of the body "
                               "that need HU are not offered",
                               what)});
    if (!haveOneScale(slices))
        notes.push_back({"rounded", phrase("the slices scale their values differently; all are rounded to steps of %1",
                                           numberOf(unit.step, 3))});
}

}  // namespace pdr::dicom
