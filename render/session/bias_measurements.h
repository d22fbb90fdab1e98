#pragma once
/// All that has to be measured of a picture's bias, each on a lattice of its own, round by round.

#include <cstdint>
#include <stop_token>
#include <vector>

#include "render/accuracy/bias.h"
#include "render/session/bias_lattice.h"

namespace pdr {

class BiasMeasurements {
  public:
    /// `facts`: of `scene`, which must have passed Scene::check().
    BiasMeasurements(const Scene& scene, const BiasFacts& facts);

    /// On a display of that exposure.
    MeasuredBiases measured(double exposure) const;
    /// That a round of would tell more of a picture which has so many samples, beside what is `known`; null: none.
    BiasLattice* next(std::uint64_t samples, const MeasuredBiases& known);

  private:
    struct Measurement {
        std::optional<MeasuredBias> MeasuredBiases::*result;
        BiasLattice lattice;
        std::uint64_t mostSamples;  ///< of each of its pixels: it knows enough then

        bool hasWork(std::uint64_t samples, const MeasuredBiases& known) const;
    };

    std::vector<Measurement> all_;
};

/// Part of the time of a final image that its bias may be measured in beside it.
inline constexpr double kBiasTimeShare = 0.1;

/// Of `biased`, in as many rounds as fit `seconds`, and one of each lattice at least. After a stop request: what there
/// is. Errors: the device's.
Result<MeasuredBiases> measureBias(const Scene& biased, double exposure, Device& device, double seconds,
                                   const std::stop_token& stop);

}  // namespace pdr
