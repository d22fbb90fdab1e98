/// Planes in another size keep their light, and straight slopes.

#include <QTest>

#include "render/denoise/resampled.h"

using namespace pdr;
using denoise::meanOf;
using denoise::Plane;

namespace {

Plane planeOf(ivec2 size, const std::function<double(int, int)>& value) {
    Plane plane(size);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            plane.row(y)[x] = float(value(x, y));
    plane.mirror();
    return plane;
}

}  // namespace

class ResampledTest : public QObject {
    Q_OBJECT

  private slots:
    void aPixelIsTheMeanOfItsPart() {
        const Plane fine = planeOf({12, 8}, [](int x, int y) { return x * x + 3 * y; });
        const Plane coarse = denoise::reduced(fine, {4, 2});
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 4; ++x) {
                double sum = 0;
                for (int v = 4 * y; v < 4 * y + 4; ++v)
                    for (int u = 3 * x; u < 3 * x + 3; ++u)
                        sum += double(fine.row(v)[u]);
                QVERIFY(std::fabs(double(coarse.row(y)[x]) - sum / 12) < 1e-5);
            }
    }

    /// Sizes need not divide each other: all pixels count, and no value lies outside the plane's.
    void anySizeWillDo() {
        const Plane fine = planeOf({447, 65}, [](int x, int y) { return 1 + (x + y) % 3; });
        for (const ivec2 size : {ivec2(1, 1), ivec2(111, 16), ivec2(446, 64), ivec2(447, 65)}) {
            QVERIFY(std::fabs(meanOf(denoise::reduced(fine, size)) - 2) < 0.02);
            QVERIFY(std::fabs(meanOf(denoise::enlarged(denoise::reduced(fine, size), fine.size())) - 2) < 0.02);
        }
    }

    /// Both sizes show the same view, from edge to edge.
    void aSlopeStaysWhereItIs() {
        const auto slope = [](double width) { return [=](int x, int y) { return (x + 0.5) / width + 0 * y; }; };
        const Plane large = denoise::enlarged(planeOf({37, 5}, slope(37)), {447, 60});
        for (int x = 10; x < 437; ++x)  // the outermost half pixels have no slope
            QVERIFY(std::fabs(double(large.row(30)[x]) - (x + 0.5) / 447) < 1e-5);
        const Plane small = denoise::reduced(planeOf({447, 60}, slope(447)), {37, 5});
        for (int x = 0; x < 37; ++x)
            QVERIFY(std::fabs(double(small.row(2)[x]) - (x + 0.5) / 37) < 1.0 / 447);
    }

    void theSameSizeChangesNothing() {
        const Plane plane = planeOf({21, 9}, [](int x, int y) { return x * 7 % 5 + y; });
        for (const Plane& same : {denoise::reduced(plane, {21, 9}), denoise::enlarged(plane, {21, 9})})
            for (int y = 0; y < 9; ++y)
                for (int x = 0; x < 21; ++x)
                    QCOMPARE(same.row(y)[x], plane.row(y)[x]);
    }
};

QTEST_GUILESS_MAIN(ResampledTest)
#include "resampled_test.moc"
