#pragma once
/// What kernels read of a scene.

#include <memory>
#include <vector>

#include "render/kernel/flat_scene.h"
#include "render/prepare/environment_tables.h"
#include "render/prepare/light_tables.h"
#include "render/prepare/majorants.h"
#include "render/prepare/transfer_tables.h"
#include "render/volume/mask.h"
#include "render/volume/ranges.h"

namespace pdr {

/// A FlatScene together with all that it points into. Immutable; devices share it. Never copied: `flat` points into
/// this.
struct PreparedScene {
    PreparedScene() = default;
    PreparedScene(const PreparedScene&) = delete;
    PreparedScene& operator=(const PreparedScene&) = delete;

    FlatScene flat{};
    std::uint64_t revision = 0;

    std::shared_ptr<const Volume> volume;
    std::shared_ptr<const Mask> mask;            ///< null: all of it is seen
    std::shared_ptr<const CellRanges> ranges;    ///< null where it was flattened only
    std::shared_ptr<const Majorants> majorants;  ///< likewise
    TransferTables tables;
    std::vector<float> optics;
    std::vector<FlatLight> lights;
    LightTables lightTables;
    std::shared_ptr<const EnvironmentTables> environment;  ///< null: no picture
    std::vector<FlatPlane> clipPlanes;
    std::vector<vec2> viewDepths;  ///< likewise empty
};

/// Whether both scenes have the same majorants, wherever these are made: of the same voxels under the same
/// opacity, of which the same is seen.
bool sameMajorants(const PreparedScene& a, const PreparedScene& b);

}  // namespace pdr
