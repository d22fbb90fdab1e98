#include <QTest>

#include <map>

#include "render/film/tile_progress.h"
#include "render/tiles/worker.h"

using namespace pdr;

namespace {

/// Which cells of a tile are audited how often, in so many results; by the corner of the cell.
std::map<std::pair<int, int>, int> auditsOf(const Tile& tile, int results) {
    Trust trust(3);
    std::map<std::pair<int, int>, int> cells;
    for (int y = tile.y; y < tile.y + tile.height; y += kFilmCell)
        for (int x = tile.x; x < tile.x + tile.width; x += kFilmCell)
            cells[{x, y}] = 0;
    for (int i = 0; i < results; ++i)
        if (const auto part = trust.partToAudit(tile))
            for (int y = part->y; y < part->y + part->height; y += kFilmCell)
                for (int x = part->x; x < part->x + part->width; x += kFilmCell)
                    ++cells.at({x, y});
    return cells;
}

}  // namespace

/// How far a worker is trusted, and what it is known to do.
class WorkerTest : public QObject {
    Q_OBJECT

  private slots:
    void trustIsEarned() {
        Trust trust(1);
        QVERIFY(trust.isStranger());
        for (double confirmed = 0; confirmed < Trust::kProof; confirmed += 1024) {
            QVERIFY(!trust.isProved());
            trust.confirmed(1024);
            QVERIFY(!trust.isStranger());
        }
        QVERIFY(trust.isProved());
    }

    void anyCellIsAuditedAsOftenAsAnyOther_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        for (const auto& [width, height] : {std::pair{16, 16}, {5, 7}, {512, 512}, {250, 130}, {1920, 16}, {16, 1080}})
            QTest::addRow("%d x %d", width, height) << width << height;
    }
    /// One chance in 50, with five standard deviations of room for each of up to 1024 cells: a false alarm of 1e-3, if
    /// the seed were another one.
    void anyCellIsAuditedAsOftenAsAnyOther() {
        QFETCH(const int, width);
        QFETCH(const int, height);
        constexpr int kResults = 50000;
        const double expected = double(kResults) / Trust::kOneIn, room = 5 * std::sqrt(expected);
        for (const auto& [cell, times] : auditsOf({48, 32, width, height}, kResults))
            QVERIFY2(std::abs(times - expected) < room, qPrintable(QString::number(times)));
    }

    void partsAreWholeCellsOfTheTile() {
        Trust trust(2);
        const Tile area{0, 0, 250, 130}, tile{32, 48, 218, 82};  // up to its lower right corner
        const TileProgress progress(area);
        for (int i = 0; i < 2000; ++i)
            if (const auto part = trust.partToAudit(tile))
                QVERIFY(part->width > 0 && part->height > 0 && isInside(*part, tile) && progress.isWholeCells(*part));
    }

    void speedFollowsWhatIsMeasured() {
        WorkerSpeed speed;
        QVERIFY(!speed.isKnown());
        speed.add(100, 1);
        QCOMPARE(speed.perSecond(), 100.0);
        for (int i = 0; i < 50; ++i)
            speed.add(100, 0.5);
        QVERIFY(std::abs(speed.perSecond() - 200) < 0.1);
    }
};

QTEST_APPLESS_MAIN(WorkerTest)
#include "worker_test.moc"
