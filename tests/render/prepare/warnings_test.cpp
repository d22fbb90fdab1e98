#include <QTest>

#include "render/prepare/warnings.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

/// Voxels of 1 x 1 x 2 mm, HU 0 to 1000, multiple scattering.
Scene dense(float extinctionPerMm) {
    Scene scene = test::plainScene(
        test::makeVolume({8, 8, 8}, {1, 1, 2}, [](int i, int, int) { return i < 4 ? 0 : 1000; }), extinctionPerMm);
    scene.model = Model::multipleScattering;
    return scene;
}

bool isOverDense(const Scene& scene) {
    const std::vector<Warning> found = warnings(scene);
    return found.size() == 1 && found[0].name == "overDense";
}

}  // namespace

class WarningsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Free paths are counted along the largest spacing, from the scene alone.
    void moreThanAThousandFreePathsAVoxelAreTold() {
        QVERIFY(warnings(dense(500)).empty());
        QVERIFY(isOverDense(dense(501)));
        QVERIFY(warnings(dense(1000))[0].text.starts_with("2e+03 free paths between voxels"));
        QCOMPARE(warningNames(warnings(dense(501))), std::string("overDense"));
        QCOMPARE(warningNames({}), std::string());
    }

    void onlyMultipleScatteringMinds() {
        Scene scene = dense(501);
        scene.maxBounces = 1;
        QVERIFY(warnings(scene).empty());
        for (const Model model : kModels) {
            scene = dense(501);
            scene.model = model;
            QCOMPARE(isOverDense(scene), model == Model::multipleScattering);
        }
    }

    void onlyTissueThatTheVolumeHoldsCounts() {
        Scene scene = dense(1e6f);
        scene.transferFunction.nodes = {{.hu = 2000, .opacity = 0}, {.hu = 2001, .opacity = 1}};
        QVERIFY(warnings(scene).empty());
        scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 1000, .opacity = 0.0004f}};
        QVERIFY(warnings(scene).empty());
        scene.transferFunction.nodes[1].opacity = 0.0006f;
        QVERIFY(isOverDense(scene));
        scene.volume = nullptr;
        QVERIFY(warnings(scene).empty());
    }
};

QTEST_APPLESS_MAIN(WarningsTest)
#include "warnings_test.moc"
