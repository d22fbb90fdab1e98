#pragma once
/// Judges slices as a stack, from their positions. Pure geometry: independent of files, tags and pixels.
///   lengths  millimetres, patient space LPS        normal  row direction x column direction
///
/// Tolerances, and why:
///   position    a tenth of the gap off the even grid, at least 0.02 mm and at most 0.15 mm, a fifth of a pixel:
///               writers round positions to a tenth of a millimetre, and tables do not move evenly. A note names the
///               largest from 0.02 mm on. Slices within 0.02 mm lie at one place. A slice that is missing puts its
///               neighbours half a gap off.
///   drift       the same, plus 1e-4 of the distance travelled along the normal: direction cosines that were rounded to
///               four decimals turn the normal by that much. A drift beyond that which is even along a straight line,
///               up to 40 degrees, is a tilted gantry: the grid is sheared. The tilt that files state (0018,1120) is
///               never read: it is absent in some, and its sign is not defined.
///   grid        0.2 mm at the far corner of a slice (slice_plane.h); a note names the largest from 0.01 mm on.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dicom/series.h"
#include "dicom/stack/slice_plane.h"

namespace pdr::dicom {

/// An even stack in the place of an uneven one (even_fill.h).
struct ResampledStack {
    std::vector<SliceBlend> blends;  ///< by the place of the measured slices in StackAnalysis::order
    VolumeGeometry geometry;
    std::vector<Note> notes;  ///< what was done, in millimetres
};

struct StackAnalysis {
    GeometryVerdict verdict;
    /// Indices of the slices, ascending along the normal of the first; in the order given if one has no geometry.
    std::vector<int> order;
    /// Complete for Stack::even; otherwise only `size` is set, if the slices agree on it.
    VolumeGeometry geometry;
    /// Pairs at the same position (each with the first one there): copies, or two different images.
    std::vector<std::pair<int, int>> samePlace;
    /// For Stack::gap: what can be shown if it is asked for.
    std::optional<ResampledStack> resampled;
};

/// Judges `slices`, of which there must be at least one.
StackAnalysis analyseStack(const std::vector<SlicePlane>& slices);

/// Returns whether two even stacks of one series are pieces of one: parallel, and one continues where the other ends or
/// fills its gaps. Two images of the same place are not.
bool continues(const VolumeGeometry& a, const VolumeGeometry& b);

/// Splits the slices of one series into parts that can share a grid (sameGrid). Parts with one slice only are gathered
/// in one last part. Returns indices, in the order given.
std::vector<std::vector<int>> splitByGrid(const std::vector<SlicePlane>& slices);

}  // namespace pdr::dicom
