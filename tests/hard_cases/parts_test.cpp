/// Parts of the patient with materials of their own.

#include <QTest>

#include "render/kernel/transport/free_flight.h"
#include "render/prepare/flatten.h"
#include "tests/support/scenes/part_scenes.h"

using namespace pdr;

namespace {

/// A part of one voxel in air, and others at a border of the scan; each part is as dense as its number [1/mm].
Scene numberedParts(const std::function<int(ivec3)>& label) {
    Scene scene = test::plainScene(test::makeVolume(ivec3(24), dvec3(1), [](int, int, int) { return 0; }), 1);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}};
    scene.parts.map = test::labelled(*scene.volume, 255, label);
    for (int number = 1; number <= 255; ++number)
        scene.parts.curves.push_back({std::uint8_t(number), {float(number), {{.hu = 0, .opacity = 1}}}});
    return scene;
}

/// The optical depth of the scan along x.
float depthAlongX(const Scene& scene, float y, float z) {
    const auto prepared = Flattener().prepare(scene);
    return freeFlight(prepared->flat, {{-0.5f, y, z}, {1, 0, 0}, 24}, 1e9f).passed;
}

bool isNear(float value, float truth) {
    return std::fabs(value - truth) <= 1e-4f * truth;
}

}  // namespace

class HardPartsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Case 67. A ray passes at 0.6 voxels from the centre of the only voxel of a part.
    void nearestLabelLosesAPartOfOneVoxel() {
        const auto label = [](ivec3 voxel) { return voxel == ivec3(11) ? 200 : 0; };
        float naive = 0;
        for (int step = 0; step < 2400; ++step)
            naive += 0.01f * float(label(ivec3(glm::floor(vec3(-0.5f + 0.01f * float(step), 11.6f, 11) + 0.5f))));
        QCOMPARE(naive, 0.0f);
        const Scene scene = numberedParts(label);
        QVERIFY(isNear(depthAlongX(scene, 11.6f, 11), 0.4f * 200));
        QVERIFY(isNear(depthAlongX(scene, 11, 11), 200));
    }

    /// Case 68. The number of the last curve is the byte that marks cells of several.
    void lastOf255PartsIsTakenForAMark() {
        const Scene scene = numberedParts([](ivec3 voxel) { return voxel.x < 12 ? 255 : 254; });
        QVERIFY(scene.check());
        const auto prepared = Flattener().prepare(scene);
        const int naive = prepared->parts.cells->at(cellIndex({1, 1, 1}, prepared->ranges->fineSize()));
        QCOMPARE(naive, kMixedCell);
        QCOMPARE(int(prepared->parts.curveOf[255]), 255);
        QVERIFY(isNear(depthAlongX(scene, 5, 5), 12 * 255 + 12 * 254));
    }

    /// Case 69. What is beyond the scan is in no part.
    void partFadesAtTheBorderOfTheScan() {
        const Scene scene = numberedParts([](ivec3 voxel) { return voxel.x == 23 ? 8 : 0; });
        const float naive = 8 * (0.5f + 0.5f - 0.125f);  // half a tent, and what is left of the other half
        QVERIFY(std::fabs(naive - 8) > 0.5f);
        QVERIFY(isNear(depthAlongX(scene, 5, 5), 8));
        QVERIFY(isNear(depthAlongX(scene, -0.4f, 23.4f), 8));
    }

    /// Case 70. Two parts of one density share a border, where each fades.
    void weightsOfNeighboursAddUpToMoreThanOne() {
        Scene scene = numberedParts([](ivec3 voxel) { return voxel.x < 12 ? 1 : 2; });
        scene.parts.curves = {{1, {3, {{.hu = 0, .opacity = 1, .albedo = vec3(1)}}}},
                              {2, {3, {{.hu = 0, .opacity = 1, .albedo = vec3(0)}}}}};
        const auto smooth = [](float x) { return x * x * (3 - 2 * x); };  // of a mask grown by half a voxel
        float naive = 0, worst = 0;
        const auto prepared = Flattener().prepare(scene);
        for (float x = 11; x <= 12; x += 0.125f) {
            naive = std::max(naive, 3 * (smooth(std::min(12.5f - x, 1.0f)) + smooth(std::min(x - 10.5f, 1.0f))));
            worst = std::max(worst, std::fabs(extinction(prepared->flat, vec3(x, 5, 5)) - 3));
        }
        QVERIFY(naive > 5.9f);
        QVERIFY(worst < 1e-5f);
        QVERIFY(isNear(depthAlongX(scene, 5, 5), 3 * 24));
    }
};

QTEST_GUILESS_MAIN(HardPartsTest)
#include "parts_test.moc"
