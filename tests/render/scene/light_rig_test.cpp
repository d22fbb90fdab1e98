/// Light rigs: old files, the places of panels, rotation, tying, and named rigs.

#include <QTest>

#include <cmath>

#include "render/scene/lamp.h"
#include "render/scene/named_look.h"
#include "render/scene/named_rig.h"
#include "render/scene/orbit.h"

using namespace pdr;

namespace {

const VolumeGeometry kBody = VolumeGeometry::aligned({40, 30, 20}, dvec3(2, 3, 4), dvec3(7, -9, 11));

Camera obliqueCamera() {
    const Camera front = standardView(StandardView::anterior, kBody.centreMm(), kBody.radiusMm(), 1);
    return orbited(orbited(front, {0.21, 0.13}), {-0.05, 0.4});
}

Look lookOf(const std::string& lights) {
    const std::string text = R"({"format": "pdrender-look", "version": 1, "name": "x",
        "transferFunction": {"extinctionPerMm": 1, "nodes": [{"hu": 0, "opacity": 1}]}, "lights": )";
    const Result<NamedLook> look = lookFromJson(text + lights + "}", "x");
    return look ? look->look : Look{};
}

std::string errorOf(const std::string& lights) {
    const std::string text = R"({"format": "pdrender-look", "version": 1, "name": "x",
        "transferFunction": {"extinctionPerMm": 1, "nodes": [{"hu": 0, "opacity": 1}]}, "lights": )";
    const Result<NamedLook> look = lookFromJson(text + lights + "}", "x");
    return look ? "none" : look.error().where;
}

/// Returns the place of a light from the centre [radii of the body].
dvec3 placeOf(const Light& light) {
    return (std::get<RectangleLight>(light).centreMm - kBody.centreMm()) / kBody.radiusMm();
}

/// Returns the greatest distance between two rigs' panels about the body [radii].
double apart(const LightRig& a, const LightRig& b, const Camera& camera) {
    const auto ofA = panelsOf(a, kBody, camera), ofB = panelsOf(b, kBody, camera);
    double most = ofA.size() == ofB.size() ? 0 : 1e9;
    for (std::size_t i = 0; i < std::min(ofA.size(), ofB.size()); ++i)
        most = std::max(most, glm::length(placeOf(ofA[i]) - placeOf(ofB[i])));
    return most;
}

}  // namespace

class LightRigTest : public QObject {
    Q_OBJECT

  private slots:
    /// Three numbers, as files had them before panels could be moved, give the standard panels.
    void threeNumbersAreTheStandardPanels() {
        const Look look = lookOf(R"({"key": 54, "fill": 2, "rim": 5, "ambient": 0.05})");
        QVERIFY(look.rig == (LightRig{standardPanels(54, 2, 5)}));
        QCOMPARE(look.environment.radiance.x, 0.05f);
        QVERIFY(lookOf("{}").rig == (LightRig{standardPanels(1, 0.3f, 0.5f)}));
        const Camera camera = obliqueCamera();
        const auto key = std::get<RectangleLight>(panelsOf(look.rig, kBody, camera)[0]);
        const dvec3 from = glm::normalize(-0.9 * camera.right() + 1.0 * camera.imageUp() - 0.9 * camera.forward());
        QVERIFY(key.centreMm == kBody.centreMm() + from * (3.0 * kBody.radiusMm()));
        QCOMPARE(key.widthMm, 1.4 * kBody.radiusMm());
        QVERIFY(key.radiance == 54.0f * vec3(1.12f, 0.99f, 0.80f));
    }

    void aListTakesThePlaceOfTheThree() {
        const Look look = lookOf(R"({"panels": [{"from": [-1, 0, 0], "radiance": 7, "edge": 0.5}], "ambient": 0})");
        QCOMPARE(look.rig.panels.size(), std::size_t(1));
        QVERIFY(look.rig.panels[0].colour == vec3(1) && look.rig.panels[0].distance == 3);
        const Camera camera = obliqueCamera();
        QVERIFY(glm::length(placeOf(panelsOf(look.rig, kBody, camera)[0]) + 3.0 * camera.right()) < 1e-12);
    }

    void mistakesNameTheField() {
        QCOMPARE(errorOf(R"({"panels": [{"from": [0, 0, 1], "radiance": 1}], "key": 1})"),
                 std::string("x, lights.key"));
        QCOMPARE(errorOf(R"({"panels": [{"from": [0, 0, 0], "radiance": 1}]})"),
                 std::string("x, lights.panels[0].from"));
        QCOMPARE(errorOf(R"({"panels": [{"from": [0, 0, 1], "radiance": 1, "distance": 0.5}]})"),
                 std::string("x, lights.panels[0].distance"));
        Look look = lookOf("{}");
        look.rig.panels.assign(65, RigPanel{});
        QCOMPARE(check(look).error().where, std::string("lights.panels"));
        look.rig.panels.clear();
        QCOMPARE(check(look).error().where, std::string("lights.panels"));
    }

