#pragma once
/// Figures that the paper derives from frame times: its tables 2 to 5 and figure 3, and further ones.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/paper/measurement.h"
#include "render/timing/frame_time_fit.h"

namespace pdr::bench::paper {

inline constexpr double kError = 0.01;

/// Figures of one resolution; null where it was not measured.
struct SizeFigures {
    ivec2 size;
    std::array<std::optional<double>, kWayCount> framesPerSecond;
    std::array<std::optional<double>, kWayCount> load;
    std::optional<double> iteration;                          ///< T_p [s], eq. 6, from pd n = 100
    std::array<std::optional<double>, kWayCount> other;       ///< T_t + T_c [s], eq. 7; the same for all n of pd
    std::array<std::optional<double>, kWayCount> efficiency;  ///< eq. 1
    std::optional<double> sampleNoise;                        ///< Lap::sampleNoise of pd n = 100

    double pixels() const { return double(size.x) * size.y; }
    std::optional<double> iterationsPerSecond(WayPlace way) const;
    /// Returns the samples per pixel until the standard error of the pixels (root mean square) is kError of the image's
    /// mean. secondsToError() returns the seconds that these samples take with `way`.
    std::optional<double> samplesToError() const;
    std::optional<double> secondsToError(WayPlace way) const;
};

/// Efficiency E at one size and n: as eq. 5 predicts it, and as the fraction of the time in which samples are taken at
/// full speed.
struct TileEfficiency {
    ivec2 size;
    WayPlace way;
    double manyNodes;             ///< E by eq. 5
    double fraction;              ///< measured E, n alpha R FPS
    ConfidenceInterval interval;  ///< 95 % interval of `fraction`, from that of alpha
};

struct Figures {
    std::vector<SizeFigures> sizes;                              ///< in the order of the plan
    std::array<std::optional<double>, kWayCount> communication;  ///< T_c [s], eq. 8, from the smallest resolution
    std::optional<FrameTimeFit> fit;                             ///< fit of the frame times of pd; null: see whyNoFit
    std::string whyNoFit;
    std::vector<TileEfficiency> tiles;  ///< efficiencies of pd; empty without a fit
};

Figures figuresOf(const Measured& measured, const Plan& plan);

/// A figure, and the goal that pd is to reach.
struct Goal {
    std::string what;
    std::optional<double> paper;  ///< value in the paper, on a GTX 560 Ti
    std::optional<double> wanted;
    std::optional<double> here;
};

std::vector<Goal> goalsOf(const Figures& figures);

}  // namespace pdr::bench::paper
