#include <QTest>

#include <algorithm>
#include <array>

#include "render/volume/label_fit.h"

using namespace pdr;

namespace {

/// A scan of 6 x 5 x 4 voxels that lies aside of the patient's origin.
VolumeGeometry scanGrid() {
    return VolumeGeometry::aligned({6, 5, 4}, {0.8, 0.9, 2.5}, {20, -30, 100});
}

/// A map on `grid` whose voxel (i,j,k) has the label 1 + its number in the scan's order, as far as `labelAt` says so.
template <class LabelAt>
LabelMap mapOn(const VolumeGeometry& grid, const LabelAt& labelAt) {
    LabelMap map;
    map.geometry = grid;
    map.labels.reserve(grid.voxelCount());
    for (int z = 0; z < grid.size.z; ++z)
        for (int y = 0; y < grid.size.y; ++y)
            for (int x = 0; x < grid.size.x; ++x)
                map.labels.push_back(labelAt(ivec3(x, y, z)));
    for (int part = 1; part <= 120; ++part)
        map.parts.push_back({standardName(part), standardColour(part)});
    return map;
}

/// Every voxel of the scan has a label of its own.
std::uint8_t ownLabel(ivec3 at) {
    return std::uint8_t(1 + at.x + 6 * (at.y + 5 * at.z));
}

/// Returns a grid whose voxels are those of `grid`, counted along other axes: axis n runs along axes[n] of `grid`,
/// backwards where it is negative (-1: axis 0 backwards, counted from 1).
VolumeGeometry turned(const VolumeGeometry& grid, const std::array<int, 3>& axes) {
    VolumeGeometry turned = grid;
    for (int n = 0; n < 3; ++n) {
        const int axis = std::abs(axes[std::size_t(n)]) - 1;
        const bool isBackwards = axes[std::size_t(n)] < 0;
        turned.size[n] = grid.size[axis];
        turned.patientFromIndex[n] = grid.patientFromIndex[axis] * (isBackwards ? -1.0 : 1.0);
        if (isBackwards)
            turned.patientFromIndex[3] += grid.patientFromIndex[axis] * double(grid.size[axis] - 1);
    }
    return turned;
}

/// Returns the voxel of the scan at a voxel of another grid.
ivec3 inScan(const VolumeGeometry& grid, ivec3 at) {
    return ivec3(glm::round(dvec3(glm::inverse(scanGrid().patientFromIndex) * grid.patientFromIndex * dvec4(at, 1))));
}

std::string refusal(const LabelMap& map, Resampling resampling = Resampling::nearest) {
    const auto placed = labelsOn(scanGrid(), map, resampling);
    return placed ? "it was taken" : std::string(placed.error().what);
}

std::vector<std::uint8_t> labelsOf(const LabelMap& map) {
    return {map.labels.begin(), map.labels.end()};
}

}  // namespace

/// A label map lies on the voxels of its scan, or it is refused: never a part beside its place.
class LabelFitTest : public QObject {
    Q_OBJECT

  private slots:
    void theSameGridIsTakenAsItIs() {
        const LabelMap map = mapOn(scanGrid(), ownLabel);
        const auto placed = labelsOn(scanGrid(), map, Resampling::refused);
        QVERIFY(bool(placed));
        QCOMPARE(labelsOf(*placed), labelsOf(map));
        QVERIFY(placed->notes.empty());
    }

    /// All 48 orders and directions of the axes: programs write the same voxels in the order that they like.
    void theOrderOfTheAxesDoesNotMatter() {
        const LabelMap expected = mapOn(scanGrid(), ownLabel);
        int orders = 0;
        std::array<int, 3> axes{1, 2, 3};
        do
            for (int signs = 0; signs < 8; ++signs, ++orders) {
                const VolumeGeometry grid = turned(
                    scanGrid(),
                    {signs & 1 ? -axes[0] : axes[0], signs & 2 ? -axes[1] : axes[1], signs & 4 ? -axes[2] : axes[2]});
                const auto placed = labelsOn(
                    scanGrid(), mapOn(grid, [&](ivec3 at) { return ownLabel(inScan(grid, at)); }), Resampling::refused);
                QVERIFY2(bool(placed), placed ? "" : placed.error().text().c_str());
                QCOMPARE(labelsOf(*placed), labelsOf(expected));
            }
        while (std::next_permutation(axes.begin(), axes.end()));
        QCOMPARE(orders, 48);
    }

    /// Slicer crops what it saves.
    void aPartOfTheGridIsTaken() {
        const VolumeGeometry part = scanGrid().part({1, 2, 1}, {3, 2, 2});
        const auto placed = labelsOn(scanGrid(), mapOn(part, [&](ivec3 at) { return ownLabel(at + ivec3(1, 2, 1)); }),
                                     Resampling::refused);
        QVERIFY(bool(placed));
        const LabelMap expected = mapOn(scanGrid(), [](ivec3 at) {
            const bool isInside = at.x >= 1 && at.x < 4 && at.y >= 2 && at.y < 4 && at.z >= 1 && at.z < 3;
            return isInside ? ownLabel(at) : std::uint8_t(0);
        });
        QCOMPARE(labelsOf(*placed), labelsOf(expected));
    }

