#include <QTest>

#include <cmath>
#include <random>

#include "render/film/tile_progress.h"
#include "render/tiles/cell_costs.h"

using namespace pdr;

namespace {

constexpr Tile kArea{32, 16, 330, 250};  // whose right and lower cells are cut
constexpr Tile kHead{112, 64, 128, 112};

/// Pixels of the head cost six times as much.
double trueCost(const Tile& tile) {
    double cost = 0;
    for (int y = tile.y; y < tile.y + tile.height; ++y)
        for (int x = tile.x; x < tile.x + tile.width; ++x)
            cost += isInside({x, y, 1, 1}, kHead) ? 6 : 1;
    return cost;
}

/// Tiles of an order as a scheduler cuts it: others in each order.
std::vector<Tile> tilesOf(const Tile& area, unsigned order) {
    const int width = kFilmCell * int(2 + order * 5 % 7), height = kFilmCell * int(1 + order * 3 % 4);
    std::vector<Tile> tiles;
    for (int y = 0; y < area.height; y += height)
        for (int x = 0; x < area.width; x += width)
            tiles.push_back(
                {area.x + x, area.y + y, std::min(width, area.width - x), std::min(height, area.height - y)});
    return tiles;
}

/// An order by two workers, one of which is three times as fast.
std::vector<TimedLease> done(const std::vector<Tile>& tiles, double noise, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> factor(1 - noise, 1 + noise);
    std::vector<TimedLease> leases;
    for (const Tile& tile : tiles) {
        const WorkerId worker = 1 + random() % 2;
        leases.push_back({worker, tile, 64, trueCost(tile) * 64 * 1e-7 * (worker == 1 ? 1 : 3) * factor(random)});
    }
    return leases;
}

double ratio(const CellCosts& costs, const Tile& tile) {
    return costs.ofSample(tile) / costs.ofSample(kArea) * trueCost(kArea) / trueCost(tile);
}

}  // namespace

/// What parts of an image cost, found by rendering them.
class CellCostsTest : public QObject {
    Q_OBJECT

  private slots:
    void nothingKnownMeansAllAlike() {
        QCOMPARE(CellCosts().ofSample({5, 7, 100, 10}), 1000.0);
        const CellCosts costs(kArea);
        QVERIFY(!costs.isKnown());
        QCOMPARE(costs.ofSample(kArea), 330.0 * 250);
        QCOMPARE(costs.ofSample({kArea.x + 320, kArea.y + 240, 10, 10}), 100.0);
        QCOMPARE(costs.ofSample({kArea.x + 16, kArea.y + 32, 48, 16}), 48.0 * 16);
    }

    void dearCellsAreFound() {
        CellCosts costs(kArea);
        for (unsigned order = 0; order < 20; ++order)
            costs.learn(done(tilesOf(kArea, order), 0.1, order));
        QVERIFY(costs.isKnown());
        QVERIFY(std::abs(costs.ofSample(kArea) / (330.0 * 250) - 1) < 1e-9);
        for (const Tile& tile : {kHead, Tile{32, 16, 80, 250}, Tile{32, 176, 330, 90}})
            QVERIFY2(std::abs(ratio(costs, tile) - 1) < 0.15, qPrintable(QString::number(ratio(costs, tile))));
    }

    /// A block of samples after the other, of the same tile: no reason to believe it more than once.
    void sameTileTwiceCountsOnce() {
        CellCosts once(kArea), twice(kArea);
        std::vector<TimedLease> leases = done(tilesOf(kArea, 1), 0, 1);
        once.learn(leases);
        const std::vector<TimedLease> again = leases;
        leases.insert(leases.end(), again.begin(), again.end());
        twice.learn(leases);
        QVERIFY(std::abs(once.ofSample(kHead) / twice.ofSample(kHead) - 1) < 1e-9);
    }

    void slowWorkersDoNotMakeCellsDear() {
        CellCosts costs(kArea);
        const Tile upper{kArea.x, kArea.y, kArea.width, 128}, lower{kArea.x, kArea.y + 128, kArea.width, 122};
        costs.learn({{1, upper, 64, 1.0}, {2, lower, 64, 5.0}});
        QVERIFY(std::abs(costs.ofSample(upper) / (330.0 * 128) - 1) < 1e-9);
    }

    void whatNobodyCanMeanDoesNoHarm() {
        CellCosts costs(kArea);
        costs.learn({});
        QVERIFY(!costs.isKnown());
        costs.learn({{1, kHead, 64, 0}, {2, kHead, 64, -1}, {3, kHead, 0, 1}, {4, kHead, 64, std::nan("")}});
        QCOMPARE(costs.ofSample(kHead), 128.0 * 112);
        costs.learn({{1, kHead, 64, 1e300}, {1, {32, 16, 16, 16}, 64, 1e-300}});
        const double head = costs.ofSample(kHead), rest = costs.ofSample(kArea) - head;
        QVERIFY(std::isfinite(head) && head > 0 && rest > 0);
    }

    /// The image of the previous test, with more pixels.
    void anotherSizeIsTheSameImage() {
        CellCosts coarse(kArea);
        for (unsigned order = 0; order < 8; ++order)
            coarse.learn(done(tilesOf(kArea, order), 0, order));
        const Tile area{0, 0, 660, 500};
        const CellCosts fine = coarse.stretchedOver(area);
        QVERIFY(fine.isKnown() && fine.area() == area);
        QVERIFY(std::abs(fine.ofSample(area) / (660.0 * 500) - 1) < 1e-9);
        const Tile head{160, 96, 256, 224};
        const double part = fine.ofSample(head) / fine.ofSample(area),
                     was = coarse.ofSample(kHead) / coarse.ofSample(kArea);
        QVERIFY2(std::abs(part / was - 1) < 0.2, qPrintable(QString("%1 %2").arg(part).arg(was)));
        QVERIFY(!CellCosts(kArea).stretchedOver(area).isKnown());
    }
};

QTEST_APPLESS_MAIN(CellCostsTest)
#include "cell_costs_test.moc"
