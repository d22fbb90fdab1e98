/// Images with known answers, on every path through the CPU device.

#include <QTest>

#include "render/kernel/random.h"
#include "render/kernel/transport/surface.h"
#include "tests/support/scenes/images.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

Scene variedScene() {
    Scene scene = test::plainScene(test::bumpyVolume({61, 45, 38}, {0.7, 1.1, 2.3}, 1), 1);
    scene.transferFunction.nodes = {
        {.hu = -200, .opacity = 0, .albedo = vec3(0.9f, 0.5f, 0.4f)},
        {.hu = 300, .opacity = 0.2f, .albedo = vec3(0.9f, 0.6f, 0.4f)},
        {.hu = 300, .opacity = 0, .albedo = vec3(0.9f)},
        {.hu = 900, .opacity = 1, .albedo = vec3(0.9f), .specular = vec3(0.05f), .roughness = 0.4f}};
    const dvec3 centre = scene.volume->geometry().centreMm();
    scene.lights.push_back(
        RectangleLight{centre + dvec3(-80, -100, 60), dvec3(80, 100, -60), {0, 0, 1}, 90, 60, vec3(4, 3, 2)});
    scene.environment = {vec3(0.2f, 0.3f, 0.4f), true};
    scene.gradientFactor = 1;
    scene.phaseG = 0.4f;
    return scene;
}

}  // namespace

class ImageTest : public QObject {
    Q_OBJECT

  private slots:
    /// L = albedo p E mu0 / (mu + mu0) [1 - exp(-tau (1/mu + 1/mu0))], light from the camera's side.
    void slabScattersBackAsTheClosedFormSays_data() {
        QTest::addColumn<double>("tau");
        QTest::addColumn<double>("mu0");
        QTest::newRow("thin") << 1e-3 << 1.0;
        QTest::newRow("one, straight") << 1.0 << 1.0;
        QTest::newRow("one, oblique") << 1.0 << 0.5;
        QTest::newRow("thick") << 20.0 << 0.8;
    }
    void slabScattersBackAsTheClosedFormSays() {
        QFETCH(double, tau);
        QFETCH(double, mu0);
        const double sine = std::sqrt(1 - mu0 * mu0);
        const Film film = test::render(test::slab(tau, {sine, 0, -mu0}, 0.8f), 8192);
        const double truth = 0.8 / (4 * M_PI) * 2 * mu0 / (1 + mu0) * -std::expm1(-tau * (1 + 1 / mu0));
        const test::ImageMean got = test::imageMean(film);
        QVERIFY2(std::fabs(got.mean - truth) < test::allowedZ(8) * got.standardError,
                 qPrintable(QString("%1 +- %2, expected %3").arg(got.mean).arg(got.standardError).arg(truth)));
    }

    void slabScattersThroughAsTheClosedFormSays() {
        const double tau = 1.5, mu0 = 0.6;
        const Film film = test::render(test::slab(tau, {0.8, 0, mu0}, 0.8f), 8192);
        const double truth = 0.8 / (4 * M_PI) * 2 * mu0 / (mu0 - 1) * (std::exp(-tau / mu0) - std::exp(-tau));
        const test::ImageMean got = test::imageMean(film);
        QVERIFY(std::fabs(got.mean - truth) < test::allowedZ(8) * got.standardError);
    }

    /// Isotropic slab in a white room, albedo 1: L = exp(-tau) + S(tau), S(1) = 0.24818824.
    void slabInAWhiteRoomShowsSingleScattering() {
        Scene scene = test::slab(1, {0, 0, -1}, 1);
        scene.lights.clear();
        scene.environment = {vec3(1), true};
        // A slab of 401 x 401 x 10 mm: light from the sides is attenuated over 200 mm.
        const test::ImageMean got = test::imageMean(test::render(scene, 16384));
        QVERIFY(std::fabs(got.mean - (std::exp(-1.0) + 0.24818824)) < test::allowedZ(8) * got.standardError);
    }

