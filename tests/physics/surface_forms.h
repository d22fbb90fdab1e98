#pragma once
/// The self-test's surfaces and its slit a second time: a half space under a flat border, where an event at optical
/// depth d is seen at cosine m through exp(-d / m) and lit at m0 through exp(-d / m0), so that a share m0 / (m + m0) of
/// all light that would meet a bare surface is left.

#include "app/selftest/scene.h"
#include "tests/physics/gauss_legendre.h"
#include "tests/physics/written_optics.h"

namespace pdr::test {

/// Returns the radiance towards the viewer per irradiance across the light's direction [1/sr].
inline double surfaceResponse(const selftest::CaseScene& s, dvec3 toViewer, dvec3 toLight) {
    const written::Tissue tissue{1, dvec3(s.albedo), dvec3(s.specular), s.roughness};
    const double fraction = written::surfaceProbability(1, s.gradientFactor, 2048 / selftest::extentMm(s));
    return fraction * written::surface(tissue, {0, 0, 1}, toViewer, toLight).x +
           (1 - fraction) * s.albedo * written::henyeyGreenstein(s.g, -glm::dot(toViewer, toLight));
}

/// Lamps stand at right angles to the viewer.
inline double surfaceValue(const selftest::Case& c) {
    const selftest::CaseScene& s = c.scene;
    const dvec3 toViewer(0, std::sqrt(1 - s.view * s.view), s.view);
    if (s.beam) {
        const double m0 = *s.beam;
        return M_PI / (s.view + m0) * surfaceResponse(s, toViewer, {std::sqrt(1 - m0 * m0), 0, m0});
    }
    constexpr int kAround = 256;
    double sum = 0;
    for (const QuadraturePoint& point : gaussLegendre(128)) {
        const double m0 = point.at, sine = std::sqrt(1 - m0 * m0);
        for (int i = 0; i < kAround; ++i) {
            const double angle = 2 * M_PI * i / kAround;
            sum += point.weight * 2 * M_PI / kAround * m0 / (s.view + m0) *
                   surfaceResponse(s, toViewer, {sine * std::cos(angle), sine * std::sin(angle), m0});
        }
    }
    return sum * s.room;
}

/// Share of a disc of radius `blur` that lies within 1 of a line through its middle, by Simpson's rule over the angle
/// under which its chords are seen.
inline double slitValue(double blur) {
    if (blur <= 1)
        return 1;
    constexpr int kPieces = 2000;
    const double last = std::asin(1 / blur);
    double sum = 0;
    for (int i = 0; i <= kPieces; ++i) {
        const double c = std::cos(last * i / kPieces);
        sum += (i == 0 || i == kPieces ? 1 : (i % 2 ? 4 : 2)) * c * c;
    }
    return sum * last / (3 * kPieces) * 4 / M_PI;
}

}  // namespace pdr::test
