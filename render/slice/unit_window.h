#pragma once
/// Grey windows in the values that a volume's voxels stand for, and in the voxels themselves.

#include <optional>

#include "render/slice/grey_window.h"
#include "render/volume/value_unit.h"
#include "render/volume/volume.h"

namespace pdr {

/// Returns the window for voxels that a window for values stands for. Where voxels are no values, LINEAR becomes
/// LINEAR_EXACT with the same black and white, since it counts from the middles of whole numbers (PS3.3, C.11.2.1.2.1).
GreyWindow inVoxels(const GreyWindow& window, const ValueUnit& unit);
/// Returns the window for values that a window for voxels stands for.
GreyWindow inValues(const GreyWindow& window, const ValueUnit& unit);

/// Returns the window that slices of `volume` begin with: the one that its files state, in values, or else, of HU that
/// of soft tissue, of other values their whole range.
GreyWindow firstWindow(const Volume& volume, const std::optional<GreyWindow>& stated);

}  // namespace pdr
