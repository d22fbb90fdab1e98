/// Parts of the patient with curves of their own: flights, tracking and events meet each part's tissue by its share.

#include <QTest>
#include <random>
#include <set>

#include "render/device/cpu/flight_batch.h"
#include "render/kernel/transport/event.h"
#include "render/kernel/transport/tracking.h"
#include "render/prepare/flatten.h"
#include "tests/support/scenes/masks.h"
#include "tests/support/scenes/part_scenes.h"
#include "tests/support/scenes/ray_reference.h"

using namespace pdr;

namespace {

/// A curve without steps, which brute force would need far smaller steps for.
TransferFunction gentle(float extinctionPerMm, float from, float to) {
    return {extinctionPerMm,
            {{.hu = from, .opacity = 0}, {.hu = (from + to) / 2, .opacity = 0.4f}, {.hu = to, .opacity = 1}}};
}

Scene gentleScene(unsigned seed, bool masked = false) {
    Scene scene = test::anyScene(seed);
    scene.parts.map = test::anyParts(*scene.volume, 4, seed);
    scene.transferFunction = gentle(0.3f, -900, 1900);
    scene.parts.curves = {{1, gentle(0.5f, -400, 600)}, {2, gentle(0.1f, -1000, 300)}, {4, gentle(0.7f, 100, 700)}};
    if (masked)
        scene.mask = test::anyMask(*scene.volume, seed);
    return scene;
}

Scene steppedScene(unsigned seed) {
    Scene scene = test::anyScene(seed);
    scene.parts.map = test::anyParts(*scene.volume, 4, seed);
    test::giveCurves(scene, seed);
    return scene;
}

/// The extinction at a place, by brute force: each of the eight voxels around it with its label's curve.
double extinctionAt(const Scene& scene, dvec3 position) {
    const Volume& volume = *scene.volume;
    const ivec3 size = volume.size();
    const double hu = test::huAt(volume, position);
    const dvec3 p = glm::clamp(position, dvec3(0), dvec3(size - 1));
    const ivec3 low = glm::min(ivec3(p), glm::max(size - 2, ivec3(0)));
    double sum = 0;
    for (int n = 0; n < 8; ++n) {
        const ivec3 corner = glm::min(low + ivec3(n & 1, (n >> 1) & 1, n >> 2), size - 1);
        const dvec3 fraction = p - dvec3(low);
        const int label =
            scene.parts.map->labels[(std::size_t(corner.z) * size.y + corner.y) * size.x + std::size_t(corner.x)];
        const auto part = std::ranges::find(scene.parts.curves, label, &PartCurve::label);
        const TransferFunction& curve =
            part == scene.parts.curves.end() ? scene.transferFunction : part->transferFunction;
        sum += (n & 1 ? fraction.x : 1 - fraction.x) * (n & 2 ? fraction.y : 1 - fraction.y) *
               (n & 4 ? fraction.z : 1 - fraction.z) * test::opticsAt(curve, hu).extinction;
    }
    return scene.mask ? sum * scene.mask->at(position) : sum;
}

double depthOn(const Scene& scene, const Ray& ray, int steps) {
    double depth = 0;
    const double step = double(ray.length) / steps;
    for (int i = 0; i < steps; ++i)
        depth += step * extinctionAt(scene, dvec3(ray.origin) + dvec3(ray.direction) * ((i + 0.5) * step));
    return depth;
}

}  // namespace

class PartsTest : public QObject {
    Q_OBJECT

  private slots:
    void flightsPassWhatBruteForceFinds() {
        std::mt19937 random(3);
        double worst = 0;
        int ended = 0;
        for (unsigned seed = 1; seed <= 40; ++seed) {
            const Scene scene = gentleScene(seed, seed % 2 == 0);
            QVERIFY(scene.check());
            const auto prepared = Flattener().prepare(scene);
            for (Ray ray : test::raysThrough(*scene.volume, 20, seed)) {
                const float wanted = freePathDepth(std::uint32_t(random()));
                const Flight flight = freeFlight(prepared->flat, ray, wanted);
                ended += flight.distance >= 0;
                ray.length = flight.distance >= 0 ? flight.distance : ray.length;
                const double expected = flight.distance >= 0 ? double(wanted) : double(flight.passed);
                worst = std::max(worst, std::fabs(depthOn(scene, ray, 4000) - expected) / (1e-3 + expected));
            }
        }
        QVERIFY2(worst < 3e-3, qPrintable(QString::number(worst)));
        QVERIFY(ended > 100 && ended < 700);
    }

