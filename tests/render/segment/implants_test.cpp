#include <QTest>

#include "render/segment/body_mask.h"
#include "render/segment/implants.h"
#include "tests/support/scenes/vessel_phantoms.h"

using namespace pdr;
using namespace pdr::segment;

namespace {

/// A trunk with a rod of 3 mm radius of that density across it, and one voxel's crumb of it elsewhere.
Volume scanWith(double rodHu) {
    test::VesselPhantom trunk{{}, {}, 0, [rodHu](dvec3 mm) {
                                  if (test::distanceFromWay(mm, {-25, -10, 30}, {25, -10, 60}) < 3)
                                      return rodHu;
                                  if (glm::length(mm - dvec3(0, 15, 80)) < 0.7)
                                      return rodHu;
                                  return test::trunkHu(mm);
                              }};
    return test::scanOf(trunk);
}

/// A trunk with one voxel of metal in each of `count` neighbouring cells of 2 mm.
Volume scanWithMetalIn(int count, const CellGrid& grid) {
    const Volume bare = scanWith(50);
    Voxels voxels(bare.voxels().begin(), bare.voxels().end());
    const ivec3 size = bare.size(), middle = size / 2 / grid.block * grid.block;
    for (int cell = 0; cell < count; ++cell)
        voxels[(std::size_t(middle.z) * size.y + middle.y) * size.x + middle.x + std::size_t(cell) * grid.block.x] =
            3000;
    return Volume(bare.geometry(), std::move(voxels));
}

}  // namespace

/// Metal is told from bone by its density.
class ImplantsTest : public QObject {
    Q_OBJECT

  private slots:
    void aRodIsFound() {
        const Volume scan = scanWith(3000);
        const auto found = findImplants(scan, noProgress);
        QVERIFY2(bool(found), found ? "" : found.error().text().c_str());
        QCOMPARE(found->parts[0].name, std::string("implant"));
        double in = 0, hits = 0, elsewhere = 0;
        std::size_t index = 0;
        for (int z = 0; z < scan.size().z; ++z)
            for (int y = 0; y < scan.size().y; ++y)
                for (int x = 0; x < scan.size().x; ++x, ++index) {
                    const dvec3 mm(scan.geometry().patientFromIndex * dvec4(x, y, z, 1));
                    const double from = test::distanceFromWay(mm, {-25, -10, 30}, {25, -10, 60});
                    in += from < 2.5;
                    hits += from < 2.5 && found->labels[index] == 1;
                    elsewhere += from > 3.6 && found->labels[index] != 0;
                }
        QVERIFY2(in > 500 && hits == in && elsewhere == 0,
                 qPrintable(QString("%1 of %2, %3 elsewhere").arg(hits).arg(in).arg(elsewhere)));
    }

    /// A piece counts from 0.05 ml of cells on.
    void piecesOfLessAreLeftOut() {
        const auto body = bodyMask(scanWith(50), noProgress);
        QVERIFY(bool(body));
        const CellGrid& grid = body->grid;
        const int enough = int(std::ceil(0.05 / grid.cellMl()));
        QVERIFY(enough > 2 && enough < 20);
        QVERIFY(!findImplants(scanWithMetalIn(enough - 1, grid), noProgress));
        const auto found = findImplants(scanWithMetalIn(enough, grid), noProgress);
        QVERIFY2(bool(found), found ? "" : found.error().text().c_str());
        QCOMPARE(std::ranges::count(found->labels, 1), std::ptrdiff_t(enough));
    }

    void boneIsNoMetal() {
        const auto found = findImplants(scanWith(1800), noProgress);
        QVERIFY(!found && found.error().kind == ErrorKind::refused);
        QVERIFY2(found.error().what.find("no metal") != std::string::npos, found.error().text().c_str());
    }

    void theSearchIsCancelled() {
        for (const double at : {0.0, 0.55}) {
            const auto found = findImplants(scanWith(3000), [at](double done, std::string_view) { return done < at; });
            QVERIFY(!found);
            QCOMPARE(found.error().kind, ErrorKind::cancelled);
        }
    }
};

QTEST_APPLESS_MAIN(ImplantsTest)
#include "implants_test.moc"
