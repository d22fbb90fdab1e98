#include "app/document/tissue_edits.h"

#include <algorithm>
#include <cmath>

#include "render/scene/edit/curve_shapes.h"
#include "render/scene/edit/tissue_channels.h"

namespace pdr::app {
namespace {

constexpr double kHuPerHeight = 1000;
constexpr double kWidthPerHeight = 4;
constexpr float kNarrowestBell = 40, kWidestBell = 160;  ///< [HU]

/// Returns the middle [HU] between where the opacity has risen to 5 % and to 95 % of its maximum.
float middleOfRise(const TransferFunction& function) {
    const Curve opacity = curveOf(function, TissueChannel::opacity);
    const float top = heightOf(opacity);
    return (firstAt(opacity, 0.05f * top) + firstAt(opacity, 0.95f * top)) / 2;
}

}  // namespace

void TissueEdits::setTransferFunction(const TransferFunction& function, bool moving) {
    Look look = document_.setup().look;
    look.transferFunction = function;
    document_.setLook(look, moving);
}

void TissueEdits::drag(QPointF inHeights, bool moving) {
    if (!document_.hasVolume())
        return beforeDrag_.reset();  // the volume was closed during the drag
    if (!beforeDrag_)
        beforeDrag_ = document_.setup().look.transferFunction;
    const double shift = std::round(inHeights.x() * kHuPerHeight);
    const double factor = std::pow(kWidthPerHeight, -inHeights.y());
    setTransferFunction(shiftedAndWidened(*beforeDrag_, float(shift), middleOfRise(*beforeDrag_), float(factor)),
                        moving);
    if (!moving)
        beforeDrag_.reset();
}

/// The bell's width follows the tissue's spread: 2.4 standard deviations, about the full width at half maximum of a
/// normal distribution, clamped to [kNarrowestBell, kWidestBell].
void TissueEdits::addBell(const TissueBehind& tissue) {
    const TransferFunction& function = document_.setup().look.transferFunction;
    const Curve opacity = curveOf(function, TissueChannel::opacity);
    const float height = heightOf(opacity), width = std::clamp(2.4f * tissue.spread, kNarrowestBell, kWidestBell);
    const Curve bell = bellCurve(std::round(tissue.hu), width, height > 0 ? height : 1.0f);
    setTransferFunction(withCurve(function, TissueChannel::opacity, larger(opacity, bell)), false);
}

}  // namespace pdr::app
