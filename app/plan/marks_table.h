#pragma once
/// The measurements of a plan as a table: the one source for the files, the command line and whatever else lists them.
/// Texts are English.

#include <string>
#include <string_view>
#include <vector>

#include "app/plan/measured.h"
#include "app/plan/plan_file.h"

namespace pdr::app {

struct MarkRow {
    std::uint64_t id = 0;
    MeasureKind kind = MeasureKind::distance;
    std::string name;                    ///< what the user calls it; empty: nothing
    std::string title;                   ///< the name, or else "Distance 2" for the second distance of the plan
    Result<Measured> value;              ///< an error says why there is none
    std::vector<measure::Place> places;  ///< as many as its kind has
};

/// The largest number of places that a measurement has, unless it is a polygon.
inline constexpr std::size_t kMostPlaces = 4;

/// Returns the measurements of `plan`, in its order, with what they say of `volume`: the scan as the plan shows it.
std::vector<MarkRow> marksTable(const Plan& plan, const Volume& volume);

/// Returns the measurements of a plan whose scan is not at hand. Its voxels are then not known, nor how its grid lies
/// in the patient: a value that depends on them is an error.
std::vector<MarkRow> marksTableWithoutScan(const SavedPlan& saved);

/// Returns the value as users read it, "42.3 ± 0.5 mm", or the sentence that says why there is none.
std::string readable(const MarkRow& row);

/// Returns the kind as plan files name it: "distance".
std::string_view kindWord(MeasureKind kind);
/// Returns how a place was found, as plan files name it: "atEdge".
std::string_view foundWord(measure::Found found);
/// Returns the bound as files name it: "atMost", "atLeast"; empty: the value is no bound.
std::string_view boundWord(measure::Bound bound);
/// Returns the unit of the value as files name it: "mm", "deg", "mm2", "HU"; of values that are no HU their own, and
/// empty where the scan states none.
std::string unitWord(const Measured& measured);
/// Returns whether the figures of a region are in HU.
bool isInHu(const Measured& measured);
/// Returns how many decimals of a value, and of a region's figures, files state: more than there are reasons for.
int valueDecimals(const Measured& measured);
int figureDecimals(const Measured& measured);

}  // namespace pdr::app
