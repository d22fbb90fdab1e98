#pragma once
/// Ranges of tissues on the scale of CT, for orientation only: they overlap and shift with the tube's voltage, so they
/// are never a classification.
///   fat              Mitsiopoulos et al. 1998, J Appl Physiol 85:115
///   muscle           of normal attenuation: Goodpaster et al. 2000, J Appl Physiol 89:104
///   lung, bone       Kalender, Computed Tomography, 3rd ed. 2011; bone from the lowest compact one to enamel
///   air, water       their definition, with the noise of a clinical scan
///   contrast         blood with iodine in the arterial to the venous phase
///   metal            above all tissue

#include <array>

namespace pdr {

struct TissueBand {
    const char* name;
    float lowHu, highHu;
};

inline constexpr std::array<TissueBand, 8> kTissueBands{{{"air", -1024, -950},
                                                         {"lung", -950, -550},
                                                         {"fat", -190, -30},
                                                         {"water", -10, 10},
                                                         {"muscle", 35, 100},
                                                         {"contrast", 150, 450},
                                                         {"bone", 250, 2500},
                                                         {"metal", 3000, 32767}}};

}  // namespace pdr
