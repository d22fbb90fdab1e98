#pragma once
/// Splits images that were taken several times at each place into phases: of the heart, of a contrast agent, two
/// energies, echoes, or diffusion gradients.

#include <vector>

#include "dicom/read/slice_header.h"

namespace pdr::dicom {

/// Slices of one phase.
struct Phase {
    std::vector<const SliceHeader*> slices;
    Text name;  ///< a phrase ("40 % of the heartbeat"); empty: they are not split
};

/// Splits `slices`, which share a grid, by the first of the PhaseKeys by whose values every place is taken once in each
/// phase, or else by the first two of them (a stack, and a point in time), and all phases have the same number of
/// slices, or one more or fewer. Phases ascend by value. Returns `slices` as one phase without a name if no place is
/// taken twice, or no key splits them so.
std::vector<Phase> phasesOf(const std::vector<const SliceHeader*>& slices);

}  // namespace pdr::dicom
