/// Parts of the patient with materials of their own.

#include <QTest>

#include "render/kernel/transport/free_flight.h"
#include "render/prepare/flatten.h"
#include "render/scene/part_styles.h"
#include "render/volume/label_fit.h"
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

/// A label map of a scan's grid with one label on the patient's right and another on the left, named so.
LabelMap twoSides(const VolumeGeometry& grid) {
    LabelMap map;
    map.geometry = grid;
    for (std::size_t at = 0; at < grid.voxelCount(); ++at)
        map.labels.push_back(std::uint8_t(int(at) % grid.size.x < grid.size.x / 2 ? 1 : 2));
    map.parts = {{"kidney_right", {}}, {"kidney_left", {}}};  // +x is the patient's left
    return map;
}

std::string refusal(const VolumeGeometry& scan, const LabelMap& map) {
    const auto placed = labelsOn(scan, map, Resampling::nearest);
    return placed ? "it was taken" : std::string(placed.error().what);
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

    /// Case 71. Two kidneys of one name: whoever looks for the first one shows half of them.
    void firstPartOfANameIsTakenForAll() {
        Scene scene = numberedParts([](ivec3 voxel) { return voxel.x < 12 ? 1 : 2; });
        auto map = std::make_shared<LabelMap>(*scene.parts.map);
        map->parts = {{"kidney", {}}, {"kidney", {}}};
        scene.parts = {};
        scene.transferFunction = {3, {{.hu = 0, .opacity = 1}}};
        const auto first = std::ranges::find(map->parts, std::string("kidney"), &MappedPart::name) - map->parts.begin();
        int naive = 0;
        for (const std::uint8_t label : map->labels)
            naive += label == first + 1;
        QCOMPARE(naive, int(map->labels.size()) / 2);
        const PartStyles hidden{.styles = {{.part = "kidney", .state = PartState::hidden}}};
        const Scene shown = withParts(scene, map, hidden);
        QVERIFY(shown.check());
        QCOMPARE(depthAlongX(shown, 5, 5), 0.0f);
    }

    /// Case 72. A header that counts from the corners of voxels puts every part half a voxel beside its place.
    void nearestVoxelTakesAMapThatIsShifted() {
        const VolumeGeometry scan = VolumeGeometry::aligned({24, 4, 4}, dvec3(1), {0, 0, 0});
        LabelMap map = twoSides(scan);
        map.geometry.patientFromIndex[3].x += 0.5 + 1e-6;
        const dmat4 mapFromScan = glm::inverse(map.geometry.patientFromIndex) * scan.patientFromIndex;
        const int naive = int(std::floor((mapFromScan * dvec4(12, 0, 0, 1)).x + 0.5));
        QCOMPARE(naive, 11);
        QCOMPARE(int(map.labels[std::size_t(naive)]), 1);  // of the left one: a voxel of the other
        QVERIFY2(refusal(scan, map).starts_with("the label map is shifted"), refusal(scan, map).c_str());
    }

    /// Case 73. Voxels written from left to right under a header that says right to left: only names can tell.
    void headerThatFitsHidesAMirroredMap() {
        const VolumeGeometry scan = VolumeGeometry::aligned({24, 4, 4}, dvec3(1), {0, 0, 0});
        LabelMap map = twoSides(scan);
        QCOMPARE(refusal(scan, map), std::string("it was taken"));
        for (auto row = map.labels.begin(); row != map.labels.end(); row += 24)
            std::reverse(row, row + 24);
        const bool naive = map.geometry.patientFromIndex == scan.patientFromIndex && map.geometry.size == scan.size;
        QVERIFY(naive);
        QVERIFY2(refusal(scan, map).starts_with("the label map is mirrored"), refusal(scan, map).c_str());
    }

    /// Case 74. A part lies beyond the scan. Clamped to its border it is smeared over what is there.
    void partBeyondTheScanIsSmearedOverItsBorder() {
        const VolumeGeometry scan = VolumeGeometry::aligned({24, 4, 4}, dvec3(1), {0, 0, 0});
        LabelMap map = twoSides(scan);
        map.geometry.patientFromIndex[3].x += 40;
        int naive = 0;
        for (int x = 0; x < 24; ++x)
            naive += map.labels[std::size_t(std::clamp(x - 40, 0, 23))] == 1;
        QCOMPARE(naive, 24);
        QCOMPARE(refusal(scan, map), std::string("the label map lies elsewhere: it reaches 40 voxels beyond the scan"));
    }
};

QTEST_GUILESS_MAIN(HardPartsTest)
#include "parts_test.moc"
