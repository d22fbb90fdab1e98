#include "render/scene/edit/tissue_channels.h"

#include <algorithm>
#include <cassert>
#include <functional>

#include "render/scene/edit/needed_nodes.h"

namespace pdr {
namespace {

float largest(vec3 colour) {
    return std::max({colour.x, colour.y, colour.z});
}

/// Returns a colour of the same hue whose largest channel is `value`; black becomes grey.
vec3 scaledTo(vec3 colour, float value) {
    const float strength = largest(colour);
    return strength > 0 ? glm::min(colour * (value / strength), vec3(value)) : vec3(value);
}

NodeProperty::Bits propertyOf(TissueChannel channel) {
    switch (channel) {
        case TissueChannel::specular:
            return NodeProperty::specular;
        case TissueChannel::roughness:
            return NodeProperty::roughness;
        case TissueChannel::emission:
            return NodeProperty::emission;
        default:
            return NodeProperty::opacity;
    }
}

TransferNode withValue(TransferNode node, TissueChannel channel, float value) {
    if (value == valueOf(node, channel))
        return node;
    switch (channel) {
        case TissueChannel::specular:
            node.specular = scaledTo(node.specular, value);
            return node;
        case TissueChannel::roughness:
            node.roughness = value;
            return node;
        case TissueChannel::emission:
            node.emission = scaledTo(node.emission, value);
            return node;
        default:
            node.opacity = value;
            return node;
    }
}

/// Returns the nodes that `property` needs; for opacity also those that no property needs. At least one.
std::vector<bool> pointsOf(const std::vector<TransferNode>& nodes, NodeProperty::Bits property) {
    std::vector<bool> points = neededBy(nodes, property);
    if (property == NodeProperty::opacity) {
        const std::vector<bool> ofOthers = neededBy(nodes, NodeProperty::all & ~NodeProperty::opacity);
        std::transform(points.begin(), points.end(), ofOthers.begin(), points.begin(),
                       [](bool needed, bool byOthers) { return needed || !byOthers; });
    }
    if (std::find(points.begin(), points.end(), true) == points.end())
        points.front() = true;
    return points;
}

/// Returns the places of the nodes that stay where `property` is replaced, because other properties need them.
std::vector<float> placesWithout(const std::vector<TransferNode>& nodes, NodeProperty::Bits property) {
    std::vector<bool> stays = neededBy(nodes, NodeProperty::all & ~property);
    if (property != NodeProperty::opacity) {
        const std::vector<bool> ofOpacity = pointsOf(nodes, NodeProperty::opacity);
        std::transform(stays.begin(), stays.end(), ofOpacity.begin(), stays.begin(), std::logical_or());
    }
    std::vector<float> places;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (stays[i])
            places.push_back(nodes[i].hu);
    return places;
}

/// Returns a node for each of `places` and of the replacement's nodes, made by `take` from both functions; two at a
/// step.
template <class Take>
std::vector<TransferNode> joined(const TransferFunction& function, const TransferFunction& replacement,
                                 std::vector<float> places, const Take& take) {
    for (const TransferNode& node : replacement.nodes)
        places.push_back(node.hu);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::vector<TransferNode> nodes;
    for (const float hu : places) {
        const TransferNode left = take(function.before(hu), replacement.before(hu));
        const TransferNode right = take(function.at(hu), replacement.at(hu));
        if (left != right)
            nodes.push_back(left);
        nodes.push_back(right);
    }
    return nodes;
}

}  // namespace

float highestValue(TissueChannel channel) {
    return channel == TissueChannel::emission ? 1e6f : 1.0f;
}

float valueOf(const TransferNode& node, TissueChannel channel) {
    switch (channel) {
        case TissueChannel::specular:
            return largest(node.specular);
        case TissueChannel::roughness:
            return node.roughness;
        case TissueChannel::emission:
            return largest(node.emission);
        default:
            return node.opacity;
    }
}

Curve curveOf(const TransferFunction& function, TissueChannel channel) {
    const std::vector<bool> points = pointsOf(function.nodes, propertyOf(channel));
    Curve curve;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i])
            curve.push_back({function.nodes[i].hu, valueOf(function.nodes[i], channel)});
    return curve;
}

TransferFunction withCurve(const TransferFunction& function, TissueChannel channel, const Curve& curve) {
    assert(!curve.empty());
    TransferFunction replacement;
    for (const CurvePoint& point : curve) {
        TransferNode node;
        node.hu = point.hu;
        node.opacity = point.value;  // stands for the channel's value
        replacement.nodes.push_back(node);
    }
    const auto take = [&](const TransferNode& node, const TransferNode& other) {
        return withValue(node, channel, other.opacity);
    };
    return {function.extinctionPerMm,
            joined(function, replacement, placesWithout(function.nodes, propertyOf(channel)), take)};
}

std::vector<ColourStop> coloursOf(const TransferFunction& function) {
    const std::vector<bool> points = pointsOf(function.nodes, NodeProperty::albedo);
    std::vector<ColourStop> stops;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i])
            stops.push_back({function.nodes[i].hu, function.nodes[i].albedo});
    return stops;
}

TransferFunction withColours(const TransferFunction& function, const std::vector<ColourStop>& stops) {
    assert(!stops.empty());
    TransferFunction replacement;
    for (const ColourStop& stop : stops) {
        TransferNode node;
        node.hu = stop.hu;
        node.albedo = stop.albedo;
        replacement.nodes.push_back(node);
    }
    const auto take = [](TransferNode node, const TransferNode& other) {
        node.albedo = other.albedo;
        return node;
    };
    return {function.extinctionPerMm,
            joined(function, replacement, placesWithout(function.nodes, NodeProperty::albedo), take)};
}

TransferFunction withRoomFor(TransferFunction function, float extinctionPerMm) {
    if (extinctionPerMm <= function.extinctionPerMm)
        return function;
    for (TransferNode& node : function.nodes)
        node.opacity *= function.extinctionPerMm / extinctionPerMm;
    function.extinctionPerMm = extinctionPerMm;
    return function;
}

TransferFunction shiftedAndWidened(TransferFunction function, float hu, float centre, float factor) {
    for (TransferNode& node : function.nodes)
        node.hu = std::clamp(centre + (node.hu - centre) * factor + hu, kLowestHu, kHighestHu);
    return function;
}

}  // namespace pdr
