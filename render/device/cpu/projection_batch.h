#pragma once
/// The CPU's way through kernel/projection.h: many rays, kLanes at a time; a lane whose ray has ended takes the next
/// one.

#include <array>
#include <cstdint>
#include <vector>

#include "render/kernel/pixel.h"
#include "render/kernel/projection.h"

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
    template <FlatModel Model>
    class LaneGroup;
    template <FlatModel Model>
    void render(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums);
    template <FlatModel Model>
    void projectInLanes(const FlatScene& scene);
    template <FlatModel Model>
    void finish(const FlatScene& scene, Health& health);
    /// Rays [row, row + kLanes) before their first step; rows from size() on are left-overs that nobody takes.
    template <FlatModel Model>
    RayWalk<FloatLanes, Model> started(const FlatScene& scene, int row) const;

    /// Which sample a ray is, and where it goes.
    struct Origin {
        PixelSums* target;
        std::uint64_t sample;
        std::uint32_t pixel;
    };
    static void add(const Origin& origin, const Projected& found, Health& health);

    template <class T>
    using Column = std::array<T, kCapacity>;
    struct Columns3 {
        Column<float> x, y, z;
        void set(int row, vec3 value) { x[row] = value.x, y[row] = value.y, z[row] = value.z; }
        vec3 at(int row) const { return {x[row], y[row], z[row]}; }
    };

    alignas(64) Columns3 origin_, direction_;
    alignas(64) Column<float> length_;
    Column<vec3> behind_;
    Column<Projected> result_;
    Column<Origin> origins_;
    int size_ = 0;
};

}  // namespace pdr
