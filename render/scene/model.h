#pragma once
/// Which picture of a scene is made, and how.

namespace pdr {

/// The optical models, from cheap to complete.
///   absorption          an X-ray: L = B exp(-int extinction), B the environment, or white where the camera sees none
///   emission            L = int extinction c ds + background; c = albedo + emission, as if white light of radiance 1
///                       reached each tissue from all sides unshadowed
///   emissionAbsorption  the same behind what lies in front of it
///   singleScattering    light from the lights, shadowed on its way, scattered once
///   multipleScattering  the same with any number of events
///   maximumIntensity    the highest HU on each ray, through a window
enum class Model { absorption, emission, emissionAbsorption, singleScattering, multipleScattering, maximumIntensity };

inline constexpr Model kModels[] = {Model::absorption,       Model::emission,           Model::emissionAbsorption,
                                    Model::singleScattering, Model::multipleScattering, Model::maximumIntensity};

/// Its word in scene files: "singleScattering".
const char* modelName(Model model);

/// How the scattering models are computed.
enum class Estimator {
    unbiased,   ///< what this program is for
    kroesMarch  ///< as Exposure Render does, steps of 3 voxels and all: BIASED, one event, to be compared with
};

inline constexpr Estimator kEstimators[] = {Estimator::unbiased, Estimator::kroesMarch};

/// Its word in scene files: "kroesMarch".
const char* estimatorName(Estimator estimator);

/// How the scattering models read the volume between its voxels.
enum class Filtering {
    exact,  ///< interpolated in single precision
    fast    ///< by texture units where a device has them: shares of 8 bits (kernel/texture.h); else exactly
};

inline constexpr Filtering kFilterings[] = {Filtering::exact, Filtering::fast};

/// Its word in scene files: "fast".
const char* filteringName(Filtering filtering);

/// Whether pictures of the model are sums along straight rays: no noise but that of the pixels' edges, no lights, no
/// shadows.
bool isProjection(Model model);

}  // namespace pdr
