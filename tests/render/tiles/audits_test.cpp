#include <QTest>

#include "tests/support/network/made_up_nodes.h"

using namespace pdr;
using namespace pdr::test;

namespace {

constexpr int kRuns = 300;
/// Its cells are a thousand.
constexpr int kSide = 512;

Film square(int side) {
    return Film(Tile{0, 0, side, side}, 0);
}

}  // namespace

/// Who renders results of workers a second time, and what is found by it.
class AuditsTest : public QObject {
    Q_OBJECT

  private slots:
    /// The share of images in which a liar is found is as the documentation of Trust says, within 3.6 standard
    /// deviations of 300 images. The seeds are fixed.
    void liarIsFoundWithTheStatedProbability_data() {
        QTest::addColumn<int>("oneIn");
        QTest::addColumn<double>("room");
        QTest::newRow("a pixel in every 20th result") << 20 << 0.1;
        QTest::newRow("a pixel in every 200th result") << 200 << 0.065;
    }
    void liarIsFoundWithTheStatedProbability() {
        QFETCH(const int, oneIn);
        QFETCH(const double, room);
        int found = 0;
        Film film = square(kSide);
        for (std::uint64_t run = 0; run < kRuns; ++run) {
            MadeUpNodes nodes(run, {{.liesOneIn = std::uint64_t(oneIn)}, {}});
            (void)nodes.renders(film, 64);
            found += nodes.worker(0).isQuarantined();
        }
        const double share = double(found) / kRuns;
        const double expected = 1 - std::pow(1 - 1.0 / Trust::kOneIn, 512.0 / oneIn);  // half of the cells are its own
        QVERIFY2(std::abs(share - expected) < room, qPrintable(QString::number(share)));
    }

    void liarIsAlwaysFoundWhereAllIsChecked_data() {
        QTest::addColumn<int>("oneIn");
        QTest::addColumn<int>("side");
        QTest::newRow("a pixel in every 20th result") << 20 << 192;
        QTest::newRow("a pixel in every 200th result") << 200 << 512;
    }
    void liarIsAlwaysFoundWhereAllIsChecked() {
        QFETCH(const int, oneIn);
        QFETCH(const int, side);
        Film film = square(side);
        for (std::uint64_t run = 0; run < kRuns; ++run) {
            MadeUpNodes nodes(run, {{.liesOneIn = std::uint64_t(oneIn)}, {}});
            nodes.state().checksAll = true;
            QVERIFY2(!nodes.renders(film, 64), "a lie is in the image");
            QVERIFY(nodes.liesOf(0) > 0 && nodes.worker(0).isQuarantined());
            QVERIFY(!nodes.worker(1).isQuarantined());
            QCOMPARE(nodes.checks().share(), 1.0);
        }
    }

    /// With one node the own device renders all again.
    void oneNodeIsCheckedByTheOwnDevice() {
        MadeUpNodes nodes(1, {{}});
        nodes.state().checksAll = true;
        Film film = square(256);
        QVERIFY(!nodes.renders(film, 64));
        QCOMPARE(nodes.ownAudits(), nodes.checks().results);
    }

    /// A relay tells of all that it has checked since it began.
    void checksOfEarlierFilmsAreKept() {
        MadeUpNodes nodes(1, {{}});
        nodes.state().checksAll = true;
        Film film = square(256);
        QVERIFY(!nodes.renders(film, 64));
        const NodeChecks before = nodes.checks();
        nodes.discarded();
        QVERIFY(before.results > 0 && nodes.checks().results == 0);
        QCOMPARE(nodes.allChecks().results, before.results);
        QCOMPARE(nodes.allChecks().checked, before.checked);
    }

    /// Whoever tells another result of somebody's samples is judged by the own device.
    void whoChecksWronglyIsFound() {
        MadeUpNodes nodes(1, {{}, {.checksWrongly = 100}, {}});
        nodes.state().checksAll = true;
        Film film = square(kSide);
        QVERIFY(!nodes.renders(film, 64));
        QVERIFY(nodes.worker(1).isQuarantined());
        QVERIFY(!nodes.worker(0).isQuarantined() && !nodes.worker(2).isQuarantined());
    }

