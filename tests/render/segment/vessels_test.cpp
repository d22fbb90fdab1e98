#include <tbb/global_control.h>

#include <QTest>

#include <array>

#include "render/segment/vessels.h"
#include "tests/support/scenes/vessel_phantoms.h"

using namespace pdr;
using namespace pdr::segment;

namespace {

/// How well the vessels that were found are those of the phantom.
struct Score {
    double pools = 0, branches = 0;  ///< shares of their voxels that were found
    double wrong =
        0;  ///< voxels that were found outside, but for those that touch a vessel, as a share of all vessels'
};

Score scoreOf(const LabelMap& map, const test::VesselPhantom& phantom) {
    std::array<double, 2> truth{}, found{};  // pools, branches
    double wrong = 0;
    std::size_t index = 0;
    for (int z = 0; z < map.geometry.size.z; ++z)
        for (int y = 0; y < map.geometry.size.y; ++y)
            for (int x = 0; x < map.geometry.size.x; ++x, ++index) {
                const auto at = [&](double dx, double dy, double dz) {
                    return dvec3(map.geometry.patientFromIndex * dvec4(x + dx, y + dy, z + dz, 1));
                };
                const auto isNear = [&] {
                    bool is = false;
                    for (int side = 0; side < 27; ++side)
                        is = is || phantom.isVessel(at(side % 3 - 1, side / 3 % 3 - 1, side / 9 - 1));
                    return is;
                };
                if (phantom.isVessel(at(0, 0, 0))) {
                    const std::size_t kind = phantom.isPool(at(0, 0, 0)) ? 0 : 1;
                    ++truth[kind];
                    found[kind] += map.labels[index];
                } else if (map.labels[index] == 1) {
                    wrong += isNear() ? 0 : 1;
                }
            }
    return {found[0] / truth[0], found[1] / truth[1], wrong / (truth[0] + truth[1])};
}

std::vector<std::uint8_t> labelsWith(const Volume& scan, std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const auto map = findVessels(scan, noProgress);
    return map ? std::vector<std::uint8_t>(map->labels.begin(), map->labels.end()) : std::vector<std::uint8_t>();
}

}  // namespace

/// Vessels with contrast medium are found and told from bone, and where that cannot be, it is said.
class VesselsTest : public QObject {
    Q_OBJECT

  private slots:
    void vesselsAreToldFromBone_data() {
        QTest::addColumn<int>("number");
        QTest::addColumn<double>("branches");
        QTest::newRow("aorta beside the spine") << 0 << 0.98;
        QTest::newRow("artery along bone") << 1 << 0.94;
        QTest::newRow("vessels in the lungs") << 2 << 0.8;
        QTest::newRow("vein full of undiluted medium") << 3 << 0.98;
    }
    void vesselsAreToldFromBone() {
        QFETCH(int, number);
        QFETCH(double, branches);
        const test::VesselPhantom phantom = number == 0   ? test::aortaBesideSpine()
                                            : number == 1 ? test::arteryAlongBone()
                                            : number == 2 ? test::lungVessels()
                                                          : test::undilutedVein();
        const auto map = findVessels(test::scanOf(phantom), noProgress);
        QVERIFY2(bool(map), map ? "" : map.error().text().c_str());
        const Score score = scoreOf(*map, phantom);
        qInfo("pools %.4f, branches %.4f, wrong %.4f", score.pools, score.branches, score.wrong);
        QVERIFY(score.pools >= 0.98);
        QVERIFY(score.branches >= branches);
        QVERIFY(score.wrong <= 0.004);
        QCOMPARE(map->parts.size(), std::size_t(1));
        QVERIFY(map->notes.front().starts_with("vessels are guessed"));
    }

    void threadsDoNotMatter() {
        const Volume scan = test::scanOf(test::arteryAlongBone());
        const std::vector<std::uint8_t> one = labelsWith(scan, 1);
        QVERIFY(!one.empty());
        QCOMPARE(labelsWith(scan, 2), one);
        QCOMPARE(labelsWith(scan, 7), one);
    }

    /// Without contrast medium the same trunk has no vessels, and neither have values that are no HU.
    void withoutContrastMediumNoneAreFound() {
        const auto map = findVessels(test::scanOf({{}, {}, 0, test::trunkHu}), noProgress);
        QVERIFY(!map);
        QCOMPARE(map.error().kind, ErrorKind::refused);
        QCOMPARE(std::string(map.error().what),
                 std::string("vessels cannot be found, because no contrast medium is found in the blood"));
    }

    void theSearchIsCancelled() {
        const Volume scan = test::scanOf(test::aortaBesideSpine());
        int calls = 0;
        QVERIFY(bool(findVessels(scan, [&](double, std::string_view) { return ++calls > 0; })));
        QVERIFY(calls > 20);
        for (int last = 0; last < calls; last += 1 + calls / 8) {
            int now = 0;
            const auto map = findVessels(scan, [&](double, std::string_view) { return now++ < last; });
            if (!map)
                QCOMPARE(map.error().kind, ErrorKind::cancelled);
        }
        const auto never = findVessels(scan, [](double, std::string_view) { return false; });
        QVERIFY(!never);
        QCOMPARE(never.error().kind, ErrorKind::cancelled);
    }
};

QTEST_APPLESS_MAIN(VesselsTest)
#include "vessels_test.moc"
