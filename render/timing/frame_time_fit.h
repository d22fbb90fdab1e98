#pragma once
/// The model of frame times (efficiency.h) fitted to measured ones, with the error of what it says.
///   weights    relative errors are taken to be equal, whatever the size of the frame
///   intervals  hold the truth 95 times in 100 where the measurements scatter about the model normally and alike; from
///              the residuals, so that what the model misses counts too; wider where a bound holds an unknown at 0

#include <array>
#include <vector>

#include "render/base/result.h"
#include "render/timing/efficiency.h"
#include "render/timing/least_squares.h"

namespace pdr {

inline constexpr int kFitSizes = 5;   ///< different numbers of pixels that a fit needs
inline constexpr int kFitCounts = 3;  ///< different numbers of iterations

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
    ConfidenceInterval interval;  ///< of one more measurement
};

class FrameTimeFit {
  public:
    /// Errors: fewer than kFitSizes sizes or kFitCounts numbers of iterations, a time that is not above 0.
    static Result<FrameTimeFit> of(const std::vector<TimedFrame>& frames);

    /// Nothing in it is negative.
    const FrameTimeModel& model() const { return model_; }
    ConfidenceInterval launch() const { return interval({1, 0, 0, 0}); }
    ConfidenceInterval sample() const { return interval({0, 1, 0, 0}); }
    ConfidenceInterval pixel() const { return interval({0, 0, 1, 0}); }
    ConfidenceInterval communication() const { return interval({0, 0, 0, 1}); }
    /// Of T0 + T_c, a frame of one launch and no pixels: often known well where neither of the two is.
    ConfidenceInterval floor() const { return interval({1, 0, 0, 1}); }

    /// False where every frame had as many launches as the others: T0 is then a part of T_c, which is all that is
    /// known.
    bool launchIsKnown() const { return launchIsKnown_; }
    double scatter() const { return scatter_; }  ///< of a measurement about the model, relative standard deviation

    PredictedFrame predict(const FrameWork& work) const;

  private:
    using Factors = std::array<double, kMostUnknowns>;
    /// Of the sum of the unknowns times `factors`; `more`: variance besides, in squared seconds.
    ConfidenceInterval interval(const Factors& factors, double more = 0) const;

    FrameTimeModel model_;
    Solution free_;  ///< without the bounds
    double scatter_ = 0;
    double quantile_ = 0;  ///< of Student's t
    bool launchIsKnown_ = true;
};

}  // namespace pdr
