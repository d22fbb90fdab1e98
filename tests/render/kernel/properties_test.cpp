/// What must hold of every scene, tried on scenes drawn by lot. Seeds are fixed; with others, one run in 1e4 would
/// raise a false alarm (1e-4 shared by all comparisons).

#include <QTest>

#include "render/kernel/ray.h"
#include "tests/support/scenes/images.h"
#include "tests/support/scenes/random_scenes.h"

using namespace pdr;

namespace {

constexpr int kComparisons = 60;  ///< in this file, at most
constexpr std::uint64_t kSamples = 192;

/// Whether two images may be of the same scene, and nothing went wrong in either. A scene too noisy to tell (10 % of
/// its mean) is none to test with.
template <class Partner>
bool alike(const Film& a, const Film& b, unsigned seed, Partner&& partner) {
    const test::Likeness found = test::likeness(a, b, partner);
    const bool healthy = a.status().health.perfect() && b.status().health.perfect();
    const bool good = healthy && found.p > 1e-4 / kComparisons && found.relativeError < 0.1;
    if (!good)
        qWarning("scene %u: p = %.3g, error %.2g%s", seed, found.p, found.relativeError, healthy ? "" : ", faults");
    return good;
}
bool alike(const Film& a, const Film& b, unsigned seed) {
    return alike(a, b, seed, [](ivec2 pixel) { return pixel; });
}

Film image(const Scene& scene) {
    return test::render(scene, kSamples);
}

/// Renders the scene with other random numbers.
Film otherImage(Scene scene) {
    scene.seed += 1000;
    return image(scene);
}

Scene withGeometry(Scene scene, const VolumeGeometry& geometry, Voxels voxels) {
    scene.volume = std::make_shared<Volume>(geometry, std::move(voxels));
    return scene;
}

/// Returns the scene with its voxels in the same places, but stored along other axes and from other corners. `axis[i]`:
/// which old axis the new axis i runs along; `back[i]`: whether it runs backwards.
Scene storedOtherwise(const Scene& scene, ivec3 axis, glm::bvec3 back) {
    const VolumeGeometry& old = scene.volume->geometry();
    VolumeGeometry geometry;
    dmat4 oldFromNew(0);
    oldFromNew[3] = {0, 0, 0, 1};
    for (int i = 0; i < 3; ++i) {
        geometry.size[i] = old.size[axis[i]];
        oldFromNew[i][axis[i]] = back[i] ? -1 : 1;
        oldFromNew[3][axis[i]] = back[i] ? geometry.size[i] - 1 : 0;
    }
    geometry.patientFromIndex = old.patientFromIndex * oldFromNew;
    Voxels voxels;
    for (int k = 0; k < geometry.size.z; ++k)
        for (int j = 0; j < geometry.size.y; ++j)
            for (int i = 0; i < geometry.size.x; ++i) {
                const ivec3 from(oldFromNew * dvec4(i, j, k, 1));
                voxels.push_back(
                    scene.volume->voxels()[(std::size_t(from.z) * old.size.y + from.y) * old.size.x + from.x]);
            }
    return withGeometry(scene, geometry, std::move(voxels));
}

/// The patient, the lights and the camera together, moved by an isometry.
Scene moved(Scene scene, const dmat4& isometry) {
    const auto place = [&](dvec3& p) { p = dvec3(isometry * dvec4(p, 1)); };
    const auto turn = [&](dvec3& v) { v = dvec3(isometry * dvec4(v, 0)); };
    VolumeGeometry geometry = scene.volume->geometry();
    geometry.patientFromIndex = isometry * geometry.patientFromIndex;
    place(scene.camera.eyeMm);
    place(scene.camera.targetMm);
    turn(scene.camera.up);
    for (Light& light : scene.lights) {
        if (auto* sun = std::get_if<DirectionalLight>(&light))
            turn(sun->direction);
        if (auto* ball = std::get_if<SphereLight>(&light))
            place(ball->centreMm);
        if (auto* panel = std::get_if<RectangleLight>(&light)) {
            place(panel->centreMm);
            turn(panel->normal);
            turn(panel->up);
        }
    }
    const auto voxels = scene.volume->voxels();
    return withGeometry(std::move(scene), geometry, {voxels.begin(), voxels.end()});
}

/// A rotation about any axis, or that with a mirror before it, and a shift.
dmat4 anyIsometry(std::mt19937& random, bool mirrored) {
    const dvec3 a = test::anyDirection(random), b = glm::normalize(glm::cross(a, test::anyDirection(random)));
    const dvec3 c = glm::cross(a, b) * (mirrored ? -1.0 : 1.0);
    return {dvec4(a, 0), dvec4(b, 0), dvec4(c, 0), dvec4(100.0 * test::anyDirection(random), 1)};
}

}  // namespace

