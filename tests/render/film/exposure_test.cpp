/// Tests the exposure that suits an image.

#include <QTest>

#include "render/film/display/exposure.h"
#include "render/film/display/tone_map.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

/// A slab that glows with that radiance, in front of nothing.
Film glowing(float radiance) {
    Scene scene = test::plainScene(test::makeVolume({4, 4, 4}, dvec3(10), [](int, int, int) { return 100; }), 50);
    scene.model = Model::emissionAbsorption;
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 1, .albedo = vec3(0), .emission = vec3(radiance)}};
    return test::render(scene, 4);
}

int levelAfter(float radiance, double exposure, double stops) {
    return displayLevel(double(radiance), {float(exposure * std::exp2(-stops))});
}

}  // namespace

class ExposureTest : public QObject {
    Q_OBJECT

  private slots:
    void anImageThatIsWellLitStays() {
        for (const float radiance : {0.05f, 0.2f, 0.3f})
            QCOMPARE(stopsFor(glowing(radiance), 1), 0.0);
    }

    void darkAndBlownOutImagesComeBack() {
        for (const float radiance : {0.001f, 0.01f, 2.0f, 4.0f}) {
            const double stops = stopsFor(glowing(radiance), 1);
            QVERIFY(radiance < 1 ? stops > 0 : stops < 0);
            QCOMPARE(stops * 10, std::round(stops * 10));
            if (std::abs(stops) < 4) {
                const int level = levelAfter(radiance, 1, stops);
                QVERIFY2(level > 45 && level < 156, qPrintable(QString::number(level)));
            }
        }
    }

    void theExposureCountsAsLightDoes() {
        QCOMPARE(stopsFor(glowing(0.01f), 1), stopsFor(glowing(0.04f), 4));
        QCOMPARE(stopsFor(glowing(1e-9f), 1), 4.0);
    }

    void nothingNeedsNoLight() {
        Scene scene = test::plainScene(test::makeVolume({4, 4, 4}, dvec3(10), [](int, int, int) { return -1000; }), 1);
        scene.transferFunction.nodes = {{.hu = -500, .opacity = 0}};
        QCOMPARE(stopsFor(test::render(scene, 4), 1), 0.0);
        QCOMPARE(stopsFor(glowing(0), 1), 0.0);
    }
};

QTEST_APPLESS_MAIN(ExposureTest)
#include "exposure_test.moc"
