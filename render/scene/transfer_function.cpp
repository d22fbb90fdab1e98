#include "render/scene/transfer_function.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "render/scene/field_check.h"
#include "render/scene/fields/tissue_fields.h"

namespace pdr {

namespace {

TransferNode between(const TransferNode& a, const TransferNode& b, float hu) {
    const float fraction = (hu - a.hu) / (b.hu - a.hu);
    return {hu,
            glm::mix(a.opacity, b.opacity, fraction),
            glm::mix(a.albedo, b.albedo, fraction),
            glm::mix(a.emission, b.emission, fraction),
            glm::mix(a.specular, b.specular, fraction),
            glm::mix(a.roughness, b.roughness, fraction)};
}

std::vector<TransferNode>::const_iterator firstAfter(const std::vector<TransferNode>& nodes, float hu) {
    return std::upper_bound(nodes.begin(), nodes.end(), hu,
                            [](float value, const TransferNode& node) { return value < node.hu; });
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

TransferNode TransferFunction::before(float hu) const {
    const auto next = std::lower_bound(nodes.begin(), nodes.end(), hu,
                                       [](const TransferNode& node, float value) { return node.hu < value; });
    if (next != nodes.begin() && next != nodes.end())
        return between(*(next - 1), *next, hu);
    TransferNode outermost = next == nodes.begin() ? nodes.front() : nodes.back();
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
    if (nodes.empty())
        return Error{phrase("at least one node is needed"), "transferFunction.nodes", ""};
    if (nodes.size() > kMostNodes)
        return Error{phrase("there are %1 nodes, at most %2 are taken", nodes.size(), kMostNodes),
                     "transferFunction.nodes", phrase("Leave out nodes that lie on a line between their neighbours.")};
    if (auto ok = FieldCheck::check(*this, "transferFunction"); !ok)
        return ok;
    for (std::size_t i = 1; i < nodes.size(); ++i)
        if (nodes[i].hu < nodes[i - 1].hu)
            return Error{phrase("must ascend from one to the next"), "transferFunction.nodes[" + std::to_string(i) + "].hu", ""};
    return {};
}

}  // namespace pdr
