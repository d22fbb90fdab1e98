#pragma once
/// All that decides what a picture converges to, as an immutable value. An edit makes a new Scene with a new revision;
/// results carry the revision that they were made for.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render/base/result.h"
#include "render/scene/camera.h"
#include "render/scene/clip.h"
#include "render/scene/light.h"
#include "render/scene/schedule.h"
#include "render/scene/transfer_function.h"
#include "render/volume/volume.h"

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

/// The HU that maximumIntensity shows as greys, in even steps at exposure 1.
struct HuWindow {
    float lowHu = -200;   ///< black; [-32768, 32767]
    float highHu = 1000;  ///< white; [-32768, 32767], above lowHu
    bool operator==(const HuWindow&) const = default;
};

/// The ranges above, with "window.lowHu" or "window.highHu" in `where`.
Result<void> check(const HuWindow& window);

/// Whether pictures of the model are sums along straight rays: no noise but that of the pixels' edges, no lights, no
/// shadows.
bool isProjection(Model model);

struct Scene {
    std::shared_ptr<const Volume> volume;  ///< never null in a scene that is rendered
    TransferFunction transferFunction;
    Model model = Model::singleScattering;
    Estimator estimator = Estimator::unbiased;
    Schedule schedule;
    Filtering filtering = Filtering::exact;
    HuWindow window;
    float toleranceLevels = 0.25f;  ///< largest error of a ray of a projection, display levels of 255; [1e-3, 16]
    float phaseG = 0;               ///< Henyey-Greenstein mean cosine; (-1, 1)
    float gradientFactor = 0;       ///< how readily an event is a surface reflection; [0, 1e6]; 0 = never
    bool unshadowed = false;        ///< light reaches every event unhindered: only to learn what shadows do (needs.h)
    std::vector<Light> lights;
    Environment environment;
    Camera camera;
    Clip clip;
    ivec2 film{512, 512};    ///< pixels; each in [1, 16384]
    int maxBounces = 1000;   ///< multiple scattering: events on a path, at most; what is cut is counted; [1, 100000]
    std::uint64_t seed = 1;  ///< any
    std::uint64_t revision = 0;  ///< grows with each edit
    std::string lookName;        ///< what the user calls the way it looks; no picture depends on it

    /// Every range above, and what cannot be rendered yet, with the field's name in `where`. The volume is not looked
    /// at.
    Result<void> check() const;
    bool operator==(const Scene&) const = default;
};

}  // namespace pdr
