#include <QTest>
#include <chrono>
#include <cmath>
#include <thread>

#include "render/device/emulated/host_gpu.h"
#include "render/device/gpu_device.h"
#include "render/film/display/tone_map.h"
#include "tests/support/devices/faulty_gpu.h"
#include "tests/support/processor_time.h"
#include "tests/support/scenes/images.h"
#include "tests/support/scenes/masks.h"
#include "tests/support/scenes/part_scenes.h"
#include "tests/support/scenes/scenes.h"
#include "tests/support/scenes/tissue_scene.h"

using namespace pdr;

namespace {

std::unique_ptr<GpuDevice<HostGpu>> hostDevice(std::size_t bytes = 0) {
    return std::make_unique<GpuDevice<HostGpu>>(DeviceInfo{"host", "threads as a GPU", false}, bytes);
}

Scene bumpyScene() {
    Scene scene = test::tissueScene();
    scene.revision = 5;
    return scene;
}

bool same(const Film& a, const Film& b) {
    return sameBits(a.content(), b.content());
}

/// Renders `samples` with a live film, n at a time.
std::shared_ptr<const Film> lived(Device& device, const Scene& scene, std::uint32_t samples, std::uint32_t n) {
    if (!device.upload(scene))
        return nullptr;
    const auto film = device.film(scene.film, scene.revision, {});
    for (std::uint32_t done = 0; done < samples; done += n)
        if (!(*film)->accumulate(std::min(n, samples - done), {}))
            return nullptr;
    return *(*film)->film();
}

}  // namespace

/// The code that runs on GPUs, on the CPU's threads: what it computes must be what the CPU device does, bit by bit.
class GpuDeviceTest : public QObject {
    Q_OBJECT

  private slots:
    void everyModelGivesTheCpusSums() {
        const auto gpu = hostDevice();
        const auto cpu = makeCpuDevice();
        for (const Model model : kModels)
            for (const Estimator estimator : {Estimator::unbiased, Estimator::kroesMarch}) {
                Scene scene = bumpyScene();
                scene.model = model;
                scene.estimator = estimator;
                if (!scene.check())
                    continue;
                const Film theirs = test::render(scene, 70, *cpu), ours = test::render(scene, 70, *gpu, 23, 32);
                QVERIFY2(same(theirs, ours), modelName(model));
            }
    }

    void everyModelGivesTheCpusSumsOfWhatIsSeen() {
        const auto gpu = hostDevice();
        const auto cpu = makeCpuDevice();
        for (const Model model : kModels)
            for (const unsigned seed : {1u, 2u}) {
                Scene scene = bumpyScene();
                scene.model = model;
                scene.mask = test::anyMask(*scene.volume, seed);
                const Film theirs = test::render(scene, 20, *cpu);
                QVERIFY2(same(theirs, test::render(scene, 20, *gpu, 23, 32)), modelName(model));
                QVERIFY2(same(theirs, *lived(*gpu, scene, 20, 20)), modelName(model));
                scene.mask = nullptr;
                ++scene.revision;
                QVERIFY2(!same(theirs, test::render(scene, 20, *gpu)), "all of it is seen again");
            }
    }

    void partsGiveTheCpusSums() {
        const auto gpu = hostDevice();
        const auto cpu = makeCpuDevice();
        for (const Model model :
             {Model::absorption, Model::singleScattering, Model::multipleScattering, Model::maximumIntensity})
            for (const unsigned seed : {1u, 2u}) {
                Scene scene = bumpyScene();
                scene.model = model;
                const Film without = test::render(scene, 20, *cpu);
                scene.parts.map = test::anyParts(*scene.volume, 5, seed);
                test::giveCurves(scene, seed);
                scene.mask = seed == 2 ? test::anyMask(*scene.volume, seed) : nullptr;
                ++scene.revision;
                const Film theirs = test::render(scene, 20, *cpu);
                QVERIFY(same(theirs, without) == (model == Model::maximumIntensity && seed == 1));
                QVERIFY2(same(theirs, test::render(scene, 20, *gpu, 23, 32)), modelName(model));
                QVERIFY2(same(theirs, *lived(*gpu, scene, 20, 20)), modelName(model));
                scene.parts = {};
                scene.mask = nullptr;
                ++scene.revision;
                QVERIFY2(same(without, test::render(scene, 20, *gpu)), "the parts are common again");
            }
    }

