/// Images of the models without scattering, on every path through the CPU device.

#include <QTest>

#include "render/film/display/tone_map.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

constexpr Model kProjections[] = {Model::absorption, Model::emission, Model::emissionAbsorption,
                                  Model::maximumIntensity};

Scene variedScene(Model model) {
    Scene scene = test::plainScene(test::bumpyVolume({61, 45, 38}, {0.7, 1.1, 2.3}, 1), 0.3f);
    scene.model = model;
    scene.transferFunction.nodes = {{.hu = -200, .opacity = 0, .albedo = vec3(0.9f, 0.5f, 0.4f)},
                                    {.hu = 300, .opacity = 0.2f, .albedo = vec3(0.9f, 0.6f, 0.4f)},
                                    {.hu = 300, .opacity = 0, .albedo = vec3(0.9f)},
                                    {.hu = 900, .opacity = 1, .albedo = vec3(0.9f)}};
    return scene;
}

/// One constant tissue, seen straight on by every pixel.
Scene slab(int hu, Model model) {
    Scene scene = test::plainScene(test::makeVolume({21, 21, 10}, dvec3(1), [hu](int, int, int) { return hu; }), 0.05f);
    scene.model = model;
    scene.camera = {.type = Camera::Type::orthographic,
                    .eyeMm = {10.5, 10.5, 500},
                    .targetMm = {10.5, 10.5, 0},
                    .up = {0, 1, 0},
                    .heightMm = 10};
    scene.film = {8, 8};
    return scene;
}

bool sameBits(const Film& a, const Film& b) {
    for (int y = 0; y < a.size().y; ++y)
        for (int x = 0; x < a.size().x; ++x)
            if (a.pixel(x, y).mean != b.pixel(x, y).mean || a.pixel(x, y).standardError != b.pixel(x, y).standardError)
                return false;
    return true;
}

}  // namespace

class ProjectionTest : public QObject {
    Q_OBJECT

  private slots:
    void imageDoesNotDependOnThreadsTilesOrIterationsPerFrame() {
        for (const Model model : kProjections) {
            const Scene scene = variedScene(model);
            const Film reference = test::render(scene, 20, *makeCpuDevice(1), 1);
            QVERIFY(reference.status().meanLuminance > 0.01 && reference.status().health.perfect());
            for (const int threads : {1, 3})
                for (const std::uint32_t n : {1u, 20u})
                    for (const int tile : {7, 4096})
                        QVERIFY(sameBits(reference, test::render(scene, 20, *makeCpuDevice(threads), n, tile)));
        }
    }

    /// No number is drawn but the place in the pixel.
    void flatSlabHasNoNoise() {
        for (const Model model : kProjections) {
            const Film film = test::render(slab(40, model), 64);
            QVERIFY(film.pixel(3, 5).standardError == dvec3(0));
            QVERIFY(film.pixel(3, 5).mean == film.pixel(4, 1).mean);
        }
    }

    void lightsSurfacesAndPhaseDoNotShow() {
        for (const Model model : kProjections) {
            Scene scene = variedScene(model);
            const Film plain = test::render(scene, 2);
            scene.gradientFactor = 2;
            scene.phaseG = 0.5f;
            scene.lights.clear();
            QVERIFY(sameBits(plain, test::render(scene, 2)));
        }
    }

    /// Cells that are passed at once are passed, and nothing else changes.
    void macrocellsDoNotChangeTheImage() {
        for (const Model model : kProjections) {
            const Scene scene = variedScene(model);
            const auto device = makeCpuDevice();
            const Film cells = test::render(scene, 4, *device);
            const Film global = test::sampled(test::withGlobalMajorant(scene), 4);
            for (int y = 0; y < 32; ++y)
                for (int x = 0; x < 32; ++x) {
                    const double a = cells.pixel(x, y).mean.x, b = global.pixel(x, y).mean.x;
                    QVERIFY2(std::fabs(a - b) <= 1e-5 * b, qPrintable(QString("%1, not %2").arg(a).arg(b)));
                }
        }
    }

    void whatLiesBehind() {
        Scene scene = slab(40, Model::absorption);
        const double left = std::exp(-0.5);
        const auto red = [](const Scene& s) { return test::render(s, 1).pixel(2, 2).mean.x; };
        const auto close = [](double value, double truth) { return std::fabs(value - truth) < 1e-6; };
        QVERIFY(close(red(scene), left));  // white where the environment is black
        scene.environment = {vec3(3), true};
        QVERIFY(close(red(scene), 3 * left));
        scene.environment.visible = false;
        QVERIFY(close(red(scene), left));  // and white where the camera does not see it
        scene.model = Model::emissionAbsorption;
        QVERIFY(close(red(scene), 1 - left));
        scene.environment.visible = true;
        QVERIFY(close(red(scene), 1 - left + 3 * left));
        scene.model = Model::emission;
        QVERIFY(close(red(scene), 0.5 + 3));
        scene.transferFunction.nodes[0].opacity = 0;  // nothing there: the pixels that meet nothing
        QVERIFY(close(red(scene), 3));
        scene.model = Model::absorption;
        QVERIFY(close(red(scene), 3));
    }

    void windowIsLinearInDisplayLevels() {
        for (const int hu : {-1000, -200, -199, 0, 77, 400, 800, 999, 1000, 3000}) {
            Scene scene = slab(hu, Model::maximumIntensity);
            scene.window = {-200, 1000};
            const std::uint8_t level = toneMap(test::render(scene, 1), {})[0];
            const double place = std::clamp((hu + 200) / 1200.0, 0.0, 254.5 / 255);
            QVERIFY2(std::abs(level - 255 * place) <= 0.502, qPrintable(QString("%1 at %2 HU").arg(level).arg(hu)));
        }
    }

    void raysThatMissAreBlackInMaximumIntensity() {
        Scene scene = slab(3000, Model::maximumIntensity);
        scene.camera.heightMm = 80;
        scene.environment = {vec3(1), true};
        const Film film = test::render(scene, 1);
        QVERIFY(film.pixel(0, 0).mean == dvec3(0));
        QVERIFY(film.pixel(4, 4).mean.x > 4);
    }

    /// One voxel along x: rays go one by one.
    void smallestVolumesRender() {
        for (const Model model : kProjections)
            for (const ivec3 size : {ivec3(1, 1, 1), ivec3(2, 1, 1), ivec3(1, 9, 1), ivec3(1, 1, 5), ivec3(5, 1, 3)}) {
                Scene scene = slab(70, model);
                scene.volume = test::makeVolume(size, dvec3(20, 20, 2), [](int, int, int) { return 70; });
                const Film film = test::render(scene, 4);
                QVERIFY(film.status().health.perfect());
                QVERIFY(film.pixel(4, 4).mean.x > 0);
            }
    }

    /// A model's tables are not those of the scene before.
    void modelsFollowOneAnother() {
        const auto device = makeCpuDevice();
        Scene scene = variedScene(Model::absorption);  // one volume: what was made for it may be used again
        for (const Model model : {Model::absorption, Model::maximumIntensity, Model::singleScattering,
                                  Model::maximumIntensity, Model::emissionAbsorption}) {
            scene.model = model;
            QVERIFY(sameBits(test::render(scene, 2, *device), test::render(scene, 2)));
        }
    }
};

QTEST_GUILESS_MAIN(ProjectionTest)
#include "projection_test.moc"
