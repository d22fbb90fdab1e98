#pragma once
/// The only builder of kernel tables: from a Scene value to the plain arrays that devices read.

#include <memory>
#include <vector>

#include "render/kernel/flat_scene.h"
#include "render/scene/environment_tables.h"
#include "render/scene/scene.h"
#include "render/scene/transfer_tables.h"
#include "render/volume/ranges.h"

namespace pdr {

/// Bounds on the extinction for one volume under one transfer function.
struct Majorants {
    std::vector<float> fine, coarse;
    vec3 occupiedLow{0}, occupiedHigh{0};

    Majorants() = default;
    Majorants(const CellRanges& ranges, const TransferTables& tables, ivec3 volumeSize);
};

/// A FlatScene together with all that it points into. Immutable; devices share it. Never copied: `flat` points into
/// this.
struct PreparedScene {
    PreparedScene() = default;
    PreparedScene(const PreparedScene&) = delete;
    PreparedScene& operator=(const PreparedScene&) = delete;

    FlatScene flat{};
    std::uint64_t revision = 0;

    std::shared_ptr<const Volume> volume;
    std::shared_ptr<const CellRanges> ranges;    ///< null where it was flattened only
    std::shared_ptr<const Majorants> majorants;  ///< likewise
    TransferTables tables;
    std::vector<float> optics;
    std::vector<FlatLight> lights;
    std::shared_ptr<const EnvironmentTables> environment;  ///< null: no picture
    std::vector<FlatPlane> clipPlanes;
    std::vector<vec2> viewDepths;  ///< likewise empty
};

/// Whether both scenes have the same majorants, wherever these are made: of the same voxels under the same opacity.
bool sameMajorants(const PreparedScene& a, const PreparedScene& b);

/// Prepares scenes one after the other and keeps what the next one can use again: the ranges while the volume stays,
/// the majorants while the transfer function stays too.
class Flattener {
  public:
    /// All that a ray needs on the host. `scene` must have passed Scene::check().
    std::shared_ptr<const PreparedScene> prepare(const Scene& scene);
    /// Without the acceleration structure: flat.majorants and flat.viewBounds are left empty, for a device that makes
    /// them from the rest in its own memory.
    std::shared_ptr<const PreparedScene> flatten(const Scene& scene);

  private:
    std::shared_ptr<PreparedScene> flattened(const Scene& scene) const;
    void bound(PreparedScene& prepared) const;

    std::shared_ptr<const PreparedScene> last_;
};

}  // namespace pdr
