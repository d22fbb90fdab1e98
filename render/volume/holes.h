#pragma once
/// Holes of a scan: layers in which its slices are interpolated, since the scanner measured none there, or only some
/// that lie much farther apart than the slices of the volume. A volume carries them as one of its remarks, which all
/// that is made from it keeps. Lengths are millimetres, patient space LPS.

#include <span>
#include <string>
#include <vector>

#include "render/volume/volume.h"

namespace pdr {

/// A layer between two measured slices. It holds the places p with fromMm < dot(normal, p) < toMm: there, the
/// interpolation between voxels uses slices that were not measured.
struct Hole {
    dvec3 normal{0};  ///< unit vector across the slices
    double fromMm = 0, toMm = 0;
    bool operator==(const Hole&) const = default;
};

/// The two measured slices beside a hole, by their heights above the lowest slice.
struct HoleHeights {
    double fromMm = 0, toMm = 0;
    bool operator==(const HoleHeights&) const = default;
};

/// Returns the remark that holesOf() reads, one word: "holes:12.50-17.50,40.00-45.00". `heights` must not be empty.
std::string holesRemark(std::span<const HoleHeights> heights);

/// Returns the holes that the remarks of `volume` name, in the order of their heights.
std::vector<Hole> holesOf(const Volume& volume);

/// Returns whether the straight line from `from` to `to` reaches into a hole. Places that lie within 0.02 mm of a
/// measured slice are taken to lie on it.
bool reachesInto(std::span<const Hole> holes, dvec3 from, dvec3 to);

}  // namespace pdr
