/// Where rays leave a surface: outside its soft edge, at the edges of grids, masks and cuts, on thin and sheared
/// tissue.

#include <QTest>

#include "render/kernel/transport/ray_origin.h"
#include "tests/physics/hybrid_scenes.h"
#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

constexpr int kComparisons = 16;
constexpr float kAlbedo = 0.8f, kIrradiance = 2;

/// White tissue above `edgeHu`, all surface, in light at the cosine `light` to +z and seen at the cosine `view`.
Scene plate(std::shared_ptr<const Volume> volume, float edgeHu, float extinctionPerMm, double view, double light) {
    Scene scene = test::plainScene(std::move(volume), extinctionPerMm);
    scene.transferFunction.nodes = {{.hu = edgeHu, .opacity = 0, .albedo = vec3(kAlbedo)},
                                    {.hu = edgeHu, .opacity = 1, .albedo = vec3(kAlbedo)}};
    scene.gradientFactor = 1000;
    scene.rayOrigin = RayOrigin::outsideEdge;
    scene.lights = {DirectionalLight{{std::sqrt(1 - light * light), 0, -light}, vec3(kIrradiance)}};
    const dvec3 middle = scene.volume->geometry().centreMm();
    scene.camera = {.type = Camera::Type::orthographic,
                    .eyeMm = middle + 200.0 * dvec3(0, std::sqrt(1 - view * view), view),
                    .targetMm = middle,
                    .up = {1, 0, 0},
                    .heightMm = 2};
    scene.film = {16, 16};
    return scene;
}

/// Layers across z of air and, in layer `layer` of 24 alone or from there down, of tissue.
std::shared_ptr<const Volume> layered(int layer, bool alone) {
    return test::makeVolume({24, 24, 24}, dvec3(1),
                            [=](int, int, int k) { return k == layer || (k < layer && !alone) ? 1000 : -1000; });
}

/// The plane edge whose light the model takes: of `depth` across all of it.
double planeRadiance(double view, double light, double depth) {
    return kAlbedo / M_PI * kIrradiance * light * light / (light + view) * -std::expm1(-depth / view);
}

void verifyIs(const Film& film, double truth) {
    const test::ImageMean got = test::imageMean(film);
    const QString found = QString("%1 +- %2, expected %3").arg(got.mean).arg(got.standardError).arg(truth);
    QVERIFY2(std::fabs(got.mean - truth) <= test::allowedZ(kComparisons) * got.standardError + 2e-4 * truth,
             qPrintable(found));
    QVERIFY2(got.standardError < 2e-3 * truth, qPrintable(found));
}

Event eventOf(const PreparedScene& prepared, vec3 position, vec3 normal) {
    return {position, normal, materialAt(prepared.flat.transferFunction, 0), normal};
}

}  // namespace

class RayOriginTest : public QObject {
    Q_OBJECT

  private slots:
    /// One step of the grid long, and along the normal in the patient, whatever the grid's spacing and shear.
    void raysStartOneVoxelOutAlongTheNormal() {
        Scene scene = test::hybridScenes().front().scene();
        scene.volume = test::unevenSurface({0.7, 1.1, 2}, 200, 0.4);
        scene.rayOrigin = RayOrigin::outsideEdge;
        const auto prepared = test::prepared(scene);
        for (const vec3 towards : {vec3(1, 0, 0), vec3(0, 0, -1), vec3(0.4f, -0.7f, 0.3f)}) {
            const vec3 normal = glm::normalize(towards), place(5, 5, 3);
            const vec3 way = rayOrigin<kSurface>(prepared->flat, eventOf(*prepared, place, normal)) - place;
            QVERIFY(std::fabs(glm::length(way) - 1) < 1e-5f);
            QVERIFY(glm::distance(glm::normalize(prepared->flat.volume.localFromIndex * way), normal) < 1e-5f);
        }
    }

