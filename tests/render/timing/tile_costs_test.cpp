#include "render/timing/tile_costs.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <random>

using namespace pdr;

namespace {

/// Returns a random number from 0 to 1, the same on every machine.
double chance(std::mt19937& random) {
    return (double(random()) + 0.5) / 4294967296.0;
}

std::vector<double> evenly(double low, double high) {
    std::vector<double> costs;
    for (int i = 0; i < 1000; ++i)
        costs.push_back(low + (high - low) * (i + 0.5) / 1000);
    return costs;
}

std::vector<double> exponential() {
    std::vector<double> costs;
    for (const double u : evenly(0, 1))
        costs.push_back(-std::log(u));
    return costs;
}

/// Returns the costs of an image half of which is air.
std::vector<double> halfAir() {
    std::vector<double> costs(1000, 0.05);
    const std::vector<double> tissue = evenly(1, 2.9);
    costs.insert(costs.end(), tissue.begin(), tissue.end());
    return costs;
}

/// Returns the longest over the mean time of a node if `nodes` take tiles from one queue, as a mean over many images.
double played(const TileCosts& costs, int nodes, int tilesPerNode, int images) {
    std::mt19937 random(7);
    double sum = 0;
    for (int image = 0; image < images; ++image) {
        std::priority_queue<double, std::vector<double>, std::greater<>> ends;
        for (int node = 0; node < nodes; ++node)
            ends.push(0);
        double all = 0, last = 0;
        for (int tile = 0; tile < nodes * tilesPerNode; ++tile) {
            const auto& sorted = costs.sorted();
            const double cost = sorted[std::size_t(chance(random) * double(sorted.size()))];
            const double end = ends.top() + cost;
            ends.pop();
            ends.push(end);
            all += cost;
            last = std::max(last, end);
        }
        sum += last / (all / nodes);
    }
    return sum / images;
}

}  // namespace

class TileCostsTest : public QObject {
    Q_OBJECT

  private slots:
    void costsAreInPartsOfTheirMean() {
        const TileCosts costs({6, 2, 4});
        QCOMPARE(costs.sorted(), (std::vector<double>{0.5, 1, 1.5}));
        QVERIFY(std::fabs(costs.deviation() - std::sqrt(1.0 / 6)) < 1e-12);
        QCOMPARE(TileCosts(std::vector<double>()).sorted(), std::vector<double>{1});
        QCOMPARE(TileCosts({0, 0}).sorted(), std::vector<double>{1});
    }

    void whatEveryTileCostsDilutesTheirDifferences() {
        const TileCosts costs({6, 2, 4});
        QCOMPARE(costs.diluted(1).sorted(), costs.sorted());
        QCOMPARE(costs.diluted(0).deviation(), 0.0);
        QVERIFY(std::fabs(costs.diluted(0.5).deviation() - costs.deviation() / 2) < 1e-12);
    }

    void oneNodeAndTilesThatAreAlikeLeaveNobodyBehind() {
        for (const double nodes : {1.0, 2.0, 1000.0, 100'000.0})
            QCOMPARE(overhang(TileCosts(), nodes, 8), 0.0);
        QCOMPARE(overhang(TileCosts(exponential()), 1, 8), 0.0);
    }

    /// No schedule without idle nodes is later by more than its longest tile: Graham, Bounds on Multiprocessing Timing
    /// Anomalies, 1969.
    void nobodyIsLaterThanTheLongestTile() {
        for (const TileCosts& costs : {TileCosts(evenly(0, 2)), TileCosts(exponential()), TileCosts(halfAir())})
            for (const double nodes : {2.0, 64.0, 1e5, 1e9}) {
                QVERIFY(overhang(costs, nodes, 64) > 0);
                QVERIFY(overhang(costs, nodes, 64) <= costs.sorted().back() * (1 - 1 / nodes));
            }
    }

    /// If each node has one tile, all wait for the longest.
    void aTileEachTakesAsLongAsTheLongest() {
        for (const TileCosts& costs : {TileCosts(evenly(0.5, 1.5)), TileCosts(halfAir())})
            for (const int nodes : {64, 1000})
                QVERIFY(std::fabs(imbalance(costs, nodes, 1) / played(costs, nodes, 1, 50) - 1) < 0.05);
    }

    void nodesThatTakeTilesEndAsForetold() {
        struct Kind {
            const char* name;
            std::vector<double> costs;
        };
        const Kind kinds[] = {{"5 %", evenly(0.95, 1.05)}, {"20 %", evenly(0.8, 1.2)}, {"half", evenly(0.5, 1.5)},
                              {"all", evenly(0, 2)},       {"air", halfAir()},         {"exponential", exponential()}};
        for (const Kind& kind : kinds)
            for (const int tiles : {8, 16, 64})
                for (const int nodes : {2, 8, 64, 1000}) {
                    const TileCosts costs(kind.costs);
                    const double truth = played(costs, nodes, tiles, nodes < 100 ? 200 : 4);
                    const double told = imbalance(costs, nodes, tiles);
                    QVERIFY2(std::fabs(told / truth - 1) < 0.05,
                             qPrintable(QString("%1, %2 tiles, %3 nodes: %4 foretold, %5 played")
                                            .arg(kind.name)
                                            .arg(tiles)
                                            .arg(nodes)
                                            .arg(told)
                                            .arg(truth)));
                }
    }
};

QTEST_GUILESS_MAIN(TileCostsTest)
#include "tile_costs_test.moc"
