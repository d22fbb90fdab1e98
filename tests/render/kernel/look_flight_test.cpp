/// Flights by looks: unbiased against exact flights, in every kind of tissue, and the same on lanes as on a single ray.

#include <QTest>
#include <algorithm>
#include <random>

#include "render/device/cpu/flight_batch.h"
#include "render/device/emulated/emulated_gpu.h"
#include "render/kernel/transport/integrator.h"
#include "tests/support/scenes/images.h"
#include "tests/support/scenes/masks.h"
#include "tests/support/scenes/part_scenes.h"
#include "tests/support/scenes/random_scenes.h"
#include "tests/support/scenes/ray_reference.h"

using namespace pdr;

namespace {

constexpr float kNeverEnds = 1e30f;

RandomStream randomOf(unsigned seed, std::uint64_t i) {
    return Random(seed, 7, i).stream(0, BounceDimension::distance);
}

/// Opacities of muscle, which is not thin, and of denser tissue.
const std::vector<TransferNode> kMuscles = {{.hu = -10, .opacity = 0},
                                            {.hu = 20, .opacity = 0.012f},
                                            {.hu = 60, .opacity = 0.055f},
                                            {.hu = 250, .opacity = 0.12f}};

/// A volume that is HU 0 except where `value` says otherwise; HU 0 is transparent and HU 1000 opaque.
template <class Value>
Scene tissue(ivec3 size, float extinctionPerMm, Value&& value) {
    Scene scene = test::plainScene(test::makeVolume(size, dvec3(1, 0.8, 1.3), value), extinctionPerMm);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 1000, .opacity = 1}};
    return scene;
}

Scene sheet(float extinctionPerMm) {
    return tissue(ivec3(40), extinctionPerMm, [](int, int, int k) { return k == 17 ? 1000 : 0; });
}
Scene voxel(float extinctionPerMm) {
    return tissue(ivec3(40), extinctionPerMm,
                  [](int i, int j, int k) { return i == 19 && j == 18 && k == 20 ? 1000 : 0; });
}
Scene ramp(float extinctionPerMm) {
    return tissue({40, 12, 12}, extinctionPerMm, [](int i, int, int) { return 25 * i; });
}
Scene sheared() {
    Scene scene = test::plainScene(test::bumpyVolume(ivec3(32), dvec3(1), 5), 1);
    VolumeGeometry geometry = scene.volume->geometry();
    geometry.patientFromIndex[2][1] = 0.7;  // a gantry's tilt
    scene.volume =
        std::make_shared<Volume>(geometry, Voxels(scene.volume->voxels().begin(), scene.volume->voxels().end()));
    scene.transferFunction.nodes = {{.hu = -300, .opacity = 0}, {.hu = 900, .opacity = 1}};
    return scene;
}
Scene masked() {
    Scene scene = test::anyScene(4);
    scene.mask = test::anyMask(*scene.volume, 4);
    return scene;
}

Scene parted() {
    Scene scene = masked();
    scene.parts.map = test::anyParts(*scene.volume, 6, 4);
    test::giveCurves(scene, 4);
    return scene;
}

/// Tissue whose curves show an extinction of at most `most` [1/mm].
Scene limited(Scene scene, float most) {
    const auto limit = [most](TransferFunction& curve) {
        curve.extinctionPerMm = std::min(curve.extinctionPerMm, most);
    };
    limit(scene.transferFunction);
    for (PartCurve& part : scene.parts.curves)
        limit(part.transferFunction);
    return scene;
}

float thinBoundOf(const Scene& scene) {
    return Flattener().prepare(scene)->flat.thinBound;
}
/// Tissue so thin that all of it is looked at.
Scene thinned(const Scene& scene) {
    return limited(scene, 0.9f * thinBoundOf(scene));
}
/// Tissue as dense as light flies through by looks at most.
Scene forLight(const Scene& scene) {
    constexpr float kVoxelDepth = 7.5f;
    return limited(scene, kVoxelDepth / kThinDepth * kFineCell * thinBoundOf(scene));
}

}  // namespace

class LookFlightTest : public QObject {
    Q_OBJECT

