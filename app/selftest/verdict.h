#pragma once
/// Verdict on a measurement: whether it agrees with physics, and whether it could detect a deviation.

#include "app/selftest/case.h"
#include "render/base/health.h"

namespace pdr::selftest {

/// A mean over independent samples and its standard error.
struct Measurement {
    double value = 0;
    double standardError = 0;
    Health health = {};
};

enum class Verdict {
    agrees,
    deviates,  ///< deviates by more than chance, rounding and the voxels' shape explain
    tooBlunt,  ///< too noisy to detect the bias that the case must detect
    faulty,    ///< some samples are faulty: NaN, a bound that did not hold, a path that was cut
};

struct Judgement {
    double z = 0;        ///< deviation in standard errors
    double detects = 0;  ///< bias that such a run detects nine times out of ten; relative as in Sharpness
    Verdict verdict = Verdict::agrees;
};

/// Judges a measurement of a case. `allowed`: |z| that chance may reach, see allowedZ(). `sharpness`: what the run must
/// detect.
Judgement judge(const Case& reference, const Measurement& got, const Sharpness& sharpness, double allowed);

/// Relative shift of a result that single precision alone may cause.
inline constexpr double kRounding = 2e-6;

/// Number of bins of the free flights. The statistic has as many degrees of freedom, because each bin is sampled on its
/// own.
inline constexpr int kFlightBins = 64;

}  // namespace pdr::selftest
