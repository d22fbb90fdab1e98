/// Hard cases 29 to 35 and 42 to 43: volumes and densities at their extremes. Each naive form is written out and must
/// fail.

#include <sys/mman.h>

#include <QTemporaryDir>
#include <QTest>

#include <cstdio>

#include "render/device/cpu/lane_tracker.h"
#include "render/kernel/transport/event.h"
#include "render/volume/raw_file.h"
#include "tests/support/scenes/images.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

RandomStream stream(int path) {
    return Random(29, unsigned(path), 1).stream(0, BounceDimension::distance);
}

/// Mean transmittance of `rays` rays from `origin` (index space) along `direction` (local, unit), by ratio tracking.
test::Sample transmittance(const FlatScene& scene, vec3 origin, vec3 direction, int rays = 40'000) {
    test::Sample sample;
    for (int i = 0; i < rays; ++i)
        sample.add(track<RatioTracking>(scene, {origin, scene.volume.indexFromLocal * direction, 1e30f}, stream(i)));
    return sample;
}

std::shared_ptr<const PreparedScene> constantMedium(ivec3 size, dvec3 spacing, float extinctionPerMm, int hu = 7) {
    return Flattener().prepare(
        test::plainScene(test::makeVolume(size, spacing, [=](int, int, int) { return hu; }), extinctionPerMm));
}

}  // namespace

class MediumTest : public QObject {
    Q_OBJECT

  private slots:
    /// Case 29. Coordinates that run from 0 to 1 are divided by size - 1.
    void volumeOfOneVoxelDividesByZero() {
        const auto naive = [](float index, int size) { return index / float(size - 1); };
        QVERIFY(std::isnan(naive(0, 1)));
        for (const ivec3 size : {ivec3(1, 1, 1), ivec3(2, 1, 1), ivec3(1, 9, 1), ivec3(1, 1, 5), ivec3(4, 1, 7)}) {
            const auto prepared = constantMedium(size, dvec3(2), 0.2f);
            const vec3 middle = 0.5f * vec3(size - 1);
            for (int axis = 0; axis < 3; ++axis) {
                vec3 origin = middle, direction(0);
                origin[axis] = -0.5f;
                direction[axis] = 1;
                const test::Sample got = transmittance(prepared->flat, origin, direction);
                QVERIFY(std::fabs(got.z(std::exp(-0.4 * size[axis]))) < test::allowedZ(15));
            }
            QVERIFY(hounsfieldGradient(prepared->flat.volume, middle) == vec3(0));
            QVERIFY(surfaceNormal(prepared->flat, prepared->flat.transferFunction, middle, {0, 0, -1}, 7, 0) ==
                    vec3(0));  // the phase function holds
        }
    }

    /// Case 30. Steps and gradients that count voxels instead of millimetres.
    void anisotropicVoxelsAreCountedInsteadOfMeasured() {
        const dvec3 spacing(0.1, 0.1, 10);
        const auto prepared = constantMedium({100, 100, 4}, spacing, 0.05f);
        const vec3 middle(49.5f, 49.5f, 1.5f);
        for (const vec3 direction : {vec3(1, 0, 0), vec3(0, -1, 0), vec3(0, 0, 1), glm::normalize(vec3(1, 1, 4))}) {
            const dvec3 toFace = dvec3(5, 5, 20) / glm::abs(dvec3(direction));
            const double chord = std::min(toFace.x, std::min(toFace.y, toFace.z));
            const test::Sample got = transmittance(prepared->flat, middle, direction);
            QVERIFY(std::fabs(got.z(std::exp(-0.05 * chord))) < test::allowedZ(4));
            const double voxels = chord * glm::length(dvec3(direction) / spacing);
            QVERIFY(std::fabs(got.z(std::exp(-0.05 * voxels))) > 10);  // steps in voxels
        }
        // HU that rise by (200, -100, 1) per mm.
        const Volume ramp =
            *test::makeVolume({20, 20, 8}, spacing, [](int i, int j, int k) { return 20 * i - 10 * j + 10 * k; });
        const auto flat = Flattener().prepare(test::plainScene(std::make_shared<Volume>(ramp), 1));
        for (const vec3 place : {vec3(5, 5, 3), vec3(5.3f, 9.8f, 4.4f), vec3(11, 3.5f, 2)}) {
            const vec3 gradient = hounsfieldGradient(flat->flat.volume, place);
            QVERIFY(glm::length(gradient - vec3(200, -100, 1)) < 1e-3f);
            const vec3 perIndex = glm::transpose(flat->flat.volume.localFromIndex) * gradient;
            QVERIFY(glm::dot(glm::normalize(perIndex), glm::normalize(gradient)) < 0.999f);  // the naive normal
        }
    }

