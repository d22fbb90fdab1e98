#pragma once
/// A measurement that is being drawn: the places that it has so far, and where the next one may lie.

#include <optional>
#include <vector>

#include "app/plan/measurement.h"
#include "render/base/result.h"
#include "render/slice/slice_stack.h"

namespace pdr::app {

/// The slice that a view shows.
struct ViewedSlice {
    AnatomicalPlane axis;  ///< which of the three views it is
    SlicePlane plane;
};

class MarkDrawing {
  public:
    explicit MarkDrawing(MeasureKind kind) : kind_(kind) {}

    MeasureKind kind() const { return kind_; }
    const std::vector<measure::Place>& places() const { return places_; }
    /// Returns whether it has all its places. A polygon never has: it is closed.
    bool isComplete() const { return kind_ != MeasureKind::polygon && places_.size() >= placesOf(kind_); }
    /// Returns whether it is a polygon that has enough corners.
    bool mayClose() const { return kind_ == MeasureKind::polygon && places_.size() >= placesOf(kind_); }

    /// Returns whether it takes no further place.
    bool isFull() const { return places_.size() >= mostPlacesOf(kind_); }
    /// Returns whether it can go on in `slice` of the scan on `geometry`. A flat figure cannot in another slice than
    /// that of its first place, where it is not seen.
    bool goesOnIn(const ViewedSlice& slice, const VolumeGeometry& geometry) const;
    /// Returns whether it is a flat figure that was begun in the slices of another view than that of `axis`.
    bool liesAcross(AnatomicalPlane axis) const;
    /// Returns where a flat figure is drawn, as the reason why it is not drawn where it was tried.
    Error isElsewhere(const VolumeGeometry& geometry) const;

    /// Sets the next place where `slice` was clicked. `free`: it goes to no edge.
    void add(const Volume& volume, const ViewedSlice& slice, dvec3 placeMm, bool free);
    void add(const measure::Place& place) { places_.push_back(place); }
    /// Takes back the last place, if there is one.
    void takeBack();

  private:
    MeasureKind kind_;
    std::vector<measure::Place> places_;
    std::optional<ViewedSlice> begun_;  ///< where the first place was clicked; none: in the image
};

}  // namespace pdr::app
