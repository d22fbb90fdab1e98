#pragma once
/// The self-test's expected values a second time, from formulas and by adding-doubling, so that a number that is wrong
/// in the data cannot pass unseen. Formulas: Chandrasekhar 1950; van de Hulst 1980.

#include <cmath>

#include "app/selftest/case.h"
#include "tests/physics/adding_doubling.h"
#include "tests/physics/surface_forms.h"

namespace pdr::test {

/// Mean of f over [low, high], times its width: composite Gauss-Legendre with 2 points on 20,000 pieces.
template <class F>
double integral(double low, double high, F&& f) {
    constexpr int kPieces = 20000;
    const double h = (high - low) / kPieces, shift = h / (2 * std::sqrt(3.0));
    double sum = 0;
    for (int i = 0; i < kPieces; ++i) {
        const double middle = low + (i + 0.5) * h;
        sum += f(middle - shift) + f(middle + shift);
    }
    return sum * h / 2;
}

/// Chandrasekhar's H function of isotropic scattering.
inline double chandrasekharH(double albedo, double mu) {
    return std::exp(-mu / M_PI * integral(0, M_PI / 2, [&](double t) {
        const double c = std::cos(t), s = std::sin(t);
        return std::log(1 - albedo * t * c / s) / (c * c + mu * mu * s * s);
    }));
}

/// Radiance of a slab, one order of scattering, under a beam of irradiance 1 from above (cosine m0 > 0) or below, seen
/// from above (m > 0) or below, one of the two straight on.
inline double singleScattering(const selftest::CaseScene& s, double m0, double m) {
    const bool back = m0 * m > 0;
    const double p = written::henyeyGreenstein(s.g, -m0 * m), a = std::fabs(m0), b = std::fabs(m), t = s.depth;
    if (back)
        return s.albedo * p * a / (a + b) * -std::expm1(-t * (1 / a + 1 / b));
    if (std::fabs(a - b) < 1e-4)
        return s.albedo * p * t / a * std::exp(-t / a);
    return s.albedo * p * a / (a - b) * (std::exp(-t / a) - std::exp(-t / b));
}

/// The second exponential integral.
inline double e2(double x) {
    return integral(1e-9, 1, [x](double mu) { return std::exp(-x / mu); });
}

/// Radiance straight out of a slab in a white room, one order of isotropic scattering.
inline double singleScatteringInARoom(double albedo, double depth) {
    if (depth > 100)  // a half space
        return albedo * (1 - std::log(2.0)) / 2;
    double sum = 0;  // Simpson's rule; e2 is steep at 0, so depth is stretched there
    constexpr int kPieces = 400;
    for (int i = 0; i <= kPieces; ++i) {
        const double x = double(i) / kPieces, t = depth * x * x * (3 - 2 * x), slope = depth * 6 * x * (1 - x);
        const double f = std::exp(-t) * (e2(t) + e2(depth - t)) * slope;
        sum += (i == 0 || i == kPieces ? 1 : (i % 2 ? 4 : 2)) * f;
    }
    return std::exp(-depth) + albedo / 2 * sum / (3 * kPieces);
}

inline double sphereValue(const selftest::Case& c) {
    const double x = c.scene.depth, lost = 1 - (1 + 2 * x) * std::exp(-2 * x);
    if (c.quantity == selftest::Quantity::discTransmittance)
        return lost / (2 * x * x);
    if (c.quantity == selftest::Quantity::escapeProbability)
        return 3 / (8 * x * x * x) * (2 * x * x - lost);
    const double strength = c.scene.albedo / (4 * M_PI), beam = c.scene.beam.value();
    if (beam == 1)
        return strength * -std::expm1(-4 * x) / 2;
    if (beam == -1)
        return strength * 2 * x * std::exp(-2 * x);
    return strength * integral(-M_PI / 2, M_PI / 2, [x](double a) {  // s = sin a
               return x * std::exp(-x * (std::sin(a) + 1) - x * std::cos(a)) * std::cos(a);
           });
}

/// All orders of scattering in a slab that is deep, or in a room, or under a perpendicular beam.
inline double multipleScatteringValue(const selftest::CaseScene& s) {
    const double view = std::fabs(s.view);
    if (s.depth >= 1000) {
        const double h = chandrasekharH(s.albedo, view);
        if (s.beam)
            return s.albedo * h * chandrasekharH(s.albedo, *s.beam) / (4 * (view + *s.beam));
        const double absorbed = std::sqrt(1 - s.albedo) * h;
        return s.emission > 0 ? absorbed : 1 - absorbed;
    }
    const AddingDoubling slab(s.albedo, s.g, s.depth, {view, 1});
    if (s.roomKind == selftest::CaseScene::Room::gradient)
        return slab.scattered(
                   0, [](double mu) { return (1 + mu) / 2; }, [](double mu) { return (1 - mu) / 2; }) +
               std::exp(-s.depth / view) * (1 - view) / 2;
    if (s.roomKind == selftest::CaseScene::Room::sky)
        return s.view > 0 ? slab.reflectance(0) : slab.transmittance(0);
    if (s.beam)
        return s.view > 0 ? slab.reflected(0, 1) : slab.transmitted(0, 1);
    if (s.bed)
        return s.inside ? slab.transmittance(0) : slab.reflectance(0);
    return slab.reflectance(0) + slab.transmittance(0);
}

inline double slabValue(const selftest::Case& c) {
    const selftest::CaseScene& s = c.scene;
    const bool balanced = s.room == 1 && s.roomKind == selftest::CaseScene::Room::even && !s.bed &&
                          std::fabs(s.albedo + s.emission - 1) < 1e-12;
    if (balanced && (s.multiple || s.albedo == 0))
        return 1;
    if (s.albedo == 0)
        return std::exp(-s.depth / std::fabs(s.view));
    if (s.multiple)
        return multipleScatteringValue(s);
    if (s.beam)
        return M_PI / std::fabs(*s.beam) * singleScattering(s, *s.beam, s.view);
    return singleScatteringInARoom(s.albedo, s.depth);
}

/// Returns the true value of `c.expected`.
inline double truth(const selftest::Case& c) {
    using selftest::Quantity;
    const double g = c.scene.g;
    if (c.quantity == Quantity::freeFlights)
        return 64;
    if (c.quantity == Quantity::meanCosine)
        return g;
    if (c.quantity == Quantity::meanSquaredCosine)
        return (1 + 2 * g * g) / 3;
    const bool white = c.scene.albedo == 1 && c.scene.multiple && c.scene.room == 1 && !c.scene.bed;
    if (white)
        return 1;
    if (c.scene.shape == selftest::CaseScene::Shape::sphere)
        return sphereValue(c);
    if (c.scene.shape == selftest::CaseScene::Shape::surface)
        return surfaceValue(c);
    if (c.scene.shape == selftest::CaseScene::Shape::slit)
        return slitValue(c.scene.blur) * c.scene.room;
    return slabValue(c);  // a ramp too: only the optical depth counts
}

}  // namespace pdr::test
