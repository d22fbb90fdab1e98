#pragma once
/// Everything that determines what an image converges to, as an immutable value. An edit makes a new Scene with a new
/// revision; results carry the revision that they were rendered for.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/base/result.h"
#include "render/scene/camera.h"
#include "render/scene/clip.h"
#include "render/scene/light.h"
#include "render/scene/model.h"
#include "render/scene/parts.h"
#include "render/scene/schedule.h"
#include "render/scene/transfer_function.h"
#include "render/scene/visible.h"
#include "render/volume/mask.h"
#include "render/volume/volume.h"

namespace pdr {

/// The range of HU that maximumIntensity shows as greys, in even steps at exposure 1.
struct HuWindow {
    float lowHu = -200;   ///< black; [-32768, 32767]
    float highHu = 1000;  ///< white; [-32768, 32767], above lowHu
    bool operator==(const HuWindow&) const = default;
};

/// Checks the ranges above; `where` of an error is "window.lowHu" or "window.highHu".
Result<void> check(const HuWindow& window);

struct Scene {
    std::shared_ptr<const Volume> volume;  ///< never null in a scene that is rendered
    std::shared_ptr<const Mask> mask;      ///< visible voxels, a mask of the volume's size; null: all
    TransferFunction transferFunction;
    Parts parts;  ///< parts of the patient with curves of their own
    Model model = Model::singleScattering;
    Estimator estimator = Estimator::unbiased;
    Schedule schedule;
    Filtering filtering = Filtering::exact;
    HuWindow window;
    float toleranceLevels = 0.25f;  ///< largest error of a projection's ray, in display levels of 255; [1e-3, 16]
    float phaseG = 0;               ///< Henyey-Greenstein mean cosine; (-1, 1)
    float gradientFactor = 0;       ///< how readily an event becomes a surface reflection; [0, 1e6]; 0 = never
    RayOrigin rayOrigin = RayOrigin::event;  ///< unused by kroesMarch
    bool unshadowed = false;  ///< light reaches every event unhindered: only to find what shadows do (needs.h)
    std::vector<Light> lights;
    Environment environment;
    std::optional<vec3> background;  ///< radiance that the camera sees behind the volume instead of the environment;
                                     ///< it lights nothing; [0, 1e30]
    Camera camera;
    Clip clip;
    Visible visible;             ///< the choice that `mask` was made for; no image depends on it
    bool ctDenoised = false;     ///< whether `volume` is to be the scan with less noise (smooth/non_local_means.h) or
                                 ///< is so already; no image depends on it
    bool maskAwaited = false;    ///< whether `mask` shows another part until it is replaced; no image depends on it
    ivec2 film{512, 512};        ///< pixels; each in [1, kLongestSide]
    int maxBounces = 1000;       ///< multiple scattering: most events on a path; cut paths are counted; [1, 100000]
    std::uint64_t seed = 1;      ///< any value
    std::uint64_t revision = 0;  ///< grows with each edit
    std::string lookName;        ///< name of the look, as the user sees it; no image depends on it

    /// Checks every range above, and that the scene can be rendered; `where` of an error is the field's name. Voxels
    /// are not examined.
    Result<void> check() const;
    bool operator==(const Scene&) const = default;
};

/// Returns whether the camera sees the environment behind the volume.
bool showsEnvironment(const Scene& scene);

/// Returns whether denoising can improve images of the scene: projections have no noise, and Exposure Render's schedule
/// exists for comparison only.
bool canBeDenoised(const Scene& scene);

}  // namespace pdr
