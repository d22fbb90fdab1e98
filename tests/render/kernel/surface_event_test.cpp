/// When an event is a surface, and what it costs to know.

#include <QTest>

#include "render/kernel/transport/event.h"
#include "render/prepare/needs.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

/// HU from -1000 to 1500 in voxels of 1 mm: a step across x in opaque tissue.
Scene step() {
    return test::plainScene(
        test::makeVolume({30, 30, 30}, dvec3(1), [](int i, int, int) { return i < 15 ? -1000 : 1500; }), 0.3f);
}

bool surfacesNeeded(const Scene& scene) {
    return has(neededFeatures(needs(scene)), kSurface);
}

}  // namespace

class SurfaceEventTest : public QObject {
    Q_OBJECT

  private slots:
    /// The gradient factor from which on surfaces are needed: below, the smallest random number is above every
    /// probability; 1.45 (the cube root of 3: the bound counts each axis for itself) times higher, the steepest place
    /// can be a surface.
    void surfacesAreOffExactlyWhereNoRandomNumberFindsOne() {
        Scene scene = step();
        float off = 1e-6f, on = 1;
        while (on / off > 1.0001f) {
            scene.gradientFactor = std::sqrt(off * on);
            (surfacesNeeded(scene) ? on : off) = scene.gradientFactor;
        }
        const auto canReflect = [&](float factor) {
            scene.gradientFactor = factor;
            const auto prepared = test::prepared(scene);
            return surfaceNormal(prepared->flat, prepared->flat.transferFunction, {14.5f, 15, 15}, {-1, 0, 0}, 250,
                                 0x1p-24f) != vec3(0);
        };
        QVERIFY2(off > 1e-3f && off < 1e-1f, qPrintable(QString::number(off)));
        QVERIFY(!canReflect(off));
        QVERIFY(canReflect(1.45f * on));
    }

    /// A surface is never more probable than the tissue is opaque: where the number lies above, no voxel is looked at.
    void aSurfaceThatOpacityRulesOutCostsNoVoxel() {
        Scene scene = step();
        scene.gradientFactor = 1;
        scene.transferFunction.nodes[0].opacity = 0.25f;
        const auto prepared = test::prepared(scene);
        prepared->flat.volume.voxels = nullptr;
        QVERIFY(surfaceNormal(prepared->flat, prepared->flat.transferFunction, {14.5f, 15, 15}, {-1, 0, 0}, 250,
                              0.25f) == vec3(0));
    }
};

QTEST_APPLESS_MAIN(SurfaceEventTest)
#include "surface_event_test.moc"