    /// Case 31. A bound of 0 is divided by.
    void emptyVolumeDividesByItsBound() {
        QVERIFY(std::isinf(0.3f / 0.0f) && std::isnan(0.0f / 0.0f));
        Scene scene = test::plainScene(test::makeVolume({40, 40, 40}, dvec3(1), [](int, int, int) { return 0; }), 1e6f);
        scene.environment = {vec3(1), true};
        for (const std::vector<TransferNode>& nodes :
             {std::vector<TransferNode>{{.hu = 0, .opacity = 0}}, {{.hu = 1, .opacity = 0}, {.hu = 1, .opacity = 1}}}) {
            scene.transferFunction.nodes = nodes;
            const auto prepared = Flattener().prepare(scene);
            MajorantTraversal<float, true> flight;
            flight.start(prepared->flat.majorants, {-0.5f, 20, 20}, {1, 0, 0}, 40, stream(1));
            int steps = 0;
            for (; flight.isActive(); ++steps)
                QVERIFY(!flight.step(prepared->flat).happened);
            QVERIFY(steps <= 40 / 4 + 3);
            QCOMPARE(track<RatioTracking>(prepared->flat, {{-0.5f, 20, 20}, {1, 0, 0}, 40}, stream(1)), 1.0f);
            const Film film = test::sampled(prepared, 4);
            QVERIFY(film.status().meanLuminance == 1 && film.status().relativeError == 0);
        }
    }

    /// Case 32. 1e6 per mm: exp underflows, and steps are too short for a float distance to grow.
    void densestMediumUnderflowsAndStalls() {
        QVERIFY(std::isnan(std::exp(-1e6f * 1.0f) / std::exp(-1e6f * 1.0f)));
        QCOMPARE(300.0f + 1e-6f, 300.0f);
        const auto prepared = constantMedium({40, 40, 40}, dvec3(1), 1e6f);
        for (int i = 0; i < 1000; ++i) {
            const float t = track<DeltaTracking>(prepared->flat, {{-0.5f, 20, 20}, {1, 0, 0}, 40}, stream(i));
            QVERIFY(t >= 0 && t < 1e-4f);
        }
        // Optical depth 1e3: nothing gets through, and nothing is 0 / 0.
        const auto thick = constantMedium({40, 40, 40}, dvec3(1), 25);
        QCOMPARE(transmittance(thick->flat, {-0.5f, 20, 20}, {1, 0, 0}, 1000).mean(), 0.0);
        QVERIFY(test::render(test::slab(1e3, {0, 0, -1}, 1), 64).status().health.perfect());
    }

    /// Case 32, thin tissue in one cell with the densest, 300 mm from where the ray began: tentative collisions come
    /// every 1e-6 mm there, and a float distance grows by 3e-5 mm or not at all.
    void thinTissueBesideTheDensestStallsTheRay() {
        const auto hu = [](int i, int j, int) { return i < 297 ? 0 : j < 7 ? 1 : 2; };
        Scene scene = test::plainScene(test::makeVolume({304, 8, 1}, dvec3(1), hu), 1e6f);
        scene.transferFunction.nodes = {{.hu = 0.01f, .opacity = 0},
                                        {.hu = 0.01f, .opacity = 2e-5f},
                                        {.hu = 1.5f, .opacity = 2e-5f},
                                        {.hu = 1.5f, .opacity = 1}};
        const auto prepared = Flattener().prepare(scene);
        // 20 per mm from x = 296.01 on; the ray is followed for 0.05 mm of it.
        test::Sample through;
        float stalled = 296.5f;
        for (int i = 0; i < 400; ++i) {
            stalled += 1e-6f;
            through.add(track<DeltaTracking>(prepared->flat, {{-0.5f, 5, 0}, {1, 0, 0}, 296.56f}, stream(i)) < 0);
        }
        QCOMPARE(stalled, 296.5f);
        const double truth = std::exp(-20 * 0.05);
        QVERIFY2(std::fabs(through.z(truth)) < test::allowedZ(1), qPrintable(QString::number(through.mean() / truth)));
    }

