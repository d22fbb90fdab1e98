#pragma once
/// A transfer function as the kernel reads it: linear pieces, and where to look for the one that holds a value.

#include <vector>

#include "render/kernel/flat_scene.h"
#include "render/scene/transfer_function.h"

namespace pdr {

struct TransferTables {
    std::vector<OpacityPiece> pieces;
    std::vector<Material> materials;     ///< two per piece
    std::vector<std::uint16_t> pieceAt;  ///< 65536 / 16
    float extinctionPerMm = 0;

    TransferTables() = default;
    /// `function` must have passed check().
    explicit TransferTables(const TransferFunction& function);

    /// Points into this.
    FlatTransferFunction flat() const;
    /// Of the whole curve.
    float highestOpacity() const;
    /// Whether the opacity is the same everywhere.
    bool sameOpacity(const TransferTables& other) const;
};

}  // namespace pdr
