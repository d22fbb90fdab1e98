#pragma once
/// Renders small images of a scan under a look, from a coarser copy of its voxels, about 30 ms each. The gallery shows
/// them, and they provide the brightness that suits a scan, in the window and with `--exposure auto`.

#include <memory>
#include <stop_token>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/device/device.h"
#include "render/film/film.h"
#include "render/scene/scene.h"
#include "render/segment/body_parts.h"

namespace pdr::app {

inline constexpr int kSmallImagePixels = 96;  ///< pixels along an edge

/// Returns a copy of `volume` with voxels large enough for a small image.
std::shared_ptr<const Volume> coarseCopy(const Volume& volume);
/// Returns the mask of what `visible` shows. The parts are found in the whole scan, since thin bone is lost in coarse
/// voxels. Null: everything is shown, as in a large image whose parts cannot be told apart.
std::shared_ptr<const Mask> coarseMask(const Volume& coarse, const segment::BodyParts& parts, const Visible& visible,
                                       const Progress& progress);

struct SmallImage {
    std::shared_ptr<const Film> film;
    /// The brightness that brings the tissue into the middle of the display; for models that followsTissue().
    double stops = 0;
};

/// Renders `scene`, whose volume and mask are coarse, in the direction of its camera, but at a distance from which
/// `body` fills the image. `exposure`: of its display. Errors: the device's; cancelled().
Result<SmallImage> smallImage(Scene scene, const VolumeGeometry& body, double exposure, Device& device,
                              const std::stop_token& stop);

}  // namespace pdr::app