    /// With the same volume on the same device, another visible part gets bounds of its own.
    void anotherChoiceHasBoundsOfItsOwn() {
        const auto gpu = hostDevice();
        Scene scene = bumpyScene();
        const ivec3 size = scene.volume->size();
        for (const bool left : {true, false}) {
            scene.mask = maskOf({size, ivec3(0)}, {},
                                [&](dvec3 place) { return std::int16_t((place.x < size.x / 2) == left ? kSeen : 0); });
            ++scene.revision;
            QVERIFY(same(test::render(scene, 20, *makeCpuDevice()), test::render(scene, 20, *gpu)));
        }
    }

    void everyEffectGivesTheCpusSums() {
        const auto gpu = hostDevice();
        const auto cpu = makeCpuDevice();
        const auto agrees = [&](const char* what, auto&& edit) {
            Scene scene = bumpyScene();
            edit(scene);
            QVERIFY2(scene.check(), what);
            const Film theirs = test::render(scene, 20, *cpu);
            QVERIFY2(same(theirs, test::render(scene, 20, *gpu)), what);
            // Compare also with ranges, bounds and the bounds of the view made on the device.
            QVERIFY2(same(theirs, *lived(*gpu, scene, 20, 20)), what);
        };
        agrees("lens", [](Scene& s) { s.camera.apertureMm = 8; });
        agrees("orthographic", [](Scene& s) { s.camera.type = Camera::Type::orthographic; });
        agrees("clipped", [](Scene& s) { s.clip.planes = {{{1, 2, 1}, s.volume->geometry().centreMm()}}; });
        agrees("phase", [](Scene& s) { s.phaseG = 0.7f; });
        agrees("panel", [](Scene& s) {
            s.lights.push_back(RectangleLight{.centreMm = {0, -300, 200}, .normal = {0, 1, 0}, .radiance = vec3(30)});
        });
        agrees("dense", [](Scene& s) { s.transferFunction.extinctionPerMm = 5000; });
        agrees("emission", [](Scene& s) { s.transferFunction.nodes[1].emission = vec3(0.3f); });
        agrees("inside", [](Scene& s) { s.camera.eyeMm = s.volume->geometry().centreMm() + dvec3(0, 1, 0); });
        agrees("close", [](Scene& s) { s.camera.eyeMm = s.volume->geometry().centreMm() - dvec3(0, 40, 0); });
        agrees("empty", [](Scene& s) { s.transferFunction.extinctionPerMm = 0; });
        agrees("one voxel", [](Scene& s) {
            s.volume = test::makeVolume({1, 1, 1}, dvec3(30), [](int, int, int) { return 500; });
        });
    }

    /// A driver ends a launch that keeps a display waiting for seconds, as one for 16384 x 16384 pixels might.
    void aLargeFilmIsTracedInSeveralLaunches() {
        const auto plan = std::make_shared<test::FaultPlan>();
        GpuDevice<test::FaultyGpu> gpu({"counting", "", false}, plan);
        const auto cpu = makeCpuDevice();
        for (const Model model : kModels)
            for (const Estimator estimator : {Estimator::unbiased, Estimator::kroesMarch}) {
                Scene scene = bumpyScene();
                scene.film = {200, 100};
                scene.model = model;
                scene.estimator = estimator;
                if (!scene.check())
                    continue;
                plan->longestQueue = 0;
                const auto ours = lived(gpu, scene, 1, 1);
                QVERIFY2(ours && same(test::render(scene, 1, *cpu), *ours), modelName(model));
                const bool hasLists = !isProjection(model) && estimator == Estimator::unbiased;
                QCOMPARE(plan->longestQueue,
                         hasLists ? kMostEvents * gpu.gpu().pathsTogether() : raysTogether(gpu.gpu()));
            }
    }

