/// Exposure Render's way of taking a sample is wrong as it is known to be, and in nothing else.

#include <QTest>

#include "render/kernel/baseline/kroes_path.h"
#include "render/kernel/pixel.h"
#include "render/volume/phantom.h"
#include "tests/support/scenes/images.h"
#include "tests/support/scenes/random_scenes.h"

using namespace pdr;

namespace {

Scene marched(Scene scene) {
    scene.estimator = Estimator::kroesMarch;
    return scene;
}

/// The head phantom as bone, lit from the side.
Scene head() {
    Scene scene;
    scene.volume = std::make_shared<Volume>(headPhantom(kHeadPhantomSize / 2, kHeadPhantomSpacingMm * 2.0));
    scene.transferFunction = {31,
                              {{.hu = -57, .opacity = 0},
                               {.hu = 157.6f, .opacity = 0.018f},
                               {.hu = 157.8f, .opacity = 0.56f},
                               {.hu = 426, .opacity = 1}}};
    scene.gradientFactor = 3;
    scene.lights = {DirectionalLight{{1, 2, -1}, vec3(2)}};
    scene.camera = standardView(StandardView::anterior, scene.volume->geometry().centreMm(), 150, 1);
    scene.film = {64, 64};
    return scene;
}

/// Thin tissue under all kinds of light: `which` % 7 = 0 all together; 1 .. 4 one alone; 5 light from all around, and
/// tissue that shines; 6 an image all around.
Scene thinScene(unsigned which) {
    Scene scene = test::anyScene(3 * which + 1);
    scene.rayOrigin = RayOrigin::event;  // the estimator knows no other
    scene.model = Model::singleScattering;
    scene.transferFunction.extinctionPerMm = 0.03f;
    scene.film = {40, 40};
    scene.environment.visible = false;
    scene.environment.nadir = vec3(1, 0.1f, 0.1f);
    const unsigned kind = which % 7;
    if (kind > 0)
        scene.lights = kind < 5 ? std::vector<Light>{scene.lights[kind - 1]} : std::vector<Light>();
    if (kind > 0 && kind < 5)
        scene.environment = {vec3(0)};
    if (kind == 5)
        for (TransferNode& node : scene.transferFunction.nodes)
            node.emission = vec3(0.5f);
    const auto picture =
        std::make_shared<EnvironmentImage>(EnvironmentImage{{2, 2}, {vec3(1), vec3(8), vec3(0), vec3(3)}});
    if (kind == 6)
        scene.environment = {.radiance = vec3(1), .visible = false, .image = picture};
    return scene;
}

/// Differences of both estimators on the same rays: where they end, and the transmittance from there to the first
/// light.
struct Compared {
    test::Sample deeper;    ///< distance where the march ends less where light collides [mm]
    test::Sample brighter;  ///< transmittance of the march less the true one
};

Compared compared(const FlatScene& scene, std::uint64_t samples) {
    const float step = marchStep(scene.volume, kExposureRenderStep);
    const ivec2 film = scene.camera.film;
    Compared result;
    for (int i = 0; i < film.x * film.y; ++i)
        for (std::uint64_t sample = 0; sample < samples; ++sample) {
            const ivec2 pixel(i % film.x, i / film.x);
            const Path path = startPath(scene, pixel, sample, depthBounds(scene, pixel));
            const Ray& ray = path.segment.ray;
            const RandomStream flight = path.sampler.stream(0, BounceDimension::distance);
            const RandomStream shadow = path.sampler.stream(0, BounceDimension::shadow);
            const float ends = marchToCollision(scene, ray, flight, step);
            const float truth = track<DeltaTracking>(scene, ray, flight);
            if (ends < 0 || truth < 0)
                continue;
            result.deeper.add(ends - truth);
            const Ray toLight{ray.origin + ray.direction * truth, scene.volume.indexFromLocal * scene.lights[0].normal,
                              kFarAway};
            result.brighter.add(marchTransmittance(scene, toLight, shadow, step) -
                                track<RatioTracking>(scene, toLight, shadow));
        }
    return result;
}

}  // namespace

