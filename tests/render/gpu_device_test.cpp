#include <QTest>
#include <cstring>

#include "render/device/cpu/host_gpu.h"
#include "render/device/gpu/gpu_device.h"
#include "render/film/tone_map.h"
#include "tests/support/faulty_gpu.h"
#include "tests/support/pictures.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scenes.h"

using namespace pdr;

namespace {

std::unique_ptr<GpuDevice<HostGpu>> hostDevice(std::size_t bytes = 0) {
    return std::make_unique<GpuDevice<HostGpu>>(DeviceInfo{"host", "threads as a GPU"}, bytes);
}

Scene bumpyScene() {
    Scene scene = test::plainScene(test::bumpyVolume({50, 41, 37}, {0.9, 1.1, 1.3}, 3), 0.4f);
    scene.transferFunction.nodes = {{.hu = -200, .opacity = 0},
                                    {.hu = 300, .opacity = 0.2f, .albedo = vec3(0.9f, 0.6f, 0.5f)},
                                    {.hu = 900, .opacity = 1, .specular = vec3(0.04f), .roughness = 0.3f}};
    scene.gradientFactor = 2;
    scene.environment.radiance = vec3(0.2f, 0.25f, 0.3f);
    scene.film = {61, 45};
    scene.revision = 5;
    return scene;
}

bool same(const Film& a, const Film& b) {
    const FilmContent x = a.content(), y = b.content();
    const auto sameBytes = [](const auto& p, const auto& q) {
        return p.size() == q.size() && std::memcmp(p.data(), q.data(), p.size() * sizeof p[0]) == 0;
    };
    return x.samplesPerPixel == y.samplesPerPixel && sameBytes(x.moments, y.moments) && sameBytes(x.block, y.block);
}

/// `samples` by way of a live film, n at a time.
std::shared_ptr<const Film> lived(Device& device, const Scene& scene, std::uint32_t samples, std::uint32_t n) {
    if (!device.upload(Flattener().prepare(scene, Bounds::onDevice)))
        return nullptr;
    const auto film = device.film(scene.film, scene.revision, {});
    for (std::uint32_t done = 0; done < samples; done += n)
        if (!(*film)->iterate(std::min(n, samples - done), {}))
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

    void everyEffectGivesTheCpusSums() {
        const auto gpu = hostDevice();
        const auto cpu = makeCpuDevice();
        const auto agrees = [&](const char* what, auto&& edit) {
            Scene scene = bumpyScene();
            edit(scene);
            QVERIFY2(scene.check(), what);
            QVERIFY2(same(test::render(scene, 20, *cpu), test::render(scene, 20, *gpu)), what);
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

    void aFilmGrownOnTheDeviceIsTheCpusBitByBit() {
        const auto gpu = hostDevice();
        const auto cpu = makeCpuDevice();
        const Film reference = test::render(bumpyScene(), 150, *cpu);
        for (const std::uint32_t n : {1u, 7u, 64u, 100u, 150u})
            QVERIFY(same(reference, *lived(*gpu, bumpyScene(), 150, n)));
    }
};

QTEST_APPLESS_MAIN(GpuDeviceTest)
#include "gpu_device_test.moc"
