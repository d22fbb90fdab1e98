#pragma once
/// A measurement: places of the patient, and what is measured between them. Its value follows from them and the scan
/// (measured.h).

#include <cstdint>
#include <string>
#include <vector>

#include "render/measure/place.h"

namespace pdr::app {

enum class MeasureKind {
    distance,  ///< between two places
    angle,     ///< at the second of three places
    lines,     ///< between the line from the first place to the second, and that from the third to the fourth
    point,     ///< the HU at a place; its name is its label
    ball,      ///< the HU around the first place, as far as the second
    ellipse,   ///< the HU in an ellipse on a slice: its middle, and the ends of its two half axes
    polygon,   ///< the area in a polygon on a slice, whose corners are its places in order, and the HU inside
};
inline constexpr std::size_t kMeasureKinds = 7;

/// Most corners of a polygon.
inline constexpr std::size_t kMostCorners = 48;

/// Returns how many places a measurement of that kind has; of a polygon, at least.
constexpr std::size_t placesOf(MeasureKind kind) {
    switch (kind) {
        case MeasureKind::point:
            return 1;
        case MeasureKind::distance:
        case MeasureKind::ball:
            return 2;
        case MeasureKind::angle:
        case MeasureKind::ellipse:
        case MeasureKind::polygon:
            return 3;
        case MeasureKind::lines:
            break;
    }
    return 4;
}

/// Returns how many places a measurement of that kind has at most.
constexpr std::size_t mostPlacesOf(MeasureKind kind) {
    return kind == MeasureKind::polygon ? kMostCorners : placesOf(kind);
}

/// Returns whether places of that kind belong to the edge of a structure. The HU at an edge are those of neither side.
constexpr bool isBetweenEdges(MeasureKind kind) {
    return kind != MeasureKind::point && kind != MeasureKind::ball && kind != MeasureKind::ellipse;
}

/// Returns whether the first place of that kind is the middle of a figure, which may reach beyond the scan.
constexpr bool hasMiddle(MeasureKind kind) {
    return kind == MeasureKind::ball || kind == MeasureKind::ellipse;
}

/// Returns whether a measurement of that kind lies in one slice, and is drawn there.
constexpr bool isFlat(MeasureKind kind) {
    return kind == MeasureKind::ellipse || kind == MeasureKind::polygon;
}

/// Returns whether a measurement of that kind holds voxels, whose statistics it states.
constexpr bool isRegion(MeasureKind kind) {
    return kind == MeasureKind::ball || isFlat(kind);
}

/// Most measurements of a plan, and the longest name of one [bytes]: plan files hold no more.
inline constexpr std::size_t kMostMeasurements = 1000, kLongestName = 200;

struct Measurement {
    std::uint64_t id = 0;  ///< random, so that files and reports name the same measurement
    MeasureKind kind = MeasureKind::distance;
    std::string name;                    ///< what the user calls it; empty: nothing
    std::vector<measure::Place> places;  ///< placesOf(kind) to mostPlacesOf(kind) of them
    bool operator==(const Measurement&) const = default;
};

}  // namespace pdr::app
