#include "app/looks/small_image.h"

#include <utility>

#include "render/base/errors.h"
#include "render/film/display/exposure.h"
#include "render/scene/fit_view.h"
#include "render/scene/visible_mask.h"
#include "render/volume/coarser.h"

namespace pdr::app {
namespace {

constexpr double kEdgeMm = 2.5;         ///< edge of the coarse voxels: a pixel shows 2 to 5 mm
constexpr std::uint32_t kSamples = 16;  ///< samples per pixel

}  // namespace

std::shared_ptr<const Volume> coarseCopy(const Volume& volume) {
    return std::make_shared<const Volume>(coarser(volume, kEdgeMm));
}

std::shared_ptr<const Mask> coarseMask(const Volume& coarse, const segment::BodyParts& parts, const Visible& visible,
                                       const Progress& progress) {
    if (visible.all())
        return nullptr;
    const auto mask = visibleMask(parts, visible, coarse.geometry(), progress);
    return mask ? *mask : nullptr;
}

Result<SmallImage> smallImage(Scene scene, const VolumeGeometry& body, double exposure, Device& device,
                              const std::stop_token& stop) {
    scene.film = ivec2(kSmallImagePixels);
    scene.camera = fittedView(scene.camera, body, 1, kViewFilled);
    const auto film = startFilm(device, scene);
    if (!film)
        return film.error();
    if (auto ok = (*film)->accumulate(kSamples, stop); !ok)
        return ok.error();
    auto known = (*film)->film();
    if (!known)
        return known.error();
    if (stop.stop_requested())
        return cancelled();
    const double stops = stopsFor(**known, exposure);
    return SmallImage{*std::move(known), stops};
}

}  // namespace pdr::app
