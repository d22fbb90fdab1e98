#pragma once
/// Fits the model of frame times (efficiency.h) to measured ones, with the error of its predictions.
///   weights    relative errors are assumed equal, whatever the size of the frame
///   intervals  contain the truth 95 times in 100 if the measurements scatter about the model normally and equally;
///              computed from the residuals, so that errors of the model count too; wider where a bound holds an
///              unknown at 0

#include <array>
#include <vector>

#include "render/base/result.h"
#include "render/timing/efficiency.h"
#include "render/timing/least_squares.h"

namespace pdr {

inline constexpr int kFitSizes = 5;   ///< distinct numbers of pixels that a fit needs
inline constexpr int kFitCounts = 3;  ///< distinct numbers of iterations that a fit needs

struct TimedFrame {
    FrameWork work;
    double seconds;  ///< measured, > 0
};

struct ConfidenceInterval {
    double low = 0, high = 0;
    bool holds(double value) const { return low <= value && value <= high; }
};

struct PredictedFrame {
    double seconds = 0;
    ConfidenceInterval interval;  ///< 95 % interval of one more measurement
};

class FrameTimeFit {
  public:
    /// Fits the model to `frames`. Errors: fewer than kFitSizes sizes or kFitCounts numbers of iterations, a time that
    /// is not above 0, or measurements that do not separate the parts of the model.
    static Result<FrameTimeFit> of(const std::vector<TimedFrame>& frames);

    /// Returns the fitted model, in which nothing is negative.
    const FrameTimeModel& model() const { return model_; }
    ConfidenceInterval launch() const { return interval({1, 0, 0, 0}); }
    ConfidenceInterval sample() const { return interval({0, 1, 0, 0}); }
    ConfidenceInterval pixel() const { return interval({0, 0, 1, 0}); }
    ConfidenceInterval communication() const { return interval({0, 0, 0, 1}); }
    /// Returns the interval of T0 + T_c, the time of a frame of one launch and no pixels. It is often known well where
    /// neither of the two is.
    ConfidenceInterval floor() const { return interval({1, 0, 0, 1}); }

    /// Returns false if all frames had equally many launches. T0 is then a part of T_c, and only that sum is known.
    bool launchIsKnown() const { return launchIsKnown_; }
    double scatter() const { return scatter_; }  ///< relative standard deviation of a measurement about the model

    PredictedFrame predict(const FrameWork& work) const;

  private:
    using Factors = std::array<double, kMostUnknowns>;
    /// Returns the interval of the sum of the unknowns times `factors`. `more`: additional variance [s^2].
    ConfidenceInterval interval(const Factors& factors, double more = 0) const;

    FrameTimeModel model_;
    Solution free_;  ///< solution without the bounds
    double scatter_ = 0;
    double quantile_ = 0;  ///< quantile of Student's t
    bool launchIsKnown_ = true;
};

}  // namespace pdr
