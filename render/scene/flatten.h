#pragma once
/// The only builder of kernel tables: from a Scene value to the plain arrays that devices read.

#include <memory>
#include <vector>

#include "render/kernel/flat_scene.h"
#include "render/scene/environment_tables.h"
#include "render/scene/scene.h"
#include "render/volume/ranges.h"

namespace pdr {

/// Bounds on the extinction for one volume under one transfer function.
struct Majorants {
    std::vector<float> fine, coarse;
    vec3 occupiedLow{0}, occupiedHigh{0};

    Majorants() = default;
    Majorants(const CellRanges& ranges, const TransferFunction& function, ivec3 volumeSize);
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
    std::shared_ptr<const CellRanges> ranges;
    std::shared_ptr<const Majorants> majorants;
    TransferFunction transferFunction;
    std::vector<OpacityPiece> pieces;
    std::vector<Material> materials;
    std::vector<std::uint16_t> pieceAt;
    std::vector<float> optics;
    std::vector<FlatLight> lights;
    std::shared_ptr<const EnvironmentTables> environment;  ///< null: no picture
    std::vector<FlatPlane> clipPlanes;
    std::vector<vec2> viewDepths;
};

/// Prepares scenes one after the other and keeps what the next one can use again: the ranges while the volume stays,
/// the majorants while the transfer function stays too.
class Flattener {
  public:
    /// `scene` must have passed Scene::check().
    std::shared_ptr<const PreparedScene> prepare(const Scene& scene);

  private:
    std::shared_ptr<const PreparedScene> last_;
};

}  // namespace pdr
