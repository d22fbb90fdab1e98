#pragma once
/// Steps in which the fields of the tissue editor move a place: fine enough for the values that a scan has, in whole
/// HU.

#include <QString>

#include "render/volume/value_unit.h"
#include "ui/tissue/plot_view.h"

namespace pdr::ui {

/// Returns the step of a field [values]: 1 HU; of other values the power of ten at a thousandth of `span` [voxels], the
/// range that a plot shows, or below it.
double placeStep(const ValueUnit& values, double span);

/// Returns how many digits behind the decimal point a field shows, so that it tells voxels and steps apart.
int placeDecimals(const ValueUnit& values, double step);

/// Returns a place [voxels] as users read it: a whole one as it is, others as exactly as `view` can show them.
QString placeText(const PlotView& view, const ValueUnit& values, double place);

}  // namespace pdr::ui
