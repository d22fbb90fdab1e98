#include <QTest>
#include <cmath>
#include <cstring>
#include <random>

#include "render/device/emulated/emulated_gpu.h"
#include "render/device/emulated/host_gpu.h"
#include "render/device/gpu_device.h"
#include "render/film/display/tone_map.h"
#include "render/kernel/volume_sampling.h"
#include "tests/support/devices/faulty_gpu.h"
#include "tests/support/devices/texture_reading.h"
#include "tests/support/scenes/images.h"
#include "tests/support/scenes/random_scenes.h"
#include "tests/support/scenes/tissue_scene.h"

using namespace pdr;

namespace {

/// A volume as the kernel sees it, filtered exactly and by an emulated texture.
struct BothWays {
    std::shared_ptr<const Volume> volume;
    FlatVolume exact, fast;

    explicit BothWays(std::shared_ptr<const Volume> of) : volume(std::move(of)) {
        exact = fast = Flattener().flatten(test::plainScene(volume, 1))->flat.volume;
        fast.texture = 1;
    }
};

/// Voxels that differ by up to `range` HU, without order.
std::shared_ptr<const Volume> noise(ivec3 size, int lowest, int range, unsigned seed) {
    std::mt19937 random(seed);
    return test::makeVolume(size, dvec3(1),
                            [&](int, int, int) { return lowest + int(random() % unsigned(range + 1)); });
}

/// Returns a position in the volume's box or a little outside.
vec3 anyPlace(std::mt19937& random, ivec3 size) {
    std::uniform_real_distribution<float> unit(-0.1f, 1.1f);
    const float x = unit(random), y = unit(random), z = unit(random);
    return vec3(x, y, z) * vec3(size) - 0.5f;
}

VoxelCell<float> cellAround(const FlatVolume& volume, vec3 place) {
    return nearestCell(volume, Vec3<int>{int(std::floor(place.x)), int(std::floor(place.y)), int(std::floor(place.z))},
                       true);
}

Scene tissue(Filtering filtering) {
    Scene scene = test::tissueScene();
    scene.filtering = filtering;
    return scene;
}

Film onEmulatedGpu(const Scene& scene, std::uint64_t samples) {
    return test::render(scene, samples, *makeEmulatedGpu());
}

}  // namespace

class FilteringTest : public QObject {
    Q_OBJECT

  private slots:
    void everyVoxelValueIsExactInATexture() {
        for (int hu = -32767; hu <= 32767; ++hu) {
            const float value = float(hu) / kTextureFullHu;
            for (const float read : {value, std::nextafter(value, -2.0f), std::nextafter(value, 2.0f)})
                QVERIFY(hounsfieldOfTexture(read) == float(hu));  // a unit may round otherwise than the CPU
        }
        QVERIFY(textureHolds({-32767, 32767}) && !textureHolds({-32768, 0}));
    }

    void voxelCentresAreExact() {
        for (const ivec3 size : {ivec3(7, 6, 5), ivec3(1, 9, 2), ivec3(300, 1, 1)}) {
            const BothWays both(noise(size, -32767, 65534, 1));
            for (int k = 0; k < size.z; ++k)
                for (int j = 0; j < size.y; ++j)
                    for (int i = 0; i < size.x; ++i)
                        QVERIFY(hounsfield(both.fast, vec3(i, j, k)) == hounsfield(both.exact, vec3(i, j, k)));
        }
    }

    void whereAllVoxelsAgreeTheirValueIsFound() {
        std::mt19937 random(2);
        for (const int hu : {-32767, -1024, -1, 0, 333, 3071, 32767}) {
            const BothWays both(noise({9, 8, 7}, hu, 0, 1));
            for (int n = 0; n < 2000; ++n)
                QVERIFY(hounsfield(both.fast, anyPlace(random, {9, 8, 7})) == float(hu));
        }
    }

    /// Checks the assumptions of bounds on the extinction; see texture.h.
    void valuesLieBetweenTheEightVoxelsAround() {
        std::mt19937 random(3);
        for (const int range : {1, 50, 4096, 65534}) {
            const BothWays both(noise({20, 21, 22}, -32767, range, 4));
            for (int n = 0; n < 50'000; ++n) {
                const vec3 place = anyPlace(random, both.volume->size());
                const auto [low, high] = std::ranges::minmax(cellAround(both.fast, place).hu);
                const float hu = hounsfield(both.fast, place);
                QVERIFY(hu >= low && hu <= high);
            }
        }
    }

