#pragma once
/// A TransferFunction taken apart into curves that are edited one at a time, and put together again. Its nodes carry
/// all properties at once; a curve has only the points that its own property needs.

#include "render/scene/edit/curve.h"
#include "render/scene/transfer_function.h"

namespace pdr {

/// Properties with one number. Of coloured ones it is the largest of the three.
enum class TissueChannel { opacity, specular, roughness, emission };

/// The largest value that a channel may have.
float highestValue(TissueChannel channel);

float valueOf(const TransferNode& node, TissueChannel channel);

/// The points that `channel` needs; nodes that no property needs count as opacity's, since somebody has put them there.
Curve curveOf(const TransferFunction& function, TissueChannel channel);
/// `function` with that curve, and all other properties as they are, up to rounding. Colours keep their hue; what was
/// black becomes grey.
TransferFunction withCurve(const TransferFunction& function, TissueChannel channel, const Curve& curve);

struct ColourStop {
    float hu = 0;
    vec3 albedo{0.8f};  ///< as in TransferNode

    bool operator==(const ColourStop&) const = default;
};

/// The stops that the colour needs: at least one, ascending, as the points of a Curve.
std::vector<ColourStop> coloursOf(const TransferFunction& function);
/// `function` with those colours, and all else as it is, up to rounding.
TransferFunction withColours(const TransferFunction& function, const std::vector<ColourStop>& stops);

/// The same extinction everywhere, with room for `extinctionPerMm` where the opacity is 1: never less than there was.
TransferFunction withRoomFor(TransferFunction function, float extinctionPerMm);

/// All nodes `hu` further up, and `factor` > 0 times as far from `centre`; what would leave the range of HU stays at
/// its end.
TransferFunction shiftedAndWidened(TransferFunction function, float hu, float centre, float factor);

}  // namespace pdr