class PropertiesTest : public QObject {
    Q_OBJECT

  private slots:
    void macrocellsGiveTheImageOfOneGlobalBound() {
        const auto device = makeCpuDevice();
        for (unsigned seed = 1; seed <= 6; ++seed) {
            Scene scene = test::anyScene(seed);
            const Film cells = test::render(scene, kSamples, *device);
            scene.seed += 1000;
            const Film global = test::sampled(test::withGlobalMajorant(scene), kSamples);
            QVERIFY(alike(cells, global, seed));
        }
    }

    /// A volume of one value attenuates what lies behind it by exp(-extinction * chord), from wherever it is seen.
    void evenVolumesAttenuateAlongTheChord() {
        for (unsigned seed = 1; seed <= 12; ++seed) {
            std::mt19937 random(seed);
            Scene scene = test::anyScene(seed);
            const VolumeGeometry geometry = scene.volume->geometry();
            const float hu = float(int(random() % 2000) - 800);
            scene = withGeometry(scene, geometry, Voxels(geometry.voxelCount(), std::int16_t(hu)));
            for (TransferNode& node : scene.transferFunction.nodes)
                node.albedo = vec3(0);
            scene.lights.clear();
            scene.environment = {vec3(1), true};
            scene.gradientFactor = 0;
            scene.camera.type = Camera::Type::orthographic;
            scene.camera.heightMm = 1e-6;
            const dvec3 half = 0.45 * dvec3(geometry.size) * geometry.spacingMm();
            const dvec3 shift = half * test::anyDirection(random);
            scene.camera.targetMm += shift;
            scene.camera.eyeMm += shift;

            const dvec3 box = dvec3(geometry.size) * geometry.spacingMm();
            const Interval<double> chord =
                clipped(scene.camera.eyeMm, scene.camera.forward(), dvec3(0), box, Interval<double>{0, 1e9});
            const double extinction = scene.transferFunction.extinctionPerMm * scene.transferFunction.at(hu).opacity;
            const double truth = std::exp(-extinction * (chord.leave - chord.enter));
            scene.transferFunction.extinctionPerMm *= truth < 0.01 ? 0.02f : 1.0f;
            const double seen = truth < 0.01 ? std::pow(truth, 0.02) : truth;
            const double n = 24 * 24 * kSamples, mean = test::imageMean(image(scene)).mean;
            const double z = (mean - seen) / (std::sqrt(seen * (1 - seen) / n) + 1e-6);
            QVERIFY2(std::fabs(z) < test::allowedZ(kComparisons),
                     qPrintable(QString("%1 instead of %2, z = %3").arg(mean).arg(seen).arg(z)));
        }
    }

    void orderOfTheLightsDoesNotShow() {
        for (unsigned seed = 11; seed <= 14; ++seed) {
            std::mt19937 random(seed);
            Scene scene = test::anyScene(seed);
            const Film first = image(scene);
            std::ranges::shuffle(scene.lights, random);
            QVERIFY(alike(first, otherImage(scene), seed));
        }
    }

