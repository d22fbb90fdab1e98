#pragma once
/// Upper bounds on the extinction, for free paths.

#include "render/base/huge_pages.h"
#include "render/kernel/flat_scene.h"
#include "render/prepare/transfer_tables.h"
#include "render/volume/ranges.h"

namespace pdr {

/// Bounds on the extinction for one volume under one transfer function, as far as it is seen.
struct Majorants {
    HugePageVector<float> fine, coarse;
    vec3 occupiedLow{0}, occupiedHigh{0};

    Majorants() = default;
    Majorants(const CellRanges& ranges, const TransferTables& tables, ivec3 volumeSize, const FlatMask& mask = {});
};

}  // namespace pdr
