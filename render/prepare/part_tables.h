#pragma once
/// The curves of the parts of a scene as the kernel reads them (FlatParts).

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/base/huge_pages.h"
#include "render/kernel/flat_scene.h"
#include "render/prepare/transfer_tables.h"
#include "render/volume/label_map.h"

namespace pdr {

struct Scene;
struct TransferFunction;

/// Returns whether a part with that curve has the shape of its labels: it is as opaque at all HU. Its surfaces are
/// where its labels end.
bool hasShapeOfLabels(const TransferFunction& function);

/// For each fine cell the only curve of its voxels, or kMixedCell.
using CellCurves = HugePageVector<std::uint8_t>;

/// All curves of a scene with parts, one after the other, and which voxels have them. Parts whose curve and
/// surfaces equal those of another one share them. Empty where no part has a curve that is not the scene's own: such a
/// scene is rendered as one without parts. It cannot be copied, since `curves` points into it.
class PartTables {
  public:
    PartTables() = default;
    PartTables(const PartTables&) = delete;
    PartTables& operator=(const PartTables&) = delete;

    /// `last`: the tables of the scene before, or null; what did not change is taken from there.
    void take(const Scene& scene, const PartTables* last);

    bool empty() const { return map == nullptr; }
    /// Returns a view that points into this object.
    FlatParts flat() const;
    /// Returns whether every voxel has the same opacity and extinction in both, for all HU.
    bool sameOpacity(const PartTables& other) const;

    std::shared_ptr<const LabelMap> map;         ///< null: there are no parts
    std::array<std::uint8_t, 256> materialOf{};  ///< number of each label's curve
    std::array<std::uint8_t, 256> curveOf{};     ///< number of the first curve of the same opacity
    std::shared_ptr<const CellCurves> cells;     ///< null without a map
    std::vector<OpacityPiece> pieces;            ///< pieces of all curves
    std::vector<Material> materials;             ///< two per piece
    std::vector<std::uint16_t> pieceAt;          ///< look-up tables: curves whose pieces begin at the same HU share one
    std::vector<FlatTransferFunction> curves;    ///< the scene's own first

  private:
    /// Adds what a curve reads and returns where its look-up table begins.
    std::size_t add(const TransferTables& tables);
};

}  // namespace pdr
