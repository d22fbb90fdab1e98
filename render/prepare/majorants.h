#pragma once
/// Upper bounds on the extinction (majorants), for sampling free paths.

#include "render/base/huge_pages.h"
#include "render/kernel/flat_scene.h"
#include "render/prepare/highest_weights.h"
#include "render/prepare/transfer_tables.h"
#include "render/volume/ranges.h"

namespace pdr {

/// Bounds on the extinction of the visible part of one volume under one transfer function.
struct Majorants {
    HugePageVector<float> fine, coarse;
    vec3 occupiedLow{0}, occupiedHigh{0};

    Majorants() = default;
    Majorants(const CellRanges& ranges, const TransferTables& tables, ivec3 volumeSize, const FlatMask& mask = {},
              const FlatParts& parts = {}) {
        HighestWeights weights(mask, volumeSize, ranges.fineSize());
        compute(ranges, tables, volumeSize, weights, parts);
    }
    /// Computes them anew, in the memory of those before. `weights`: of the scene's mask; `parts`: the curves of the
    /// scene, where it has parts.
    void compute(const CellRanges& ranges, const TransferTables& tables, ivec3 volumeSize, HighestWeights& weights,
                 const FlatParts& parts);
};

}  // namespace pdr
