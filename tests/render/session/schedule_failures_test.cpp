/// A failure of the device in Exposure Render's schedule is reported, and nothing is lost.

#include <QTest>

#include "render/device/baseline/cpu_frame_sampler.h"
#include "render/device/baseline/kroes_accumulator.h"
#include "tests/support/devices/faulty_gpu.h"
#include "tests/support/scenes/random_scenes.h"

using namespace pdr;
using test::FaultPlan;
using test::FaultyGpu;

namespace {

constexpr Schedule kOrderOnly{Schedule::Kind::kroes, false, false, false};

Scene someScene(ivec2 film) {
    Scene scene = test::anyScene(4);
    scene.film = film;
    return scene;
}

/// A film of Exposure Render's schedule on a device that fails as `plan` says, with all that the film needs.
struct Faulty {
    std::shared_ptr<FaultPlan> plan;
    std::shared_ptr<const PreparedScene> scene;
    CpuTracer tracer;
    FaultyGpu gpu;

    Faulty(const Scene& flat, std::shared_ptr<FaultPlan> wanted, std::size_t bytes = 0)
        : plan(std::move(wanted)), scene(Flattener().prepare(flat)), gpu(plan, bytes) {}

    Result<std::unique_ptr<Accumulator>> film(const Schedule& schedule) {
        const ivec2 size = scene->flat.camera.film;
        return KroesAccumulator<FaultyGpu>::make(gpu, wholeImage(size), 1, schedule,
                                                 std::make_unique<CpuFrameSampler>(tracer, gpu, scene));
    }

    /// Does everything that a session does, until something fails.
    Result<void> used(const Schedule& schedule) {
        auto made = film(schedule);
        if (!made)
            return made.error();
        Accumulator& film = **made;
        if (auto ok = film.accumulate(2, {}); !ok)
            return ok;
        if (auto ok = film.resolve({.exposure = 3}); !ok)
            return ok;
        if (auto image = film.readback(); !image)
            return image.error();
        const auto known = film.film();
        if (!known)
            return known.error();
        return film.resume(**known);
    }
};

}  // namespace

class ScheduleFailuresTest : public QObject {
    Q_OBJECT

  private slots:
    void whateverFailsIsSaidAndLosesNoMemory_data() {
        QTest::addColumn<FaultPlan::Call>("call");
        QTest::newRow("allocate") << FaultPlan::Call::allocate;
        QTest::newRow("copy") << FaultPlan::Call::copy;
        QTest::newRow("clear") << FaultPlan::Call::clear;
        QTest::newRow("launch") << FaultPlan::Call::launch;
        QTest::newRow("await") << FaultPlan::Call::await;
        QTest::newRow("any") << FaultPlan::Call::any;
    }
    void whateverFailsIsSaidAndLosesNoMemory() {
        QFETCH(FaultPlan::Call, call);
        const Scene scene = someScene({8, 8});
        int failed = 0;
        for (const bool lost : {false, true})
            for (const bool runningMean : {false, true})
                for (int nth = 0;; ++nth) {
                    Faulty faulty(scene, std::make_shared<FaultPlan>(FaultPlan{call, nth, lost}));
                    const Result<void> used = faulty.used({Schedule::Kind::kroes, true, true, runningMean});
                    QCOMPARE(faulty.gpu.allocated(), std::size_t(0));
                    QCOMPARE(bool(used), !faulty.plan->failed);
                    if (!faulty.plan->failed)
                        break;
                    QCOMPARE(used.error().where, std::string("faulty"));
                    QCOMPARE(used.error().what, std::string("it failed on purpose"));
                    ++failed;
                }
        qInfo("%d failures", failed);
        QVERIFY(failed >= 6);
    }

    void aFilmThatDoesNotFitIsRefusedWithItsBytes() {
        Faulty faulty(someScene({512, 512}), std::make_shared<FaultPlan>(), 5000000);
        const auto film = faulty.film(kOrderOnly);
        QVERIFY(!film);
        QVERIFY2(film.error().what.find("are needed") != std::string::npos, film.error().what.c_str());
        QCOMPARE(faulty.gpu.allocated(), std::size_t(0));
    }

    void aFilmReleasesAllItTook() {
        Faulty faulty(someScene({24, 24}), std::make_shared<FaultPlan>());
        {
            const auto film = faulty.film({Schedule::Kind::kroes, true, true, true});
            QVERIFY(bool(film));
            QVERIFY(bool((*film)->accumulate(1, {})));
            const std::size_t after = faulty.gpu.allocated();
            QVERIFY(after > 0);
            QVERIFY(bool((*film)->accumulate(10, {})));
            QCOMPARE(faulty.gpu.allocated(), after);
        }
        QCOMPARE(faulty.gpu.allocated(), std::size_t(0));
    }
};

QTEST_GUILESS_MAIN(ScheduleFailuresTest)
#include "schedule_failures_test.moc"
