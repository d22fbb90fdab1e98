#include "render/prepare/light_tables.h"

#include <algorithm>

#include "render/kernel/transport/lights.h"
#include "render/kernel/transport/many_lights.h"
#include "render/kernel/volume_sampling.h"

namespace pdr {

namespace {

/// Share of the picks that is distributed equally over the lights that shine: the sampled positions do not represent
/// every corner of the volume.
constexpr double kPickedAlike = 0.25;

bool shines(const FlatLight& light) {
    return light.radiance != vec3(0);
}

/// Returns 27 positions distributed over the volume, local [mm].
std::vector<vec3> placesWithin(const FlatVolume& volume) {
    std::vector<vec3> places;
    for (int i = 0; i < 27; ++i) {
        const vec3 fraction = vec3(i % 3, i / 3 % 3, i / 9) * 0.4f + 0.1f;
        places.push_back(localPosition(volume, fraction * vec3(volume.lastIndex)));
    }
    return places;
}

/// Returns the approximate irradiance by a light, summed over positions and colour channels. A light counts as filling
/// half of a position's directions at most.
double bringsTo(const FlatLight& light, std::span<const vec3> places) {
    double sum = 0;
    for (const vec3 place : places) {
        const vec3 radiance = sampleLight<kPlacedLights>(light, place, vec2(0.5f)).radiance;
        const vec3 most = light.type == LightType::directional ? radiance : light.radiance * (2 * kPi);
        const vec3 brought = glm::min(radiance, most);
        sum += double(brought.x) + brought.y + brought.z;
    }
    return sum;
}

std::vector<float> sumsOf(std::span<const FlatLight> lights, std::span<const vec3> places) {
    std::vector<double> brought;
    double whole = 0;
    for (const FlatLight& light : lights) {
        brought.push_back(bringsTo(light, places));
        whole += brought.back();
    }
    const auto shining = double(std::ranges::count_if(lights, shines));
    std::vector<float> sums{0};
    double sum = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const double alike = shines(lights[i]) ? 1 / shining : 0;
        sum += whole > 0 ? kPickedAlike * alike + (1 - kPickedAlike) * brought[i] / whole : alike;
        sums.push_back(float(sum));
    }
    return sums;
}

float reachOf(const FlatLight& light) {
    return light.type == LightType::sphere ? light.radius : glm::length(light.halfU + light.halfV);
}

class LightTree {
  public:
    /// Builds a tree of `lights`. `slack` [mm]: margin that is added to the radius of each bounding sphere.
    LightTree(std::span<const FlatLight> lights, float slack) : lights_(lights), slack_(slack) {}

    void add(std::span<int> members) {
        const std::size_t node = nodes_.size();
        nodes_.push_back(ballAround(members));
        if (members.size() == 1) {
            nodes_[node].light = members.front();
        } else {
            const std::size_t half = splitAcross(members);
            add(members.first(half));
            add(members.subspan(half));
        }
        nodes_[node].next = int(nodes_.size());
    }
    std::vector<FlatLightNode> take() { return std::move(nodes_); }

  private:
    struct Box {
        vec3 low{1e30f}, high{-1e30f};
    };
    Box centresOf(std::span<const int> members) const {
        Box box;
        for (const int i : members) {
            box.low = glm::min(box.low, lights_[std::size_t(i)].position);
            box.high = glm::max(box.high, lights_[std::size_t(i)].position);
        }
        return box;
    }
    FlatLightNode ballAround(std::span<const int> members) const {
        const Box box = centresOf(members);
        const vec3 centre = 0.5f * box.low + 0.5f * box.high;
        float radius = 0;
        for (const int i : members) {
            const FlatLight& light = lights_[std::size_t(i)];
            radius = std::max(radius, glm::distance(centre, light.position) + reachOf(light));
        }
        return {centre, radius * 1.001f + slack_ + 1e-5f * glm::length(centre), -1, 0};
    }
    /// Splits the lights into halves along the axis of their largest extent. Returns the size of the first half.
    std::size_t splitAcross(std::span<int> members) const {
        const Box box = centresOf(members);
        const vec3 extent = box.high - box.low;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
        const std::size_t half = members.size() / 2;
        std::ranges::nth_element(members, members.begin() + std::ptrdiff_t(half), {},
                                 [&](int i) { return lights_[std::size_t(i)].position[axis]; });
        return half;
    }

    std::span<const FlatLight> lights_;
    float slack_;
    std::vector<FlatLightNode> nodes_;
};

/// Returns the tree of the rectangles and spheres that shine. The margin is needed since single precision finds where a
/// ray passes a sphere to about 1e-7 of the distance from the sphere to the ray's origin.
std::vector<FlatLightNode> treeOf(std::span<const FlatLight> lights, std::span<const vec3> places) {
    std::vector<int> placed;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].type != LightType::directional && shines(lights[i]))
            placed.push_back(int(i));
    LightTree tree(lights, 1e-5f * glm::distance(places.front(), places.back()));
    if (!placed.empty())
        tree.add(placed);
    return tree.take();
}

}  // namespace

LightTables lightTables(std::span<const FlatLight> lights, const FlatVolume& volume) {
    if (std::ranges::count_if(lights, shines) <= kMostLightsInTurn)
        return {};
    const std::vector<vec3> places = placesWithin(volume);
    return {sumsOf(lights, places), treeOf(lights, places)};
}

}  // namespace pdr
