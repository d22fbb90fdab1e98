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

Scale scaleOf(const SliceHeader& slice) {
    return {slice.meaning.slope.value_or(1), slice.meaning.intercept.value_or(0)};
}

bool haveOneScale(const Slices& slices) {
    return std::ranges::all_of(slices, [&](const auto* each) { return scaleOf(*each) == scaleOf(*slices.front()); });
}

/// Returns the steps of values that slices of one scale store as whole numbers.
ValueSteps stepsOf(const Slices& slices) {
    if (slices.front()->realBits != 0 || !haveOneScale(slices))
        return {};
    const auto [slope, intercept] = scaleOf(*slices.front());
    return {std::abs(slope), intercept};
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

FittedUnit seriesUnit(const Slices& slices, const ValueRange& range) {
    if (std::ranges::all_of(slices, [](const auto* slice) { return isInHu(*slice); }))
        return {};
    return range.isFinite() ? fittedUnit(nameOf(slices), range, stepsOf(slices))
                            : FittedUnit{ValueUnit::other(nameOf(slices))};
}

Note roundingNote(const ValueUnit& unit) {
    return {"rounded", phrase("the values are rounded to steps of %1, 65,536 from the lowest to the highest",
                              numberOf(unit.step, 3))};
}

void noteUnit(const Slices& slices, const FittedUnit& fitted, std::vector<Note>& notes) {
    const ValueUnit& unit = fitted.unit;
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
    if (fitted.isExact)
        return;
    notes.push_back(haveOneScale(slices)
                        ? roundingNote(unit)
                        : Note{"rounded", phrase("the slices scale their values differently; all are rounded to steps "
                                                 "of %1",
                                                 numberOf(unit.step, 3))});
}

}  // namespace pdr::dicom
