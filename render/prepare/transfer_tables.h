#pragma once
/// A transfer function as the kernel reads it: linear pieces, and a look-up table of the piece that holds a value.

#include <vector>

#include "render/kernel/flat_scene.h"
#include "render/scene/transfer_function.h"

namespace pdr {

struct TransferTables {
    std::vector<OpacityPiece> pieces;
    std::vector<Material> materials;     ///< two per piece
    std::vector<std::uint16_t> pieceAt;  ///< 65536 / 16 entries, see FlatTransferFunction
    float extinctionPerMm = 0;

    TransferTables() = default;
    /// Builds the tables. `function` must have passed check().
    explicit TransferTables(const TransferFunction& function);

    /// Returns a view that points into this object.
    FlatTransferFunction flat() const;
    /// Returns the highest opacity of the whole curve.
    float highestOpacity() const;
    /// Returns whether `other` has the same opacity and extinction for all HU.
    bool sameOpacity(const TransferTables& other) const;
};

}  // namespace pdr
