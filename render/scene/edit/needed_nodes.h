#pragma once
/// Finds the nodes of a transfer function that its properties need.

#include <vector>

#include "render/scene/transfer_function.h"

namespace pdr {

/// Properties of a node as bits; several: A | B.
struct NodeProperty {
    enum Bits : unsigned { opacity = 1, albedo = 2, emission = 4, specular = 8, roughness = 16, all = 31 };
};

/// Returns for each node whether one of `properties` (a sum of NodeProperty) changes when it is left out together with
/// all others that are not needed; no node is needed where they are the same everywhere. Lines count as straight to
/// 1e-6 of the property's largest value.
std::vector<bool> neededBy(const std::vector<TransferNode>& nodes, unsigned properties);

}  // namespace pdr
