#pragma once
/// Slices that share a grid, sorted along their normal, and the reasons why they are not an even stack: one in which
/// each slice lies as the one before, moved by the same step. A tilted gantry makes the step lead sideways too.

#include <string>
#include <utility>
#include <vector>

#include "dicom/series.h"
#include "dicom/stack/slice_plane.h"

namespace pdr::dicom {

/// Largest distance of slices that lie at one place [mm].
inline constexpr double kSamePlaceMm = 0.02;
inline constexpr double kDriftTolerance = 1e-4;
/// Largest tilt of a gantry that is believed. Scanners tilt by up to 30 degrees.
inline constexpr double kMostTiltDegrees = 40;

/// Heights, or drifts sideways, at even distances [mm].
struct EvenHeights {
    double start = 0, gap = 0;
    double at(int k) const { return start + gap * k; }
};

/// Returns even heights that fit `heights`: those from the first to the last or, if one lies farther off
/// than kSamePlaceMm, those with the least squares of distances.
EvenHeights evenHeightsAt(const std::vector<double>& heights);

/// One stack of slices that share a grid, sorted.
class SortedStack {
  public:
    /// Sorts `slices`: at least one, all with geometry; they must outlive this.
    explicit SortedStack(const std::vector<SlicePlane>& slices);

    const std::vector<int>& order() const { return order_; }
    int count() const { return int(order_.size()); }
    double height(int k) const { return heightOf(order_[k]); }
    const std::string& name(int k) const { return slices_[order_[k]].name; }
    dvec3 position(int k) const { return *slices_[order_[k]].position; }
    /// Returns the distance between slices of the even grid.
    double gap() const { return even_.gap; }
    /// Returns the height of slice k of the even grid.
    double evenHeight(int k) const { return even_.at(k); }
    /// Returns how far a slice may lie from an even grid [mm].
    double toleranceMm() const;
    /// Returns the same for slice k and sideways alone: direction cosines that were rounded turn the normal.
    double sidewaysToleranceMm(int k) const;
    /// Returns whether no slice lies farther sideways of slice 0 than that.
    bool isUpright() const { return isUpright_; }

    /// Returns how far slice k lies sideways of slice 0 [mm]: along the row, along the column.
    dvec2 drift(int k) const;
    /// Returns the same for slice k of the even grid; 0 where slices are upright.
    dvec2 evenDrift(int k) const { return dvec2(evenRow_.at(k), evenColumn_.at(k)); }
    /// Returns the even grid in the place of the lowest slice. It is sheared where slices are not upright.
    VolumeGeometry geometry() const;
    /// Returns the grid of so many even slices from the lowest slice to the highest.
    VolumeGeometry geometryOf(int slices) const;
    /// Returns the largest distance of a pixel of any slice from that grid, due to its spacing and directions [mm].
    double gridDeviationMm() const;
    /// Returns the largest distance of a slice's first pixel from that grid [mm].
    double unevennessMm() const;

  private:
    void followDrift();
    double heightOf(int index) const { return glm::dot(*slices_[index].position, normal_); }

    const std::vector<SlicePlane>& slices_;
    dvec3 row_, column_, normal_;
    std::vector<int> order_;
    EvenHeights even_, evenRow_, evenColumn_;
    bool isUpright_ = true;
};

/// Returns pairs of slices at the same position, each with the first one there.
std::vector<std::pair<int, int>> findSamePlace(const SortedStack& stack);

/// Returns `even`, or what is wrong first: one slice, doubled heights, crooked or excessive drift, uneven gaps. Gaps
/// are named in addition.
GeometryVerdict judge(const SortedStack& stack);

}  // namespace pdr::dicom
