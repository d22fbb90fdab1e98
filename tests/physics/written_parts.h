#pragma once
/// The tissue of a scene whose parts have materials of their own, once more and in double precision; nothing is shared
/// with render/kernel.

#include <algorithm>
#include <memory>
#include <vector>

#include "render/scene/scene.h"
#include "tests/physics/written_volume.h"

namespace pdr::test::written {

/// A material and its weight at a place.
struct WeightedMaterial {
    const TransferFunction* curve;
    double gradientFactor, weight;
    const Grid* shape = nullptr;  ///< 1000 in its labels, 0 elsewhere, where its surfaces are there

    double wholeExtinction(double hu) const { return curve->extinctionPerMm * tissueAt(curve->nodes, hu).opacity; }
    double extinction(double hu) const { return weight * wholeExtinction(hu); }
};

class Materials {
  public:
    explicit Materials(const Scene& scene) : scene_(scene), grid_(*scene.volume), nodes_(scene.transferFunction.nodes) {
        for (const PartCurve& part : scene.parts.curves) {
            nodes_.insert(nodes_.end(), part.transferFunction.nodes.begin(), part.transferFunction.nodes.end());
            shapes_.push_back(shapeOf(part));
        }
    }

    /// The nodes of all curves.
    const std::vector<TransferNode>& nodes() const { return nodes_; }

    /// Returns the materials of the eight voxels around an index, one for each; without parts, the scene's own.
    std::vector<WeightedMaterial> at(dvec3 index) const {
        if (!scene_.parts.map)
            return {{&scene_.transferFunction, scene_.gradientFactor, 1}};
        const ivec3 size = scene_.volume->size();
        const dvec3 inside = glm::clamp(index, dvec3(0), dvec3(size - 1));
        const ivec3 low = glm::min(ivec3(inside), glm::max(size - 2, ivec3(0)));
        std::vector<WeightedMaterial> around;
        for (int n = 0; n < 8; ++n) {
            const ivec3 voxel = low + ivec3(n % 2, n / 2 % 2, n / 4);
            const dvec3 share = 1.0 - glm::abs(inside - dvec3(voxel));
            around.push_back(materialOf(voxel, share.x * share.y * share.z));
        }
        return around;
    }

    /// Returns the gradient that a material's surfaces have [HU/mm]: `ofHu`, that of the HU, and of 200 HU where other
    /// materials are less opaque, to the same side.
    dvec3 edge(const WeightedMaterial& material, dvec3 index, double hu, dvec3 ofHu) const {
        if (material.shape)
            return material.shape->gradient(index);
        if (!scene_.parts.map)
            return ofHu;
        const double whole = material.wholeExtinction(hu);
        const dvec3 end = 200.0 * grid_.gradientOf(index, [&](ivec3 voxel) {
            return std::min(materialOf(voxel, 1).wholeExtinction(hu) / whole, 1.0);
        });
        return glm::dot(end, ofHu) < 0 ? end - ofHu : end + ofHu;
    }

  private:
    struct Shape {
        std::shared_ptr<const Volume> volume;
        Grid grid;
    };
    /// Returns the shape of a part that is as opaque at all HU; null for all others.
    std::shared_ptr<const Shape> shapeOf(const PartCurve& part) const {
        for (const TransferNode& node : part.transferFunction.nodes)
            if (node.opacity != part.transferFunction.nodes[0].opacity || node.opacity == 0)
                return nullptr;
        Voxels voxels;
        for (const std::uint8_t label : scene_.parts.map->labels)
            voxels.push_back(label == part.label ? 1000 : 0);
        const auto volume = std::make_shared<const Volume>(scene_.parts.map->geometry, std::move(voxels));
        return std::make_shared<const Shape>(Shape{volume, Grid(*volume)});
    }

    WeightedMaterial materialOf(ivec3 voxel, double weight) const {
        const ivec3 size = scene_.volume->size();
        const int label =
            scene_.parts.map->labels[(std::size_t(voxel.z) * size.y + voxel.y) * size.x + std::size_t(voxel.x)];
        const auto part = std::ranges::find(scene_.parts.curves, label, &PartCurve::label);
        if (part == scene_.parts.curves.end())
            return {&scene_.transferFunction, scene_.gradientFactor, weight};
        const auto& shape = shapes_[std::size_t(part - scene_.parts.curves.begin())];
        return {&part->transferFunction, part->gradientFactor.value_or(scene_.gradientFactor), weight,
                shape ? &shape->grid : nullptr};
    }

    const Scene& scene_;
    Grid grid_;
    std::vector<TransferNode> nodes_;
    std::vector<std::shared_ptr<const Shape>> shapes_;  ///< shape of each part
};

}  // namespace pdr::test::written
