/// A whole volume in the image, and as large as possible.

#include <QTest>
#include <cmath>

#include "render/scene/fit_view.h"

namespace pdr {

/// Returns a flat, off-centre grid: 300 x 200 x 50 mm.
static VolumeGeometry slab() {
    return VolumeGeometry::aligned({100, 100, 20}, {3, 2, 2.5}, {-120, 40, 700});
}

/// Returns the largest |x| and |y| of the box's corners in the image, each in half its width or height.
static dvec2 reach(const Camera& camera, double aspect) {
    dvec2 reach(0);
    for (int i = 0; i < 8; ++i) {
        const dvec3 index = dvec3(i & 1, (i >> 1) & 1, i >> 2) * dvec3(slab().size) - 0.5;
        const dvec3 ray = dvec3(slab().patientFromIndex * dvec4(index, 1)) - camera.eyeMm;
        const double halfHeight = camera.type == Camera::Type::orthographic
                                      ? camera.heightMm / 2
                                      : glm::dot(ray, camera.forward()) * std::tan(glm::radians(camera.fovDegrees) / 2);
        const dvec2 seen(glm::dot(ray, camera.right()) / aspect, glm::dot(ray, camera.imageUp()));
        reach = glm::max(reach, glm::abs(seen) / halfHeight);
    }
    return reach;
}

class TestFitView : public QObject {
    Q_OBJECT

  private slots:
    void theBoxReachesTheMarginAndNotBeyond_data();
    void theBoxReachesTheMarginAndNotBeyond();
    void theDirectionStays();
    void whatIsSeenReachesTheMarginAndNotBeyond();
    void aScanIsSeenFromTheFrontAndFewSlicesFromWhereTheyAreWide();
};

void TestFitView::theBoxReachesTheMarginAndNotBeyond_data() {
    QTest::addColumn<int>("view");
    QTest::addColumn<double>("aspect");
    for (int view = 0; view < 6; ++view) {
        for (const double aspect : {0.5, 1.0, 2.2})
            QTest::addRow("view %d, aspect %g", view, aspect) << view << aspect;
    }
}

void TestFitView::theBoxReachesTheMarginAndNotBeyond() {
    QFETCH(int, view);
    QFETCH(double, aspect);
    Camera camera = standardView(StandardView(view), slab().centreMm(), slab().radiusMm(), aspect);
    for (const Camera::Type type : {Camera::Type::perspective, Camera::Type::orthographic}) {
        camera.type = type;
        const dvec2 farthest = reach(fittedView(camera, slab(), aspect, 0.9), aspect);
        QVERIFY2(std::abs(std::max(farthest.x, farthest.y) - 0.9) < 1e-9, qPrintable(QString::number(farthest.x)));
    }
}

void TestFitView::theDirectionStays() {
    const Camera camera = standardView(StandardView::left, slab().centreMm(), slab().radiusMm(), 1);
    const Camera fitted = fittedView(camera, slab(), 1, 0.9);
    QVERIFY(glm::length(fitted.forward() - camera.forward()) < 1e-12);
    QVERIFY(fitted.targetMm == camera.targetMm);
    QVERIFY(fitted.up == camera.up);
}

void TestFitView::whatIsSeenReachesTheMarginAndNotBeyond() {
    std::vector<dvec3> ball;  // as large as the slab is thin
    for (int i = 0; i < 1000; ++i) {
        const double z = (i + 0.5) / 500 - 1, turn = 2.4 * i;
        ball.push_back(slab().centreMm() +
                       25.0 * dvec3(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z));
    }
    const Framed framed{slab(), std::make_shared<const std::vector<dvec3>>(ball)};
    for (const StandardView view : {StandardView::anterior, StandardView::left, StandardView::inferior}) {
        const Camera camera = fittedView(view, framed, 1.5, 0.9);
        QVERIFY(glm::length(camera.targetMm - slab().centreMm()) < 1e-9);
        const double slope = 0.9 * std::tan(glm::radians(camera.fovDegrees) / 2);
        const double expected = 25 * std::sqrt(1 + 1 / (slope * slope));  // where the cone touches the ball
        QVERIFY(std::abs(glm::length(camera.eyeMm - camera.targetMm) / expected - 1) < 0.005);
        const Camera whole = fittedView(view, {slab(), nullptr}, 1.5, 0.9);
        QVERIFY(whole == fittedView(standardView(view, slab().centreMm(), slab().radiusMm(), 1.5), slab(), 1.5, 0.9));
    }
}

void TestFitView::aScanIsSeenFromTheFrontAndFewSlicesFromWhereTheyAreWide() {
    const auto stack = [](dvec3 row, dvec3 column, dvec3 normal, int slices) {
        VolumeGeometry geometry{{100, 100, slices}, dmat4(1)};
        geometry.patientFromIndex[0] = dvec4(row * 3.0, 0);
        geometry.patientFromIndex[1] = dvec4(column * 2.0, 0);
        geometry.patientFromIndex[2] = dvec4(normal * 2.5, 0);
        return firstView(geometry);
    };
    const dvec3 left(1, 0, 0), back(0, 1, 0), head(0, 0, 1);
    QVERIFY(stack(left, back, head, 80) == StandardView::anterior);
    QVERIFY(stack(left, back, head, 30) == StandardView::anterior);
    QVERIFY(stack(left, back, head, 20) == StandardView::inferior);
    QVERIFY(stack(left, -back, -head, 2) == StandardView::inferior);
    QVERIFY(stack(back, -head, -left, 20) == StandardView::left);
    QVERIFY(stack(left, -head, back, 20) == StandardView::anterior);
    const dvec3 tilted = glm::normalize(dvec3(0, 0.4, 1));
    QVERIFY(stack(left, glm::normalize(dvec3(0, 1, -0.4)), tilted, 20) == StandardView::inferior);
}

}  // namespace pdr

QTEST_GUILESS_MAIN(pdr::TestFitView)
#include "fit_view_test.moc"
