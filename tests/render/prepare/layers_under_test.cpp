/// What is seen under a point of the image: a place, a choice, fog, nothing or all depths, on plates, fog and a ball
/// whose light is known by formula.

#include "render/prepare/layers_under.h"

#include <QTest>

#include "render/prepare/layers_text.h"
#include "tests/support/scenes/masks.h"
#include "tests/support/scenes/plates.h"

using namespace pdr;
using test::depthFor;

namespace {

constexpr vec2 kMiddle(4.5f, 4.5f);

LayersUnder seen(const Scene& scene, vec2 place = kMiddle) {
    return layersUnder(*test::prepared(scene), place);
}

bool near(double value, double truth, double allowed = 1e-3) {
    return std::fabs(value - truth) < allowed;
}

/// Makes 8 x 8 x 200 voxels of even tissue, `spacing` mm apart, seen as platesScene() is.
Scene even(double extinctionPerMm, double spacing) {
    Scene scene = test::platesScene({}, spacing);
    scene.transferFunction = {float(extinctionPerMm), {{.hu = 0, .opacity = 1}}};
    return scene;
}

/// A ball of 20 mm about (30, 30, 30) in air, nearly opaque from its edge on, seen along -z; a pixel is 0.5 mm wide.
Scene ball() {
    Scene scene = test::plainScene(
        test::makeVolume({60, 60, 60}, dvec3(1),
                         [](int i, int j, int k) { return 500 * (20 - glm::length(dvec3(i, j, k) - 29.5)); }),
        50);
    scene.transferFunction.nodes = {{.hu = -10, .opacity = 0}, {.hu = 10, .opacity = 1}};
    scene.camera = {.type = Camera::Type::orthographic,
                    .eyeMm = {30, 30, 200},
                    .targetMm = {30, 30, 0},
                    .up = {0, 1, 0},
                    .heightMm = 60};
    scene.film = {120, 120};
    return scene;
}

/// Returns what is seen of ball() `mm` to the right of its middle.
LayersUnder besideItsMiddle(double mm) {
    return seen(ball(), vec2(float(60 + 2 * mm), 60));
}

}  // namespace

class LayersUnderTest : public QObject {
    Q_OBJECT

  private slots:
    void aPlateIsAPlace();
    void ofTwoPlatesOneIsChosen();
    void theHeavierHalfIsThePlace();
    void sharesAreOfAllLight();
    void whatNothingStopsInIsFog();
    void whatPassesIsNothing();
    void theWindowIsAsWideAsTheVoxels();
    void aLayerWithoutItsLightAtThePlaceIsNone();
    void aSilhouetteIsMarked();
    void whatIsCutAwayIsNotSeen();
    void whatIsMaskedIsNotSeen();
    void aLensMakesAPlaceUncertainAcross();
    void sumsHaveNoPlaces();
    void theHighestIsThePlaceOfAProjection();
};

void LayersUnderTest::aPlateIsAPlace() {
    const LayersUnder under = seen(test::platesScene({{100, 3}}));
    QVERIFY(under.seen == SeenAt::place && under.layers.size() == 1);
    const SeenLayer& layer = under.layers[0];
    const double share = -std::expm1(-3.0);
    QVERIFY(near(layer.share, share) && near(under.met, share));
    const double height = test::heightOf(100) + test::frontOf(3, 0.5);
    QVERIFY(near(layer.placeMm.z, height) && near(layer.placeMm.x, 2.25) && near(layer.placeMm.y, 1.75));
    QVERIFY(near(layer.depthMm, 1100 - height));
    QVERIFY(near(layer.sigmaAlongMm, (test::frontOf(3, 0.16) - test::frontOf(3, 0.84)) / 2));
    QVERIFY(near(layer.sigmaAcrossMm, 0.5 / std::sqrt(12.0)));
    QVERIFY(!layer.onSilhouette && layersText(under).empty());
    QVERIFY(glm::distance(under.direction, dvec3(0, 0, -1)) < 1e-6);
}

