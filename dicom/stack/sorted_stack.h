#pragma once
/// Slices that share a grid, sorted along their normal, and what keeps them from being an even, upright stack.

#include <string>
#include <utility>
#include <vector>

#include "dicom/series.h"
#include "dicom/stack/slice_plane.h"

namespace pdr::dicom {

inline constexpr double kPositionToleranceMm = 0.02;
inline constexpr double kDriftTolerance = 1e-4;

/// One stack of slices that share a grid, sorted.
class SortedStack {
  public:
    /// At least one slice, all with geometry; they must outlive this.
    explicit SortedStack(const std::vector<SlicePlane>& slices);

    const std::vector<int>& order() const { return order_; }
    int count() const { return int(order_.size()); }
    double height(int k) const { return heightOf(order_[k]); }
    const std::string& name(int k) const { return slices_[order_[k]].name; }
    dvec3 position(int k) const { return *slices_[order_[k]].position; }
    double gap() const { return (height(count() - 1) - height(0)) / (count() - 1); }

    /// How far slice k lies sideways of slice 0: along the row, along the column.
    dvec2 drift(int k) const;
    /// The grid of the lowest slice, with the mean distance between slices.
    VolumeGeometry geometry() const;
    /// How far a pixel of any slice lies at the most from that grid, for its spacing and directions [mm].
    double gridDeviationMm() const;

  private:
    double heightOf(int index) const { return glm::dot(*slices_[index].position, normal_); }

    const std::vector<SlicePlane>& slices_;
    dvec3 row_, column_, normal_;
    std::vector<int> order_;
};

/// Pairs at the same position, each with the first one there.
std::vector<std::pair<int, int>> findSamePlace(const SortedStack& stack);

/// Even, or what is wrong first: one slice, doubled heights, tilt, uneven gaps. What else is wrong is named as well.
GeometryVerdict judge(const SortedStack& stack);

}  // namespace pdr::dicom
