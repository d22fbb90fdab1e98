#pragma once
/// All measurements of an image's bias, each on its own lattice, round by round.

#include <cstdint>
#include <stop_token>
#include <vector>

#include "render/accuracy/bias.h"
#include "render/session/bias_lattice.h"

namespace pdr {

class BiasMeasurements {
  public:
    /// `facts` must be those of `scene`, which must have passed Scene::check().
    BiasMeasurements(const Scene& scene, const BiasFacts& facts);

    /// Returns the biases measured so far, on a display of that tone.
    MeasuredBiases measured(const Tone& tone) const;
    /// Returns the lattice of which another round would improve on what is `known` of an image with so many samples;
    /// null if none.
    BiasLattice* next(std::uint64_t samples, const MeasuredBiases& known);

  private:
    struct Measurement {
        std::optional<MeasuredBias> MeasuredBiases::*result;
        BiasLattice lattice;
        std::uint64_t mostSamples;  ///< per pixel: enough, no more are measured

        bool hasWork(std::uint64_t samples, const MeasuredBiases& known) const;
    };

    std::vector<Measurement> all_;
};

/// Fraction of a final image's time in which its bias may be measured.
inline constexpr double kBiasTimeShare = 0.1;

/// Measures the biases of `biased`, in as many rounds as fit `seconds`, but at least one per lattice. After a stop
/// request, returns what is known so far. Errors: the device's.
Result<MeasuredBiases> measureBias(const Scene& biased, const Tone& tone, Device& device, double seconds,
                                   const std::stop_token& stop);

}  // namespace pdr