    void aFilmGrownOnTheDeviceIsTheCpusBitByBit() {
        const auto gpu = hostDevice();
        const auto cpu = makeCpuDevice();
        const Film reference = test::render(bumpyScene(), 150, *cpu);
        for (const std::uint32_t n : {1u, 7u, 64u, 100u, 150u})
            QVERIFY(same(reference, *lived(*gpu, bumpyScene(), 150, n)));
    }

    void twoImagesOnTheirWayAreThoseOfTheirFilms() {
        const auto gpu = hostDevice();
        const Scene scene = bumpyScene();
        QVERIFY(gpu->upload(scene));
        const auto film = *gpu->film(scene.film, scene.revision, {});
        QCOMPARE(film->maxInFlight(), 2);
        std::vector<std::shared_ptr<const Film>> films;
        const auto order = [&] {
            QVERIFY(film->accumulate(30, {}));
            QVERIFY(film->resolve({.exposure = 0.7f}));
            films.push_back(*film->film());
        };
        order();
        for (int round = 0; round < 4; ++round) {
            order();
            const Result<Image> image = film->readback();
            QVERIFY(image);
            const Film& shown = *films[round];
            QVERIFY(image->rgba == toneMap(shown, {.exposure = 0.7f}));
            QCOMPARE(image->status.samplesPerPixel, shown.samplesPerPixel());
            QVERIFY(std::fabs(image->status.relativeError / shown.status().relativeError - 1) < 1e-12);
            const FilmStatus here = imageOf(shown, {.exposure = 0.7f}).status;
            QCOMPARE(image->status.displayError, here.displayError);
            QCOMPARE(std::isfinite(here.displayError), shown.samplesPerPixel() >= kSamplesToEstimate);
            QVERIFY(here.tissuePixels > 100 && here.tissuePixels < 61 * 45);
            QCOMPARE(image->status.tissuePixels, here.tissuePixels);
            QCOMPARE(image->status.fewBrightSamples, here.fewBrightSamples);
            QVERIFY(std::fabs(image->status.meanLuminance / shown.status().meanLuminance - 1) < 1e-12);
        }
    }

    void anImageGoesOnOnAnotherDeviceAsIfItHadBeenThereAllTheTime() {
        const Scene scene = bumpyScene();
        const auto gpu = hostDevice();
        const auto cpu = makeCpuDevice();
        const Film reference = test::render(scene, 130, *cpu);
        QVERIFY(gpu->upload(scene));
        QVERIFY(cpu->upload(scene));
        std::shared_ptr<const Film> film = std::make_shared<const Film>(scene.film, scene.revision);
        Device* const turns[] = {gpu.get(), cpu.get(), gpu.get(), cpu.get()};
        const std::uint32_t samples[] = {37, 40, 52, 1};
        for (int i = 0; i < 4; ++i) {
            const auto here = *turns[i]->film(scene.film, scene.revision, {});
            QVERIFY(here->resume(*film));
            QVERIFY(here->accumulate(samples[i], {}));
            film = *here->film();
        }
        QVERIFY(same(reference, *film));
    }

    void exposureRendersScheduleGivesTheSameImageHere() {
        const Schedule plain{.kind = Schedule::Kind::kroes, .redundant = true, .filter = false, .runningMean = false};
        const Scene scene = bumpyScene();
        const auto gpu = hostDevice();
        QVERIFY(gpu->upload(scene));
        const auto film = *gpu->film(scene.film, scene.revision, plain);
        QVERIFY(film->accumulate(70, {}));
        QVERIFY(same(test::render(scene, 70), **film->film()));
    }

