#include <QTest>

#include "render/segment/shells.h"
#include "tests/support/scenes/vessel_phantoms.h"

using namespace pdr;
using namespace pdr::segment;

namespace {

double radiusOf(const LabelMap& map, ivec3 at) {
    const dvec3 mm(map.geometry.patientFromIndex * dvec4(at, 1));
    return std::hypot(mm.x, mm.y);
}

/// Returns the share of the voxels from `fromMm` to `toMm` of the trunk's axis, before the spine, with this label.
double shareBetween(const LabelMap& map, double fromMm, double toMm, std::uint8_t label) {
    double all = 0, with = 0;
    std::size_t index = 0;
    for (int z = 0; z < map.geometry.size.z; ++z)
        for (int y = 0; y < map.geometry.size.y; ++y)
            for (int x = 0; x < map.geometry.size.x; ++x, ++index) {
                const double radius = radiusOf(map, {x, y, z});
                if (radius < fromMm || radius > toMm || (map.geometry.patientFromIndex * dvec4(x, y, z, 1)).y > 5)
                    continue;
                ++all;
                with += map.labels[index] == label;
            }
    return with / all;
}

}  // namespace

/// Skin lies around, and muscle below it, where no other part is. The trunk's radius is 45 mm.
class ShellsTest : public QObject {
    Q_OBJECT

  private slots:
    void skinLiesAroundMuscle() {
        const auto map = findShells(test::scanOf({{}, {}, 0, test::trunkHu}), nullptr, noProgress);
        QVERIFY2(bool(map), map ? "" : map.error().text().c_str());
        QVERIFY(shareBetween(*map, 46.5, 60, 1) < 0.01);
        QVERIFY(shareBetween(*map, 43.8, 44.2, 1) > 0.9);
        QVERIFY(shareBetween(*map, 0, 41.5, 1) < 0.01);
        QVERIFY(shareBetween(*map, 0, 41.5, 2) > 0.99);
        QVERIFY(shareBetween(*map, 44.5, 60, 2) < 0.01);
    }

    void boneIsNoMuscle() {
        const auto map = findShells(test::scanOf({{}, {}, 0, test::trunkHu}), nullptr, noProgress);
        QVERIFY(bool(map));
        std::size_t inSpine = 0, muscle = 0, index = 0;
        for (int z = 0; z < map->geometry.size.z; ++z)
            for (int y = 0; y < map->geometry.size.y; ++y)
                for (int x = 0; x < map->geometry.size.x; ++x, ++index) {
                    const dvec3 mm(map->geometry.patientFromIndex * dvec4(x, y, z, 1));
                    if (std::hypot(mm.x, mm.y - 28) > 14)
                        continue;
                    ++inSpine;
                    muscle += map->labels[index] == 2;
                }
        QVERIFY(inSpine > 10000);
        QVERIFY(muscle * 100 < inSpine);
    }

    void voxelsOfOtherPartsStayFree() {
        const Volume scan = test::scanOf({{}, {}, 0, test::trunkHu});
        LabelMap taken;
        taken.geometry = scan.geometry();
        for (std::size_t i = 0; i < scan.voxels().size(); ++i)
            taken.labels.push_back(std::uint8_t(i % 2));
        const auto map = findShells(scan, &taken, noProgress), whole = findShells(scan, nullptr, noProgress);
        QVERIFY(map && whole);
        for (std::size_t i = 0; i < scan.voxels().size(); ++i)
            QCOMPARE(map->labels[i], i % 2 ? std::uint8_t(0) : whole->labels[i]);
    }

    void theSearchIsCancelled() {
        const Volume scan = test::scanOf({{}, {}, 0, test::trunkHu});
        const auto never = findShells(scan, nullptr, [](double, std::string_view) { return false; });
        QVERIFY(!never);
        QCOMPARE(never.error().kind, ErrorKind::cancelled);
        const auto late = findShells(scan, nullptr, [](double done, std::string_view) { return done < 0.75; });
        QVERIFY(!late);
        QCOMPARE(late.error().kind, ErrorKind::cancelled);
    }
};

QTEST_APPLESS_MAIN(ShellsTest)
#include "shells_test.moc"
