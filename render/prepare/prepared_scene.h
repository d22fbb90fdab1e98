#pragma once
/// A scene prepared for kernels.

#include <memory>
#include <span>
#include <vector>

#include "render/kernel/flat_scene.h"
#include "render/prepare/environment_tables.h"
#include "render/prepare/freehand_mask.h"
#include "render/prepare/light_tables.h"
#include "render/prepare/majorants.h"
#include "render/prepare/part_tables.h"
#include "render/prepare/transfer_tables.h"
#include "render/volume/mask.h"
#include "render/volume/ranges.h"

namespace pdr {

/// A FlatScene together with everything that it points to. Immutable and shared by devices. It cannot be copied, since
/// `flat` points into it.
struct PreparedScene {
    PreparedScene() = default;
    PreparedScene(const PreparedScene&) = delete;
    PreparedScene& operator=(const PreparedScene&) = delete;

    FlatScene flat{};
    std::uint64_t revision = 0;

    std::shared_ptr<const Volume> volume;
    SeenParts seen;
    std::shared_ptr<const Mask> mask;            ///< mask of everything visible; null: all is visible
    std::shared_ptr<const CellRanges> ranges;    ///< null after Flattener::flatten()
    std::shared_ptr<const Majorants> majorants;  ///< null after Flattener::flatten()
    TransferTables tables;
    PartTables parts;  ///< empty without parts
    std::vector<float> optics;
    std::vector<FlatLight> lights;
    LightTables lightTables;
    std::shared_ptr<const EnvironmentTables> environment;  ///< null without an environment image
    std::vector<FlatPlane> clipPlanes;
    std::vector<vec2> viewDepths;  ///< empty after Flattener::flatten()
};

/// Returns all curves of a scene: its own, and then those of its parts.
std::span<const FlatTransferFunction> curvesOf(const PreparedScene& scene);

/// Returns whether both scenes have the same majorants, wherever these are computed: for the same voxels, the same
/// opacity, parts and visible part.
bool sameMajorants(const PreparedScene& a, const PreparedScene& b);

}  // namespace pdr