    void errorStaysWithinItsBoundAndComesNearIt() {
        std::mt19937 random(5);
        for (const int range : {0, 10, 400, 4096}) {
            const BothWays both(noise({20, 21, 22}, -1000, range, 6));
            for (int n = 0; n < 50'000; ++n) {
                const vec3 place = anyPlace(random, both.volume->size());
                const auto [low, high] = std::ranges::minmax(cellAround(both.fast, place).hu);
                const float error = std::fabs(hounsfield(both.fast, place) - hounsfield(both.exact, place));
                QVERIFY(error <= textureError(high - low));
            }
        }
        const BothWays corner(
            test::makeVolume({2, 2, 2}, dvec3(1), [](int i, int j, int k) { return i + j + k ? 3071 : -1024; }));
        float worst = 0;
        for (float x = 0; x < 1.0f / 128; x += 1.0f / 8192)
            worst = std::max(worst, std::fabs(hounsfield(corner.fast, vec3(x)) - hounsfield(corner.exact, vec3(x))));
        QVERIFY(worst > 0.95f * textureError(4095) && worst <= textureError(4095));
    }

    void betweenTwoVoxelsValuesNeverTurnBack() {
        const BothWays both(noise({40, 2, 2}, -1024, 4095, 7));
        for (int i = 0; i + 1 < 40; ++i) {
            const float first = hounsfield(both.fast, vec3(i, 0, 0)), last = hounsfield(both.fast, vec3(i + 1, 0, 0));
            float before = first;
            int steps = 0;
            for (int n = 0; n <= 4096; ++n) {
                const float hu = hounsfield(both.fast, vec3(float(i) + float(n) / 4096, 0, 0));
                QVERIFY(last >= first ? hu >= before : hu <= before);
                steps += hu != before;
                before = hu;
            }
            QVERIFY(before == last);
            QVERIFY(steps <= 256);
        }
    }

    void programsReadTheVolumeAsTheSceneAsks() {
        std::mt19937 random(8);
        std::vector<vec3> places;
        const BothWays both(noise({20, 21, 22}, -1024, 4095, 9));
        for (int n = 0; n < 10'000; ++n)
            places.push_back(anyPlace(random, both.volume->size()));
        Scene scene = test::plainScene(both.volume, 1);
        for (const Filtering filtering : kFilterings) {
            scene.filtering = filtering;
            HostGpu gpu;
            const auto hu = test::readOn(gpu, Flattener().flatten(scene), places);
            QVERIFY(hu);
            for (std::size_t i = 0; i < places.size(); ++i)
                QVERIFY((*hu)[i] == hounsfield(filtering == Filtering::fast ? both.fast : both.exact, places[i]));
            QCOMPARE(gpu.allocated(), std::size_t(0));
        }
    }

    void exactImagesAreTheCpusBitByBit() {
        const Scene scene = tissue(Filtering::exact);
        QVERIFY(test::sameBits(onEmulatedGpu(scene, 20), test::render(scene, 20)));
    }

    void theCpuIsExactWhateverIsAsked() {
        QVERIFY(test::sameBits(test::render(tissue(Filtering::fast), 20), test::render(tissue(Filtering::exact), 20)));
    }

    /// Both images have the same samples: nearly all paths continue as they did.
    void fastImagesDifferByLessThanTheirNoise() {
        const Film exact = onEmulatedGpu(tissue(Filtering::exact), 64),
                   fast = onEmulatedGpu(tissue(Filtering::fast), 64);
        QVERIFY(!test::sameBits(exact, fast));
        double squares = 0, noise = 0;
        for (int y = 0; y < exact.size().y; ++y)
            for (int x = 0; x < exact.size().x; ++x) {
                const dvec3 difference = fast.pixel(x, y).mean - exact.pixel(x, y).mean;
                const dvec3 error = exact.pixel(x, y).standardError;
                squares += glm::dot(difference, difference);
                noise += glm::dot(error, error);
            }
        const double shift = fast.status().meanLuminance / exact.status().meanLuminance - 1;
        qInfo("rms difference %.3f of the standard error, mean %+.2g", std::sqrt(squares / noise), shift);
        QVERIFY(std::sqrt(squares / noise) < 0.1);
        QVERIFY(std::fabs(shift) < 1e-4);
    }

    void boundsHoldForTextures() {
        std::uint64_t paths = 0;
        for (unsigned seed = 1; seed <= 30; ++seed) {
            Scene scene = test::anyScene(seed);
            scene.filtering = Filtering::fast;
            const FilmStatus status = onEmulatedGpu(scene, 16).status();
            QCOMPARE(status.health.faults[int(Fault::overMajorant)].count, 0u);
            QCOMPARE(status.health.rejected(), 0u);
            paths += 16 * 24 * 24;
        }
        QVERIFY(paths > 200'000);
    }

    void textureIsMadeWhenAskedForKeptAndReleased() {
        GpuDevice<HostGpu> gpu(DeviceInfo{"host", "", false});
        const auto bytes = [&](const Scene& scene) { return gpu.upload(scene) ? gpu.gpu().allocated() : 0; };
        Scene scene = tissue(Filtering::exact);
        const std::size_t texture = 50 * 41 * 37 * 2, exact = bytes(scene);
        scene.filtering = Filtering::fast;
        QCOMPARE(bytes(scene), exact + texture);
        scene.camera.eyeMm.x += 1;
        QCOMPARE(bytes(scene), exact + texture);
        scene.model = Model::emissionAbsorption;
        QCOMPARE(bytes(scene), exact);
        scene.model = Model::multipleScattering;
        QCOMPARE(bytes(scene), exact + texture);
        const auto volume = std::exchange(scene.volume, test::bumpyVolume({20, 20, 20}, dvec3(1), 1));
        const std::size_t smaller = bytes(scene);
        scene.filtering = Filtering::exact;
        QCOMPARE(bytes(scene) + 20 * 20 * 20 * 2, smaller);
        scene.volume = volume;
        QCOMPARE(bytes(scene), exact);
    }

    void anotherVolumeGetsATextureOfItsOwn() {
        struct CountingGpu : HostGpu {
            std::vector<const std::int16_t*> made;
            std::uint64_t makeTexture(const std::int16_t* voxels, ivec3 size) {
                made.push_back(voxels);
                return HostGpu::makeTexture(voxels, size);
            }
        };
        GpuDevice<CountingGpu> gpu(DeviceInfo{"counting", "", false});
        const auto upload = [&](const Scene& scene) { return bool(gpu.upload(scene)); };
        Scene scene = tissue(Filtering::fast);
        const auto first = scene.volume, second = test::bumpyVolume({50, 41, 37}, {0.9, 1.1, 1.3}, 4);
        QVERIFY(upload(scene) && upload(scene));
        scene.volume = second;
        QVERIFY(upload(scene) && upload(scene));
        QVERIFY((gpu.gpu().made == std::vector{first->voxels().data(), second->voxels().data()}));
    }

    void aVolumeThatATextureCannotHoldStaysExact() {
        const auto padded =
            test::makeVolume({20, 20, 20}, dvec3(1), [](int i, int, int k) { return k == 0 ? -32768 : 40 * i; });
        Scene scene = test::plainScene(padded, 0.3f);
        scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 700, .opacity = 1}};
        const Film exact = onEmulatedGpu(scene, 8);
        scene.filtering = Filtering::fast;
        QVERIFY(test::sameBits(exact, onEmulatedGpu(scene, 8)));
    }

