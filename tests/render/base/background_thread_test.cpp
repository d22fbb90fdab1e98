#include <sys/resource.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <QTest>
#include <algorithm>
#include <filesystem>
#include <latch>
#include <string>
#include <thread>
#include <vector>

#include "render/base/background_thread.h"
#include "render/session/session.h"
#include "tests/support/devices/screen.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

constexpr int kLowest = 19;  // of nice(1)

int priorityOfThisThread() {
    return getpriority(PRIO_PROCESS, id_t(gettid()));
}

constexpr int kThreads = 3;

/// Lets TBB start its threads, from this one, at its priority.
void startThreads() {
    tbb::task_arena arena(kThreads);
    std::latch allRun(kThreads);
    arena.execute([&] { tbb::parallel_for(0, kThreads, [&](int) { allRun.arrive_and_wait(); }); });
}

/// Returns the priorities of all threads of this program.
std::vector<int> priorities() {
    std::vector<int> all;
    for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task"))
        all.push_back(getpriority(PRIO_PROCESS, id_t(std::stoi(thread.path().filename().string()))));
    return all;
}

Scene someScene() {
    Scene scene = test::plainScene(test::bumpyVolume({40, 40, 40}, dvec3(1), 3), 1);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 600, .opacity = 1}};
    scene.film = {64, 64};
    return scene;
}

}  // namespace

class BackgroundThreadTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        if (priorityOfThisThread() >= kLowest)
            QSKIP("this test runs at the lowest priority already");
    }

    void onlyTheThreadThatAsksIsLowered() {
        const int before = priorityOfThisThread();
        int once = 0, twice = 0;
        std::jthread([&] {
            QVERIFY(!worksInBackground());
            workInBackground();
            once = priorityOfThisThread();
            workInBackground();
            twice = priorityOfThisThread();
            QVERIFY(worksInBackground());
        }).join();
        QCOMPARE(once, std::min(before + 5, kLowest));
        QCOMPARE(twice, once);
        QCOMPARE(priorityOfThisThread(), before);
        QVERIFY(!worksInBackground());
    }

    /// The window's thread, and whatever computes slices, must not wait for samples.
    void allThreadsThatRenderForASessionWorkInTheBackground() {
        const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, kThreads);
        const int own = priorityOfThisThread();
        const auto asHighAsThis = [&] { return std::ranges::count(priorities(), own); };
        const auto before = asHighAsThis();
        startThreads();
        QCOMPARE(asHighAsThis(), before + kThreads - 1);
        test::Screen screen;
        Session session(makeCpuDevice(kThreads), screen.sink());
        session.submit(someScene(), false);
        // On a busy machine, a thread may come late.
        QVERIFY(
            screen.await([&](const Frame& f) { return asHighAsThis() == before || f.status.samplesPerPixel >= 200; }));
        QCOMPARE(asHighAsThis(), before);
        QCOMPARE(std::ranges::count(priorities(), std::min(own + 5, kLowest)), kThreads);  // the session's own, too
    }
};

QTEST_GUILESS_MAIN(BackgroundThreadTest)
#include "background_thread_test.moc"
