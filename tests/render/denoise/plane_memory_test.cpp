/// What planes leave is used again, within a limit.

#include <QTest>

#include "render/denoise/plane.h"

using namespace pdr;
using namespace pdr::denoise;

namespace {

constexpr ivec2 kSize{500, 300};

}  // namespace

class PlaneMemoryTest : public QObject {
    Q_OBJECT

  private slots:
    void whatAPlaneLeavesIsTheNextOnes() {
        const float* first = nullptr;
        {
            const Plane plane(kSize);
            first = plane.row(0);
        }
        QVERIFY(keptForPlanes() > 0);
        const Plane same = Plane::unset(kSize);
        QCOMPARE(same.row(0), first);
        QCOMPARE(keptForPlanes(), std::size_t(0));
    }

    /// A plane of zeros is one even where another has left its values.
    void zerosAreZeros() {
        {
            Plane plane(kSize);
            plane.row(7)[9] = 4711;
        }
        const Plane zeros(kSize);
        for (int y = -Plane::kBorder; y < kSize.y + Plane::kBorder; ++y)
            for (int x = -Plane::kBorder; x < kSize.x + Plane::kBorder; ++x)
                QCOMPARE(zeros.row(y)[x], 0.0f);
    }

    void noMoreIsKeptThanTheLimit() {
        { const std::vector<Plane> many(80, Plane(kSize)); }
        QVERIFY(keptForPlanes() > kMostKeptBytes / 2 && keptForPlanes() <= kMostKeptBytes);
        { const Plane large({4000, 3000}); }
        QVERIFY(keptForPlanes() <= kMostKeptBytes);
        dropKeptForPlanes();
        QCOMPARE(keptForPlanes(), std::size_t(0));
    }
};

QTEST_GUILESS_MAIN(PlaneMemoryTest)
#include "plane_memory_test.moc"
