/// Hard cases of images that several machines make: 65 and 66, and what 13, 14, 58 and 59 are between workers.

#include <QtTest>

#include <chrono>
#include <cmath>
#include <numeric>
#include <random>

#include "render/base/angles.h"
#include "render/tiles/shared_device.h"
#include "tests/support/network/nearby_worker.h"
#include "tests/support/scenes/tissue_scene.h"

using namespace pdr;
using namespace pdr::test;

namespace {

/// The image of tissueScene() by the own device and so many workers.
FilmContent imageOf(int workers, std::uint32_t samples) {
    const auto pool = std::make_shared<WorkerPool>(1);
    std::vector<std::unique_ptr<NearbyWorker>> all;
    for (int i = 0; i < workers; ++i)
        all.push_back(std::make_unique<NearbyWorker>(pool, std::to_string(i)));
    const auto device = shareDevice(makeCpuDevice(1), pool);
    const auto film = *startFilm(*device, tissueScene());
    if (!film->accumulate(samples, {}))
        qFatal("it cannot be rendered");
    return (*film->film())->content();
}

}  // namespace

class MachinesTest : public QObject {
    Q_OBJECT

  private slots:
    /// 13
    void consumedNumbersDependOnWhoTakesThem() {
        // Naive: each worker draws from a generator of its own as it goes. Who takes four tiles decides their numbers.
        const auto naive = [](const std::vector<int>& workerOfTile) {
            std::vector<std::mt19937> generators{std::mt19937(1), std::mt19937(2)};
            std::vector<std::uint32_t> tiles;
            for (const int worker : workerOfTile)
                tiles.push_back(generators[std::size_t(worker)]());
            return tiles;
        };
        QVERIFY(naive({0, 1, 0, 1}) != naive({0, 0, 1, 1}));
        QVERIFY(sameBits(imageOf(3, 70), imageOf(0, 70)));
    }

    /// 14
    void sameSamplesTwiceLookLikeMoreSamples() {
        const Scene scene = tissueScene();
        const auto device = makeCpuDevice(1);
        QVERIFY(bool(device->upload(scene)));
        const Tile tile{0, 0, kFilmCell, kFilmCell};
        const LeaseResult result = *traceLease(*device, {1, 1, tile, {0, kSamplesPerBlock}, {}}, {});
        // Naive: what comes is added. The stated error shrinks by a square root of 2, and no image is better for it.
        Moments once = merged({}, result.sums[0]), twice = merged(once, result.sums[0]);
        QVERIFY(once.mean == twice.mean || glm::length(once.mean - twice.mean) < 1e-12);
        QVERIFY(standardErrorOf(twice).x < 0.75 * standardErrorOf(once).x || once.m2.x == 0);
        Film film(scene.film, scene.revision);
        const TileResult sent{scene.revision, tile, result.samples, result.sums, result.health};
        QVERIFY(bool(film.merge(sent)));
        QVERIFY(!film.merge(sent));
    }

    /// 58
    void partsAddedAsTheyComeDependOnWhoWasFirst() {
        // Naive: a float sum of parts in the order of their arrival.
        std::vector<float> parts(64);
        std::iota(parts.begin(), parts.end(), 0.1f);
        const float forward = std::accumulate(parts.begin(), parts.end(), 0.0f);
        const float backward = std::accumulate(parts.rbegin(), parts.rend(), 0.0f);
        QVERIFY(forward != backward);
        const FilmContent first = imageOf(2, 200), again = imageOf(2, 200);
        QVERIFY(sameBits(first, again));
        QVERIFY(sameBits(first, imageOf(0, 200)));
    }

    /// 59
    void tilesOfTwoWorkersShowASeam() {
        // Naive: each worker smooths its tile, and knows nothing of the next one.
        const auto denoised = [](const std::vector<double>& row) {
            std::vector<double> result(row.size());
            for (std::size_t i = 0; i < row.size(); ++i)
                result[i] = (row[i > 0 ? i - 1 : 0] + row[i] + row[std::min(i + 1, row.size() - 1)]) / 3;
            return result;
        };
        const std::vector<double> row{0, 1, 4, 9, 16, 25, 36, 49};
        std::vector<double> parts = denoised({row.begin(), row.begin() + 4});
        const std::vector<double> right = denoised({row.begin() + 4, row.end()});
        parts.insert(parts.end(), right.begin(), right.end());
        QVERIFY(parts != denoised(row));
        const FilmContent alone = imageOf(0, 20), together = imageOf(2, 20);
        QVERIFY(sameBits(alone.block, together.block));
    }

    /// 65
    void wallClockThatJumpsTakesAllWorkAway() {
        TileScheduler scheduler({{{0, 0, 64, 64}, 0, 1}}, Split::tiles, 1);
        const double now = poolSeconds();
        const auto portion = scheduler.take(1, {1e9, 1e6}, now);
        // Naive: the wall clock, which somebody sets.
        TileScheduler naive = scheduler;
        QCOMPARE(naive.expire(now + 3 * 86400), std::vector<WorkerId>{1});
        QVERIFY(scheduler.expire(poolSeconds()).empty());
        QVERIFY(scheduler.heldBy(1, portion->number));
        using Seconds = std::chrono::duration<double>;
        const auto steady = std::chrono::steady_clock::now();
        static_assert(std::chrono::steady_clock::is_steady);
        QVERIFY(std::abs(poolSeconds() - Seconds(steady.time_since_epoch()).count()) < 3600);
    }

    /// 66
    void librariesDisagreeInTheLastBit() {
        // Naive: whatever the mathematical library makes of it. This is another library's way: a fraction of series.
        const auto another = [](double x) { return x / (1 + x * x / 6 * (1 + 7 * x * x / 60)); };
        int different = 0;
        for (double x = 0.001; x < 0.01; x += 0.001)
            different += another(x) != std::sin(x);
        QVERIFY(different > 0);
        for (double x = 0.001; x < 0.01; x += 0.001)
            QVERIFY(std::abs(sineCosine(x).sine - std::sin(x)) <= 5e-16 * x);
        static_assert(sineCosine(0.5).sine > 0.479425538604 &&
                      sineCosine(0.5).sine < 0.479425538605);  // any compiler's
    }
};

QTEST_APPLESS_MAIN(MachinesTest)
#include "machines_test.moc"
