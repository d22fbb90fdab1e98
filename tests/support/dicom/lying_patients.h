#pragma once
/// Lying patients made from formulas, on tables and in clothes, and the mistakes of the rule that hides the table.

#include <cmath>
#include <functional>
#include <memory>
#include <random>

#include "render/segment/hidden_table.h"
#include "tests/support/scenes/scenes.h"

namespace pdr::test {

inline constexpr int kAirHu = -1000, kTissueHu = 40, kShellHu = 100, kFoamHu = -930;

/// Matter at a place.
enum class Matter { air, body, foreign, foam };

/// Returns the matter at a place, in mm from the middle of the grid: +x left, +y back, +z head.
using Anatomy = std::function<Matter(dvec3 place)>;

/// Whether a place lies in a cylinder along z.
inline bool inTube(dvec3 place, dvec2 centre, double radius) {
    return std::hypot(place.x - centre.x, place.y - centre.y) < radius;
}

/// A trunk of 120 x 90 mm.
inline Matter trunk(dvec3 p) {
    return std::hypot(p.x / 60, p.y / 45) < 1 ? Matter::body : Matter::air;
}

/// A table of foam in a shell of 3 mm, 160 mm wide and 24 mm thick, whose top lies at `top` mm behind the middle.
inline Matter table(dvec3 p, double top) {
    if (std::abs(p.x) > 80 || p.y < top || p.y > top + 24)
        return Matter::air;
    const bool inside = std::abs(p.x) < 77 && p.y > top + 3 && p.y < top + 21;
    return inside ? Matter::foam : Matter::foreign;
}

/// Returns the first of both that is not air.
inline Matter either(Matter one, Matter other) {
    return one == Matter::air ? other : one;
}

inline const dvec3 kLyingSpacingMm{1.5, 1.5, 2.5};
inline const ivec3 kLyingSize{128, 96, 48};

struct Lying {
    std::shared_ptr<const Volume> volume;
    std::vector<Matter> truth;  ///< matter of each voxel
};

/// Makes the volume of a patient. `noiseHu`: standard deviation of the noise.
inline Lying lying(const Anatomy& anatomy, ivec3 size = kLyingSize, dvec3 spacing = kLyingSpacingMm,
                   double noiseHu = 0) {
    Lying patient;
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0, 1);
    const dvec3 middle = dvec3(size) * spacing * 0.5;
    patient.volume = makeVolume(size, spacing, [&](int i, int j, int k) {
        const Matter matter = anatomy((dvec3(i, j, k) + 0.5) * spacing - middle);
        patient.truth.push_back(matter);
        const int hu = matter == Matter::air    ? kAirHu
                       : matter == Matter::body ? kTissueHu
                       : matter == Matter::foam ? kFoamHu
                                                : kShellHu;
        return std::max(-1024.0, std::round(hu + noiseHu * noise(random)));
    });
    return patient;
}

/// Mistakes of the rule that hides the table [voxels].
struct Mistakes {
    std::int64_t lost = 0;     ///< body that is hidden
    std::int64_t kept = 0;     ///< foreign matter that is not hidden
    std::int64_t foreign = 0;  ///< all foreign matter
};

inline Mistakes mistakesOf(const Lying& patient, const segment::HiddenTable& table) {
    Mistakes mistakes;
    const Volume& seen = table.body ? *table.body : *patient.volume;
    for (std::size_t i = 0; i < patient.truth.size(); ++i) {
        const bool shown = seen.voxels()[i] == patient.volume->voxels()[i];
        mistakes.lost += patient.truth[i] == Matter::body && !shown;
        mistakes.kept += patient.truth[i] == Matter::foreign && shown;
        mistakes.foreign += patient.truth[i] == Matter::foreign;
    }
    return mistakes;
}

/// Makes a trunk on a table `gap` mm below the back; below 0 the back is pressed into the table.
inline Lying onTable(double gap, double noiseHu = 0) {
    return lying([=](dvec3 p) { return either(trunk(p), table(p, 45 + gap)); }, kLyingSize, kLyingSpacingMm, noiseHu);
}

inline segment::HiddenTable hidden(const Volume& volume) {
    return *segment::hideTable(volume, noProgress);
}

}  // namespace pdr::test