void LayersUnderTest::ofTwoPlatesOneIsChosen() {
    const double front = 0.35, back = 0.4;
    const LayersUnder under = seen(test::platesScene({{150, depthFor(front)}, {60, depthFor(back, front)}}));
    QVERIFY(under.seen == SeenAt::choice && under.layers.size() == 2);
    QVERIFY(near(under.layers[0].share, front) && near(under.layers[1].share, back));  // nearest first
    QVERIFY(near(under.layers[0].placeMm.z, test::heightOf(150) + test::frontOf(depthFor(front), 0.5)));
    QVERIFY(near(under.layers[1].placeMm.z, test::heightOf(60) + test::frontOf(depthFor(back, front), 0.5)));
    QVERIFY(under.heaviest() == &under.layers[1]);
    QCOMPARE(layersText(under), "the light here stops at 2 depths: the one with the most, 40 %, was taken");
}

void LayersUnderTest::theHeavierHalfIsThePlace() {
    const double front = 0.3, back = 0.6;
    const LayersUnder under = seen(test::platesScene({{150, depthFor(front)}, {60, depthFor(back, front)}}));
    QVERIFY(under.seen == SeenAt::place && under.layers.size() == 1);
    QVERIFY(near(under.layers[0].share, back) && near(under.layers[0].placeMm.z, test::heightOf(60), 0.5));
}

/// All the light that stops does so in one plate, but most of the light passes.
void LayersUnderTest::sharesAreOfAllLight() {
    const LayersUnder under = seen(test::platesScene({{100, depthFor(0.3)}}));
    QVERIFY(under.seen == SeenAt::choice && under.layers.size() == 1 && near(under.layers[0].share, 0.3));
    QCOMPARE(layersText(under), "only 30 % of the light here stops at one depth, which was taken");
}

void LayersUnderTest::whatNothingStopsInIsFog() {
    const LayersUnder under = seen(even(0.05, 0.5));  // of 100 mm, whose first 2 mm hold 9.5 %
    QVERIFY(under.seen == SeenAt::fog && under.layers.empty() && !under.heaviest());
    const double met = -std::expm1(-5.0);
    QVERIFY(near(under.met, met) && near(under.spreadMm, 20 * std::log((1 - 0.1 * met) / (1 - 0.9 * met)), 0.01));
    QCOMPARE(layersText(under), "what is seen here is spread over 43 mm of depth: too translucent to be one place");
}

void LayersUnderTest::whatPassesIsNothing() {
    const LayersUnder faint = seen(test::platesScene({{100, depthFor(0.12)}}));
    QVERIFY(faint.seen == SeenAt::nothing && faint.layers.empty() && near(faint.met, 0.12));
    QCOMPARE(layersText(faint), "no tissue at this point: 88 % of the light passes");
    for (const vec2 outside : {vec2(-1, 4), vec2(4, -0.5f), vec2(8, 4), vec2(4, 9)}) {
        const LayersUnder under = seen(test::platesScene({{100, 3}}), outside);
        QVERIFY(under.seen == SeenAt::nothing && under.layers.empty());
    }
}

/// In voxels of 4 mm a plate stops its light over 4 mm or so: no 2 mm hold half of it, but 6 mm do.
void LayersUnderTest::theWindowIsAsWideAsTheVoxels() {
    const LayersUnder under = seen(test::platesScene({{100, 2}}, 4));
    QVERIFY(under.seen == SeenAt::place && under.layers[0].share > 0.75);
    QVERIFY(seen(test::platesScene({{100, 2}, {104, 0.05}}, 0.5)).layers[0].share > 0.8);  // 1 mm in front
}

/// The first 6 mm hold 20 % of the light, but no 2 mm of them more than 7 %.
void LayersUnderTest::aLayerWithoutItsLightAtThePlaceIsNone() {
    QVERIFY(seen(even(-std::log(0.8) / 6, 4)).seen == SeenAt::fog);
}