    /// A fifth of a voxel is what rounded headers are off; more is another grid. Along the slices 0.2 mm is the limit.
    void voxelsBesideThoseOfTheScanAreRefused() {
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0}) {
                const double step = scanGrid().spacingMm()[axis];
                const auto movedBy = [&](double mm) {
                    VolumeGeometry moved = scanGrid();
                    moved.patientFromIndex[3][axis] += sign * mm;
                    return mapOn(moved, ownLabel);
                };
                const auto near = labelsOn(scanGrid(), movedBy(0.95 * std::min(0.2, 0.2 * step)), Resampling::refused);
                QVERIFY(bool(near));
                QCOMPARE(labelsOf(*near), labelsOf(mapOn(scanGrid(), ownLabel)));
                for (const double voxels : {0.25, 0.5, 0.75})
                    QVERIFY2(refusal(movedBy(voxels * step)).starts_with("the label map is shifted"),
                             refusal(movedBy(voxels * step)).c_str());
            }
        VolumeGeometry slices = scanGrid();
        slices.patientFromIndex[3].z += 0.25;  // a tenth of their distance
        QVERIFY(refusal(mapOn(slices, ownLabel)).starts_with("the label map is shifted"));
    }

    /// A header that means RAS where it says LPS puts the patient's left at the right.
    void mirroredHeadersAreRefused() {
        for (const dvec3 signs : {dvec3(-1, 1, 1), dvec3(-1, -1, 1), dvec3(1, -1, 1), dvec3(1, 1, -1)}) {
            VolumeGeometry mirrored = scanGrid();
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 3; ++row)
                    mirrored.patientFromIndex[column][row] *= signs[row];
            QVERIFY2(refusal(mapOn(mirrored, ownLabel)).starts_with("the label map is mirrored: it fits the scan with"),
                     refusal(mapOn(mirrored, ownLabel)).c_str());
        }
    }

    /// Voxels in the wrong order have a header that fits: the names of paired organs tell.
    void mirroredVoxelsAreToldByNames() {
        const VolumeGeometry grid = VolumeGeometry::aligned({40, 2, 2}, {1, 1, 1}, {-20, 0, 0});
        const auto sides = [](ivec3 at) { return std::uint8_t(at.x < 10 ? 1 : at.x >= 30 ? 2 : 0); };
        LabelMap map = mapOn(grid, sides);
        map.parts = {{"kidney_right", {}}, {"Kidney_Left", {}}};  // +x is the patient's left
        QVERIFY(bool(labelsOn(grid, map, Resampling::refused)));
        std::swap(map.parts[0], map.parts[1]);
        const auto crossed = labelsOn(grid, map, Resampling::refused);
        QVERIFY(!crossed);
        QCOMPARE(std::string(crossed.error().what),
                 std::string("the label map is mirrored: \"Kidney_Left\" lies at the right of \"kidney_right\""));
    }

    void anotherScansMapIsRefused() {
        VolumeGeometry other = scanGrid();
        other.patientFromIndex[3] += dvec4(0.8 * 2, 0, 0, 0);
        QCOMPARE(refusal(mapOn(other, ownLabel)), std::string("the label map lies elsewhere: it reaches 2 voxels "
                                                              "beyond the scan"));
    }

    void aFlatGridIsRefused() {
        VolumeGeometry flat = scanGrid();
        flat.patientFromIndex[2] = flat.patientFromIndex[1];
        QCOMPARE(refusal(mapOn(flat, ownLabel)), std::string("the axes of the label map lie in one plane"));
    }

    /// Voxels of twice the edge: each of the scan's takes the label of the one that it lies in.
    void otherVoxelsAreResampledWhenAsked() {
        const VolumeGeometry scan = VolumeGeometry::aligned({6, 4, 2}, {1, 1, 1}, {0, 0, 0});
        const VolumeGeometry coarse = VolumeGeometry::aligned({3, 2, 1}, {2, 2, 2}, {0.5, 0.5, 0.5});
        const LabelMap map = mapOn(coarse, [](ivec3 at) { return std::uint8_t(1 + at.x + 3 * at.y); });
        const auto refused = labelsOn(scan, map, Resampling::refused);
        QVERIFY(!refused);
        QVERIFY(refused.error().what.starts_with("the label map has voxels of 2 x 2 x 2 mm, the scan of 1 x 1 x 1 mm"));
        const auto placed = labelsOn(scan, map, Resampling::nearest);
        QVERIFY(bool(placed));
        QCOMPARE(labelsOf(*placed),
                 labelsOf(mapOn(scan, [](ivec3 at) { return std::uint8_t(1 + at.x / 2 + 3 * (at.y / 2)); })));
        QCOMPARE(placed->notes.size(), std::size_t(1));
        QCOMPARE(partsMl(*placed), partsMl(map));
    }

    void volumesCountWholeVoxels() {
        const LabelMap map = mapOn(scanGrid(), [](ivec3 at) { return std::uint8_t(at.z < 2 ? 2 : 0); });
        const std::vector<double> ml = partsMl(map);
        QCOMPARE(ml[0], 0.0);
        QVERIFY(std::abs(ml[1] - 60 * 0.8 * 0.9 * 2.5 / 1000) < 1e-12);
    }

    void neighbouringColoursDiffer() {
        for (int part = 1; part < 255; ++part) {
            const LabelColour a = standardColour(part), b = standardColour(part + 1);
            int apart = 0;
            for (std::size_t i = 0; i < 3; ++i)
                apart = std::max(apart, std::abs(int(a[i]) - int(b[i])));
            QVERIFY2(apart > 60, std::to_string(part).c_str());
        }
    }
};

QTEST_APPLESS_MAIN(LabelFitTest)
#include "label_fit_test.moc"
