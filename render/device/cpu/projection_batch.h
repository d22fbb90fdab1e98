#pragma once
/// Runs kernel/quadrature/projection.h on the CPU: many rays, kLanes at a time.

#include <array>

#include "render/device/cpu/lane_group.h"
#include "render/device/cpu/sample_origin.h"
#include "render/kernel/quadrature/projection.h"

namespace pdr {

/// Renders pixels of one scene. Owns the memory for the rays, so each thread has one.
class ProjectionBatch {
  public:
    /// Adds `samples` to each pixel of `tile`. For scenes whose flat model is not scattering. sums.health must not be
    /// null.
    void render(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums);

    static constexpr int kCapacity = 1024;

    void clear() { size_ = 0; }
    int size() const { return size_; }
    /// Adds a ray with what lies behind it; its number is its place in the order of adding. There must be room:
    /// kCapacity rays.
    void add(const Ray& ray, vec3 behind);
    /// Walks all rays to their ends.
    template <FlatModel Model>
    void project(const FlatScene& scene);
    /// Returns what project() found.
    const Projected& result(int ray) const { return result_[ray]; }

  private:
    template <FlatModel Model, Tissue Kind>
    struct InLanes;
    template <FlatModel Model, Tissue Kind>
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