    /// Emission and absorption alone: L = e (1 - exp(-tau)), and the room behind it through exp(-tau).
    void glowingSlabIsTheClosedForm() {
        Scene scene = test::slab(1.3, {0, 0, -1}, 0);
        scene.lights.clear();
        scene.transferFunction.nodes[0].emission = vec3(2);
        const test::ImageMean dark = test::imageMean(test::render(scene, 8192));
        QVERIFY(std::fabs(dark.mean - 2 * -std::expm1(-1.3)) < test::allowedZ(8) * dark.standardError);
        scene.environment = {vec3(2), true};  // as bright as the glow: nothing can be seen of the slab
        const Film film = test::render(scene, 64);
        for (int i = 0; i < 4; ++i)
            QCOMPARE(film.pixel(i, i).mean.x, 2.0);
    }

    /// Half space, isotropic, albedo 0.9, seen and lit straight on: L = E / pi * 0.38507 (Chandrasekhar's H).
    void halfSpaceScattersBackAsChandrasekharSays() {
        Scene scene = test::slab(40, {0, 0, -1}, 0.9f);
        scene.model = Model::multipleScattering;
        const test::ImageMean got = test::imageMean(test::render(scene, 8192));
        QVERIFY2(std::fabs(got.mean - 2 / M_PI * 0.38507) < test::allowedZ(8) * got.standardError,
                 qPrintable(QString("%1 +- %2").arg(got.mean / 2 * M_PI).arg(got.standardError / 2 * M_PI)));
    }

    /// White tissue in a white room cannot be seen, however often light is scattered in it.
    void losslessTissueInAWhiteRoomIsInvisible() {
        Scene scene = variedScene();
        scene.model = Model::multipleScattering;
        scene.maxBounces = 100000;
        scene.gradientFactor = 0;
        scene.lights.clear();
        scene.environment = {vec3(1), true};
        for (TransferNode& node : scene.transferFunction.nodes)
            node.albedo = vec3(1);
        const test::ImageMean got = test::imageMean(test::render(scene, 256));
        QCOMPARE(got.mean, 1.0);
        QCOMPARE(got.standardError, 0.0);
    }

    void imageDoesNotDependOnThreadsTilesOrIterationsPerFrame() {
        const Scene scene = variedScene();
        const Film reference = test::render(scene, 100, *makeCpuDevice(1), 1);
        for (const int threads : {1, 2, 4})
            for (const std::uint32_t n : {1u, 10u, 100u})
                for (const int tile : {7, 16, 4096})
                    QVERIFY(test::sameBits(reference, test::render(scene, 100, *makeCpuDevice(threads), n, tile)));
    }

    void anotherSeedGivesAnotherNoise() {
        Scene scene = variedScene();
        const Film one = test::render(scene, 4);
        scene.seed = 2;
        QVERIFY(!test::sameBits(one, test::render(scene, 4)));
    }

