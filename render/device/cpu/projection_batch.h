#pragma once
/// The CPU's way through kernel/projection.h: many rays, kLanes at a time.

#include <array>

#include "render/device/cpu/lane_group.h"
#include "render/device/cpu/sample_origin.h"
#include "render/kernel/quadrature/projection.h"

namespace pdr {

/// Renders pixels of one scene; owns the room for the rays, so one per thread.
class ProjectionBatch {
  public:
    /// Adds `samples` to each pixel of `tile`. sums.health must be there. For scenes whose flat model is no scattering.
    void render(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums);

    static constexpr int kCapacity = 1024;

    void clear() { size_ = 0; }
    int size() const { return size_; }
    /// Adds a ray with what lies behind it; its number is its place in the order of adding. There is room for
    /// kCapacity.
    void add(const Ray& ray, vec3 behind);
    /// Takes all rays to their end.
    template <FlatModel Model>
    void project(const FlatScene& scene);
    /// What project() found.
    const Projected& result(int ray) const { return result_[ray]; }

  private:
    template <FlatModel Model, bool Masked>
    struct InLanes;
    template <FlatModel Model, bool Masked>
    void projectInLanes(const FlatScene& scene);
    template <FlatModel Model>
    void render(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums);
    template <FlatModel Model>
    void finish(const FlatScene& scene, Health& health);

    alignas(64) RayColumns<kCapacity> rays_;
    std::array<vec3, kCapacity> behind_;
    std::array<Projected, kCapacity> result_;
    std::array<SampleOrigin, kCapacity> origins_;
    int size_ = 0;
};

}  // namespace pdr
