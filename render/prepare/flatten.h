#pragma once
/// The only builder of kernel tables: from a Scene value to the plain arrays that devices read.

#include <memory>

#include "render/prepare/prepared_scene.h"

namespace pdr {

struct Scene;

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
