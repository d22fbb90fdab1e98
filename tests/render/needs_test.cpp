#include <QTest>

#include "render/kernel/features.h"
#include "render/scene/needs.h"
#include "tests/support/scenes.h"

using namespace pdr;

namespace {

Scene plain() {
    return test::plainScene(test::bumpyVolume({30, 30, 30}, dvec3(1), 1), 0.3f);
}

Effect effect(const Scene& scene, const std::string& name) {
    for (const Effect& effect : needs(scene))
        if (effect.name == name)
            return effect;
    return {};
}

/// A scene that has one effect, and what it is called.
struct Case {
    std::string name;
    Scene scene;
};

std::vector<Case> onePerEffect() {
    std::vector<Case> cases;
    const auto add = [&](const char* name, auto&& change) {
        cases.push_back({name, plain()});
        change(cases.back().scene);
    };
    add("surface reflection", [](Scene& s) { s.gradientFactor = 1; });
    add("highlights", [](Scene& s) {
        s.gradientFactor = 1;
        s.transferFunction.nodes[0].specular = vec3(0.1f);
    });
    add("directed scattering", [](Scene& s) { s.phaseG = 0.5f; });
    add("lights with a place", [](Scene& s) { s.lights.push_back(RectangleLight{.centreMm = {0, -50, 0}}); });
    add("lights in view", [](Scene& s) { s.lights.push_back(SphereLight{.radiusMm = 2, .visible = true}); });
    add("light from all around", [](Scene& s) { s.environment.radiance = vec3(1); });
    add("visible background", [](Scene& s) { s.environment.radiance = vec3(1); });
    add("depth of field", [](Scene& s) { s.camera.apertureMm = 20; });
    add("clipping", [](Scene& s) { s.clip.planes = {{s.volume->geometry().centreMm(), {1, 0, 0}}}; });
    add("multiple scattering", [](Scene& s) { s.model = Model::multipleScattering; });
    add("emission", [](Scene& s) { s.transferFunction.nodes[0].emission = vec3(1); });
    return cases;
}

bool sameBits(const Film& a, const Film& b) {
    for (int y = 0; y < a.size().y; ++y)
        for (int x = 0; x < a.size().x; ++x)
            if (a.pixel(x, y).mean != b.pixel(x, y).mean)
                return false;
    return true;
}

/// The picture of `scene` with more compiled in than it needs.
Film renderedWith(const Scene& scene, std::uint32_t features) {
    const auto prepared = test::prepared(scene);
    prepared->flat.features |= features;
    return test::sampled(*makeCpuDevice(), prepared, 32);
}

}  // namespace

class NeedsTest : public QObject {
    Q_OBJECT

  private slots:
    void everyEffectIsOffUntilTheSceneCallsForIt() {
        for (const Case& one : onePerEffect()) {
            const Effect off = effect(plain(), one.name), on = effect(one.scene, one.name);
            QVERIFY2(!off.needed && on.needed, one.name.c_str());
            QVERIFY(!off.reason.empty() && !on.reason.empty() && off.reason != on.reason);
        }
    }

    void plainestSceneRunsThePlainestKernel() {
        QCOMPARE(neededFeatures(needs(plain())), 0u);
        QVERIFY(effect(plain(), "shadows").needed);
        Scene dark = plain();
        dark.lights.clear();
        QCOMPARE(effect(dark, "shadows").reason, std::string("there is no light"));
    }

    void whatCannotBeMetIsNotNeeded() {
        Scene scene = plain();
        scene.gradientFactor = 1;
        scene.transferFunction.nodes = {{.hu = 0, .opacity = 0, .emission = vec3(1), .specular = vec3(1)},
                                        {.hu = 10, .opacity = 0},
                                        {.hu = 20, .opacity = 1}};
        QVERIFY(!effect(scene, "emission").needed);
        QVERIFY(!effect(scene, "highlights").needed);
    }

    /// Sums along straight rays know no light but their own and that behind them.
    void modelsWithoutScatteringSayWhatTheyDoNotHave() {
        for (const Model model :
             {Model::absorption, Model::emission, Model::emissionAbsorption, Model::maximumIntensity}) {
            for (Case& one : onePerEffect()) {
                if (one.name == "depth of field" || one.name == "clipping")
                    continue;  // these are about which rays there are
                one.scene.model = model;
                QVERIFY(bool(one.scene.check()));
                QCOMPARE(neededFeatures(needs(one.scene)), 0u);
                const Effect found = effect(one.scene, one.name);
                const bool light = model != Model::maximumIntensity && one.name == "visible background";
                const bool within =
                    (model == Model::emission || model == Model::emissionAbsorption) && one.name == "emission";
                QVERIFY2(found.needed == (light || within), one.name.c_str());
                QVERIFY(found.needed || found.reason.starts_with("the model") ||
                        found.reason == "there are no surfaces");
            }
        }
    }

    /// An effect that is compiled in but has nothing to do leaves every bit as it is.
    void effectsWithoutInfluenceLeaveThePictureBitIdentical() {
        const Film lean = renderedWith(plain(), 0);
        for (const Feature feature : {kSurface, kPlacedLights, kEnvironment, kEmission, kBounces})
            QVERIFY2(sameBits(lean, renderedWith(plain(), feature)), qPrintable(QString::number(feature)));
    }

    void effectsWithInfluenceChangeThePicture() {
        const Film lean = renderedWith(plain(), 0);
        for (const Case& one : onePerEffect())
            QVERIFY2(!sameBits(lean, renderedWith(one.scene, 0)), one.name.c_str());
    }

    /// What an effect's leaveOut makes of its scene is the scene without it, bit by bit.
    void leavingAnEffectOutGivesThePictureWithoutIt() {
        const Film lean = renderedWith(plain(), 0);
        for (const Case& one : onePerEffect()) {
            Scene without = one.scene;
            effect(one.scene, one.name).leaveOut(without);
            QVERIFY2(!effect(without, one.name).needed, one.name.c_str());
            if (one.name == "highlights" || one.name == "visible background" || one.name == "lights in view")
                continue;  // these cases have a second effect, which stays
            QVERIFY2(sameBits(lean, renderedWith(without, 0)), one.name.c_str());
        }
    }

    /// Effects that are numbers of a kernel: nothing changes when their number says that there is nothing to do.
    void nullsOfEffectsThatAreNotCompiledInAreBitIdentical() {
        const Film lean = renderedWith(plain(), 0);
        Scene scene = plain();
        scene.camera.focusMm = 123;  // of a closed lens
        scene.clip.box = ClipBox{dvec3(-1e6), dvec3(1e6)};
        scene.clip.shadows = true;
        scene.environment.rotationDegrees = 40;  // of no picture
        scene.model = Model::multipleScattering;
        scene.maxBounces = 1;
        QVERIFY(sameBits(lean, renderedWith(scene, 0)));
    }
};

QTEST_GUILESS_MAIN(NeedsTest)
#include "needs_test.moc"
