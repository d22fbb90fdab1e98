#pragma once
/// Builds the kernel's tables: from a Scene value to the plain arrays that devices read. No other code builds them.

#include <memory>

#include "render/prepare/edited_majorants.h"
#include "render/prepare/prepared_scene.h"

namespace pdr {

struct Scene;

/// Prepares scenes one after the other and keeps what the next one can reuse: the ranges as long as the volume stays
/// the same, and the majorants as long as the transfer function and the visible parts stay the same, too; after an edit
/// of a curve, those of the tissue that it leaves as it was.
class Flattener {
  public:
    /// Prepares everything that a ray needs on the host. `scene` must have passed Scene::check().
    std::shared_ptr<const PreparedScene> prepare(const Scene& scene);
    /// Prepares a scene without the acceleration structure: flat.majorants and flat.viewBounds stay empty, for a device
    /// that computes them from the rest in its own memory.
    std::shared_ptr<const PreparedScene> flatten(const Scene& scene);

  private:
    std::shared_ptr<PreparedScene> flattened(const Scene& scene) const;
    void bound(PreparedScene& prepared);
    std::shared_ptr<const Majorants> majorantsOf(const PreparedScene& prepared);

    std::shared_ptr<const PreparedScene> last_;
    EditedMajorants edited_;
};

}  // namespace pdr
