#include "render/scene/transfer_function.h"

#include <algorithm>
#include <cmath>

namespace pdr {

namespace {

TransferNode between(const TransferNode& a, const TransferNode& b, float hu) {
    const float share = (hu - a.hu) / (b.hu - a.hu);
    return {hu,
            glm::mix(a.opacity, b.opacity, share),
            glm::mix(a.albedo, b.albedo, share),
            glm::mix(a.emission, b.emission, share),
            glm::mix(a.specular, b.specular, share),
            glm::mix(a.roughness, b.roughness, share)};
}

std::vector<TransferNode>::const_iterator firstAfter(const std::vector<TransferNode>& nodes, float hu) {
    return std::upper_bound(nodes.begin(), nodes.end(), hu,
                            [](float value, const TransferNode& node) { return value < node.hu; });
}

bool inside(float value, float low, float high) {
    return value >= low && value <= high;  // false for NaN
}

bool inside(vec3 value, float low, float high) {
    return inside(value.x, low, high) && inside(value.y, low, high) && inside(value.z, low, high);
}

}  // namespace

TransferNode TransferFunction::at(float hu) const {
    const auto after = firstAfter(nodes, hu);
    if (after != nodes.begin() && after != nodes.end())
        return between(*(after - 1), *after, hu);
    TransferNode outermost = after == nodes.begin() ? nodes.front() : nodes.back();
    outermost.hu = hu;
    return outermost;
}

float TransferFunction::opacityAt(float hu) const {
    const auto after = firstAfter(nodes, hu);
    if (after == nodes.begin() || after == nodes.end())
        return after == nodes.begin() ? nodes.front().opacity : nodes.back().opacity;
    const auto before = after - 1;
    return glm::mix(before->opacity, after->opacity, (hu - before->hu) / (after->hu - before->hu));
}

Result<void> TransferFunction::check() const {
    if (!inside(extinctionPerMm, 0, 1e6f))
        return Error{"extinctionPerMm must lie in [0, 1e6] per mm", "transferFunction.extinctionPerMm", ""};
    if (nodes.empty())
        return Error{"at least one node is needed", "transferFunction.nodes", ""};
    if (nodes.size() > kMostNodes)
        return Error{"there are " + std::to_string(nodes.size()) + " nodes, at most " + std::to_string(kMostNodes) +
                         " are taken",
                     "transferFunction.nodes", "Leave out nodes that lie on a line between their neighbours."};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const TransferNode& node = nodes[i];
        const std::string where = "transferFunction.nodes[" + std::to_string(i) + "]";
        if (!inside(node.hu, -32768, 32767))
            return Error{"hu must lie in [-32768, 32767]", where + ".hu", ""};
        if (i > 0 && node.hu < nodes[i - 1].hu)
            return Error{"nodes must ascend in hu", where + ".hu", ""};
        if (!inside(node.opacity, 0, 1))
            return Error{"opacity must lie in [0, 1]", where + ".opacity", ""};
        if (!inside(node.albedo, 0, 1))
            return Error{"albedo must lie in [0, 1]", where + ".albedo", ""};
        if (!inside(node.emission, 0, 1e6f))
            return Error{"emission must lie in [0, 1e6]", where + ".emission", ""};
        if (!inside(node.specular, 0, 1))
            return Error{"specular must lie in [0, 1]", where + ".specular", ""};
        if (!inside(node.roughness, 0, 1))
            return Error{"roughness must lie in [0, 1]", where + ".roughness", ""};
    }
    return {};
}

}  // namespace pdr