    void onlyWhatChangedIsSentAgain() {
        const auto plan = std::make_shared<test::FaultPlan>();
        plan->call = test::FaultPlan::Call::copy;
        GpuDevice<test::FaultyGpu> gpu(DeviceInfo{"counting", "", false}, plan);
        const auto copiesFor = [&](const Scene& scene) {
            const int before = plan->calls;
            return gpu.upload(scene) ? plan->calls - before : -1;
        };
        Scene scene = bumpyScene();
        QVERIFY(copiesFor(scene) > 4);
        QCOMPARE(copiesFor(scene), 0);
        scene.camera.eyeMm += dvec3(10, 0, 0);
        QCOMPARE(copiesFor(scene), 0);
        scene.transferFunction.nodes[1].albedo = vec3(0.1f);  // materials, and the table of the other models
        QCOMPARE(copiesFor(scene), 2);
        scene.transferFunction.nodes[1].opacity = 0.3f;  // these, the pieces, and the summary to and fro
        QCOMPARE(copiesFor(scene), 4);
    }

    /// Edits while the user drags: opacities, colours, the view and a light, from one edit to its image.
    void anEditTakesNoMemory() {
        const auto plan = std::make_shared<test::FaultPlan>();
        GpuDevice<test::FaultyGpu> gpu(DeviceInfo{"counting", "", false}, plan);
        Scene scene = bumpyScene();
        QVERIFY(gpu.upload(scene));
        const auto film = *gpu.film(scene.film, scene.revision, {});
        const auto image = [&] {
            ++scene.revision;
            return gpu.upload(scene) && film->restart(wholeImage(scene.film), scene.revision) &&
                   film->accumulate(1, {}) && film->resolve({}) && film->readback();
        };
        QVERIFY(image());
        for (const test::FaultPlan::Call taken : {test::FaultPlan::Call::allocate, test::FaultPlan::Call::pinned}) {
            plan->call = taken;
            plan->calls = 0;
            for (int i = 0; i < 4; ++i) {
                scene.transferFunction.nodes[1].opacity = 0.3f + 0.1f * float(i);
                scene.transferFunction.nodes[1].albedo = vec3(0.1f * float(i));
                scene.camera.eyeMm.x += 5;
                scene.environment.radiance = vec3(float(i));
                QVERIFY(image());
            }
            QCOMPARE(plan->calls, 0);
        }
    }

    void memoryReturnsToItsStartAfterAThousandLoads() {
        const auto cycle = [](GpuDevice<HostGpu>& gpu, std::shared_ptr<const Volume> volume) {
            Scene scene = bumpyScene();
            scene.volume = std::move(volume);
            scene.film = {8, 8};
            return gpu.upload(scene) && (*gpu.film(scene.film, 1, {}))->accumulate(1, {});
        };
        const auto one = test::bumpyVolume({20, 21, 22}, dvec3(1), 1),
                   other = test::bumpyVolume({30, 9, 12}, dvec3(1), 2);
        const auto gpu = hostDevice();
        QVERIFY(cycle(*gpu, one) && cycle(*gpu, other) && cycle(*gpu, one));
        const std::size_t start = gpu->gpu().allocated();
        for (int i = 0; i < 1000; ++i)
            QVERIFY(cycle(*gpu, i % 2 ? one : other));
        QCOMPARE(gpu->gpu().allocated(), start);
    }

    void aVolumeThatDoesNotFitIsRefusedWithTheFigures() {
        const auto gpu = hostDevice(1'000'000);
        Scene scene = bumpyScene();
        scene.volume = test::makeVolume({100, 100, 100}, dvec3(1), [](int, int, int) { return 0; });
        const Result<void> refused = gpu->upload(scene);
        QVERIFY(!refused);
        QCOMPARE(refused.error().what,
                 std::string("the volume does not fit into its memory: 2.2 MB are needed, 1.0 MB are free"));
        QVERIFY(gpu->upload(bumpyScene()));  // a smaller one fits
    }

    void withoutASceneNothingIsRendered() {
        const auto gpu = hostDevice(1'000'000);
        const Scene scene = bumpyScene();
        QVERIFY(gpu->upload(scene));
        Scene tooLarge = scene;
        tooLarge.volume = test::makeVolume({100, 100, 100}, dvec3(1), [](int, int, int) { return 0; });
        QVERIFY(!gpu->upload(tooLarge));
        const Schedule k0{.kind = Schedule::Kind::kroes, .redundant = true}, k1{.kind = Schedule::Kind::kroes};
        for (const Schedule& schedule : {Schedule{}, k0, k1}) {
            const auto live = gpu->film(ivec2(8, 8), 1, schedule);
            QVERIFY(!live || !(*live)->accumulate(1, {}));
        }
    }

