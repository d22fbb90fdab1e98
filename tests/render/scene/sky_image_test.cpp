/// Environment images that are chosen as light: their brightness, what they replace, and their rotation.

#include <QTest>
#include <cmath>

#include "render/kernel/transport/environment.h"
#include "render/scene/orbit.h"
#include "render/scene/sky_image.h"
#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

/// Returns an image that is constant except for one texel.
EnvironmentImage picture(ivec2 size, float radiance, float spot) {
    EnvironmentImage image{size, std::vector<vec3>(std::size_t(size.x * size.y), vec3(radiance))};
    image.texels[std::size_t(size.x * (size.y / 2) + size.x / 8)] = vec3(spot);
    return image;
}

Scene cube() {
    return test::plainScene(test::makeVolume({3, 3, 3}, dvec3(1), [](int, int, int) { return 0; }), 1);
}

/// Returns the radiance from `direction`.
float seen(const Environment& environment, dvec3 direction) {
    Scene scene = cube();
    scene.environment = environment;
    return environmentRadiance(test::prepared(scene)->flat.environment, glm::normalize(vec3(direction))).x;
}

}  // namespace

class SkyImageTest : public QObject {
    Q_OBJECT

  private slots:
    void theMeanCountsDirectionsNotTexels() {
        QVERIFY(std::abs(meanLuminance(picture({16, 8}, 3, 3)) - 3) < 1e-5);
        EnvironmentImage cap{{1, 4}, {vec3(1), vec3(0), vec3(0), vec3(0)}};  // 45 degrees about the zenith
        QVERIFY(std::abs(meanLuminance(cap) - (1 - std::sqrt(0.5)) / 2) < 1e-6);
        const auto scaled = scaledToMeanOne(cap);
        QVERIFY(scaled && std::abs(meanLuminance(*scaled) - 1) < 1e-6);
        QVERIFY(!scaledToMeanOne(picture({4, 2}, 0, 0)));
    }

    void itTakesTheRigsPlaceAsBright() {
        const Lighting before{{standardPanels(54, 2, 5), LightRig::Follows::patient},
                              {vec3(0.05f), false, vec3(0.01f)}};
        const auto sky = std::make_shared<const EnvironmentImage>(*scaledToMeanOne(picture({16, 8}, 3, 700)));
        const Lighting lit = litBy(before, sky);
        QVERIFY(std::abs(strengthOf(lit) / strengthOf(before) - 1) < 1e-5);
        QVERIFY(lit.rig.follows == before.rig.follows && !lit.environment.visible && !lit.environment.nadir);
        QVERIFY(panelsOf(lit.rig, cube().volume->geometry(), {}).empty() && !nameOf(lit.rig));
        QVERIFY(lit.rig.panels.size() == 1 && check(lit.rig.panels[0]) && check(lit.environment));
        QVERIFY(litBy(lit, NamedRig::rim).environment.image == nullptr);
        QVERIFY(std::abs(strengthOf(litBy(lit, NamedRig::rim)) / strengthOf(before) - 1) < 1e-5);
        const Environment even = withoutImage(turned(lit, {0.3, 0}, {}).environment);
        QVERIFY(!even.image && even.radiance == lit.environment.radiance && even.rotationDegrees == 0);
        QVERIFY(std::abs(strengthOf(litBy({{standardPanels(0, 0, 0)}, {}}, sky)) - 1) < 1e-5);
    }

    /// A drag turns the image about the patient's axis, like the near side of the ball that it is painted on.
    void aDragTurnsItWithTheLamps() {
        const auto sky = std::make_shared<const EnvironmentImage>(picture({16, 8}, 1, 9));
        const Lighting lit = litBy({{standardPanels(1, 1, 1)}, {}}, sky);
        const auto bright = [&](const Lighting& lighting, dvec3 from) {
            return seen(lighting.environment, from) > 3 * lit.environment.radiance.x;
        };
        const double texel = 2 * kHalfTurn / 16;
        dvec3 spot(std::sin((2.5 - 8) * texel), std::cos((2.5 - 8) * texel), -0.1);
        QVERIFY(bright(lit, spot));
        for (const StandardView view : {StandardView::anterior, StandardView::left})
            for (const double drag : {0.25, -0.6, 0.9}) {
                const Camera camera = standardView(view, dvec3(0), 100, 1);
                const Lighting after = turned(lit, {drag, 0}, camera);
                QVERIFY(bright(after, turned(spot, camera.imageUp(), drag * kHalfTurn)) && !bright(after, spot));
                QVERIFY(std::abs(after.environment.rotationDegrees) <= 180);
                QVERIFY(turned(lit, {0, drag}, camera).environment == lit.environment);
            }
        const Lighting lamps{{standardPanels(1, 1, 1)}, {vec3(1)}};
        const Camera front = standardView(StandardView::anterior, dvec3(0), 100, 1);
        QVERIFY(turned(lamps, {0.2, 0.1}, front).rig == turned(lamps.rig, {0.2, 0.1}, front));
        QVERIFY(turned(lamps, {0.2, 0.1}, front).environment == lamps.environment);
    }
};

QTEST_APPLESS_MAIN(SkyImageTest)
#include "sky_image_test.moc"
