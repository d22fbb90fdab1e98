#pragma once
/// All that decides what a picture converges to, as an immutable value. An edit makes a new Scene with a new revision;
/// results carry the revision that they were made for.

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
#include "render/scene/schedule.h"
#include "render/scene/transfer_function.h"
#include "render/scene/visible.h"
#include "render/volume/mask.h"
#include "render/volume/volume.h"

namespace pdr {

/// The HU that maximumIntensity shows as greys, in even steps at exposure 1.
struct HuWindow {
    float lowHu = -200;   ///< black; [-32768, 32767]
    float highHu = 1000;  ///< white; [-32768, 32767], above lowHu
    bool operator==(const HuWindow&) const = default;
};

/// The ranges above, with "window.lowHu" or "window.highHu" in `where`.
Result<void> check(const HuWindow& window);

struct Scene {
    std::shared_ptr<const Volume> volume;  ///< never null in a scene that is rendered
    std::shared_ptr<const Mask> mask;      ///< what is seen of it: a volume of that size; null: all
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
    std::optional<vec3> background;  ///< radiance that the camera sees behind the volume instead of the environment;
                                     ///< it lights nothing; [0, 1e30]
    Camera camera;
    Clip clip;
    Visible visible;           ///< what the mask was made for; no picture depends on it
    bool maskAwaited = false;  ///< another part is shown until that mask is there; no picture depends on it
    ivec2 film{512, 512};      ///< pixels; each in [1, kLongestSide]
    int maxBounces = 1000;     ///< multiple scattering: events on a path, at most; what is cut is counted; [1, 100000]
    std::uint64_t seed = 1;    ///< any
    std::uint64_t revision = 0;  ///< grows with each edit
    std::string lookName;        ///< what the user calls the way it looks; no picture depends on it

    /// Every range above, and what cannot be rendered yet, with the field's name in `where`. The volume is not looked
    /// at.
    Result<void> check() const;
    bool operator==(const Scene&) const = default;
};

/// Whether the camera sees the environment behind the volume.
bool showsEnvironment(const Scene& scene);

/// Whether smoothing can do its pictures any good: projections have no noise, and Exposure Render's schedule is there
/// to be compared with.
bool canBeSmoothed(const Scene& scene);

}  // namespace pdr
