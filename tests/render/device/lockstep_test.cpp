/// The code that shares a queue among a GPU's threads (walk_queue.h), in warps that run in lockstep on the CPU.

#include <QTest>

#include <atomic>
#include <vector>

#include "app/bench/parity/scenes.h"
#include "render/device/device_list.h"
#include "render/device/emulated/host_gpu.h"
#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

/// Walks of any length, some of which never begin.
struct UnevenWalks {
    static constexpr const char* kName = "uneven";
    std::uint32_t* begun;
    std::uint32_t* steps;

    struct Walk {
        std::int64_t index;
        int left;
    };
    static int length(std::int64_t index) { return int(index * index * 7 % 23); }

    bool start(std::int64_t index, Walk& walk) const {
        atomicAddTo(begun[index], 1);
        walk = {index, length(index)};
        return walk.left > 0;
    }
    bool step(Walk& walk) const {
        atomicAddTo(steps[walk.index], 1);
        return --walk.left > 0;
    }
};

}  // namespace

class LockstepTest : public QObject {
    Q_OBJECT

  private slots:
    void noWalkIsLostOrDoubled() {
        for (const std::int64_t count : {0, 1, 31, 32, 33, 1000, 10'007}) {
            HostGpu gpu(0, 3, HostGpu::Walks::inWarps);
            std::vector<std::uint32_t> begun(std::size_t(count) + 64, 0), steps(begun);
            gpu.launchQueued(UnevenWalks{begun.data(), steps.data()}, count, GpuStream::compute);
            QVERIFY(!gpu.takeError());
            for (std::size_t i = 0; i < begun.size(); ++i) {
                const bool asked = std::int64_t(i) < count;
                QCOMPARE(begun[i], std::uint32_t(asked));
                QCOMPARE(steps[i], std::uint32_t(asked ? UnevenWalks::length(std::int64_t(i)) : 0));
            }
        }
    }

    /// Lanes whose walks have ended take others: most are busy, although one walk in 23 is 22 steps long and many have
    /// none.
    void lanesAreRefilled() {
        HostGpu gpu(0, 1, HostGpu::Walks::inWarps);
        constexpr std::int64_t kCount = 20'000;
        std::vector<std::uint32_t> begun(kCount, 0), steps(kCount, 0);
        gpu.launchQueued(UnevenWalks{begun.data(), steps.data()}, kCount, GpuStream::compute);
        const WarpCounts& counts = gpu.warpCounts().at("uneven");
        QCOMPARE(counts.started, std::uint64_t(kCount));
        const double busy = double(counts.stepped) / double(counts.steps);
        QVERIFY2(busy > 24 && busy <= kWarp, qPrintable(QString::number(busy)));
    }

    /// A warp whose threads do not all meet is a fault, as it is on a GPU.
    void whoAsksAloneIsSeen() {
        LockstepWarp warp;
        const auto nobody = [] {};
        QVERIFY(warp.run([](const LockstepWarp::Lane& lane) { lane.ballot(true); }, nobody));
        QVERIFY(!LockstepWarp().run(
            [](const LockstepWarp::Lane& lane) {
                if (lane.lane() != 5)
                    lane.ballot(true);
            },
            nobody));
    }

    void lanesHearEachOther() {
        std::atomic<int> wrong = 0;
        const bool together = LockstepWarp().run(
            [&](const LockstepWarp::Lane& lane) {
                for (int round = 0; round < 100; ++round) {
                    const std::uint32_t votes = lane.ballot((lane.lane() + round) % 3 == 0);
                    for (int other = 0; other < kWarp; ++other)
                        wrong += (votes >> other & 1) != std::uint32_t((other + round) % 3 == 0);
                    wrong += lane.broadcast(std::uint64_t(1000 * lane.lane() + round)) != std::uint64_t(round);
                }
            },
            [] {});
        QVERIFY(together);
        QCOMPARE(wrong.load(), 0);
    }

    void warpsGiveTheCpusImages() {
        const auto warps = openDevice("lockstep");
        const auto cpu = makeCpuDevice();
        for (const bench::ParityScene& one : bench::parityScenes()) {
            Scene scene = one.scene;
            scene.film = {37, 21};
            const Film theirs = test::render(scene, 5, *cpu), ours = test::render(scene, 5, **warps);
            QVERIFY2(sameBits(theirs.content(), ours.content()), one.name.c_str());
        }
    }
};

QTEST_GUILESS_MAIN(LockstepTest)
#include "lockstep_test.moc"