    /// Any call may fail: it gives an error text, no crash, and afterwards the device works again.
    void everyCallMayFail() {
        const Scene scene = bumpyScene();
        const Film reference = test::render(scene, 3);
        const auto image = [&](Device& device) -> Result<std::shared_ptr<const Film>> {
            if (const auto uploaded = device.upload(scene); !uploaded)
                return uploaded.error();
            auto film = device.film(scene.film, 1, {});
            if (!film)
                return film.error();
            if (const auto accumulated = (*film)->accumulate(3, {}); !accumulated)
                return accumulated.error();
            if (const auto shown = (*film)->resolve({}); !shown)
                return shown.error();
            if (const auto taken = (*film)->readback(); !taken)
                return taken.error();
            return (*film)->film();
        };
        int failures = 0;
        for (int call = 0;; ++call) {
            const auto plan = std::make_shared<test::FaultPlan>();
            plan->fails = call;
            GpuDevice<test::FaultyGpu> gpu(DeviceInfo{"faulty", "", false}, plan);
            const auto made = image(gpu);
            if (!plan->failed)
                break;
            failures += !made;
            QVERIFY(made || made.error().what == "it failed on purpose");
            const auto again = image(gpu);
            QVERIFY2(again && same(reference, **again), qPrintable(QString("after call %1").arg(call)));
        }
        QVERIFY(failures > 30);
    }

    void aLostDeviceIsToldAndLeftInPeace() {
        for (const int call : {3, 20, 60, 80}) {
            const auto plan = std::make_shared<test::FaultPlan>();
            plan->fails = call;
            plan->lost = true;
            GpuDevice<test::FaultyGpu> gpu(DeviceInfo{"faulty", "", false}, plan);
            const Scene scene = bumpyScene();
            const bool uploaded(gpu.upload(scene));
            if (const auto film = gpu.film(scene.film, 1, {}))
                for (int i = 0; i < 10 && !plan->failed; ++i)
                    (void)((*film)->accumulate(1, {}) && (*film)->resolve({}) && (*film)->readback());
            QVERIFY(plan->failed);
            const Result<void> again = gpu.upload(scene);
            QVERIFY(!again && again.error().kind == ErrorKind::deviceLost);  // not that the volume does not fit
            QVERIFY(call < 60 || uploaded);
        }
    }

    void aTornImageIsSeen() {
        struct TornGpu : HostGpu {
            using HostGpu::HostGpu;
            void copyToHost(void* to, const void* from, std::size_t bytes, GpuStream stream) {
                HostGpu::copyToHost(to, from, stream == GpuStream::copy ? bytes / 2 : bytes, stream);
            }
        };
        GpuDevice<TornGpu> gpu(DeviceInfo{"torn", "", false});
        const Scene scene = bumpyScene();
        QVERIFY(gpu.upload(scene));
        const auto film = *gpu.film(scene.film, 1, {});
        QVERIFY(film->accumulate(1, {}) && film->resolve({}));
        const Result<Image> image = film->readback();
        QVERIFY(!image);
        QVERIFY(image.error().what.find("damaged") != std::string::npos);
    }

    void aStopEndsAFilmBetweenLaunches() {
        const auto gpu = hostDevice();
        const Scene scene = bumpyScene();
        QVERIFY(gpu->upload(scene));
        const auto film = *gpu->film(scene.film, 1, {});
        std::stop_source stop;
        std::jthread later([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            stop.request_stop();
        });
        const test::ProcessorTime spent;
        QVERIFY(film->accumulate(1'000'000, stop.get_token()));
        QVERIFY(spent.seconds() < 2);
    }
};

QTEST_APPLESS_MAIN(GpuDeviceTest)
#include "gpu_device_test.moc"
