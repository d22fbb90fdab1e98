#pragma once
/// Splits a TransferFunction into curves that are edited one at a time, and joins them again. Its nodes carry all
/// properties at once; a curve has only the points that its own property needs.

#include "render/scene/edit/curve.h"
#include "render/scene/transfer_function.h"

namespace pdr {

/// Properties that are edited as one number; for a colour, the largest of its three channels.
enum class TissueChannel { opacity, specular, roughness, emission };

/// Returns the largest value that a channel may have.
float highestValue(TissueChannel channel);

float valueOf(const TransferNode& node, TissueChannel channel);

/// Returns the points that `channel` needs. Nodes that no property needs count as opacity's, since a user has put them
/// there.
Curve curveOf(const TransferFunction& function, TissueChannel channel);
/// Returns `function` with that curve, and all other properties unchanged up to rounding. Colours keep their hue; black
/// becomes grey.
TransferFunction withCurve(const TransferFunction& function, TissueChannel channel, const Curve& curve);

struct ColourStop {
    float hu = 0;
    vec3 albedo{0.8f};  ///< as TransferNode::albedo

    bool operator==(const ColourStop&) const = default;
};

/// Returns the stops that the colour needs: at least one, ascending, like the points of a Curve.
std::vector<ColourStop> coloursOf(const TransferFunction& function);
/// Returns `function` with those colours, and everything else unchanged up to rounding.
TransferFunction withColours(const TransferFunction& function, const std::vector<ColourStop>& stops);

/// Raises the extinction at opacity 1 to `extinctionPerMm` if it is lower, and scales the opacities so that the
/// extinction stays the same everywhere.
TransferFunction withRoomFor(TransferFunction function, float extinctionPerMm);

/// Moves all nodes up by `hu` and scales their distances from `centre` by `factor` > 0; nodes that would leave the
/// range of HU stay at its end.
TransferFunction shiftedAndWidened(TransferFunction function, float hu, float centre, float factor);

}  // namespace pdr
