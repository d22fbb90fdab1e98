#pragma once
/// Maps Hounsfield units to optical properties: piecewise linear between nodes, applied after interpolation.
///   order       nodes ascending in hu; two nodes at the same hu make a vertical step; further ones between are ignored
///   at a step   the right-hand node holds (right-continuous); outside the nodes the first or last one holds
///   extinction  extinctionPerMm * opacity(hu)     scattering  albedo * extinction     emission  emission * extinction

#include <string>
#include <vector>

#include "render/base/portable.h"
#include "render/base/result.h"

namespace pdr {

struct TransferNode {
    float hu = 0;            ///< Hounsfield units; [-32768, 32767]
    float opacity = 0;       ///< fraction of extinctionPerMm; [0, 1]
    vec3 albedo{0.8f};       ///< scattered fraction of the extinction, linear Rec. 709; [0, 1]
    vec3 emission{0.0f};     ///< emitted radiance per optical depth, linear Rec. 709; [0, 1e6]
    vec3 specular{0.0f};     ///< reflectance at normal incidence, linear Rec. 709; [0, 1]
    float roughness = 0.5f;  ///< microfacet roughness; [0, 1]

    bool operator==(const TransferNode&) const = default;
};

struct TransferFunction {
    float extinctionPerMm = 1;        ///< extinction where the opacity is 1 [1/mm]; [0, 1e6]
    std::vector<TransferNode> nodes;  ///< 1 to kMostNodes

    static constexpr std::size_t kMostNodes = 4096;

    /// Returns all properties at `hu`, by the rules above. Needs at least one node.
    TransferNode at(float hu) const;

    /// Returns the limit of at() from the left, which differs from at() only at a step. Needs at least one node.
    TransferNode before(float hu) const;

    /// Returns at(hu).opacity, without computing the rest.
    float opacityAt(float hu) const;

    /// Checks the rules above: ranges, ascending order, at least one node. `where` of an error names the offending
    /// node.
    Result<void> check() const;

    bool operator==(const TransferFunction&) const = default;
};

}  // namespace pdr