  private slots:
    void transmittanceIsUnbiased_data() {
        QTest::addColumn<Scene>("scene");
        QTest::newRow("sheet of one voxel") << sheet(2);
        QTest::newRow("thin sheet of one voxel") << thinned(sheet(1));
        QTest::newRow("opaque voxel in air") << voxel(5);
        QTest::newRow("thin voxel in air") << thinned(voxel(1));
        QTest::newRow("very thin ramp") << ramp(0.01f);
        QTest::newRow("thin ramp") << thinned(ramp(1));
        QTest::newRow("dense ramp") << ramp(3);
        QTest::newRow("sheared grid") << sheared();
        QTest::newRow("thin tissue on a sheared grid") << thinned(sheared());
        QTest::newRow("partly hidden") << masked();
        QTest::newRow("thin and partly hidden") << thinned(masked());
        QTest::newRow("parts") << parted();
        QTest::newRow("thin parts") << thinned(parted());
        for (unsigned seed = 1; seed <= 4; ++seed) {
            QTest::addRow("any scene %u", seed) << test::anyScene(seed);
            QTest::addRow("any scene %u, thin", seed) << thinned(test::anyScene(seed));
        }
    }
    /// Rays that meet little and rays that meet much: the mean of what looks leave of the light is what there is, ray
    /// by ray, and over all rays to 1e-4. The looks of a ray lie in (0, 1].
    void transmittanceIsUnbiased() {
        QFETCH(Scene, scene);
        transmittanceOf<FlightEnd::place, ThinTissue::looked>(scene);
    }
    void lightIsUnbiased_data() { transmittanceIsUnbiased_data(); }
    /// Light looks at thick tissue, too.
    void lightIsUnbiased() {
        QFETCH(Scene, scene);
        transmittanceOf<FlightEnd::whether, ThinTissue::allLooked>(forLight(scene));
    }

    /// Checks share, mean and mean square of the places where flights end against exact flights of the same depths.
    void flightsEndWhereExactOnesDo_data() { transmittanceIsUnbiased_data(); }
    void flightsEndWhereExactOnesDo() {
        QFETCH(Scene, scene);
        const auto prepared = Flattener().prepare(scene);
        std::mt19937 random(6);
        for (const Ray& ray : test::raysThrough(*scene.volume, 4, 8)) {
            test::Sample difference[3];
            for (int i = 0; i < 20'000; ++i) {
                const float depth = freePathDepth(std::uint32_t(random()));
                const double exact = double(freeFlight(prepared->flat, ray, depth).distance);
                const double looked =
                    double(lookFlight(prepared->flat, ray, depth, randomOf(9, std::uint64_t(i))).distance);
                const auto or0 = [](double distance) { return std::max(distance, 0.0); };
                difference[0].add(double(looked < 0) - double(exact < 0));
                difference[1].add(or0(looked) - or0(exact));
                difference[2].add(or0(looked) * or0(looked) - or0(exact) * or0(exact));
            }
            for (const test::Sample& moment : difference)
                QVERIFY2(std::fabs(moment.mean()) <= test::allowedZ(21 * 12) * moment.standardError() + 1e-5,
                         qPrintable(QString("%1 +- %2").arg(moment.mean()).arg(moment.standardError())));
        }
    }

