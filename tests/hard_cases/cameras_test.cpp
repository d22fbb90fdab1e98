/// Hard cases 24 to 28: cameras and image sizes. Each naive form is written out and must fail.

#include <QTest>

#include <array>

#include "render/kernel/transport/camera_ray.h"
#include "render/kernel/volume_sampling.h"
#include "tests/support/scenes/images.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

std::shared_ptr<const Volume> cube() {
    return test::makeVolume({24, 24, 24}, dvec3(1), [](int, int, int) { return 0; });
}

}  // namespace

class CamerasTest : public QObject {
    Q_OBJECT

  private slots:
    /// Case 24. The slab test alone begins behind the camera.
    void cameraInsideSeesWhatLiesBehindIt_data() {
        QTest::addColumn<double>("eyeX");
        QTest::addColumn<double>("lookX");
        QTest::addColumn<double>("crossed");
        QTest::newRow("middle") << 12.0 << 1.0 << 12.0;
        QTest::newRow("between voxels, to the other side") << 10.5 << -1.0 << 10.5;
        QTest::newRow("on a face, inwards") << 0.0 << 1.0 << 24.0;
        QTest::newRow("on a face, outwards") << 24.0 << 1.0 << 0.0;
        QTest::newRow("before the box, outwards") << -5.0 << -1.0 << 0.0;
    }
    void cameraInsideSeesWhatLiesBehindIt() {
        QFETCH(double, eyeX);
        QFETCH(double, lookX);
        QFETCH(double, crossed);
        Scene scene = test::plainScene(cube(), 0.1f);
        scene.environment = {vec3(1), true};
        scene.transferFunction.nodes[0].albedo = vec3(0);
        scene.film = {8, 8};
        for (const Camera::Type type : {Camera::Type::perspective, Camera::Type::orthographic}) {
            scene.camera = {.type = type,
                            .eyeMm = {eyeX, 12, 12},
                            .targetMm = {eyeX + lookX, 12, 12},
                            .up = {0, 0, 1},
                            .fovDegrees = 1e-3,
                            .heightMm = 1};
            const test::ImageMean got = test::imageMean(test::render(scene, 512));
            const double truth = std::exp(-0.1 * crossed), naive = std::exp(-0.1 * 24);
            QVERIFY(std::fabs(got.mean - truth) <= test::allowedZ(10) * got.standardError);
            QVERIFY(crossed == 24 || std::fabs(got.mean - naive) > 20 * got.standardError);
        }
    }

    /// Case 25. A perspective camera 10 km away: single precision knows places to 1 mm there.
    void farCameraQuantisesPlaces() {
        Scene scene = test::plainScene(cube(), 1);
        const dvec3 centre(12), away = glm::normalize(dvec3(1, 2, 3));
        double worst = 0, naiveWorst = 0;
        for (const double distance : {1e3, 1e7}) {
            scene.camera = {.eyeMm = centre + away * distance,
                            .targetMm = centre,
                            .fovDegrees = glm::degrees(2 * std::atan(15 / distance))};
            const auto prepared = Flattener().prepare(scene);
            const FlatCamera& camera = prepared->flat.camera;
            for (int i = 0; i < 100; ++i) {
                const vec2 place(float(i % 10) * 3 + 1.5f, float(i / 10) * 3 + 1.5f);
                const dvec3 towards = glm::normalize(camera.forward + camera.right * (place.x / 32.0 - 0.5) -
                                                     camera.up * (place.y / 32.0 - 0.5));
                const Ray ray = generateCameraRay(prepared->flat, place, vec2(0), {0, 1e30f}).ray;
                if (!(ray.length > 0))
                    continue;
                const auto offLine = [&](dvec3 p) { return glm::length(glm::cross(p - camera.eye, towards)); };
                worst = std::max(
                    {worst, offLine(dvec3(ray.origin)), offLine(dvec3(ray.origin + ray.direction * ray.length))});
                const float depth = float(glm::dot(dvec3(ray.origin) - camera.eye, towards));
                naiveWorst = std::max(naiveWorst, offLine(dvec3(vec3(camera.eye) + vec3(towards) * depth)));
            }
        }
        QVERIFY2(worst < 1e-5 && naiveWorst > 0.1, qPrintable(QString("%1, %2").arg(worst).arg(naiveWorst)));
    }

