#pragma once
/// Values of voxels as users read them, with their unit: a number that is no HU must not look like one.

#include <QString>

#include "render/volume/value_unit.h"

namespace pdr::ui {

/// Returns what stands behind numbers of `unit`: "HU", "Bq/ml", "(no unit)".
QString unitName(const ValueUnit& unit);

/// Returns the value of a voxel, or between voxels, without its unit, as the language writes it; no "-0". `part` of a
/// voxel, at most 1: the distance of places that are told apart by their digits.
QString valueNumber(const ValueUnit& unit, double voxel, double part = 1);

/// Returns the value of a voxel with its unit: "40 HU", "12.5 Bq/ml", "812 (no unit)".
QString valueText(const ValueUnit& unit, double voxel, double part = 1);

}  // namespace pdr::ui
