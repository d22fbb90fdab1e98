#pragma once
/// How much the costs of an image's tiles differ, and how long the last node works on if nodes take a new tile whenever
/// they have none.

#include <vector>

namespace pdr {

/// A histogram of tile costs, relative to their mean.
class TileCosts {
  public:
    /// Makes all tiles equal.
    TileCosts() = default;
    /// Takes the costs of measured tiles, in any unit, each >= 0. Without tiles, or if none costs anything, all are
    /// equal.
    explicit TileCosts(std::vector<double> measured);

    /// Returns the same tiles if only the fraction `share`, [0, 1], of the mean varies with them and the rest is spent
    /// on every tile.
    TileCosts diluted(double share) const;

    double deviation() const;  ///< standard deviation over the mean
    /// Returns the costs in ascending order, each >= 0, with mean 1; at least one.
    const std::vector<double>& sorted() const { return sorted_; }

  private:
    std::vector<double> sorted_{1.0};
};

/// Returns how much longer than the mean the last of `nodes` works, in units of a tile's mean cost. Nodes take tiles
/// from one queue, which holds `tilesPerNode` tiles for each of them. Both are >= 1; `nodes` counts only nodes that get
/// tiles.
double overhang(const TileCosts& costs, double nodes, double tilesPerNode);

/// Returns the longest over the mean time of a node, lambda_b: 1 + overhang / tilesPerNode.
double imbalance(const TileCosts& costs, double nodes, double tilesPerNode);

/// Returns whether the nodes end each tile nearly together, so that their results come all at once. overhang() is
/// then that of sums that hardly differ, and not that of tiles which began at any time.
bool inStep(const TileCosts& costs, double nodes, double tilesPerNode);

}  // namespace pdr