    /// Case 26. tan(90 degrees) in single precision is a large negative number: the image is turned round.
    void extremeFieldsOfViewOverflow() {
        QVERIFY(std::tan(float(M_PI) / 2) < 0);
        Scene scene = test::plainScene(cube(), 1);
        scene.camera.up = glm::normalize(dvec3(0.3, 0.2, 1));
        for (const double fov : {1e-12, 1e-4, 179.9, 179.99999}) {
            scene.camera.fovDegrees = fov;
            QVERIFY(bool(scene.check()));
            const auto prepared = Flattener().prepare(scene);
            for (const vec2 place : {vec2(0), vec2(32), vec2(0, 32), vec2(16), vec2(16, 16.001f)}) {
                const PathSegment segment = generateCameraRay(prepared->flat, place, vec2(0), {0, 1e30f});
                QVERIFY(std::fabs(glm::length(segment.direction) - 1) < 1e-6);
                QVERIFY(!std::isnan(segment.ray.length) &&
                        glm::dot(dvec3(segment.direction), scene.camera.forward()) > 0);
            }
            QCOMPARE(test::render(scene, 4).status().health.rejected(), std::uint64_t(0));
        }
        for (const double fov : {0.0, 1e-300, 180.0, -10.0, 360.0, double(NAN), double(INFINITY)}) {
            scene.camera.fovDegrees = fov;
            QVERIFY(!scene.check());
        }
    }

    /// Case 27. A lens of no size is a pinhole, bit by bit; a focus next to nothing divides by it.
    void focusOfNothingDividesByZero() {
        QVERIFY(std::isinf(1 / (1e-30f * 1e-30f)));
        const auto device = test::testedDevice();
        Scene scene = test::plainScene(test::bumpyVolume({24, 24, 24}, dvec3(1), 2), 1);
        scene.transferFunction.nodes = {{.hu = 0, .opacity = 0, .albedo = vec3(1)},
                                        {.hu = 600, .opacity = 1, .albedo = vec3(1)}};
        scene.environment = {vec3(1), true};
        const Film pinhole = test::render(scene, 8, *device);
        scene.camera.apertureMm = 1e-30;
        QVERIFY(test::sameBits(pinhole, test::render(scene, 8, *device)));
        // White tissue in a white room is 1 wherever it is seen from, through whatever lens.
        scene.model = Model::multipleScattering;
        scene.maxBounces = 100000;
        scene.lights.clear();
        for (const double focus : {0.0, 1e-12, 1e9})
            for (const double aperture : {1e-30, 1.0, 200.0})  // the widest reaches into the volume
                for (const dvec3 eye : {scene.camera.eyeMm, dvec3(12, 11.9, 12)}) {
                    Scene lens = scene;
                    lens.camera.apertureMm = aperture;
                    lens.camera.focusMm = focus;
                    lens.camera.eyeMm = eye;
                    QVERIFY(bool(lens.check()));
                    const Film film = test::render(lens, 8, *device);
                    QVERIFY(film.status().health.perfect());
                    const test::ImageMean got = test::imageMean(film);
                    QVERIFY2(std::fabs(got.mean - 1) <= test::allowedZ(18) * got.standardError + 1e-6 &&
                                 got.standardError < 0.03,
                             qPrintable(QString("%1 +- %2").arg(got.mean).arg(got.standardError)));
                }
        // Less would leave no direction at all, and a ray without one never ends.
        for (const auto& [aperture, focus] : {std::pair(1.0, 1e-30), std::pair(1.0, 1e-300), std::pair(1e3, 0.0)}) {
            scene.camera.apertureMm = aperture;
            scene.camera.focusMm = focus;
            QVERIFY(!scene.check());
        }
    }

    /// Case 27. Unit directions stretched to the focal distance make the sharp surface a sphere.
    void offAxisFocusLiesOnASphere() {
        Scene scene = test::plainScene(cube(), 1);
        scene.camera.fovDegrees = 60;
        scene.camera.apertureMm = 20;
        const auto prepared = Flattener().prepare(scene);
        const FlatCamera& camera = prepared->flat.camera;
        double worst = 0, naiveWorst = 0;
        for (const vec2 lens : {vec2(1, 0), vec2(0, 1), vec2(-0.7f, 0.7f), vec2(0.1f, -0.9f)})
            for (const vec2 place : {vec2(14, 12), vec2(12, 17), vec2(20, 17)}) {
                const dvec3 towards = camera.forward + camera.right * (double(place.x) / 32 - 0.5) -
                                      camera.up * (double(place.y) / 32 - 0.5);
                const dvec3 onLens = camera.lensRight * double(lens.x) + camera.lensUp * double(lens.y);
                const dvec3 sharp = towards * camera.focus;
                const auto miss = [&](dvec3 from, dvec3 direction) {  // distance of the ray from the sharp point
                    return glm::length(glm::cross(sharp - from, glm::normalize(direction)));
                };
                naiveWorst = std::max(naiveWorst, miss(onLens, glm::normalize(towards) * camera.focus - onLens));
                const PathSegment segment = generateCameraRay(prepared->flat, place, lens, {0, 1e30f});
                QVERIFY(segment.ray.length > 0);
                const dvec3 entry(localPosition(prepared->flat.volume, segment.ray.origin));
                worst = std::max(worst, miss(entry - camera.localEye, dvec3(segment.direction)));
            }
        QVERIFY2(worst < 1e-4 && naiveWorst > 0.05, qPrintable(QString("%1, %2").arg(worst).arg(naiveWorst)));
    }

