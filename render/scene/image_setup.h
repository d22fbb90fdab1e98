#pragma once
/// Everything that a user sets for an image: the state that a document remembers and a plan saves. The voxels, the
/// window and the device are not part of it.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "render/scene/look.h"
#include "render/scene/table.h"

namespace pdr {

struct ImageSetup {
    Look look;
    std::string lookName;      ///< name of the look, as the user sees it
    bool lookChanged = false;  ///< whether the look has been changed since it was chosen
    double stops = 0;          ///< brightness relative to the look's; one more is twice as bright; [-64, 64]
    Camera camera;
    std::optional<vec3> background;  ///< as Scene::background
    Clip clip;
    Table table = Table::hidden;
    Model model = Model::singleScattering;
    Estimator estimator = Estimator::unbiased;
    Schedule schedule;
    bool operator==(const ImageSetup&) const = default;
};

/// Checks the ranges of all members; `where` of an error is the field's name.
Result<void> check(const ImageSetup& setup);

/// Returns the look's title in images and files, the same in every language of the window: "Bone", "Bone (changed)".
std::string lookTitle(const ImageSetup& setup);
/// The ending of a changed look's title.
inline constexpr std::string_view kChangedLook = " (changed)";

/// Makes the scene of a setup, a volume and a film size [pixels]; the only place that joins them. `volume` must not be
/// null; it must be the one without a table if the setup hides the table. `map`: parts of the patient on its grid, or
/// null.
Scene sceneOf(const ImageSetup& setup, std::shared_ptr<const Volume> volume, ivec2 film,
              std::shared_ptr<const LabelMap> map = nullptr);

/// Returns `setup` changed so that its scene is `scene`, which is a scene of `setup` with some settings changed; none
/// if no setup has this scene.
std::optional<ImageSetup> setupOf(const Scene& scene, ImageSetup setup);

/// Returns how images of the setup are displayed.
Display displayOf(const ImageSetup& setup);

}  // namespace pdr