    void lanesFlyAsOneRayDoes() {
        std::mt19937 random(7);
        for (unsigned seed = 1; seed <= 12; ++seed) {
            Scene scene = steppedScene(seed);
            if (seed % 2)
                scene.mask = test::anyMask(*scene.volume, seed);
            const auto prepared = Flattener().prepare(scene);
            auto flights = std::make_unique<FlightBatch>();
            const std::vector<Ray> rays = test::raysThrough(*scene.volume, 200, seed);
            std::vector<float> depths;
            for (const Ray& ray : rays) {
                depths.push_back(freePathDepth(std::uint32_t(random())));
                flights->add(ray, depths.back());
            }
            flights->fly(prepared->flat);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const Flight alone = freeFlight(prepared->flat, rays[i], depths[i]);
                QCOMPARE(flights->distance(int(i)), alone.distance);
                if (alone.distance < 0)
                    QCOMPARE(flights->passed(int(i)), alone.passed);
            }
        }
    }

    /// At a place, too, each of the eight voxels around it counts with its own curve, however many there are. Lanes are
    /// those of one place, and nothing is asked of lanes without a ray.
    void placesMixTheCurvesOfEightVoxels() {
        std::mt19937 random(5);
        std::uniform_real_distribution<float> unit(0, 1);
        double worst = 0;
        int several = 0;
        for (unsigned seed = 1; seed <= 8; ++seed) {
            const Scene scene = gentleScene(seed, seed % 2 == 0);
            const auto prepared = Flattener().prepare(scene);
            for (int i = 0; i < 200; ++i) {
                Vec3<FloatLanes> places;
                FloatLanes hu;
                IntLanes asked;
                for (int lane = 0; lane < kLanes; ++lane) {
                    const vec3 at = vec3(scene.volume->size()) * vec3(unit(random), unit(random), unit(random)) - 0.5f;
                    places.x[lane] = at.x, places.y[lane] = at.y, places.z[lane] = at.z;
                    hu[lane] = hounsfield(prepared->flat.volume, at);
                    asked[lane] = unit(random) < 0.8f ? -1 : 0;
                }
                const FloatLanes found = extinction(prepared->flat, places, hu, asked);
                for (int lane = 0; lane < kLanes; ++lane) {
                    const vec3 at(places.x[lane], places.y[lane], places.z[lane]);
                    const float alone = extinction(prepared->flat, at);
                    worst = std::max(worst, std::fabs(alone - extinctionAt(scene, dvec3(at))));
                    QCOMPARE(found[lane], asked[lane] ? alone : 0.0f);
                    const std::uint64_t labels =
                        cornerLabels(prepared->flat, placeInCell(prepared->flat.volume, at).corner);
                    std::set<int> curves;
                    for (int n = 0; n < 8; ++n)
                        curves.insert(curveAt(prepared->flat, labels, n));
                    several += curves.size() > 2;
                }
            }
        }
        QVERIFY2(worst < 1e-4, qPrintable(QString::number(worst)));
        QVERIFY(several > 10);
    }

    /// Exact flights integrate polynomials, tracking asks for the extinction place by place, within its bounds.
    void trackingFindsTheSame() {
        std::mt19937 random(6);
        for (unsigned seed = 1; seed <= 8; ++seed) {
            Scene scene = steppedScene(seed);
            if (seed % 4 == 0)
                scene.parts.curves[1].transferFunction.extinctionPerMm = 400;  // bounds of voxels
            const auto prepared = Flattener().prepare(scene);
            const Ray ray = test::raysThrough(*scene.volume, 1, seed)[0];
            test::Sample exact[3], tracked[3], light;
            const auto add = [](test::Sample* to, double distance) {
                to[0].add(distance < 0);
                to[1].add(distance < 0 ? 0 : distance);
                to[2].add(distance < 0 ? 0 : distance * distance);
            };
            bool over = false;
            for (std::uint64_t i = 0; i < 20'000; ++i) {
                const Random numbers(seed, 0, i);
                add(exact, double(freeFlight(prepared->flat, ray, freePathDepth(std::uint32_t(random()))).distance));
                add(tracked, double(track<DeltaTracking>(prepared->flat, ray,
                                                         numbers.stream(0, BounceDimension::distance), over)));
                light.add(double(
                    track<RatioTracking>(prepared->flat, ray, numbers.stream(0, BounceDimension::shadow), over)));
            }
            QVERIFY(!over);
            for (int moment = 0; moment < 3; ++moment) {
                const double error = std::hypot(exact[moment].standardError(), tracked[moment].standardError());
                QVERIFY(std::fabs(exact[moment].mean() - tracked[moment].mean()) <= test::allowedZ(32) * error + 1e-9);
            }
            const double left = std::exp(-double(freeFlight(prepared->flat, ray, 1e9f).passed));
            QVERIFY(std::fabs(light.mean() - left) <= test::allowedZ(32) * light.standardError() + 1e-6);
        }
    }

    /// Parts that all have the common curve give the bits of a scene without parts, and so do those of no voxel.
    void theCommonCurveIsNoPart() {
        for (const Model model :
             {Model::absorption, Model::singleScattering, Model::multipleScattering, Model::maximumIntensity}) {
            Scene scene = test::anyScene(4);
            scene.model = model;
            const Film plain = test::render(scene, 8);
            scene.parts.map = test::anyParts(*scene.volume, 9, 4);
            for (int label = 1; label <= 9; ++label)
                scene.parts.curves.push_back({std::uint8_t(label), scene.transferFunction});
            QVERIFY(Flattener().prepare(scene)->parts.empty());
            QVERIFY2(sameBits(plain.content(), test::render(scene, 8).content()), modelName(model));
        }
    }

    /// One part that is everywhere gives the bits of a scene whose own curve is that of the part.
    void onePartEverywhereIsTheWholeScene() {
        for (const Model model : {Model::absorption, Model::singleScattering, Model::multipleScattering}) {
            Scene scene = test::anyScene(5);
            scene.model = model;
            const Film plain = test::render(scene, 8);
            scene.parts.map = test::labelled(*scene.volume, 1, [](ivec3) { return 1; });
            scene.parts.curves = {{1, scene.transferFunction}};
            scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}};
            QVERIFY(!Flattener().prepare(scene)->parts.empty());
            QVERIFY2(sameBits(plain.content(), test::render(scene, 8).content()), modelName(model));
        }
    }

    /// Between two materials an event is in each by its share of the extinction, and the number that chose is even
    /// again.
    void eventsShareTheExtinction() {
        Scene scene = test::plainScene(test::makeVolume(ivec3(8), dvec3(1), [](int, int, int) { return 100; }), 1);
        scene.transferFunction.nodes[0].albedo = vec3(1, 0, 0);
        scene.parts.map = test::labelled(*scene.volume, 1, [](ivec3 voxel) { return voxel.x >= 4 ? 1 : 0; });
        scene.parts.curves = {{1, {3, {{.hu = 0, .opacity = 1, .albedo = vec3(0, 1, 0)}}}}};
        const auto prepared = Flattener().prepare(scene);
        constexpr int kNumbers = 4000;
        int met = 0;
        double left[2] = {0, 0};
        for (int i = 0; i < kNumbers; ++i) {
            float u = (float(i) + 0.5f) / kNumbers;
            const bool part = curveMet(prepared->flat, {3.25f, 4.3f, 2.1f}, 100, u).extinctionPerMm == 3;
            met += part;
            left[part] += double(u);
            QVERIFY(u >= 0 && u < 1);
        }
        QVERIFY(std::abs(met - kNumbers / 2) <= 8);  // .25 * 3 of .25 * 3 + .75 * 1
        QVERIFY(std::fabs(left[0] / (kNumbers - met) - 0.5) < 0.01 && std::fabs(left[1] / met - 0.5) < 0.01);
        QVERIFY(std::fabs(extinction(prepared->flat, vec3(3.25f, 4.3f, 2.1f)) - 1.5f) < 1e-6f);
    }

    /// Parts that differ in colour alone are one for flights, and events still tell them apart.
    void partsOfOneOpacityDifferInTheirColour() {
        Scene scene = test::plainScene(test::makeVolume(ivec3(8), dvec3(1), [](int, int, int) { return 100; }), 1);
        scene.parts.map = test::labelled(*scene.volume, 2, [](ivec3 voxel) { return voxel.x < 4 ? 1 : 2; });
        for (const int label : {1, 2}) {
            scene.parts.curves.push_back({std::uint8_t(label), scene.transferFunction});
            scene.parts.curves.back().transferFunction.nodes[0].albedo = vec3(0.25f * float(label));
        }
        const auto prepared = Flattener().prepare(scene);
        QCOMPARE(prepared->parts.curves.size(), std::size_t(3));
        QCOMPARE(prepared->parts.pieceAt.size(), std::size_t(65536 / 16));  // of all curves: their borders are the same
        std::uint64_t labels{};
        for (int x = 0; x < 7; ++x)
            QCOMPARE(onlyCurve(prepared->flat, ivec3(x, 3, 3), labels), 0);
        const auto share = [&](float x) {  // of the second part
            int met = 0;
            for (int i = 0; i < 1000; ++i) {
                float u = (float(i) + 0.5f) / 1000;
                met += materialAt(curveMet(prepared->flat, {x, 3, 3}, 100, u), 100).albedo == vec3(0.5f);
            }
            return met;
        };
        QCOMPARE(share(2.5f), 0);
        QVERIFY(std::abs(share(3.25f) - 250) <= 2);
        QCOMPARE(share(5), 1000);
    }

    /// A part reflects as readily as its own gradient factor says, where the common tissue does not.
    void aPartHasSurfacesOfItsOwn() {
        Scene scene =
            test::plainScene(test::makeVolume(ivec3(8), dvec3(1), [](int i, int, int) { return 100 * i; }), 1);
        scene.transferFunction.nodes = {{.hu = -1000, .opacity = 0.8f}, {.hu = 1000, .opacity = 1}};
        scene.parts.map = test::labelled(*scene.volume, 2, [](ivec3 voxel) { return voxel.x / 3; });
        scene.parts.curves = {{1, scene.transferFunction, 50.0f}, {2, scene.transferFunction, 0.0f}};
        QVERIFY(scene.check());
        const auto prepared = Flattener().prepare(scene);
        QCOMPARE(prepared->parts.curves.size(), std::size_t(2));
        QVERIFY(has(prepared->flat.features, kSurface));
        const auto isSurfaceAt = [&](float x) {
            return eventAt<kSurface>(prepared->flat, {x, 4, 4}, {-1, 0, 0}, 0.5f).normal != vec3(0);
        };
        QVERIFY(!isSurfaceAt(1.5f) && isSurfaceAt(4) && !isSurfaceAt(6.5f));
        scene.parts.curves[0].gradientFactor = {};
        QVERIFY(Flattener().prepare(scene)->parts.empty());
    }

    /// A part that is as opaque at all HU has its surface where its labels end, whatever the HU are there.
    void aPartOfTheShapeOfItsLabelsHasTheirSurface() {
        Scene scene =
            test::plainScene(test::makeVolume(ivec3(12), dvec3(1), [](int, int j, int) { return 100 * j; }), 1);
        scene.gradientFactor = 50;
        scene.parts.map = test::labelled(*scene.volume, 1, [](ivec3 voxel) { return voxel.x >= 6 ? 1 : 0; });
        scene.parts.curves = {{1, {0.5f, {{.hu = 0, .opacity = 1}, {.hu = 800, .opacity = 1}}}}};
        const auto prepared = Flattener().prepare(scene);
        const auto normalIn = [&](float x) {
            return eventAt<kSurface>(prepared->flat, {x, 5, 5}, {-1, 0, 0}, 0.01f).normal;
        };
        QCOMPARE(normalIn(6.2f), vec3(-1, 0, 0));
        QCOMPARE(normalIn(9), vec3(0));
        QVERIFY(std::fabs(glm::dot(normalIn(2), vec3(0, 1, 0))) > 0.99f);  // the rest has that of the HU
        scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}};
        scene.volume = test::makeVolume(ivec3(12), dvec3(1), [](int, int, int) { return 7; });
        QVERIFY(has(Flattener().prepare(scene)->flat.features, kSurface));
    }

    /// A part has a surface where it ends beside less opaque tissue, also where the HU have no edge, or one that falls
    /// into it as steeply; beside tissue as opaque it has none.
    void aPartEndsWhereTissueIsLessOpaque() {
        Scene scene = test::plainScene(
            test::makeVolume(ivec3(20), dvec3(1), [](int i, int j, int) { return 40 * j - 100 * i; }), 1);
        scene.gradientFactor = 50;
        scene.parts.map = test::labelled(
            *scene.volume, 2, [](ivec3 voxel) { return voxel.x >= 10 && voxel.z <= 12 ? 1 + voxel.y / 10 : 0; });
        const TransferFunction solid{0.5f, {{.hu = -3000, .opacity = 0.9f}, {.hu = 100, .opacity = 1}}};
        scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}};
        scene.parts.curves = {{1, solid}, {2, solid, 40.0f}};
        const auto normalIn = [&](vec3 position) {
            return eventAt<kSurface>(Flattener().prepare(scene)->flat, position, {-1, 0, 0}, 0.01f).normal;
        };
        QVERIFY(normalIn({10, 5, 5}).x < -0.95f);
        const vec3 ofHu = glm::normalize(vec3(-100, 40, 0));
        QVERIFY(glm::distance(normalIn({15, 5, 5}), ofHu) < 1e-5f);
        QVERIFY(glm::distance(normalIn({15, 9.5f, 5}), ofHu) < 1e-5f);  // between the parts
        QVERIFY(std::fabs(normalIn({15, 5, 11.5f}).z) > 0.1f);          // of the next fine cell
        scene.parts.curves[1].transferFunction.extinctionPerMm = 0.25f;
        QVERIFY(std::fabs(normalIn({15, 9.4f, 5}).y) > 0.7f);
        scene.volume = test::makeVolume(ivec3(20), dvec3(1), [](int, int, int) { return 7; });
        QCOMPARE(normalIn({10, 5, 5}), vec3(-1, 0, 0));
        QVERIFY(has(Flattener().prepare(scene)->flat.features, kSurface));
    }

    void whatCannotBeShownIsRefused() {
        Scene scene = gentleScene(1);
        const auto refused = [&](const char* what, auto&& edit) {
            Scene edited = scene;
            edit(edited);
            const Result<void> checked = edited.check();
            QVERIFY2(!checked && checked.error().where.starts_with("parts"), what);
        };
        refused("model", [](Scene& s) { s.model = Model::emission; });
        refused("label 0", [](Scene& s) { s.parts.curves[0].label = 0; });
        refused("twice", [](Scene& s) { s.parts.curves[1].label = 1; });
        refused("gradient factor", [](Scene& s) { s.parts.curves[0].gradientFactor = -1.0f; });
        refused("curve", [](Scene& s) { s.parts.curves[0].transferFunction.nodes.clear(); });
        refused("grid", [](Scene& s) {
            auto map = std::make_shared<LabelMap>(*s.parts.map);
            map->geometry.patientFromIndex[3].x += 0.5;
            s.parts.map = map;
        });
    }
};

QTEST_GUILESS_MAIN(PartsTest)
#include "parts_test.moc"
