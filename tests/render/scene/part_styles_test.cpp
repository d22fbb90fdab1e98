#include <QTest>

#include "render/scene/named_look.h"
#include "render/scene/part_styles.h"
#include "tests/support/scenes/part_scenes.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

/// A scene without parts, and a map of its volume with the parts "a", "b" and, once more, "a".
struct Parted {
    std::shared_ptr<const Volume> volume =
        test::makeVolume({4, 4, 4}, dvec3(1), [](int i, int j, int k) { return 10 * (i + j + k); });
    std::shared_ptr<LabelMap> map;
    Scene scene;

    Parted() {
        map = std::make_shared<LabelMap>(*test::labelled(*volume, 3, [](ivec3 at) { return at.x; }));
        map->parts = {{"a", {255, 0, 0}}, {"b", {0, 255, 0}}, {"a", {0, 0, 255}}};
        scene.volume = volume;
        scene.transferFunction = {4, {{.hu = 0, .opacity = 0}, {.hu = 30, .opacity = 1}}};
    }
    Scene with(const PartStyles& styles) const { return withParts(scene, map, styles); }
};

TransferFunction ownCurve() {
    return {2, {{.hu = 10, .opacity = 0.5f}}};
}

}  // namespace

/// How parts are shown is said by name, and becomes curves of the labels of a scan.
class PartStylesTest : public QObject {
    Q_OBJECT

  private slots:
    /// An image in which all parts look as all tissue does is the one without parts, which costs less.
    void withoutStylesTheSceneStays() {
        const Parted parted;
        QVERIFY(parted.with({}) == parted.scene);
        QVERIFY(withParts(parted.scene, nullptr, {.rest = PartState::hidden}) == parted.scene);
        QVERIFY(parted.with({.styles = {{.part = "of another scan", .state = PartState::hidden}}}) == parted.scene);
    }

    void partsOfOneNameAreShownAlike() {
        const Parted parted;
        const Scene scene = parted.with({.styles = {{.part = "a", .transferFunction = ownCurve(), .look = "x"}}});
        QVERIFY(scene.check() && scene.parts.map == parted.map);
        QVERIFY(scene.transferFunction == parted.scene.transferFunction);
        QCOMPARE(scene.parts.curves.size(), std::size_t(2));
        QVERIFY(scene.parts.curves[0] == (PartCurve{1, ownCurve()}));
        QVERIFY(scene.parts.curves[1] == (PartCurve{3, ownCurve()}));
    }

    void ghostsAreThinAndHiddenPartsAreEmpty() {
        const Parted parted;
        const Scene scene = parted.with(
            {.styles = {{.part = "a", .state = PartState::ghost}, {.part = "b", .state = PartState::hidden}}});
        QVERIFY(bool(scene.check()));
        const TransferFunction &ghost = scene.parts.curves[0].transferFunction,
                               &hidden = scene.parts.curves[1].transferFunction;
        QCOMPARE(ghost.extinctionPerMm, kGhostPerMm);
        QVERIFY(ghost.nodes == parted.scene.transferFunction.nodes);
        for (const float hu : {-1000.0f, 0.0f, 30.0f, 3000.0f})
            QCOMPARE(hidden.opacityAt(hu), 0.0f);
    }

    /// What is around the parts has no label: its curve is the scene's own, and all parts keep theirs.
    void theRestIsHiddenAndPartsStay() {
        const Parted parted;
        const Scene scene = parted.with({.rest = PartState::hidden});
        QVERIFY(bool(scene.check()));
        QCOMPARE(scene.transferFunction.opacityAt(30), 0.0f);
        QCOMPARE(scene.parts.curves.size(), std::size_t(3));
        for (const PartCurve& part : scene.parts.curves)
            QVERIFY(part.transferFunction == parted.scene.transferFunction);
    }

    void coloursReplaceThoseOfTheCurve() {
        const Parted parted;
        const vec3 blue(0.1f, 0.2f, 0.8f);
        const Scene scene = parted.with({.inColour = true, .styles = {{.part = "b", .colour = blue}}});
        QCOMPARE(scene.parts.curves.size(), std::size_t(3));
        QVERIFY(scene.parts.curves[0].transferFunction.nodes[1].albedo == vec3(1, 0, 0));
        QVERIFY(scene.parts.curves[1].transferFunction.nodes[0].albedo == blue);
        QVERIFY(scene.parts.curves[1].transferFunction.nodes[1].opacity == 1);
    }

    void modelsOfLightFromWithinHaveNone() {
        Parted parted;
        for (const Model model : kModels) {
            parted.scene.model = model;
            const Scene scene = parted.with({.rest = PartState::hidden});
            QVERIFY2(bool(scene.check()), modelName(model));
            QCOMPARE(bool(scene.parts.map), showsParts(model));
        }
        QVERIFY(showsParts(Model::absorption) && showsParts(Model::singleScattering));
        QVERIFY(!showsParts(Model::emissionAbsorption) && !showsParts(Model::maximumIntensity));
    }

    void aStyleThatSaysNothingIsLeftOut() {
        PartStyles styles = withStyle({}, {.part = "a", .state = PartState::ghost});
        QCOMPARE(styles.styles.size(), std::size_t(1));
        styles = withStyle(styles, {.part = "a", .state = PartState::hidden});
        QVERIFY(styles.styles.size() == 1 && styleOf(styles, "a").state == PartState::hidden);
        QVERIFY(withStyle(styles, {.part = "a"}).empty());
        QVERIFY(withStyle({}, {.part = "b"}).empty());
    }

    void looksKeepThem() {
        NamedLook look;
        look.name = "with parts";
        look.look.transferFunction = ownCurve();
        QVERIFY(lookText(look).find("\"parts\"") == std::string::npos);
        look.look.parts = {PartState::ghost,
                           true,
                           {{"liver", PartState::hidden, vec3(0.25f), ownCurve(), "Organs"}, {.part = "skin"}}};
        const auto read = lookFromJson(lookText(look), "look");
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QVERIFY(*read == look);
        look.look.parts.styles[1].part = "liver";
        const auto twice = lookFromJson(lookText(look), "look");
        QVERIFY(!twice && twice.error().text().find("parts.styles[1].part") != std::string::npos);
    }

    /// Scans differ in the contrast of their blood, and a part's curve is drawn for one.
    void curvesFollowTheBlood() {
        NamedLook look;
        look.bloodHu = 400;
        look.look.transferFunction = ownCurve();
        look.look.parts.styles = {{.part = "vessels", .transferFunction = TransferFunction{1, {{.hu = 400}}}}};
        QCOMPARE(fittedTo(look, 300).look.parts.styles[0].transferFunction->nodes[0].hu, 300.0f);
    }

    /// An effect that is left out must not take the part's curves for the look's.
    void aSetupIsFoundForItsScene() {
        const Parted parted;
        ImageSetup setup;
        setup.look.transferFunction = parted.scene.transferFunction;
        setup.look.parts.rest = PartState::hidden;
        Scene scene = sceneOf(setup, parted.volume, {4, 4}, parted.map);
        QVERIFY(setupOf(scene, setup) == setup);
        scene.phaseG = 0.5f;
        const auto found = setupOf(scene, setup);
        QVERIFY(found && found->look.phaseG == 0.5f && found->look.transferFunction == setup.look.transferFunction);
        scene.parts.curves.pop_back();
        QVERIFY(!setupOf(scene, setup));
    }
};

QTEST_APPLESS_MAIN(PartStylesTest)
#include "part_styles_test.moc"