/// The ball's surface is known, so its depth around a point is, too. 0.2 mm inside its rim the depth changes by 5.3 mm
/// on 1.5 mm; in the middle by 0.06 mm.
void LayersUnderTest::aSilhouetteIsMarked() {
    for (const double mm : {0.0, 5.0, 10.0, 14.0}) {
        const LayersUnder under = besideItsMiddle(mm);
        QVERIFY(under.seen == SeenAt::place && !under.layers[0].onSilhouette);
        QVERIFY(near(under.layers[0].placeMm.z, 30 + std::sqrt(400 - mm * mm), 0.15));
        QVERIFY(under.layers[0].sigmaAlongMm < 0.1);
    }
    const LayersUnder rim = besideItsMiddle(19.8);
    QVERIFY(rim.seen == SeenAt::place && rim.layers[0].onSilhouette);
    const double depth = std::sqrt(400 - 19.8 * 19.8);
    double squares = 0;
    int met = 0;
    for (int i = 0; i < 8; ++i) {
        const double x = 19.8 + 1.5 * std::cos(i * 0.785398), y = 1.5 * std::sin(i * 0.785398);
        if (x * x + y * y >= 400)
            continue;
        squares += std::pow(std::sqrt(400 - x * x - y * y) - depth, 2);
        ++met;
    }
    QVERIFY(near(rim.layers[0].sigmaAlongMm, std::sqrt(squares / met), 0.2));
    QVERIFY(besideItsMiddle(20.5).seen == SeenAt::nothing);
}

void LayersUnderTest::whatIsCutAwayIsNotSeen() {
    Scene scene = test::platesScene({{150, 3}, {60, 3}});
    scene.clip.planes = {{{0, 0, 50}, {0, 0, 1}}};
    QVERIFY(near(seen(scene).layers[0].placeMm.z, test::heightOf(60) + test::frontOf(3, 0.5)));
    Scene block = even(1000, 0.5);
    block.clip.planes = {{{0, 0, 50}, {0, 0, 1}}};
    QVERIFY(near(seen(block).layers[0].placeMm.z, 50, 2e-3));
}

void LayersUnderTest::whatIsMaskedIsNotSeen() {
    Scene scene = test::platesScene({{150, 3}, {60, 3}});
    scene.mask = maskOf({scene.volume->size(), ivec3(0)}, "",
                        [](dvec3 place) { return std::int16_t(place.z > 120 ? 0 : kSeen); });
    QVERIFY(near(seen(scene).layers[0].placeMm.z, test::heightOf(60) + test::frontOf(3, 0.5)));
}

/// Out of focus a point spreads over a disc of the diameter aperture |1 - depth / focus|.
void LayersUnderTest::aLensMakesAPlaceUncertainAcross() {
    Scene scene = test::platesScene({{100, 3}});
    scene.camera.apertureMm = 40;
    scene.camera.focusMm = 1000;
    const SeenLayer layer = seen(scene).layers[0];
    const double disc = 40 * std::fabs(1 - layer.depthMm / 1000);
    QVERIFY(disc > 1.9 && near(layer.sigmaAcrossMm, std::hypot(0.5 / std::sqrt(12.0), disc / 4)));
}

void LayersUnderTest::sumsHaveNoPlaces() {
    for (const Model model : {Model::absorption, Model::emission}) {
        Scene scene = test::platesScene({{100, 3}});
        scene.model = model;
        const LayersUnder under = seen(scene);
        QVERIFY(under.seen == SeenAt::everyDepth && under.layers.empty());
        QCOMPARE(layersText(under), "this image adds up all depths: no point of it is one place");
    }
}

void LayersUnderTest::theHighestIsThePlaceOfAProjection() {
    Scene scene = test::platesScene({{150, 2}, {60, 2.1}, {20, 2.05}});
    scene.model = Model::maximumIntensity;
    scene.window = {-200, 1000};
    const LayersUnder under = seen(scene);
    QVERIFY(under.seen == SeenAt::place && under.layers.size() == 1);
    QVERIFY(near(under.layers[0].placeMm.z, test::heightOf(60), 0.5 / 16 + 1e-3));
    QVERIFY(near(under.layers[0].sigmaAlongMm, 0.5 / std::sqrt(12.0)) && !under.layers[0].onSilhouette);
    scene.mask = maskOf({scene.volume->size(), ivec3(0)}, "",
                        [](dvec3 place) { return std::int16_t(std::fabs(place.z - 60) < 5 ? 0 : kSeen); });
    QVERIFY(near(seen(scene).layers[0].placeMm.z, test::heightOf(20), 0.5 / 16 + 1e-3));
    scene.window = {9000, 10000};
    QVERIFY(seen(scene).seen == SeenAt::nothing);
}

QTEST_GUILESS_MAIN(LayersUnderTest)
#include "layers_under_test.moc"
