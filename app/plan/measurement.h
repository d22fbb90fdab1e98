#pragma once
/// A measurement: places of the patient, and what is measured between them. Its value follows from them.

#include <cstdint>
#include <string>
#include <vector>

#include "render/base/result.h"
#include "render/measure/place.h"
#include "render/measure/stated.h"

namespace pdr::app {

enum class MeasureKind {
    distance,  ///< between two places
    angle,     ///< at the second of three places
};

/// Returns how many places a measurement of that kind has.
constexpr std::size_t placesOf(MeasureKind kind) {
    return kind == MeasureKind::distance ? 2 : 3;
}

struct Measurement {
    std::uint64_t id = 0;  ///< random, so that files and reports name the same measurement
    MeasureKind kind = MeasureKind::distance;
    std::string name;                    ///< what the user calls it; empty: nothing
    std::vector<measure::Place> places;  ///< placesOf(kind) of them
    bool operator==(const Measurement&) const = default;
};

/// Returns the value of a measurement in a scan on `geometry`, in millimetres or degrees. Fails if its places are too
/// close to each other for an angle.
Result<measure::Stated> valueOf(const Measurement& measurement, const VolumeGeometry& geometry);

}  // namespace pdr::app