    /// A larger depth leads farther with the same looks, as low-discrepancy numbers require.
    void flightsGrowWithTheirDepth() {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const Scene scene = test::anyScene(seed);
            const auto prepared = Flattener().prepare(scene);
            const Ray ray = test::raysThrough(*scene.volume, 1, seed)[0];
            float last = 0;
            for (float depth = 1e-4f; depth < 20; depth *= 1.01f) {
                const float distance = lookFlight(prepared->flat, ray, depth, randomOf(seed, 1)).distance;
                if (distance < 0)
                    break;
                QVERIFY(distance >= last);
                last = distance;
            }
        }
    }

    void lanesLookAsOneRayDoes_data() { transmittanceIsUnbiased_data(); }
    void lanesLookAsOneRayDoes() {
        QFETCH(Scene, scene);
        const auto prepared = Flattener().prepare(scene);
        lanesOf<FlightEnd::place, ThinTissue::looked>(prepared->flat, *scene.volume);
    }
    void lanesOfLightLookAsOneRayDoes_data() { transmittanceIsUnbiased_data(); }
    void lanesOfLightLookAsOneRayDoes() {
        QFETCH(Scene, scene);
        const auto prepared = Flattener().prepare(forLight(scene));
        FlatScene flat = prepared->flat;
        flat.lightLooks = true;
        lanesOf<FlightEnd::whether, ThinTissue::allLooked>(flat, *scene.volume);
    }

    /// Light ends where it passes more than its depth, and only there; the rest of it passes what it would anyway.
    void lightEndsBeyondItsDepth() {
        const auto prepared = Flattener().prepare(thinned(masked()));
        for (std::uint64_t i = 0; const Ray& ray : test::raysThrough(*prepared->volume, 300, 8)) {
            const auto flown = [&](float depth) {
                return lookFlight<FlightEnd::whether, ThinTissue::allLooked>(prepared->flat, ray, depth,
                                                                             randomOf(4, i));
            };
            const Flight endless = flown(kNeverEnds), light = flown(0.3f);
            QVERIFY(light.distance == (endless.passed > 0.3f ? 0.0f : -1.0f));
            QVERIFY(light.distance == 0 || light.passed == endless.passed);
            ++i;
        }
    }

    /// Nothing to see: no step, and no light lost.
    void emptySceneTakesNothing() {
        const Scene scene = tissue(ivec3(40), 5, [](int, int, int) { return 0; });
        const auto prepared = Flattener().prepare(scene);
        for (const Ray& ray : test::raysThrough(*scene.volume, 100, 3)) {
            const Flight flight = lookFlight(prepared->flat, ray, 1e-6f, randomOf(1, 0));
            QVERIFY(flight.distance == -1 && flight.passed == 0);
        }
    }

    /// A ray that is cut short takes no light behind its end.
    void cutRaysLookNoFarther() {
        const auto prepared = Flattener().prepare(thinned(ramp(1)));
        Ray ray{{39, 6, 6}, {-1, 0, 0}, 10};
        for (int i = 0; i < 2000; ++i) {
            const float distance = lookFlight(prepared->flat, ray, 0.5f, randomOf(3, std::uint64_t(i))).distance;
            QVERIFY(distance < ray.length);
        }
    }

    /// Tissue up to 1e6 / mm is no trap: the walk reads it cell by cell, and ends where exact flights do.
    void denseTissueIsRead_data() {
        QTest::addColumn<float>("extinction");
        for (const float extinction : {5.0f, 100.0f, 1e4f, 1e6f})
            QTest::addRow("%g / mm", double(extinction)) << extinction;
    }
    void denseTissueIsRead() {
        QFETCH(float, extinction);
        const Scene scene = ramp(extinction);
        const auto prepared = Flattener().prepare(scene);
        std::uint64_t i = 0;
        for (const Ray& ray : test::raysThrough(*scene.volume, 500, 5)) {
            const float exact = freeFlight(prepared->flat, ray, 1).distance;
            const float looked = lookFlight(prepared->flat, ray, 1, randomOf(2, i++)).distance;
            QVERIFY2(std::fabs(looked - exact) < 1e-3f * std::max(1.0f, exact),
                     qPrintable(QString("%1 for %2").arg(looked).arg(exact)));
        }
    }

    /// Looks are fewer than the cells that an exact flight reads: in thin tissue a step passes a coarse cell.
    void thinTissueTakesFewSteps() {
        const Scene scene =
            test::plainScene(test::makeVolume(ivec3(128), dvec3(1), [](int, int, int) { return 100; }), 0.001f);
        const auto prepared = Flattener().prepare(scene);
        const Ray ray{{-0.5f, 60.3f, 61.1f}, {1, 0, 0}, 128};
        FreeFlight<float, Tissue::whole, FlightEnd::place, ThinTissue::looked> flight;
        flight.start(prepared->flat, ray, 100, randomOf(1, 1));
        int steps = 0;
        for (; flight.going(); ++steps)
            flight.step(prepared->flat);
        QVERIFY2(steps <= 12, qPrintable(QString::number(steps)));
    }

    /// Flights look under curves that show much thin tissue, and only there: everywhere else bits stay as they were.
    void curveDecidesWhetherFlightsLook() {
        const auto looks = [](float extinctionPerMm, std::vector<TransferNode> nodes) {
            Scene scene = ramp(extinctionPerMm);
            scene.transferFunction.nodes = std::move(nodes);
            return Flattener().prepare(scene)->flat.looksAtThin;
        };
        QVERIFY(looks(4, {{.hu = 30, .opacity = 0}, {.hu = 200, .opacity = 0.012f}, {.hu = 300, .opacity = 1}}));
        QVERIFY(!looks(4, {{.hu = 30, .opacity = 0}, {.hu = 60, .opacity = 0.012f}, {.hu = 300, .opacity = 1}}));
        QVERIFY(looks(4, {{.hu = 30, .opacity = 0}, {.hu = 130, .opacity = 0.017f}, {.hu = 300, .opacity = 1}}));
        QVERIFY(!looks(4, {{.hu = 30, .opacity = 0}, {.hu = 115, .opacity = 0.017f}, {.hu = 300, .opacity = 1}}));
        QVERIFY(!looks(400, {{.hu = 30, .opacity = 0}, {.hu = 200, .opacity = 0.012f}, {.hu = 300, .opacity = 1}}));
        QVERIFY(!looks(4, {{.hu = -500, .opacity = 0}, {.hu = 300, .opacity = 0}, {.hu = 310, .opacity = 1}}));
    }

    /// Light flies by looks alone where flights look, and no voxel is deeper than 7.5: of 1 x 0.8 x 1.3 mm, 1.82 long.
    void densityDecidesHowLightLooks() {
        const auto looks = [](float extinctionPerMm, float opacity, float ofPart) {
            Scene scene = ramp(extinctionPerMm);
            scene.lights = {SphereLight{}};
            scene.transferFunction.nodes = {{.hu = 30, .opacity = 0}, {.hu = 330, .opacity = opacity}};
            if (ofPart > 0) {
                scene.parts.map = test::anyParts(*scene.volume, 1, 4);
                scene.parts.curves = {{1, scene.transferFunction}};
                scene.parts.curves[0].transferFunction.extinctionPerMm = ofPart;
            }
            return Flattener().prepare(scene)->flat.lightLooks;
        };
        QVERIFY(looks(4, 0.01f, 0));
        QVERIFY(!looks(4.3f, 0.01f, 0));
        QVERIFY(!looks(4, 1, 0));  // no thin tissue
        QVERIFY(looks(4, 0.01f, 3.9f));
        QVERIFY(!looks(4, 0.01f, 4.3f));
        Scene parallel = ramp(4);
        parallel.transferFunction.nodes = {{.hu = 30, .opacity = 0}, {.hu = 330, .opacity = 0.01f}};
        parallel.lights = {DirectionalLight{}};
        const auto prepared = Flattener().prepare(parallel);
        QVERIFY(prepared->flat.looksAtThin && !prepared->flat.lightLooks);
    }

    /// Light flies by looks also through soft tissue that is not thin, where the camera's flights are exact; not where
    /// fat or muscle is dense, nor where the curve shows none.
    void lightLooksAtSoftTissue() {
        const auto flat = [](std::vector<TransferNode> nodes) {
            Scene scene = ramp(4);
            scene.lights = {SphereLight{}};
            scene.transferFunction.nodes = std::move(nodes);
            return Flattener().prepare(scene)->flat;
        };
        const FlatScene muscles = flat(kMuscles);
        QVERIFY(muscles.lightLooks && !muscles.looksAtThin);
        QVERIFY(
            !flat({{.hu = -500, .opacity = 0}, {.hu = -300, .opacity = 0.15f}, {.hu = -20, .opacity = 1}}).lightLooks);
        QVERIFY(
            !flat({{.hu = 110, .opacity = 0}, {.hu = 150, .opacity = 0.055f}, {.hu = 300, .opacity = 1}}).lightLooks);
    }

    /// The looks of a path's first flight and of its flights to the lights share no number: else what a path meets and
    /// what light reaches it would depend on each other.
    void looksOfAPathShareNoNumbers() {
        const auto prepared = Flattener().prepare(ramp(1));
        std::vector<std::pair<float, float>> numbers;
        for (std::uint64_t sample = 0; sample < 50; ++sample) {
            const Path path{pathSampler(prepared->flat, {3, 4}, sample), {}};
            for (RandomStream stream :
                 {lookStream(path), lightLookStream(path, 0), lightLookStream(path, 1), shadowStream(path, 0)})
                for (int i = 0; i < 20; ++i) {
                    const vec2 pair = stream.pair();
                    numbers.emplace_back(pair.x, pair.y);
                }
        }
        std::ranges::sort(numbers);
        QVERIFY(std::ranges::adjacent_find(numbers) == numbers.end());
    }

    /// A scene whose flights look is the same on the CPU, by one thread or two, and on a GPU, in lockstep too.
    void devicesLookAlike_data() {
        QTest::addColumn<Scene>("scene");
        QTest::newRow("masked") << masked();
        QTest::newRow("whole") << test::anyScene(5);
        QTest::newRow("sheared") << sheared();
        Scene soft = sheared();
        soft.transferFunction.nodes = kMuscles;
        QTest::newRow("soft") << soft;
    }
    void devicesLookAlike() {
        QFETCH(Scene, scene);
        const bool isSoft = QTest::currentDataTag() == QByteArray("soft");
        scene = isSoft ? scene : thinned(scene);
        scene.transferFunction.extinctionPerMm *= 3;
        scene.lights = {SphereLight{{20, -60, 40}, 10, vec3(30)}};
        const auto prepared = Flattener().prepare(scene);
        QVERIFY(prepared->flat.looksAtThin != isSoft && prepared->flat.lightLooks);
        const Film one = test::sampled(prepared, 8, 8, 4096, 1);
        QVERIFY(test::sameBits(one, test::sampled(prepared, 8, 8, 7, 2)));
        const std::unique_ptr<Device> emulated = makeEmulatedGpu(), lockstep = makeLockstepGpu();
        QVERIFY(test::sameBits(one, test::render(scene, 8, *emulated, 8)));
        QVERIFY(test::sameBits(one, test::render(scene, 8, *lockstep, 8)));
    }

  private:
    template <FlightEnd End, ThinTissue Thin>
    void transmittanceOf(const Scene& scene) {
        constexpr int kRays = 40, kLooks = 4000;
        const auto prepared = Flattener().prepare(scene);
        double difference = 0, truth = 0, variance = 0;
        unsigned number = 100;
        for (const Ray& ray : test::raysThrough(*scene.volume, kRays, 3)) {
            const double exact = std::exp(-double(freeFlight(prepared->flat, ray, kNeverEnds).passed));
            test::Sample left;
            ++number;
            for (int i = 0; i < kLooks; ++i) {
                const Flight flight =
                    lookFlight<End, Thin>(prepared->flat, ray, kNeverEnds, randomOf(number, std::uint64_t(i)));
                QVERIFY(flight.distance == -1 && flight.passed >= 0);
                left.add(std::exp(-double(flight.passed)));
            }
            QVERIFY2(std::fabs(left.mean() - exact) <= test::allowedZ(21 * kRays) * left.standardError() + 3e-6,
                     qPrintable(QString("%1 of %2").arg(left.mean()).arg(exact)));
            difference += left.mean() - exact;
            truth += exact;
            variance += left.standardError() * left.standardError();
        }
        QVERIFY2(std::fabs(difference) <= test::allowedZ(21) * std::sqrt(variance) + 1e-5 * truth,
                 qPrintable(QString::number(difference / truth)));
    }

    template <FlightEnd End, ThinTissue Thin>
    void lanesOf(const FlatScene& flat, const Volume& volume) {
        std::mt19937 random(7);
        FlightBatch batch;
        const std::vector<Ray> rays = test::raysThrough(volume, 777, 5);
        std::vector<float> depths;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            depths.push_back(freePathDepth(std::uint32_t(random())));
            batch.add(rays[i], depths.back(), randomOf(2, i));
        }
        batch.flyByLooks(flat, End);
        for (int i = 0; i < batch.size(); ++i) {
            const auto at = std::size_t(i);
            const Flight one = lookFlight<End, Thin>(flat, rays[at], depths[at], randomOf(2, at));
            QVERIFY(batch.distance(i) == one.distance);
            QVERIFY(one.distance >= 0 || batch.passed(i) == one.passed);
        }
    }
};

QTEST_GUILESS_MAIN(LookFlightTest)
#include "look_flight_test.moc"
