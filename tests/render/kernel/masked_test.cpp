/// Volumes of which a part is hidden: light meets tissue as far as it is seen, by all models, on lanes as alone.

#include <QTest>
#include <random>

#include "render/device/cpu/flight_batch.h"
#include "render/device/cpu/projection_batch.h"
#include "render/kernel/quadrature/projection.h"
#include "render/kernel/transport/event.h"
#include "render/kernel/transport/tracking.h"
#include "render/prepare/needs.h"
#include "render/scene/model.h"
#include "tests/support/scenes/masks.h"
#include "tests/support/scenes/random_scenes.h"
#include "tests/support/scenes/ray_reference.h"

using namespace pdr;

namespace {

Scene maskedScene(unsigned seed) {
    Scene scene = test::anyScene(seed);
    scene.mask = test::anyMask(*scene.volume, seed);
    return scene;
}

/// A ray segment through the visible tissue, by brute force in double precision.
struct Seen {
    double depth = 0;
    dvec3 emitted{0}, absorbed{0};
};
Seen seenOn(const Scene& scene, const Ray& ray, int steps) {
    Seen seen;
    const double step = double(ray.length) / steps;
    for (int i = 0; i < steps; ++i) {
        const dvec3 place = dvec3(ray.origin) + dvec3(ray.direction) * ((i + 0.5) * step);
        const test::Optics optics = test::opticsAt(scene.transferFunction, test::huAt(*scene.volume, place));
        const double depth = optics.extinction * scene.mask->at(place) * step;
        seen.emitted += optics.source * depth;
        seen.absorbed += optics.source * (std::exp(-seen.depth) * -std::expm1(-depth));
        seen.depth += depth;
    }
    return seen;
}

/// A curve without steps, which brute force would need far smaller steps for.
Scene gentleScene(unsigned seed) {
    Scene scene = maskedScene(seed);
    scene.transferFunction.nodes = {{.hu = -900, .opacity = 0, .albedo = vec3(0.2f, 0.5f, 0.9f)},
                                    {.hu = 300, .opacity = 0.4f, .albedo = vec3(0.9f, 0.3f, 0.5f)},
                                    {.hu = 1900, .opacity = 1, .albedo = vec3(0.4f, 0.8f, 0.2f)}};
    scene.transferFunction.extinctionPerMm = 0.3f;
    return scene;
}

/// White, even tissue of 32^3 voxels of 1 mm of which the half with x < 16 is seen: the weight is 1/2 at x = 15.5.
Scene halfSeen(float extinctionPerMm) {
    Scene scene =
        test::plainScene(test::makeVolume(ivec3(32), dvec3(1), [](int, int, int) { return 100; }), extinctionPerMm);
    scene.mask = maskOf({ivec3(32), ivec3(0)}, "", [](dvec3 place) { return edgeWeight(15.5 - place.x, 1); });
    return scene;
}

Scene without(Scene scene) {
    scene.mask = nullptr;
    return scene;
}

}  // namespace

class MaskedTest : public QObject {
    Q_OBJECT

  private slots:
    void halfACubeHalvesTheDepth() {
        const auto prepared = Flattener().prepare(halfSeen(0.2f));
        const Ray across{{-0.5f, 10.3f, 12.1f}, {1, 0, 0}, 32}, along{{7.2f, -0.5f, 9.0f}, {0, 1, 0}, 32},
            hidden{{20.2f, -0.5f, 9.0f}, {0, 1, 0}, 32};
        QVERIFY(std::fabs(freeFlight(prepared->flat, across, 100).passed - 0.2f * 16) < 1e-5f);
        QVERIFY(std::fabs(freeFlight(prepared->flat, along, 100).passed - 0.2f * 32) < 1e-5f);
        QCOMPARE(freeFlight(prepared->flat, hidden, 100).passed, 0.0f);
        // In the ramp from 1 at 15 to 0 at 16 the depth is quadratic: at 15.5 it has passed 3/8 of a voxel's.
        const float distance = freeFlight(prepared->flat, across, 0.2f * (15.5f + 0.375f)).distance;
        QVERIFY2(std::fabs(distance - 16.0f) < 1e-4f, qPrintable(QString::number(distance)));
    }

    void flightsPassWhatBruteForceFinds() {
        std::mt19937 random(3);
        double worst = 0;
        int ended = 0;
        for (unsigned seed = 1; seed <= 40; ++seed) {
            const Scene scene = gentleScene(seed);
            const auto prepared = Flattener().prepare(scene);
            for (Ray ray : test::raysThrough(*scene.volume, 20, seed)) {
                const float wanted = freePathDepth(std::uint32_t(random()));
                const Flight flight = freeFlight(prepared->flat, ray, wanted);
                ended += flight.distance >= 0;
                ray.length = flight.distance >= 0 ? flight.distance : ray.length;
                const double expected = flight.distance >= 0 ? double(wanted) : double(flight.passed);
                worst = std::max(worst, std::fabs(seenOn(scene, ray, 4000).depth - expected) / (1e-3 + expected));
            }
        }
        QVERIFY2(worst < 3e-3, qPrintable(QString::number(worst)));
        QVERIFY(ended > 100 && ended < 700);
    }

