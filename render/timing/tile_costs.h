#pragma once
/// How unlike the tiles of a picture are, and how long the last node works on where nodes take a tile whenever they
/// have none.

#include <vector>

namespace pdr {

/// A histogram of tiles by what they cost, in parts of the mean.
class TileCosts {
  public:
    /// All tiles are alike.
    TileCosts() = default;
    /// Of measured tiles, in any unit, each >= 0; of no tiles, and where none costs anything: all alike.
    explicit TileCosts(std::vector<double> measured);

    /// The same tiles where only `share` in [0, 1] of the mean varies with them; the rest is spent on every tile.
    TileCosts diluted(double share) const;

    double deviation() const;  ///< standard deviation over the mean
    /// Ascending, each >= 0, of mean 1; one at least.
    const std::vector<double>& sorted() const { return sorted_; }

  private:
    std::vector<double> sorted_{1.0};
};

/// How much longer than the mean the last of `nodes` works, in parts of a tile's mean cost: they take tiles from one
/// heap, and `tilesPerNode` tiles were there for each. Nodes and tiles >= 1, as many as there are tiles for.
double overhang(const TileCosts& costs, double nodes, double tilesPerNode);

/// Longest over mean time of a node, lambda_b: 1 + overhang / tilesPerNode.
double imbalance(const TileCosts& costs, double nodes, double tilesPerNode);

/// Whether the nodes end each tile nearly together, so that their results come all at once: overhang() is then that of
/// sums that hardly differ and not that of tiles which began at any time.
bool inStep(const TileCosts& costs, double nodes, double tilesPerNode);

}  // namespace pdr
