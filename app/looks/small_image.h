#pragma once
/// Small images of a scan under a look, of a coarser copy of its voxels, some 30 ms each: the gallery shows them, and
/// the brightness that suits a scan comes from them, in the window and with `--exposure auto`.

#include <memory>
#include <stop_token>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/device/device.h"
#include "render/film/film.h"
#include "render/scene/scene.h"
#include "render/segment/body_parts.h"

namespace pdr::app {

inline constexpr int kSmallImagePixels = 96;  ///< along an edge

/// Voxels of `volume` as large as suits a small image.
std::shared_ptr<const Volume> coarseCopy(const Volume& volume);
/// What `visible` shows, told apart in the whole scan, since thin bone is lost in coarse voxels. Null: all is shown, as
/// in a large image where the parts cannot be told apart.
std::shared_ptr<const Mask> coarseMask(const Volume& coarse, const segment::BodyParts& parts, const Visible& visible,
                                       const Progress& progress);

struct SmallImage {
    std::shared_ptr<const Film> film;
    double stops = 0;  ///< that bring the tissue into the middle of the display; for models that followsTissue()
};

/// Renders `scene`, whose volume and mask are coarse, from where its camera stands, but so near that `body` fills the
/// image. `exposure`: of its display. Errors: the device's; cancelled().
Result<SmallImage> smallImage(Scene scene, const VolumeGeometry& body, double exposure, Device& device,
                              const std::stop_token& stop);

}  // namespace pdr::app
