/// Extremes of volume, density, camera and model, every one with every other: each image must come to an end, finite
/// and without a fault.

#include <QTest>

#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

std::vector<std::shared_ptr<const Volume>> volumes() {
    const auto constant = [](int, int, int) { return 7; };
    const auto checkerboard = [](int i, int j, int k) { return (i + j + k) % 2 ? 4095 : 0; };
    const auto whole = [](int i, int j, int k) { return (i * 31 + j * 17 + k * 7) % 5 < 2 ? -32768 : 32767; };
    return {test::makeVolume({1, 1, 1}, dvec3(9), constant), test::makeVolume({1, 9, 1}, {9, 1, 9}, constant),
            test::makeVolume({2, 1, 17}, {4, 9, 0.5}, checkerboard),
            test::makeVolume({9, 8, 7}, dvec3(1), checkerboard), test::makeVolume({6, 9, 18}, {1.5, 1, 0.5}, whole)};
}

/// A camera of each extreme kind about the middle of `geometry`.
std::vector<Camera> cameras(const VolumeGeometry& geometry) {
    const dvec3 centre = geometry.centreMm();
    const auto looking = [&](dvec3 from, double fov) {
        return Camera{.eyeMm = centre + from, .targetMm = centre + dvec3(0.01, 0, 0), .fovDegrees = fov};
    };
    Camera parallel = looking({0, -1e7, 0}, 35);
    parallel.type = Camera::Type::orthographic;
    parallel.heightMm = 20;
    Camera lens = looking({0, -12, 3}, 60);
    lens.apertureMm = 30;
    return {looking({0, -1e7, 0}, 1e-4),
            looking({0, -20, 0}, 179.9),
            looking({0, -1e-3, 0}, 90),
            looking({4.5, 0, 0}, 90),
            looking({-20, 1e-9, 0}, 40),
            parallel,
            lens};
}

}  // namespace

class ExtremesTest : public QObject {
    Q_OBJECT

  private slots:
    void everyExtremeWithEveryOther_data() {
        QTest::addColumn<int>("model");
        for (int model = 0; model <= int(Model::maximumIntensity); ++model)
            QTest::newRow(modelName(Model(model))) << model;
    }
    void everyExtremeWithEveryOther() {
        QFETCH(int, model);
        const auto device = test::testedDevice();
        for (const auto& volume : volumes()) {
            std::vector<double> clear;  // what each camera sees where there is no tissue
            for (const float extinction : {0.0f, 1e-12f, 0.3f, 1e6f}) {
                Scene scene = test::plainScene(volume, extinction);
                scene.model = Model(model);
                scene.transferFunction.nodes = {{.hu = -32768, .opacity = 1e-3f, .albedo = vec3(0.9f)},
                                                {.hu = 300, .opacity = 0.5f, .albedo = vec3(1), .emission = vec3(0.2f)},
                                                {.hu = 300, .opacity = 1e-3f, .specular = vec3(0.04f), .roughness = 0},
                                                {.hu = 32767, .opacity = 1, .albedo = vec3(1)}};
                const dvec3 centre = volume->geometry().centreMm();
                scene.lights = {SphereLight{centre + dvec3(0, 0, 1), 0.5, vec3(1e6f), true},
                                RectangleLight{centre, {0, 1, 0}, {0, 0, 1}, 1e9, 1e-9, vec3(1e6f), true}};
                scene.environment = {vec3(0.5f), true, vec3(0)};
                scene.phaseG = 0.999f;
                scene.gradientFactor = 3;
                scene.film = {7, 5};
                scene.clip.planes = {{centre + dvec3(0, 0, 2), {0, 1e-9, 1}}};
                const std::vector<Camera> all = cameras(volume->geometry());
                for (std::size_t i = 0; i < all.size(); ++i) {
                    scene.camera = all[i];
                    const Result<void> accepted = scene.check();
                    QVERIFY2(bool(accepted), accepted ? "" : accepted.error().text().c_str());
                    const FilmStatus status = test::render(scene, 3, *device).status();
                    for (int fault = 0; fault < kFaults; ++fault)  // white tissue has paths beyond 1000 events
                        QVERIFY(Fault(fault) == Fault::cutPath || status.health.of(Fault(fault)).count == 0);
                    QVERIFY(std::isfinite(status.meanLuminance) && status.meanLuminance >= 0);
                    if (extinction == 0)
                        clear.push_back(status.meanLuminance);
                    if (extinction == 1e-12f)  // at most 1e-6 free paths of 0.2 times the brightest light
                        QVERIFY(std::fabs(status.meanLuminance - clear[i]) <= 1e-6 * clear[i] + 1e-9);
                }
            }
        }
    }
};

QTEST_GUILESS_MAIN(ExtremesTest)
#include "extremes_test.moc"