    /// Case 33. 1 - exp(-1e-11) is 0 in single precision. Nothing is left out: what is met is what optical depths below
    /// 6e-8 have, nearly nothing.
    void thinnestMediumVanishes() {
        QCOMPARE(1 - std::exp(-1e-11f), 0.0f);
        const auto prepared = constantMedium({40, 40, 40}, dvec3(1), 1e-12f);
        for (int i = 0; i < 1000; ++i)
            QVERIFY(track<DeltaTracking>(prepared->flat, {{-0.5f, 20, 20}, {1, 0, 0}, 40}, stream(i)) < 0);
        Scene scene = test::slab(1e-4, {0, 0, -1}, 0.8f);
        const Film film = test::render(scene, 1 << 18);
        const double truth = 0.8 / (4 * M_PI) * 2 * 0.5 * -std::expm1(-2e-4);
        QVERIFY2(std::fabs(test::z(film, truth)) < test::allowedZ(2),
                 qPrintable(QString::number(test::z(film, truth))));
        QVERIFY(film.status().health.perfect());
    }

    /// Case 34. The whole range of int16, and floats that are no numbers.
    void extremeVoxelsOverflowInt16() {
        QVERIFY(std::int16_t(32767 - -32768) < 0 && std::int16_t(std::abs(-32768)) < 0);
        const auto volume = test::makeVolume({19, 18, 17}, dvec3(1), [](int i, int j, int k) {
            return (i + j + k) % 2 ? 32767 : (i * j * k) % 3 ? -32768 : -3024;
        });
        QVERIFY(volume->lowestHu() == -32768 && volume->highestHu() == 32767);
        Scene scene = test::plainScene(volume, 3);
        scene.environment = {vec3(1), true};
        scene.gradientFactor = 1;
        scene.transferFunction.nodes = {
            {.hu = -32768, .opacity = 0.2f}, {.hu = 0, .opacity = 0}, {.hu = 32767, .opacity = 1}};
        const Film film = test::render(scene, 16);
        QVERIFY(film.status().health.perfect());

        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("volume.raw").toStdString();
        for (const float bad : {NAN, INFINITY, -INFINITY, 32768.0f, -40000.0f}) {
            const float voxels[] = {1, 2, bad, 4};
            std::FILE* file = std::fopen(path.c_str(), "wb");
            std::fwrite(voxels, sizeof(float), 4, file);
            std::fclose(file);
            const auto loaded = loadRaw({.path = path, .type = RawFile::Type::float32, .size = {2, 2, 1}});
            QVERIFY(!loaded && loaded.error().what.find("voxel 2") != std::string::npos);
        }
    }

    /// Case 35. A window from the lowest to the highest value has no width.
    void constantVolumeHasNoWindow() {
        QVERIFY(std::isnan((5.0f - 5.0f) / (5.0f - 5.0f)));
        for (const int hu : {-32768, -1024, 0, 5, 32767}) {
            const auto prepared = constantMedium({9, 9, 9}, dvec3(1), 0.1f, hu);
            QVERIFY(std::fabs(transmittance(prepared->flat, {-0.5f, 4, 4}, {1, 0, 0}).z(std::exp(-0.9))) <
                    test::allowedZ(5));
            QVERIFY(test::sampled(prepared, 4).status().health.perfect());
        }
    }

