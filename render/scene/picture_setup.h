#pragma once
/// All that a user sets up of a picture: what a document remembers and a session saves. The voxels, the window and the
/// device are not part of it.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "render/scene/look.h"
#include "render/scene/table.h"

namespace pdr {

struct PictureSetup {
    Look look;
    std::string lookName;      ///< what the user calls it: the name of a look
    bool lookChanged = false;  ///< it was that look, and has been changed since
    double stops = 0;          ///< brightness against the look's; one more is twice as bright; [-64, 64]
    Camera camera;
    std::optional<vec3> background;  ///< as in Scene
    Clip clip;
    Table table = Table::hidden;
    Model model = Model::singleScattering;
    Estimator estimator = Estimator::unbiased;
    Schedule schedule;
    bool operator==(const PictureSetup&) const = default;
};

/// The ranges of all that it holds, with the field's name in `where`.
Result<void> check(const PictureSetup& setup);

/// What pictures and files say of its look, in every language of the window: "Bone", "Bone (changed)".
std::string lookTitle(const PictureSetup& setup);
/// What the title of a changed look ends with.
inline constexpr std::string_view kChangedLook = " (changed)";

/// The one place that joins a look, a camera and a volume. `volume` is not null, and the one without a table where that
/// is hidden; `film`: pixels.
Scene sceneOf(const PictureSetup& setup, std::shared_ptr<const Volume> volume, ivec2 film);

/// `setup` changed so that its scene is `scene`, which is one of `setup` with some things set otherwise; none where no
/// setup says what `scene` says.
std::optional<PictureSetup> setupOf(const Scene& scene, PictureSetup setup);

/// How its pictures are shown.
Display displayOf(const PictureSetup& setup);

/// Reads a setup from JSON text ("format": "pdrender-session"). `where` is used in error texts.
Result<PictureSetup> setupFromJson(std::string_view json, std::string_view where);
/// The text that setupFromJson() reads as an equal setup, to the bit. Pictures of surroundings are not written.
std::string setupText(PictureSetup setup);

}  // namespace pdr
