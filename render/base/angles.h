#pragma once
/// Elementary functions in double by their Taylor series: sums and products that are rounded the same everywhere, so
/// that images of two machines agree bit by bit whatever their mathematical libraries do. Relative errors are below
/// 5e-16 where the value is not near 0 by cancellation.

namespace pdr {

struct SineCosine {
    double sine, cosine;
};

/// Returns sine and cosine of `radians` in [-pi/4, pi/4].
constexpr SineCosine sineCosineNearZero(double radians) {
    const double x2 = radians * radians;
    double sine = 1, cosine = 1;
    for (int n = 18; n >= 2; n -= 2) {
        sine = 1 - x2 / double(n * (n + 1)) * sine;
        cosine = 1 - x2 / double(n * (n - 1)) * cosine;
    }
    return {radians * sine, cosine};
}

/// Returns sine and cosine of `radians` in [0, pi].
constexpr SineCosine sineCosine(double radians) {
    constexpr double kQuarterPi = 0.785398163397448310;
    constexpr double kHalfPi = 1.57079632679489656, kHalfPiRest = 6.12323399573676604e-17;
    if (radians <= kQuarterPi)
        return sineCosineNearZero(radians);
    if (radians <= 3 * kQuarterPi) {
        const SineCosine turned = sineCosineNearZero(radians - kHalfPi - kHalfPiRest);
        return {turned.cosine, -turned.sine};
    }
    const SineCosine turned = sineCosineNearZero(radians - 2 * kHalfPi - 2 * kHalfPiRest);
    return {-turned.sine, -turned.cosine};
}

/// Returns the tangent of `radians` in [0, pi/2).
constexpr double tangent(double radians) {
    const SineCosine both = sineCosine(radians);
    return both.sine / both.cosine;
}

/// Returns e^x - 1 for x in [-1, 1].
constexpr double expMinusOne(double x) {
    double series = 1;
    for (int n = 20; n >= 2; --n)
        series = 1 + x / n * series;
    return x * series;
}

}  // namespace pdr