    /// Case 42. Outside the outermost centres a weight of -0.5 extrapolates, and voxel n does not exist.
    void interpolationLeavesTheVolumeAtItsBorder() {
        const auto prepared = Flattener().prepare(test::plainScene(
            test::makeVolume({3, 4, 5}, dvec3(1), [](int i, int j, int k) { return 100 * i + 10 * j + k; }), 1));
        const FlatVolume& volume = prepared->flat.volume;
        const auto naive = [](float x) { return 0 + (100 - 0) * (x - float(int(x))); };  // between voxels 0 and 1
        QVERIFY(naive(-0.5f) < -40);
        QCOMPARE(hounsfield(volume, vec3(-0.5f, 0, 0)), 0.0f);
        QCOMPARE(hounsfield(volume, vec3(2, 3, 4)), 234.0f);
        QCOMPARE(hounsfield(volume, vec3(2.5f, 3.5f, 4.5f)), 234.0f);
        for (const float x : {0.0f, 1.0f, 2.0f, -0.5f, 2.5f})  // continuous through centres and borders
            QVERIFY(std::fabs(hounsfield(volume, vec3(std::nextafter(x, -9.0f), 1, 1)) -
                              hounsfield(volume, vec3(std::nextafter(x, 9.0f), 1, 1))) < 1e-4f);
    }

    /// Case 43. 2048^3 voxels: the last ones lie beyond what 32 bits count. Reserved, not filled: it takes no memory.
    void voxelIndexOverflowsBeyondTwoBillion() {
        const int n = 2048;
        QVERIFY(std::int32_t(std::uint32_t((n - 1) * n + n - 1) * unsigned(n)) < 0);
        const std::size_t bytes = sizeof(std::int16_t) * n * n * n;
        void* reserved =
            mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (reserved == MAP_FAILED)
            QSKIP("this machine does not reserve 16 GiB of addresses");
        auto* voxels = static_cast<std::int16_t*>(reserved);
        const auto at = [&](int i, int j, int k) -> std::int16_t& { return voxels[(std::size_t(k) * n + j) * n + i]; };
        at(n - 1, n - 1, n - 1) = 1000;
        at(5, 0, 1024) = 300;  // index 2^32 + 5: as 32 bits it is voxel 5

        const auto prepared = test::prepared(test::plainScene(constantMedium({8, 8, 8}, dvec3(1), 0)->volume, 1e-3f));
        const std::vector<float> coarse(129 * 129 * 129, 1.001e-3f);
        FlatScene& scene = prepared->flat;
        scene.volume.voxels = voxels;
        scene.volume.size = ivec3(n);
        scene.volume.lastIndex = vec3(float(n - 1));
        scene.volume.lastCorner = vec3(float(n - 2));
        scene.volume.stepY = n;
        scene.volume.stepZ = std::int64_t(n) * n;
        scene.majorants.coarse = coarse.data();
        scene.majorants.coarseSize = ivec3(129);
        scene.majorants.fineSize = ivec3(516);
        scene.majorants.occupiedLow = vec3(-0.5f);
        scene.majorants.occupiedHigh = vec3(n - 0.5f);
        QCOMPARE(hounsfield(scene.volume, vec3(float(n))), 1000.0f);
        QCOMPARE(hounsfield(scene.volume, vec3(n - 1.5f, n - 1, n - 1)), 500.0f);
        QCOMPARE(hounsfield(scene.volume, vec3(5, 0, 1024.25f)), 225.0f);
        RayBatch rays;
        test::Sample through;
        for (int i = 0; i < RayBatch::kCapacity; ++i)
            rays.add({vec3(n - 1.2f, n - 1.4f, -0.5f), vec3(0, 0, 1), 1e30f}, stream(i));
        rays.track<RatioTracking>(scene);
        for (int i = 0; i < RayBatch::kCapacity; ++i)
            through.add(rays.result(i));
        QVERIFY(std::fabs(through.z(std::exp(-2.048))) < test::allowedZ(1));
        munmap(reserved, bytes);
    }
};

QTEST_GUILESS_MAIN(MediumTest)
#include "medium_test.moc"
