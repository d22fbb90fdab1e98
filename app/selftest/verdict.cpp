#include "app/selftest/verdict.h"

#include <cmath>
#include <limits>

#include "render/base/significance.h"

namespace pdr::selftest {

namespace {

constexpr double kNineOfTen = 1.2816;  ///< z below which a normal variable lies nine times out of ten

/// Converts the deviation of a chi-square from its expected value to the z of the same probability; 0 below the median.
double flightsZ(double value) {
    const double p = chiSquareP(value, kFlightBins);
    return p < 1 ? normalZ(p) : 0;
}

/// Returns the relative shift of the extinction that moves chi-square beyond `allowed` nine times out of ten. A shift d
/// adds N d^2 to it (Fisher's information of an exponential distribution is 1 per flight), and its variance becomes 2
/// bins + 4 N d^2.
double flightsDetect(double allowed, double samples) {
    double low = 0, high = 1e6;  // chi-square that has the probability of `allowed`
    for (int i = 0; i < 200; ++i) {
        const double middle = (low + high) / 2;
        (flightsZ(middle) < allowed ? low : high) = middle;
    }
    double added = high - kFlightBins;
    for (int i = 0; i < 50; ++i)
        added = high - kFlightBins + kNineOfTen * std::sqrt(2 * kFlightBins + 4 * added);
    return std::sqrt(added / samples);
}

}  // namespace

Judgement judge(const Case& reference, const Measurement& got, const Sharpness& sharpness, double allowed) {
    Judgement result;
    const bool absolute = reference.quantity == Quantity::meanCosine;  // its expected value may be 0
    const double scale = absolute ? 1 : std::fabs(reference.expected);
    const double room = (reference.geometryBias + kRounding) * scale;
    const double deviation = got.value - reference.expected;
    if (reference.quantity == Quantity::freeFlights) {
        result.z = flightsZ(got.value);
        result.detects = flightsDetect(allowed, double(sharpness.samples));
    } else {
        result.detects = ((allowed + kNineOfTen) * got.standardError + room) / scale;
        if (got.standardError > 0)
            result.z = deviation / got.standardError;
        else if (std::fabs(deviation) > room)
            result.z = std::copysign(std::numeric_limits<double>::infinity(), deviation);
    }
    const bool flights = reference.quantity == Quantity::freeFlights;
    const bool near = flights ? result.z <= allowed : std::fabs(deviation) <= allowed * got.standardError + room;
    if (!got.health.perfect())
        result.verdict = Verdict::faulty;
    else if (!near)  // also if the value is not a number
        result.verdict = Verdict::deviates;
    else if (!(result.detects <= sharpness.detects))
        result.verdict = Verdict::tooBlunt;
    return result;
}

}  // namespace pdr::selftest
