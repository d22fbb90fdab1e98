#pragma once
/// Reads what tells an image from others of its place, from the object itself or from the groups of a frame.

#include <string>

#include "dicom/read/functional_groups.h"
#include "dicom/read/slice_header.h"

class DcmItem;

namespace pdr::dicom {

/// Returns the values that `item` states, by PhaseKey; empty: not stated. Numbers have no superfluous digits. The
/// diffusion is the b-value [s/mm²], and behind it, where there is one, the direction of its gradient in the patient
/// (LPS, two decimals): "1000 0.71 0.71 0".
PhaseValues phaseValues(DcmItem& item);

/// Overwrites the values that the groups of a frame state. What a legacy converted image leaves unassigned is used
/// where no group states it.
void readPhaseValues(const FunctionalGroups& groups, PhaseValues& values);

}  // namespace pdr::dicom
