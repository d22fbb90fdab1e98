#pragma once
/// Whether a measurement agrees with physics, and whether it could have told if it did not.

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
    deviates,  ///< farther off than chance, rounding and the voxels' shape explain
    tooBlunt,  ///< too noisy to find the bias that the case must be able to find
    faulty,    ///< samples went wrong: NaN, a bound that did not hold, a path that was cut
};

struct Judgement {
    double z = 0;        ///< deviation in standard errors
    double detects = 0;  ///< bias that such a run finds nine times out of ten; relative as in Sharpness
    Verdict verdict = Verdict::agrees;
};

/// `allowed`: |z| that chance may reach, see allowedZ(). `sharpness`: what the run was meant to find.
Judgement judge(const Case& reference, const Measurement& got, const Sharpness& sharpness, double allowed);

/// Single precision alone may shift a result by so much, relative.
inline constexpr double kRounding = 2e-6;

/// Bins of the free flights; the statistic has as many degrees of freedom, since each bin is drawn on its own.
inline constexpr int kFlightBins = 64;

}  // namespace pdr::selftest
