/// Lines drawn on an image cut what lies behind them: in perspective a cone, in a parallel view a prism.

#include "render/prepare/freehand_mask.h"

#include <QTest>

#include "render/scene/edit/view_geometry.h"
#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

/// A circle around the middle of the image.
FreehandCut circle(const Camera& camera, double radius, bool keepInside) {
    FreehandCut cut{camera, {}, keepInside};
    for (int i = 0; i < 180; ++i)
        cut.outline.push_back({radius * std::cos(2 * M_PI * i / 180), radius * std::sin(2 * M_PI * i / 180)});
    return cut;
}

/// A block 120 mm wide, with voxels of 2 mm and its corner at the origin; aslant() views it from the front and above.
std::shared_ptr<const Volume> block() {
    return test::makeVolume({60, 60, 60}, dvec3(2), [](int, int, int) { return 100; });
}

Camera aslant(Camera::Type type) {
    return {.type = type, .eyeMm = {20, -160, 110}, .targetMm = {60, 60, 60}, .fovDegrees = 40, .heightMm = 160};
}

}  // namespace

class FreehandMaskTest : public QObject {
    Q_OBJECT

  private slots:
    void whatLiesBehindTheLineIsCutAway_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<bool>("keepInside");
        QTest::newRow("cone away") << int(Camera::Type::perspective) << false;
        QTest::newRow("cone kept") << int(Camera::Type::perspective) << true;
        QTest::newRow("prism away") << int(Camera::Type::orthographic) << false;
        QTest::newRow("prism kept") << int(Camera::Type::orthographic) << true;
    }
    /// A place's distance from the axis of view tells which: to the radius that the circle has at its depth.
    void whatLiesBehindTheLineIsCutAway() {
        QFETCH(int, type);
        QFETCH(bool, keepInside);
        const Camera camera = aslant(Camera::Type(type));
        const auto volume = block();
        const auto mask = freehandMask({circle(camera, 0.2, keepInside)}, volume->geometry());
        const ViewGeometry view(camera, 1);
        int in = 0, out = 0;
        for (int i = 0; i < 20 * 20 * 20; ++i) {
            const dvec3 index = dvec3(i % 20, i / 20 % 20, i / 400) * 3.0;
            const dvec3 place(volume->geometry().patientFromIndex * dvec4(index, 1)), away = place - camera.eyeMm;
            const double fromAxis = glm::length(away - camera.forward() * glm::dot(away, camera.forward()));
            const double inside = 0.2 * view.heightMm(place) - fromAxis;
            if (std::fabs(inside) < Mask::kEdgeMm + 1)
                continue;
            QCOMPARE(mask->at(index), (inside > 0) == keepInside ? 1.0 : 0.0);
            ++(inside > 0 ? in : out);
        }
        QVERIFY(in > 500 && out > 500);
    }

    void nothingBehindTheEyeIsInside() {
        const auto volume = block();
        const Camera within{.eyeMm = {60, 60, 60}, .targetMm = {60, 100, 60}, .fovDegrees = 60};
        const auto removed = freehandMask({circle(within, 0.3, false)}, volume->geometry());
        QCOMPARE(removed->at({30, 50, 30}), 0.0);
        QCOMPARE(removed->at({30, 5, 30}), 1.0);
        const auto kept = freehandMask({circle(within, 0.3, true)}, volume->geometry());
        QCOMPARE(kept->at({30, 50, 30}), 1.0);
        QCOMPARE(kept->at({30, 5, 30}), 0.0);
    }

    void severalLinesCutTogether() {
        const auto volume = block();
        const Camera camera = aslant(Camera::Type::orthographic);
        const auto rim = freehandMask({circle(camera, 0.3, true), circle(camera, 0.15, false)}, volume->geometry());
        const ViewGeometry view(camera, 1);
        const auto at = [&](double x) {
            const SightLine line = view.under({0.5 + x, 0.5});
            const dvec3 place = line.originMm + line.direction * glm::dot(dvec3(60) - line.originMm, line.direction);
            return rim->at(dvec3(glm::inverse(volume->geometry().patientFromIndex) * dvec4(place, 1)));
        };
        QCOMPARE(at(0), 0.0);
        QCOMPARE(at(0.22), 1.0);
        QCOMPARE(at(0.36), 0.0);
        QVERIFY(freehandMask({}, volume->geometry()) == nullptr);
    }

    /// Where tissue was cut away, the image shows what is behind: nothing; beside the cut it stays as it was.
    void theImageShowsTheCut() {
        Scene scene = test::plainScene(block(), 1);
        scene.camera = aslant(Camera::Type::orthographic);
        scene.environment = {vec3(0.25f), true};
        scene.film = {64, 64};
        const Film before = test::render(scene, 16);
        scene.clip.freehand = {circle(scene.camera, 0.15, false)};
        const Film after = test::render(scene, 16);
        QCOMPARE(after.pixel(32, 32).mean.x, 0.25);
        QVERIFY(before.pixel(32, 32).mean.x != 0.25);
        QCOMPARE(after.pixel(2, 2).mean.x, before.pixel(2, 2).mean.x);
    }

    /// What did not change is not made again: not by another camera, nor by another curve.
    void theMaskIsMadeOnce() {
        Scene scene = test::plainScene(block(), 1);
        scene.clip.freehand = {circle(aslant(Camera::Type::perspective), 0.2, false)};
        Flattener flattener;
        const auto first = flattener.prepare(scene);
        scene.camera.eyeMm.x += 5;
        scene.transferFunction.extinctionPerMm = 2;
        QCOMPARE(flattener.prepare(scene)->mask, first->mask);
        scene.clip.freehand[0].keepInside = true;
        const auto other = flattener.prepare(scene);
        QVERIFY(other->mask != first->mask);
        scene.clip.freehand.clear();
        QVERIFY(flattener.prepare(scene)->mask == nullptr);
    }
};

QTEST_GUILESS_MAIN(FreehandMaskTest)
#include "freehand_mask_test.moc"