    /// Case 28. Images of any size, cut into tiles of any size, none of them written beside.
    void oddImagesAreWrittenBesideTheirEdge() {
        const auto device = test::testedDevice();
        Scene scene = test::plainScene(test::bumpyVolume({24, 24, 24}, dvec3(1), 2), 1);
        scene.environment = {vec3(1), false};
        for (const ivec2 size : {ivec2(1, 1), ivec2(1, 37), ivec2(41, 1), ivec2(17, 33)}) {
            scene.film = size;
            const auto prepared = Flattener().prepare(scene);
            const Film whole = test::render(scene, 5, *device);
            CpuTracer tracer;
            const int stride = size.x + 7;
            std::vector<PixelSums> sums(std::size_t(stride) * (size.y + 2));
            for (const Tile tile : {Tile{size.x / 2, size.y / 3, size.x - size.x / 2, size.y - size.y / 3},
                                    Tile{0, 0, size.x, 0}, Tile{0, 0, 0, size.y}, Tile{size.x - 1, size.y - 1, 1, 1}}) {
                sums.assign(sums.size(), PixelSums{.count = 77});
                TileSums target{&sums[std::size_t(stride) + 3], stride};
                for (int i = 0; i < tile.width * tile.height; ++i)
                    target.pixels[i / tile.width * stride + i % tile.width] = {};
                tracer.trace(prepared->flat, tile, {0, 5}, target);
                for (int y = 0; y < tile.height; ++y)
                    for (int x = 0; x < tile.width; ++x) {
                        const PixelSums& got = target.pixels[y * stride + x];
                        QCOMPARE(got.count, 5u);
                        QVERIFY(got.sum / 5.0 == whole.pixel(tile.x + x, tile.y + y).mean);
                    }
                const auto untouched = std::count_if(
                    sums.begin(), sums.end(), [](const PixelSums& s) { return s.count == 77 && s.sum == dvec3(0); });
                QCOMPARE(untouched, std::ptrdiff_t(sums.size()) - tile.width * tile.height);
            }
            for (const int tile : {1, 7, 16})
                QVERIFY(test::sameBits(whole, test::render(scene, 5, *device, 2, tile)));
        }
    }

    /// Case 28. The largest film: a pixel's number needs 28 bits, of which a float keeps 24.
    void numbersOfNeighbouringPixelsMeetOnTheLargestFilm() {
        QVERIFY(float(16384 * 16384 - 1) == float(16384 * 16384 - 2));
        Scene scene = test::plainScene(test::bumpyVolume({24, 24, 24}, dvec3(1), 2), 0.2f);
        scene.transferFunction.nodes = {{.hu = -1000, .opacity = 0.5f, .albedo = vec3(0.1f)},
                                        {.hu = 2000, .opacity = 1, .albedo = vec3(1)}};
        scene.environment = {vec3(1), false};
        scene.film = {16384, 16384};
        scene.camera.fovDegrees = 1;  // all of it is volume
        const auto device = test::testedDevice();
        (void)device->upload(scene);
        std::vector<double> means;
        for (const ivec2 corner : {ivec2(0, 0), ivec2(16380, 0), ivec2(0, 16380), ivec2(16380, 16380)}) {
            const auto film = test::renderedPart(scene, {corner.x, corner.y, 4, 4}, 64, *device, 64);
            for (int i = 0; i < 16; ++i) {
                const PixelEstimate pixel = film->pixel(i % 4, i / 4);
                QCOMPARE(pixel.count, std::uint64_t(64));
                means.push_back(pixel.mean.x);
            }
        }
        std::sort(means.begin(), means.end());
        QVERIFY(std::adjacent_find(means.begin(), means.end()) == means.end());
    }
};

QTEST_GUILESS_MAIN(CamerasTest)
#include "cameras_test.moc"
