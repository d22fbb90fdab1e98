/// What a GPU's memory is allocated for, and when it is released.

#include <QTest>

#include "render/device/emulated/host_gpu.h"
#include "render/device/gpu_device.h"
#include "tests/support/scenes/tissue_scene.h"

using namespace pdr;

namespace {

/// Counts the allocations of device memory and of host memory.
struct CountingGpu : HostGpu {
    using HostGpu::HostGpu;
    int allocations = 0;

    void* allocate(std::size_t bytes) {
        ++allocations;
        return HostGpu::allocate(bytes);
    }
    void* allocatePinned(std::size_t bytes) {
        ++allocations;
        return HostGpu::allocatePinned(bytes);
    }
};

}  // namespace

class GpuMemoryTest : public QObject {
    Q_OBJECT

  private slots:
    /// The next scene's film is made in the memory of the last one.
    void anEditAllocatesNothing() {
        Scene scene = test::tissueScene();
        scene.film = {1920, 1080};
        const dvec3 centre = scene.volume->geometry().centreMm();
        scene.camera.eyeMm = centre + 20.0 * (scene.camera.eyeMm - centre);  // the film counts here, not the paths
        GpuDevice<CountingGpu> device(DeviceInfo{"counting", "", false});
        const auto image = [&](Accumulator& film) {
            return film.accumulate(1, {}) && film.resolve({}) && bool(film.readback());
        };
        QVERIFY(device.upload(scene));
        const auto film = *static_cast<Device&>(device).film(scene.film, scene.revision, {});
        QVERIFY(image(*film));
        const auto allocations = [&](const auto& edit) {
            const int before = device.gpu().allocations;
            edit(scene);
            ++scene.revision;
            const bool shown =
                device.upload(scene) && film->restart(wholeImage(scene.film), scene.revision) && image(*film);
            return shown ? device.gpu().allocations - before : -1;
        };
        QVERIFY(allocations([](Scene&) {}) >= 0);  // both slots of its images have been used by now
        QCOMPARE(allocations([](Scene& s) { s.camera.eyeMm.x += 5; }), 0);
        QCOMPARE(allocations([](Scene& s) { s.transferFunction.nodes[1].albedo = vec3(0.3f); }), 0);
        QCOMPARE(allocations([](Scene& s) { s.transferFunction.nodes[1].opacity = 0.4f; }), 0);
        QCOMPARE(allocations([](Scene& s) { s.film = {240, 135}; }), 0);  // while something moves
        QCOMPARE(allocations([](Scene& s) { s.film = {1920, 1080}; }), 0);
        QVERIFY(sameBits((*film->film())->content(), test::render(scene, 1).content()));
    }

    void aGpuGivesTheMemoryOfAClosedSceneBack() {
        GpuDevice<HostGpu> gpu{DeviceInfo{}, 0, 1};
        const Scene scene = test::tissueScene();
        QVERIFY(gpu.upload(scene));
        const std::size_t loaded = gpu.gpu().allocated();
        QVERIFY(gpu.unload());
        QVERIFY(loaded - gpu.gpu().allocated() >= GpuScene<HostGpu>::bytesFor(scene.volume->size()));
        QVERIFY(gpu.unload());  // nothing to forget
        QVERIFY(gpu.upload(scene));
        QCOMPARE(gpu.gpu().allocated(), loaded);
    }
};

QTEST_APPLESS_MAIN(GpuMemoryTest)
#include "gpu_memory_test.moc"