    void tyingLeavesTheLightsWhereTheyAre() {
        const Camera camera = obliqueCamera();
        const LightRig rig{standardPanels(3, 2, 1)};
        const LightRig tied = tiedTo(rig, LightRig::Follows::patient, camera);
        QVERIFY(tied.follows == LightRig::Follows::patient);
        QVERIFY(apart(rig, tied, camera) < 1e-12);
        const Camera other = standardView(StandardView::superior, kBody.centreMm(), kBody.radiusMm(), 1);
        QVERIFY(apart(tied, tied, other) == 0 && apart(rig, tied, other) > 0.1);
        QVERIFY(apart(rig, tiedTo(tied, LightRig::Follows::camera, camera), other) < 1e-12);
    }

    /// A drag moves the lights as if it turned the ball that they stand on by its near side, whatever they are tied to.
    void aDragTakesTheLightsAlong() {
        const Camera camera = obliqueCamera();
        LightRig rig{{RigPanel{}}};  // beside the eye
        for (const auto follows : {LightRig::Follows::camera, LightRig::Follows::patient}) {
            rig = tiedTo(rig, follows, camera);
            const auto after = [&](dvec2 drag) {
                return placeOf(panelsOf(turned(rig, drag, camera), kBody, camera)[0]);
            };
            QVERIFY(glm::length(after({0.5, 0}) - 3.0 * camera.right()) < 1e-9);
            QVERIFY(glm::length(after({0, 0.5}) + 3.0 * camera.imageUp()) < 1e-9);
            QVERIFY(glm::length(after({1, 0}) - 3.0 * camera.forward()) < 1e-9);
            QVERIFY(turned(rig, {0, 0}, camera) == rig);
        }
    }

    void namedRigsAreKnownAgainAndAsBright() {
        const Look look = lookOf(R"({"key": 54, "fill": 2, "rim": 5, "ambient": 0.05})");
        const Lighting before{look.rig, look.environment};
        QVERIFY(!nameOf(look.rig));
        for (const NamedRig name : kNamedRigs) {
            Lighting lit = litBy(before, name);
            QVERIFY(nameOf(lit.rig) == name);
            QVERIFY(std::abs(strengthOf(lit) / strengthOf(before) - 1) < 1e-5);
            QVERIFY(!lit.environment.visible && check(lit.environment));
            QVERIFY(apart(tiedTo(tiedTo(lit.rig, LightRig::Follows::patient, obliqueCamera()),
                                 LightRig::Follows::camera, obliqueCamera()),
                          lit.rig, obliqueCamera()) < 1e-9);
            lit.rig.panels[0].radiance *= 3;
            QVERIFY(nameOf(lit.rig) == name);
            lit.rig.panels[0].from.x += 0.01;
            QVERIFY(!nameOf(lit.rig));
        }
    }

    void withoutLightARigOfItsOwnStrengthIsTaken() {
        Lighting dark{{standardPanels(0, 0, 0)}, {vec3(0)}};
        QCOMPARE(strengthOf(dark), 0.0);
        QVERIFY(std::abs(strengthOf(litBy(dark, NamedRig::sky)) - 1) < 1e-5);
    }

    void theOperatingLampIsOneLampFromAbove() {
        const LightRig rig = litBy({}, NamedRig::operatingLamp).rig;
        QVERIFY(rig.panels.size() > 3);
        QCOMPARE(lampsOf(rig).size(), std::size_t(1));
        for (const RigPanel& panel : rig.panels)
            QVERIFY(glm::normalize(panel.from).y > 0.4);
    }

    /// A lamp moves with all its panels, which keep their relative positions.
    void aLampMovesAsAWhole() {
        LightRig rig = litBy({}, NamedRig::operatingLamp).rig;
        rig.panels.push_back({"Other", {0, 0, -1}});
        const dvec3 place = glm::normalize(dvec3(0.3, -0.8, -0.2));
        const LightRig moved = withLampFrom(rig, "Lamp", place);
        QVERIFY(glm::length(lampsOf(moved)[0].from - place) < 1e-9);
        QVERIFY(moved.panels.back() == rig.panels.back());
        for (std::size_t i = 1; i + 1 < rig.panels.size(); ++i)
            QVERIFY(std::abs(glm::dot(moved.panels[i].from, moved.panels[0].from) -
                             glm::dot(rig.panels[i].from, rig.panels[0].from)) < 1e-9);
        const LightRig across = withLampFrom(rig, "Other", {0, 0, 1});  // half a turn, about whichever axis
        QVERIFY(glm::length(lampsOf(across)[1].from - dvec3(0, 0, 1)) < 1e-9);
        QVERIFY(withLampFrom(rig, "nobody", place) == rig);
    }

    void aLampIsAsStrongAndAsLargeAsWasAsked() {
        LightRig rig = litBy({}, NamedRig::operatingLamp).rig;
        rig = withLampStrength(rig, "Lamp", 20);
        QVERIFY(std::abs(lampsOf(rig)[0].irradiance - 20) < 1e-4);
        rig = withLampEdge(rig, "Lamp", 2);
        QCOMPARE(lampsOf(rig)[0].edge, 2.0);
        QVERIFY(std::abs(lampsOf(rig)[0].irradiance - 20) < 1e-4);  // no brighter for being larger
        rig = withLampStrength(withLampStrength(rig, "Lamp", 0), "Lamp", 5);
        QVERIFY(std::abs(lampsOf(rig)[0].irradiance - 5) < 1e-4);
    }
};

QTEST_APPLESS_MAIN(LightRigTest)
#include "light_rig_test.moc"
