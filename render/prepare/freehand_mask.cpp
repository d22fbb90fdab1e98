#include "render/prepare/freehand_mask.h"

#include <algorithm>
#include <utility>

#include "render/scene/edit/drawn_outline.h"
#include "render/scene/edit/view_geometry.h"

namespace pdr {
namespace {

/// One line, prepared for queries.
class Cut {
  public:
    explicit Cut(const FreehandCut& cut) : view_(cut.camera, 1), outline_(cut.outline), keepInside_(cut.keepInside) {}

    /// Returns how deep a position lies in what the line leaves [mm]; negative in what it cuts away.
    double depthMm(dvec3 placeMm) const {
        constexpr double kFarOutside = -1e9;  // behind the eye
        const std::optional<dvec2> seen = view_.at(placeMm);
        const double inside = seen ? outline_.at(*seen - 0.5) * view_.heightMm(placeMm) : kFarOutside;
        return keepInside_ ? inside : -inside;
    }

  private:
    ViewGeometry view_;
    OutlineDistance outline_;
    bool keepInside_;
};

bool isSame(const VolumeGeometry& a, const VolumeGeometry& b) {
    return a.size == b.size && a.patientFromIndex == b.patientFromIndex;
}

}  // namespace

std::shared_ptr<const Mask> freehandMask(const std::vector<FreehandCut>& cuts, const VolumeGeometry& geometry) {
    if (cuts.empty())
        return nullptr;
    constexpr double kNodeMm = 2;  // a little coarser than other masks, since the image waits for it
    const std::vector<Cut> all(cuts.begin(), cuts.end());
    return maskOf(MaskGrid::over(geometry, kNodeMm), "", [&](dvec3 place) {
        const dvec3 placeMm(geometry.patientFromIndex * dvec4(place, 1));
        double depth = 1e9;
        for (const Cut& cut : all)
            depth = std::min(depth, cut.depthMm(placeMm));
        return edgeWeight(depth);
    });
}

SeenParts::SeenParts(const std::vector<FreehandCut>& cuts, std::shared_ptr<const Mask> visible,
                     const VolumeGeometry& geometry, const SeenParts* last)
    : cuts_(cuts), geometry_(geometry), visible_(std::move(visible)) {
    const bool sameLines = last && last->cuts_ == cuts_ && isSame(last->geometry_, geometry_);
    left_ = sameLines ? last->left_ : freehandMask(cuts_, geometry_);
    mask_ = sameLines && last->visible_ == visible_ ? last->mask_ : combined(visible_, left_);
}

}  // namespace pdr