class KroesPathTest : public QObject {
    Q_OBJECT

  private slots:
    void eventsLieTooDeepAndShadowsAreTooBright() {
        const auto prepared = Flattener().prepare(head());
        const Compared got = compared(prepared->flat, 4);
        const double step = double(marchStep(prepared->flat.volume, kExposureRenderStep));
        qInfo("step %.2f mm: %+.2f mm (z = %.0f), transmittance %+.4f (z = %.0f)", step, got.deeper.mean(),
              got.deeper.z(0), got.brighter.mean(), got.brighter.z(0));
        QVERIFY(got.deeper.z(0) > test::allowedZ(2) && got.deeper.mean() < 2 * step);
        QVERIFY(got.brighter.z(0) > test::allowedZ(2));
    }

    void theImageIsNotTheUnbiasedOne() {
        const Film biased = test::render(marched(head()), 32), truth = test::render(head(), 32);
        const test::ImageMean got = test::imageMean(biased), right = test::imageMean(truth);
        const double z = (got.mean - right.mean) / std::hypot(got.standardError, right.standardError);
        qInfo("image mean %+.1f %% (z = %.0f)", 100 * (got.mean / right.mean - 1), z);
        QVERIFY(std::fabs(z) > 2 * test::allowedZ(1));
    }

    /// Where a step is a small part of a free path, little of the bias is left: what else differs would be seen.
    void inThinTissueItAgreesWithTheUnbiasedEstimator() {
        constexpr unsigned kScenes = 14;
        for (unsigned seed = 0; seed < kScenes; ++seed) {
            const Scene scene = thinScene(seed);
            Scene other = marched(scene);
            other.seed += 1000;
            QVERIFY(bool(other.check()));
            const test::ImageMean got = test::imageMean(test::render(other, 256));
            const test::ImageMean right = test::imageMean(test::render(scene, 256));
            const double z = (got.mean - right.mean) / std::hypot(got.standardError, right.standardError);
            qInfo("scene %u: %.5f and %.5f, %+.2f %% (z = %.2f)", seed, got.mean, right.mean,
                  100 * (got.mean / right.mean - 1), z);
            QVERIFY(right.standardError < 0.02 * right.mean);
            QVERIFY(std::fabs(z) < test::allowedZ(int(kScenes)));
        }
    }

    void tilesThreadsAndIterationsPerFrameChangeNoBit() {
        Scene scene = marched(test::anyScene(4));
        scene.model = Model::singleScattering;
        scene.film = {50, 37};
        const Film whole = test::render(scene, 70, *makeCpuDevice(1));
        QVERIFY(test::imageMean(whole).mean > 0);
        QVERIFY(test::sameBits(whole, test::render(scene, 70, *makeCpuDevice(3), 7, 13)));
    }

    void withoutLightAndWithoutTissueItIsBlack() {
        Scene scene = marched(test::plainScene(test::bumpyVolume({20, 20, 20}, dvec3(1), 1), 1));
        scene.lights.clear();
        QCOMPARE(test::imageMean(test::render(scene, 4)).mean, 0.0);
        scene.environment.radiance = vec3(1);
        QVERIFY(test::imageMean(test::render(scene, 4)).mean > 0);
        scene.environment.visible = false;
        scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}};
        QCOMPARE(test::imageMean(test::render(scene, 4)).mean, 0.0);
    }

    void onlySingleScatteringCanBeMarched() {
        for (const Model model : kModels) {
            Scene scene = marched(test::plainScene(test::bumpyVolume({8, 8, 8}, dvec3(1), 1), 1));
            scene.model = model;
            const Result<void> ok = scene.check();
            QCOMPARE(bool(ok), model == Model::singleScattering);
            if (!ok)
                QVERIFY(ok.error().where == "estimator" && ok.error().what.find(modelName(model)) != std::string::npos);
        }
    }
};

QTEST_GUILESS_MAIN(KroesPathTest)
#include "kroes_path_test.moc"