    /// Cells, view bounds and bounds on the extinction are accelerators: without them the image is the same.
    void macrocellsDoNotChangeTheImage() {
        const Scene scene = variedScene();
        const auto device = makeCpuDevice();
        const Film cells = test::render(scene, 512, *device);
        const Film global = test::sampled(test::withGlobalMajorant(scene), 512);
        double square = 0;
        int pixels = 0;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const PixelEstimate a = cells.pixel(x, y), b = global.pixel(x, y);
                const double variance = a.standardError.x * a.standardError.x + b.standardError.x * b.standardError.x;
                if (!(variance > 0)) {
                    QCOMPARE(a.mean.x, b.mean.x);
                    continue;
                }
                square += (a.mean.x - b.mean.x) * (a.mean.x - b.mean.x) / variance;
                ++pixels;
            }
        QVERIFY(pixels > 200);
        QVERIFY2(test::chiSquareP(square, pixels) > 1e-4, qPrintable(QString("%1 on %2").arg(square).arg(pixels)));
        const test::ImageMean a = test::imageMean(cells), b = test::imageMean(global);
        QVERIFY(std::fabs(a.mean - b.mean) < 4 * std::hypot(a.standardError, b.standardError));
    }

    /// A volume that is stored with other axes (sagittal slices, say) but lies at the same place looks the same.
    void storageOrderDoesNotShow() {
        const ivec3 size(30, 24, 20);
        const dvec3 spacing(1, 1.5, 2);
        const auto hu = [](int i, int j, int k) { return 20 * i + 10 * j - 15 * k; };
        Scene scene = test::plainScene(test::makeVolume(size, spacing, hu), 0.5f);
        scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 500, .opacity = 1}};
        const test::ImageMean upright = test::imageMean(test::render(scene, 4096));

        Voxels voxels;  // i along -y, j along z, k along x
        for (int k = 0; k < size.x; ++k)
            for (int j = 0; j < size.z; ++j)
                for (int i = 0; i < size.y; ++i)
                    voxels.push_back(std::int16_t(hu(k, size.y - 1 - i, j)));
        dmat4 map(0);
        map[0] = {0, -spacing.y, 0, 0};
        map[1] = {0, 0, spacing.z, 0};
        map[2] = {spacing.x, 0, 0, 0};
        map[3] = {0.5 * spacing.x, (size.y - 0.5) * spacing.y, 0.5 * spacing.z, 1};
        scene.volume = std::make_shared<Volume>(VolumeGeometry{{size.y, size.z, size.x}, map}, voxels);
        const test::ImageMean turned = test::imageMean(test::render(scene, 4096));
        QVERIFY(upright.mean > 1e-3);
        QVERIFY(std::fabs(upright.mean - turned.mean) < 4 * std::hypot(upright.standardError, turned.standardError));
    }

    /// Inside glowing tissue that no path leaves, n events bring e (1 + a + ... + a^(n - 1)), each path alike, and each
    /// path is one that was cut.
    void maxBouncesIsTheNumberOfEvents() {
        Scene scene = test::plainScene(test::makeVolume({8, 8, 8}, dvec3(10), [](int, int, int) { return 0; }), 100);
        scene.model = Model::multipleScattering;
        scene.transferFunction.nodes[0].albedo = vec3(0.9f, 0.8f, 0.7f);
        scene.transferFunction.nodes[0].emission = vec3(2, 3, 5);
        scene.lights.clear();
        scene.camera = {.eyeMm = {41, 42, 43}, .targetMm = {80, 40, 30}};
        scene.film = {8, 8};
        dvec3 expected(0), event(2, 3, 5);
        for (int bounces = 1; bounces <= 4; ++bounces) {
            expected += event;
            event *= dvec3(vec3(0.9f, 0.8f, 0.7f));
            scene.maxBounces = bounces;
            const Film film = test::render(scene, 16);
            const dvec3 got = film.pixel(3, 5).mean;
            for (int c = 0; c < 3; ++c)
                QVERIFY2(std::fabs(got[c] / expected[c] - 1) < 1e-6,
                         qPrintable(QString("%1 instead of %2 at %3").arg(got[c]).arg(expected[c]).arg(bounces)));
            const std::uint64_t cut = bounces == 1 ? 0 : 8 * 8 * 16;  // one event is all that was asked for
            QCOMPARE(film.status().health.of(Fault::cutPath).count, cut);
        }
    }

    void farAwayCameraSeesTheSame() {
        Scene scene = variedScene();
        scene.lights.pop_back();
        scene.camera.type = Camera::Type::orthographic;
        scene.camera.heightMm = 120;
        const dvec3 back = -scene.camera.forward();
        scene.camera.eyeMm = scene.camera.targetMm + back * 1e3;
        const test::ImageMean near = test::imageMean(test::render(scene, 1024));
        scene.camera.eyeMm = scene.camera.targetMm + back * 1e7;
        const test::ImageMean far = test::imageMean(test::render(scene, 1024));
        QVERIFY(std::fabs(near.mean - far.mean) < 4 * std::hypot(near.standardError, far.standardError));
    }

    void smallestVolumesAndImagesRender() {
        for (const ivec3 size : {ivec3(1, 1, 1), ivec3(2, 1, 1), ivec3(1, 9, 1), ivec3(1, 1, 5), ivec3(5, 1, 3)})
            for (const ivec2 film : {ivec2(1, 1), ivec2(3, 17)}) {
                Scene scene = test::plainScene(test::makeVolume(size, dvec3(2), [](int, int, int) { return 7; }), 0.3f);
                scene.film = film;
                scene.gradientFactor = 1;
                const FilmStatus status = test::render(scene, 1024).status();  // some cover 1 % of the image
                QVERIFY(status.health.perfect());
                QVERIFY(status.meanLuminance > 0);
            }
    }

    void cameraInsideTheVolumeSeesOutwards() {
        Scene scene = test::plainScene(test::makeVolume({20, 20, 20}, dvec3(1), [](int, int, int) { return 7; }), 0.1f);
        scene.environment = {vec3(1), true};
        scene.transferFunction.nodes[0].albedo = vec3(0);
        scene.camera = {.type = Camera::Type::perspective,
                        .eyeMm = {10, 10, 10},
                        .targetMm = {20, 10, 10},
                        .up = {0, 0, 1},
                        .fovDegrees = 1e-3};
        const test::ImageMean got = test::imageMean(test::render(scene, 1024));
        QVERIFY(std::fabs(got.mean - std::exp(-1.0)) < 4 * got.standardError);
    }

    /// Every event in a flat half space is a Lambert reflection; on its way out light crosses what lies above the
    /// event: L = 2 int_0^1 mu^2 / (1 + mu) dmu = 2 ln 2 - 1.
    void flatLambertSurfaceInAWhiteRoom() {
        Scene scene = test::slab(1, {0, 0, -1}, 1);
        scene.volume = test::makeVolume({101, 101, 20}, dvec3(1), [](int, int, int k) { return k < 10 ? 1000 : 0; });
        scene.transferFunction = {20, {{.hu = 500, .opacity = 0}, {.hu = 500, .opacity = 1, .albedo = vec3(1)}}};
        scene.camera.eyeMm = {50.5, 50.5, 500};
        scene.camera.targetMm = {50.5, 50.5, 0};
        scene.gradientFactor = 100;
        scene.lights.clear();
        scene.environment = {vec3(1), true};
        const test::ImageMean got = test::imageMean(test::render(scene, 8192));
        QVERIFY2(std::fabs(got.mean - (2 * std::log(2.0) - 1)) < test::allowedZ(8) * got.standardError,
                 qPrintable(QString("%1 +- %2").arg(got.mean).arg(got.standardError)));
    }

    void shinySurfaceReflectsNoMoreThanItGets() {
        for (const float roughness : {0.05f, 0.3f, 1.0f})
            for (const float cosine : {0.1f, 0.5f, 1.0f}) {
                const Material material{vec3(1), vec3(0), vec3(0.04f), roughness};
                const vec3 n(0, 0, 1), view(std::sqrt(1 - cosine * cosine), 0, cosine);
                test::Sample reflected;
                RandomStream random = Random(3, 0, 0).stream(Dimension::filter);
                for (int i = 0; i < 100000; ++i) {
                    const vec2 u = random.pair();
                    const vec3 towards = surfaceSample(material, n, view, random.pair().x, u);
                    const float density = surfacePdf(material, n, view, towards);
                    reflected.add(density > 0 ? surfaceEval(material, n, view, towards).x / density : 0);
                }
                QVERIFY2(
                    reflected.mean() < 1 + 4 * reflected.standardError(),
                    qPrintable(
                        QString("%1 at roughness %2, cosine %3").arg(reflected.mean()).arg(roughness).arg(cosine)));
            }
    }
};

QTEST_GUILESS_MAIN(ImageTest)
#include "image_test.moc"