    void memoryThatSufficesForExactFilteringOnlyIsTold() {
        Scene scene = tissue(Filtering::exact);
        GpuDevice<HostGpu> large(DeviceInfo{"large", "", false});
        QVERIFY(large.upload(scene));
        GpuDevice<HostGpu> gpu(DeviceInfo{"small", "", false}, large.gpu().allocated() + 1000);
        QVERIFY(gpu.upload(scene));
        scene.filtering = Filtering::fast;
        const ivec3 size = scene.volume->size();
        const std::size_t texture = GpuTexture<HostGpu>::bytesFor(size),
                          all = GpuScene<HostGpu>::bytesFor(size) + texture;
        for (const std::size_t needed : {texture, all}) {  // with the volume there, and anew
            const Result<void> refused = gpu.upload(scene);
            QVERIFY(!refused);
            QVERIFY(refused.error().what.starts_with("the volume does not fit into its memory: " + bytesText(needed)));
            QVERIFY(refused.error().text().find("exact filtering") != std::string::npos);
        }
        scene.filtering = Filtering::exact;
        QVERIFY(gpu.upload(scene));
    }

    void aTextureThatFailsIsToldAndMadeTheNextTime() {
        const auto plan = std::make_shared<test::FaultPlan>();
        plan->call = test::FaultPlan::Call::texture;
        plan->fails = 0;
        GpuDevice<test::FaultyGpu> gpu(DeviceInfo{"faulty", "", false}, plan);
        const Scene scene = tissue(Filtering::fast);
        const Result<void> failed = gpu.upload(scene);
        QVERIFY(!failed && failed.error().what == "it failed on purpose");
        QVERIFY(gpu.upload(scene));
        QCOMPARE(plan->calls, 2);
    }
};

QTEST_APPLESS_MAIN(FilteringTest)
#include "filtering_test.moc"