    /// Exact flights know the weight as a cubic, tracking asks for it place by place.
    void trackingFindsTheSame() {
        std::mt19937 random(6);
        for (unsigned seed = 1; seed <= 8; ++seed) {
            const Scene scene = maskedScene(seed);
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

    void sumsAlongRaysAreThoseOfBruteForce() {
        double worst = 0;
        for (unsigned seed = 1; seed <= 30; ++seed) {
            Scene scene = gentleScene(seed);
            scene.environment = {};
            const auto found = [&](Model model, const Ray& ray) {
                scene.model = model;
                const auto prepared = Flattener().prepare(scene);
                const Projected seen =
                    model == Model::absorption ? project<FlatModel::absorption>(prepared->flat, ray, vec3(1))
                    : model == Model::emission ? project<FlatModel::emission>(prepared->flat, ray, vec3(0))
                                               : project<FlatModel::emissionAbsorption>(prepared->flat, ray, vec3(0));
                return dvec3(seen.withinTolerance ? seen.radiance : vec3(NAN));
            };
            for (const Ray& ray : test::raysThrough(*scene.volume, 5, seed)) {
                const Seen truth = seenOn(scene, ray, 6000);
                const auto compare = [&](dvec3 value, dvec3 expected) {
                    for (int c = 0; c < 3; ++c)
                        worst = std::max(worst, std::fabs(value[c] - expected[c]) / (1e-3 + expected[c]));
                };
                compare(found(Model::absorption, ray), dvec3(std::exp(-truth.depth)));
                compare(found(Model::emission, ray), truth.emitted);
                compare(found(Model::emissionAbsorption, ray), truth.absorbed);
            }
        }
        const double allowed = 1 - std::exp(-0.25 / (255 * 0.6232)) + 3e-3;  // what the scene tolerates, and the steps
        QVERIFY2(worst < allowed, qPrintable(QString::number(worst)));
    }

    void theHighestHuIsTheHighestThatIsSeen() {
        Scene scene = halfSeen(1);
        scene.volume = test::makeVolume(ivec3(32), dvec3(1), [](int i, int, int) { return 10 * i; });
        scene.model = Model::maximumIntensity;
        const auto prepared = Flattener().prepare(scene);
        RayMaximum<float, true> walk;
        walk.start(prepared->flat, {-0.5f, 10.3f, 12.1f}, {1, 0, 0}, 32);
        while (walk.going())
            walk.step(prepared->flat);
        QVERIFY(std::fabs(walk.result().value[0] - 155) <= 2.5f);  // within a quarter of a cell
        RayMaximum<float, true> hidden;
        hidden.start(prepared->flat, {20.2f, -0.5f, 9.0f}, {0, 1, 0}, 32);
        while (hidden.going())
            hidden.step(prepared->flat);
        QVERIFY(hidden.result().value[0] < -32768);
    }

    void lanesSeeAsOneRayDoes() {
        std::mt19937 random(7);
        for (unsigned seed = 1; seed <= 12; ++seed) {
            Scene scene = maskedScene(seed);
            const auto prepared = Flattener().prepare(scene);
            auto flights = std::make_unique<FlightBatch>();
            const std::vector<Ray> rays = test::raysThrough(*scene.volume, 200, seed);
            std::vector<float> depths;
            for (const Ray& ray : rays) {
                depths.push_back(freePathDepth(std::uint32_t(random())));
                flights->add(ray, depths.back());
            }
            flights->fly(prepared->flat);
            scene.model = Model::emissionAbsorption;
            const auto sums = Flattener().prepare(scene);
            auto projections = std::make_unique<ProjectionBatch>();
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const Flight alone = freeFlight(prepared->flat, rays[i], depths[i]);
                QCOMPARE(flights->distance(int(i)), alone.distance);
                if (alone.distance < 0)
                    QCOMPARE(flights->passed(int(i)), alone.passed);
                projections->add(rays[i], vec3(0.5f));
            }
            projections->project<FlatModel::emissionAbsorption>(sums->flat);
            for (std::size_t i = 0; i < rays.size(); ++i)
                QVERIFY(projections->result(int(i)).radiance ==
                        project<FlatModel::emissionAbsorption>(sums->flat, rays[i], vec3(0.5f)).radiance);
        }
    }

    /// A mask that shows everything changes no bit, and one that hides everything leaves the background, for each
    /// model.
    void allSeenIsNoMaskAndAllHiddenIsNoTissue() {
        for (const Model model : kModels)
            for (const float extinction : {0.3f, 3000.0f}) {
                Scene scene = test::anyScene(4);
                scene.model = model;
                scene.transferFunction.extinctionPerMm = extinction;
                const Film plain = test::render(scene, 8);
                scene.mask = test::evenMask(*scene.volume, kSeen, ivec3(1, 0, 2));
                QVERIFY2(sameBits(plain.content(), test::render(scene, 8).content()), modelName(model));
                scene.mask = test::evenMask(*scene.volume, 0);
                const Film hidden = test::render(scene, 8);
                if (model == Model::maximumIntensity)
                    scene.window = {32766, 32767};  // nothing of it shows
                scene.mask = nullptr;
                scene.transferFunction.extinctionPerMm = 0;
                const Film empty = test::render(scene, 8);
                for (int y = 0; y < scene.film.y; ++y)
                    for (int x = 0; x < scene.film.x; ++x)
                        QVERIFY2(hidden.pixel(x, y).mean == empty.pixel(x, y).mean, modelName(model));
            }
    }

    /// A mask agrees within the noise with a clip box that cuts at the middle of its edge; a shifted mask does not.
    void aBoxIsSeenAsAClipBoxIs() {
        for (const Model model : {Model::singleScattering, Model::multipleScattering}) {
            Scene scene = test::anyScene(5);
            scene.volume = test::bumpyVolume({40, 36, 44}, dvec3(1), 5);
            scene.film = {32, 32};
            scene.gradientFactor = 0;
            scene.model = model;
            scene.transferFunction = gentleScene(1).transferFunction;
            const auto boxed = [&](double shift) {
                Scene masked = scene;
                masked.seed = 9;
                masked.mask = maskOf({scene.volume->size(), ivec3(0)}, "", [shift](dvec3 place) {
                    const dvec3 inside = glm::min(place - 8.5 - shift, 27.5 + shift - place);
                    return edgeWeight(std::min(inside.x, std::min(inside.y, inside.z)), 1);
                });
                return test::render(masked, 256);
            };
            scene.clip.box = ClipBox{dvec3(9), dvec3(28)};  // voxel 0 is centred at 0.5 mm
            const Film clipped = test::render(scene, 256);
            QVERIFY(test::likeness(clipped, boxed(0)).p > 1e-4);
            QVERIFY(test::likeness(clipped, boxed(1)).p < 1e-4);
        }
    }

    /// Hidden cells are passed, and no bound is broken.
    void hiddenCellsAreEmptyAndBoundsHold() {
        const Scene scene = halfSeen(0.5f);
        const auto half = Flattener().prepare(scene), whole = Flattener().prepare(without(scene));
        const auto empty = [](const PreparedScene& prepared) {
            return std::ranges::count(prepared.majorants->fine, 0.0f);
        };
        QVERIFY(empty(*half) > empty(*whole) + 200);  // of 9^3 cells 4 x 9^2 are hidden
        QVERIFY(half->flat.majorants.occupiedHigh.x <= 16.0f);
        QCOMPARE(whole->flat.majorants.occupiedHigh.x, 31.5f);
    }

    /// What is hidden counts as air: 2000 HU that are seen, and fewer from there on, end in an edge of 2000 HU per mm.
    void anEdgeReflectsAsOneAgainstAirDoes() {
        Scene scene = halfSeen(5);
        scene.volume = test::makeVolume(ivec3(32), dvec3(1), [](int, int j, int) { return 100 * j; });
        scene.gradientFactor = 1e4f;
        const auto masked = Flattener().prepare(scene), plain = Flattener().prepare(without(scene));
        const auto normal = [](const PreparedScene& prepared, float x) {
            return eventAt<kSurface>(prepared.flat, {x, 10, 10}, {0.8f, -0.6f, 0}, 0.1f).normal;
        };
        const vec3 gradient = seenGradient(masked->flat, {15.5f, 10, 10}, 1000);
        QVERIFY(glm::distance(gradient, vec3(-2000, 50, 0)) < 0.1f);
        QVERIFY(glm::distance(normal(*masked, 15.5f), -glm::normalize(gradient)) < 1e-6f);
        QVERIFY(normal(*plain, 15.5f) == vec3(0, -1, 0));
        QVERIFY(normal(*masked, 12.0f) == normal(*plain, 12.0f));
    }

    /// Uniform tissue, which has no other edge, reflects at the edge of a mask as well; noise hardly turns its face.
    void theFaceOfWhatIsHiddenIsFlat() {
        Scene scene = halfSeen(5);
        scene.gradientFactor = 4;
        QVERIFY(has(neededFeatures(needs(scene)), kSurface));
        QVERIFY(!has(neededFeatures(needs(without(scene))), kSurface));
        std::mt19937 random(8);
        std::normal_distribution<double> noise(0, 40);
        scene.volume = test::makeVolume(ivec3(32), dvec3(1), [&](int, int, int) { return 400 + noise(random); });
        const auto prepared = Flattener().prepare(scene);
        for (int i = 0; i < 200; ++i) {
            const vec3 place(15.5f, 4 + 0.1f * float(i), 8 + 0.07f * float(i));
            const vec3 gradient = seenGradient(prepared->flat, place, hounsfield(prepared->flat.volume, place));
            QVERIFY(glm::normalize(gradient).x < -0.995f);
        }
    }

    void aMaskOfAnotherVolumeIsRefused() {
        Scene scene = halfSeen(1);
        QVERIFY(scene.check());
        scene.mask = test::evenMask(*test::bumpyVolume({4, 4, 4}, dvec3(1), 1), kSeen);
        QCOMPARE(scene.check().error().where, std::string("mask"));
    }
};

QTEST_GUILESS_MAIN(MaskedTest)
#include "masked_test.moc"