    /// However many nodes there are, the own device has little to do, and as much is checked.
    void checksKeepUpWithManyNodes() {
        Film film = square(1024);
        for (const std::size_t count : {16, 64}) {
            MadeUpNodes nodes(5, std::vector<MadeUpNodes::Nature>(count));
            for (int image = 0; image < 4; ++image)  // until all are proved
                (void)nodes.renders(film, 64);
            for (std::size_t node = 0; node < count; ++node)
                QVERIFY(nodes.worker(node).trust.isProved());
            const std::uint64_t before = nodes.ownAudits();
            (void)nodes.renders(film, 64, 0);
            QCOMPARE(nodes.ownAudits(), before);
            const double share = nodes.checks().share();  // of 4096 cells: 0.02 +- 0.0022
            QVERIFY2(std::abs(share - 0.02) < 0.009, qPrintable(QString::number(share)));
        }
    }

    /// Proving nodes costs a twentieth of an image at most, and no sample of a stranger is in one.
    void provingNodesIsCheap_data() {
        QTest::addColumn<int>("side");
        QTest::addColumn<int>("samples");
        for (const auto& [side, samples] : {std::pair{96, 64}, {96, 1}, {256, 64}, {60, 256}, {512, 4}})
            QTest::addRow("%d x %d, %d samples", side, side, samples) << side << samples;
    }
    void provingNodesIsCheap() {
        QFETCH(const int, side);
        QFETCH(const int, samples);
        for (const std::size_t count : {1, 4, 16}) {
            Film film = square(side);
            SharedRequest request(film, 1, {{film.area(), 0, std::uint64_t(samples)}}, Split::tiles, 1, {});
            double cost = 0;
            for (WorkerId worker = 1; worker <= count; ++worker)
                while (const auto portion = request.takeProof(worker, {1e30, 1e6}, 0))
                    cost += workOf(portion->tile, portion->samples);
            QVERIFY(cost > 0);
            QVERIFY(cost <= 0.05 * side * side * samples);
        }
    }

    /// An image that cannot afford to check a cell is rendered by the own device, whoever should.
    void strangersGetNothingThatCannotBeChecked() {
        WorkerPool pool(1);
        pool.setOwnHelps(false);
        pool.setSplit(Split::tiles);
        const WorkerId stranger = pool.join("key", "name");
        const std::uint64_t scene = pool.publish(Purpose::viewport, std::make_shared<const Scene>());
        pool.hasScene(stranger, scene);
        Film film(Tile{0, 0, 64, 64}, 0);
        QVERIFY(pool.begin(film, scene, {{film.area(), 0, 1}}, {}));
        QVERIFY(!pool.take(stranger));
        const auto work = pool.nextOwn({});
        QVERIFY(work && work->lease && !work->audit);
        (void)pool.end();
    }

    void liarWhoIsNewIsFoundBeforeTheFilmHasALie() {
        Film film = square(96);
        for (std::uint64_t run = 0; run < 20; ++run) {
            MadeUpNodes nodes(run, {{.liesOneIn = 1}, {}});
            QVERIFY(!nodes.renders(film, 64));
            QVERIFY(nodes.worker(0).isQuarantined());
            QCOMPARE(nodes.worker(0).status.results, 0u);
        }
    }

    /// A lease that a worker gives back goes to another one, never to the same: it would look like an attack.
    void auditIsGivenToNobodyTwice() {
        const auto proved = [](WorkerId id) {
            Worker worker(id, std::to_string(id), "name", 1);
            worker.trust.confirmed(Trust::kProof);
            worker.speed.add(1000, 1);
            return worker;
        };
        const Worker author = proved(1), one = proved(2), other = proved(3);
        Audits audits;
        audits.add({.worker = 1, .key = "1", .lease = {.number = 9}, .cost = 10});
        QVERIFY(!audits.give(author, 0, 0));
        QCOMPARE(audits.give(one, 0, 0)->number, 9u);
        QVERIFY(!audits.give(other, 0, 0) && !audits.takeLate(0.01));
        audits.giveBackAll(2);
        QVERIFY(!audits.give(one, 0, 0));
        QVERIFY(audits.give(other, 0, 0) && !audits.takeFrom(2, 9));
        QCOMPARE(audits.expire(100), std::vector<WorkerId>{3});
        QVERIFY(!audits.areDone() && audits.takeLate(100) && audits.areDone());
    }

    void whatWouldHaveBeenFound() {
        const NodeChecks checks{4096, 1000, 20};
        QCOMPARE(checks.share(), 0.02);
        QVERIFY(std::abs(checks.foundWith(200) - 0.3388) < 1e-3);
        QCOMPARE((NodeChecks{100, 7, 7}.foundWith(200)), 1.0);
        QCOMPARE(NodeChecks{}.foundWith(200), 0.0);
    }
};

QTEST_APPLESS_MAIN(AuditsTest)
#include "audits_test.moc"
