#include "render/timing/tile_costs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/base/significance.h"

namespace pdr {

namespace {

/// Returns the expected maximum of `count` standard normal numbers. Blom, Statistical Estimates and Transformed
/// Beta-Variables, 1958: the quantile (count - 3/8) / (count + 1/4).
double greatestOfNormals(double count) {
    return count > 1 ? normalZ(1.25 / (count + 0.25)) : 0;
}

/// Returns the overhang if every node processes equally many tiles: the expected maximum of sums that are nearly
/// normal.
double overhangOfSums(const TileCosts& costs, double nodes, double tilesPerNode) {
    return greatestOfNormals(nodes) * costs.deviation() * std::sqrt(tilesPerNode);
}

/// Returns the overhang if tiles end at any time. When no tile is left, every node is somewhere in its last one. The
/// rest of that tile is distributed as the residual life of a renewal process, G(x) = integral of 1 - F over [0, x]
/// (Feller, An Introduction to Probability Theory, vol. 2, XI.4). The result is the expected maximum of `nodes` such
/// rests minus their mean; it is exact for the steps of F, between which G is linear.
double overhangOfRests(const TileCosts& costs, double nodes) {
    const std::vector<double>& sorted = costs.sorted();
    const double count = double(sorted.size());
    double reached = 0, before = 0, greatest = 0, mean = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const double width = sorted[i] - reached, slope = (count - double(i)) / count;
        mean += sorted[i] * sorted[i] / (2 * count);
        if (!(width > 0))
            continue;
        const double after = std::min(1.0, before + slope * width);
        greatest += width - (std::pow(after, nodes + 1) - std::pow(before, nodes + 1)) / ((nodes + 1) * slope);
        reached = sorted[i];
        before = after;
    }
    return greatest - mean;
}

/// Returns the expected cost of the longest of `tiles` tiles that are drawn from the histogram.
double longestOf(const TileCosts& costs, double tiles) {
    const double count = double(costs.sorted().size());
    double longest = 0, before = 0;
    for (std::size_t i = 0; i < costs.sorted().size(); ++i) {
        const double after = std::pow(double(i + 1) / count, tiles);
        longest += costs.sorted()[i] * (after - before);
        before = after;
    }
    return longest;
}

}  // namespace

TileCosts::TileCosts(std::vector<double> measured) : sorted_(std::move(measured)) {
    const double sum = std::accumulate(sorted_.begin(), sorted_.end(), 0.0);
    if (!(sum > 0)) {
        sorted_ = {1.0};
        return;
    }
    std::ranges::sort(sorted_);
    for (double& cost : sorted_)
        cost *= double(sorted_.size()) / sum;
}

TileCosts TileCosts::diluted(double share) const {
    TileCosts costs = *this;
    for (double& cost : costs.sorted_)
        cost = 1 + share * (cost - 1);
    return costs;
}

double TileCosts::deviation() const {
    double squares = 0;
    for (const double cost : sorted_)
        squares += (cost - 1) * (cost - 1);
    return std::sqrt(squares / double(sorted_.size()));
}

double overhang(const TileCosts& costs, double nodes, double tilesPerNode) {
    if (!(nodes > 1))
        return 0;
    // No image ends before its longest tile; if every node has one tile, all wait for the longest
    const double longest = longestOf(costs, nodes * tilesPerNode) - tilesPerNode;
    const double last = std::min(overhangOfSums(costs, nodes, tilesPerNode), overhangOfRests(costs, nodes));
    return tilesPerNode > 1 ? std::max(last, longest) : longest;
}

double imbalance(const TileCosts& costs, double nodes, double tilesPerNode) {
    return 1 + overhang(costs, nodes, tilesPerNode) / tilesPerNode;
}

bool inStep(const TileCosts& costs, double nodes, double tilesPerNode) {
    return overhangOfSums(costs, nodes, tilesPerNode) < overhangOfRests(costs, nodes);
}

}  // namespace pdr
