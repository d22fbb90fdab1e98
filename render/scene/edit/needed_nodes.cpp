#include "render/scene/edit/needed_nodes.h"

#include <algorithm>
#include <array>
#include <limits>

namespace pdr {
namespace {

constexpr std::size_t kNumbers = 11;
constexpr double kStraight = 1e-6;  ///< tolerance relative to the largest value: several times the rounding of a float

using Numbers = std::array<double, kNumbers>;

constexpr std::array<NodeProperty::Bits, kNumbers> kOwners{
    NodeProperty::opacity,  NodeProperty::albedo,   NodeProperty::albedo,   NodeProperty::albedo,
    NodeProperty::emission, NodeProperty::emission, NodeProperty::emission, NodeProperty::specular,
    NodeProperty::specular, NodeProperty::specular, NodeProperty::roughness};

Numbers numbersOf(const TransferNode& node) {
    return {node.opacity,    node.albedo.x,   node.albedo.y,   node.albedo.z,   node.emission.x, node.emission.y,
            node.emission.z, node.specular.x, node.specular.y, node.specular.z, node.roughness};
}

struct Place {
    double hu;
    Numbers values;
};

/// All lines from one place that miss none of the places after it by more than the tolerance.
class Cone {
  public:
    Cone(const Place& from, const Numbers& tolerance, unsigned properties)
        : from_(from), tolerance_(tolerance), properties_(properties) {
        lowest_.fill(-std::numeric_limits<double>::infinity());
        highest_.fill(std::numeric_limits<double>::infinity());
    }

    /// Returns whether a straight line to `place` is one of them.
    bool reaches(const Place& place) const {
        const double distance = place.hu - from_.hu;
        for (std::size_t n = 0; n < kNumbers; ++n) {
            const double rise = place.values[n] - from_.values[n];
            if (!(kOwners[n] & properties_))
                continue;
            if (distance > 0 ? rise < lowest_[n] * distance || rise > highest_[n] * distance : rise != 0)
                return false;
        }
        return true;
    }

    /// Restricts the cone to lines that do not miss `place`.
    void pass(const Place& place) {
        const double distance = place.hu - from_.hu;
        for (std::size_t n = 0; n < kNumbers && distance > 0; ++n) {
            const double rise = place.values[n] - from_.values[n];
            lowest_[n] = std::max(lowest_[n], (rise - tolerance_[n]) / distance);
            highest_[n] = std::min(highest_[n], (rise + tolerance_[n]) / distance);
        }
    }

  private:
    Place from_;
    Numbers tolerance_;
    unsigned properties_;
    Numbers lowest_, highest_;
};

Numbers toleranceOf(const std::vector<TransferNode>& nodes) {
    Numbers largest{};
    for (const TransferNode& node : nodes) {
        const Numbers values = numbersOf(node);
        std::transform(largest.begin(), largest.end(), values.begin(), largest.begin(),
                       [](double a, double b) { return std::max(a, b); });
    }
    for (double& number : largest)
        number *= kStraight;
    return largest;
}

}  // namespace

/// Extends a straight line from each needed node as far as it goes. A place far away on either side stands for the
/// constant values outside the nodes.
std::vector<bool> neededBy(const std::vector<TransferNode>& nodes, unsigned properties) {
    constexpr double kFar = 1e9;  // [HU]: a line from there is level
    std::vector<Place> places{{nodes.front().hu - kFar, numbersOf(nodes.front())}};
    for (const TransferNode& node : nodes)
        places.push_back({node.hu, numbersOf(node)});
    places.push_back({nodes.back().hu + kFar, numbersOf(nodes.back())});

    const Numbers tolerance = toleranceOf(nodes);
    std::vector<bool> needed(nodes.size());
    Cone cone(places.front(), tolerance, properties);
    for (std::size_t i = 1; i < places.size(); ++i) {
        if (!cone.reaches(places[i])) {
            if (i > 1 && !needed[i - 2]) {  // the place before is a corner
                needed[i - 2] = true;
                cone = Cone(places[i - 1], tolerance, properties);
            }
            if (!cone.reaches(places[i])) {  // a step
                needed[i - 1] = true;
                cone = Cone(places[i], tolerance, properties);
                continue;
            }
        }
        cone.pass(places[i]);
    }
    return needed;
}

}  // namespace pdr