    /// Events of the phase function, those without a gradient, and all of the other model.
    void otherRaysStartAtTheirEvent() {
        Scene scene = plate(layered(12, false), 0, 1, 1, 1);
        const vec3 place(5, 5, 11.5f), up(0, 0, 1);
        const auto outside = test::prepared(scene);
        const Event medium = eventOf(*outside, place, vec3(0)), surface = eventOf(*outside, place, up);
        QVERIFY(rayOrigin<kSurface>(outside->flat, medium) == place);
        QVERIFY(rayOrigin<0>(outside->flat, surface) == place);
        QCOMPARE(edgeTransmittance<kSurface>(outside->flat, medium, up), 1.0f);
        QVERIFY(eventAt<kSurface>(outside->flat, {5, 5, 4}, up, 1e-6f).normal == vec3(0));
        scene.rayOrigin = RayOrigin::event;
        const auto within = test::prepared(scene);
        QVERIFY(rayOrigin<kSurface>(within->flat, surface) == place);
        QCOMPARE(edgeTransmittance<kSurface>(within->flat, surface, up), 1.0f);
    }

    void aPlaneTakesItsShare_data() {
        QTest::addColumn<double>("view");
        QTest::addColumn<double>("light");
        QTest::newRow("straight") << 1.0 << 1.0;
        QTest::newRow("grazing light") << 0.9 << 0.2;
        QTest::newRow("grazing view") << 0.3 << 0.8;
    }
    /// A sheet that is one voxel thick: rays to the light start outside, on whichever half of it the event is.
    void aPlaneTakesItsShare() {
        QFETCH(double, view);
        QFETCH(double, light);
        verifyIs(test::render(plate(layered(12, true), 0, 1, view, light), 1024), planeRadiance(view, light, 1));
    }

    /// The edge lies in the last half voxel of the grid, and rays start beyond it.
    void raysMayStartOutsideTheGrid() {
        verifyIs(test::render(plate(layered(22, false), -900, 20, 0.8, 0.5), 1024), planeRadiance(0.8, 0.5, 1e9));
    }

    /// A cut has no soft edge: rays start in its plane, which need not be a voxel away.
    void noRayStartsBeyondACut() {
        Scene scene = plate(layered(30, false), 0, 50, 0.8, 0.5);
        scene.clip.planes = {{{0, 0, 15.2}, {0, 0, 1}}};
        const auto prepared = test::prepared(scene);
        const Event event = eventOf(*prepared, {5, 5, 14.3f}, {0, 0, 1});  // 0.4 voxels below
        QVERIFY(std::fabs(rayOrigin<kSurface>(prepared->flat, event).z - 14.7f) < 1e-4f);
        verifyIs(test::render(scene, 1024), planeRadiance(0.8, 0.5, 1e9));
        scene.clip.shadows = true;  // of 0.8 mm and more of dense tissue
        QVERIFY(test::imageMean(test::render(scene, 64)).mean < 1e-6);
    }

    /// Tissue that a mask hides from z = 15 mm on ends in an edge that is one voxel wide.
    void theEdgeOfAMaskIsLeft() {
        Scene scene = plate(layered(30, false), 0, 50, 0.8, 0.5);
        scene.mask =
            maskOf({scene.volume->size(), ivec3(0)}, "", [](dvec3 place) { return place.z < 14.5 ? kSeen : 0; });
        verifyIs(test::render(scene, 1024), planeRadiance(0.8, 0.5, 1e9));
    }

    /// A roof one voxel above a surface casts its shadow on it.
    void shadowsOfWhatIsAVoxelAwayStay() {
        Scene scene = plate(
            test::makeVolume({24, 24, 24}, dvec3(1), [](int, int, int k) { return k <= 12 || k == 14 ? 1000 : -1000; }),
            0, 20, 0.8, 0.5);
        scene.clip.planes = {{{0, 0, 13.7}, {0, 0, 1}}};  // between both
        verifyIs(test::render(scene, 1024), planeRadiance(0.8, 0.5, 1e9));
        scene.clip.shadows = true;
        QVERIFY(test::imageMean(test::render(scene, 64)).mean < 1e-6);
    }
};

QTEST_APPLESS_MAIN(RayOriginTest)
#include "ray_origin_test.moc"