    void anyTilingGivesTheSameBits() {
        for (unsigned seed = 21; seed <= 26; ++seed) {
            std::mt19937 random(seed);
            const Scene scene = test::anyScene(seed);
            const Film whole = test::render(scene, 70, *makeCpuDevice(1), 64);
            const int threads = 1 + int(random() % 4), n = 1 + int(random() % 70), tile = 1 + int(random() % 24);
            QVERIFY2(test::sameBits(whole, test::render(scene, 70, *makeCpuDevice(threads), std::uint32_t(n), tile)),
                     qPrintable(QString("scene %1, n %2, tile %3").arg(seed).arg(n).arg(tile)));
        }
    }

    void orthographicCameraMayStandAnywhereAlongItsView() {
        for (unsigned seed = 31; seed <= 34; ++seed) {
            Scene scene = test::anyScene(seed);
            scene.camera.type = Camera::Type::orthographic;
            scene.camera.heightMm = 0.2 * scene.volume->geometry().radiusMm();  // near enough to see half a voxel
            const Film near = image(scene);
            scene.camera.eyeMm = scene.camera.targetMm - 1e7 * scene.camera.forward();
            QVERIFY(alike(near, otherImage(scene), seed));
        }
    }

    void storageOrderDoesNotShow() {
        for (unsigned seed = 41; seed <= 46; ++seed) {
            std::mt19937 random(seed);
            const Scene scene = test::anyScene(seed);
            int order[] = {0, 1, 2};
            std::ranges::shuffle(order, random);
            const glm::bvec3 back(random() % 2, random() % 2, random() % 2);
            const Scene other = storedOtherwise(scene, {order[0], order[1], order[2]}, back);
            QVERIFY(alike(image(scene), otherImage(other), seed));
        }
    }

    void turnedWorldLooksTheSame() {
        for (unsigned seed = 51; seed <= 54; ++seed) {
            std::mt19937 random(seed);
            const Scene scene = test::anyScene(seed);
            const Scene turned = moved(scene, anyIsometry(random, false));
            QVERIFY(alike(image(scene), otherImage(turned), seed));
        }
    }

    void mirroredWorldIsSeenMirrored() {
        for (unsigned seed = 61; seed <= 64; ++seed) {
            std::mt19937 random(seed);
            const Scene scene = test::anyScene(seed);
            const Scene mirrored = moved(scene, anyIsometry(random, true));
            const Film film = image(scene), other = otherImage(mirrored);
            const auto across = [](ivec2 pixel) { return ivec2(23 - pixel.x, pixel.y); };
            QVERIFY(alike(film, other, seed, across));
            // Negative control: without the mirror the images must differ.
            QVERIFY(test::likeness(film, other).p < 1e-6);
        }
    }

    void clippingToTheWholeVolumeChangesNothing() {
        for (unsigned seed = 71; seed <= 74; ++seed) {
            Scene scene = test::anyScene(seed);
            scene.gradientFactor = 0;  // the face of a cut reflects, and the volume's own border does not
            const Film whole = image(scene);
            const VolumeGeometry& geometry = scene.volume->geometry();
            const dvec3 box = dvec3(geometry.size) * geometry.spacingMm();
            scene.clip.box = ClipBox{dvec3(0), box};
            scene.clip.shadows = seed % 2 == 0;
            QVERIFY(test::sameBits(whole, image(scene)));
            scene.clip.box = ClipBox{dvec3(1e-4), box - 1e-4};  // not known to be all: it has to be clipped
            QVERIFY(alike(whole, otherImage(scene), seed));
            // Negative control.
            scene.clip.box = ClipBox{dvec3(0), 0.6 * box};
            QVERIFY(test::likeness(whole, otherImage(scene)).p < 1e-6);
        }
    }
};

QTEST_GUILESS_MAIN(PropertiesTest)
#include "properties_test.moc"
