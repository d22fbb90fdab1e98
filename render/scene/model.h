#pragma once
/// The optical models of images, and the methods that compute them.

namespace pdr {

/// The optical models, from cheap to complete.
///   absorption          an X-ray: L = B exp(-int extinction), B the environment, or white where the camera sees none
///   emission            L = int extinction c ds + background; c = albedo + emission, as if white light of radiance 1
///                       reached each tissue from all sides unshadowed
///   emissionAbsorption  as emission, attenuated by the tissue in front
///   singleScattering    light from the lights, shadowed on its way, scattered once
///   multipleScattering  as singleScattering, with any number of scattering events
///   maximumIntensity    the highest HU on each ray, through a window
enum class Model { absorption, emission, emissionAbsorption, singleScattering, multipleScattering, maximumIntensity };

inline constexpr Model kModels[] = {Model::absorption,       Model::emission,           Model::emissionAbsorption,
                                    Model::singleScattering, Model::multipleScattering, Model::maximumIntensity};

/// Returns the model's word in scene files: "singleScattering".
const char* modelName(Model model);

/// How the scattering models are computed.
enum class Estimator {
    unbiased,   ///< the program's own estimators, without bias
    kroesMarch  ///< Exposure Render's ray marching in steps of 3 voxels: BIASED, one event; for comparison only
};

inline constexpr Estimator kEstimators[] = {Estimator::unbiased, Estimator::kroesMarch};

/// Returns the estimator's word in scene files: "kroesMarch".
const char* estimatorName(Estimator estimator);

/// Where rays leave an event on a surface, to the side that it is seen from. Rays to the camera start at the event.
enum class RayOrigin {
    event,       ///< at the event, inside the soft edge of the surface, which shadows it
    outsideEdge  ///< one voxel out along the normal; the edge takes what a plane one would on average
};

/// How the scattering models interpolate the volume between its voxels.
enum class Filtering {
    exact,  ///< interpolated in single precision
    fast    ///< by the device's texture units, with weights of 8 bits (kernel/texture.h); exact on devices without them
};

inline constexpr Filtering kFilterings[] = {Filtering::exact, Filtering::fast};

/// Returns the filtering's word in scene files: "fast".
const char* filteringName(Filtering filtering);

/// Returns whether images of the model are computed along straight rays: without lights and shadows, and without noise
/// other than that of the pixels' edges.
bool isProjection(Model model);

}  // namespace pdr
