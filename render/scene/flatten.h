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
    std::shared_ptr<const CellRanges> ranges;    ///< null with Bounds::onDevice
    std::shared_ptr<const Majorants> majorants;  ///< likewise
    TransferTables tables;
    std::vector<float> optics;
    std::vector<FlatLight> lights;
    std::shared_ptr<const EnvironmentTables> environment;  ///< null: no picture
    std::vector<FlatPlane> clipPlanes;
    std::vector<vec2> viewDepths;  ///< empty with Bounds::onDevice
};

/// Who makes what rays are led by: ranges, majorants and the bounds of the view.
enum class Bounds {
    onHost,   ///< they are in the prepared scene
    onDevice  ///< flat.majorants and flat.viewBounds are left empty: the device makes them from the rest
};

/// Prepares scenes one after the other and keeps what the next one can use again: the ranges while the volume stays,
/// the majorants while the transfer function stays too.
class Flattener {
  public:
    /// `scene` must have passed Scene::check().
    std::shared_ptr<const PreparedScene> prepare(const Scene& scene, Bounds bounds = Bounds::onHost);

  private:
    void bound(PreparedScene& prepared) const;

    std::shared_ptr<const PreparedScene> last_;
};

}  // namespace pdr
