#include <QTest>

#include "render/kernel/features.h"
#include "render/prepare/needs.h"
#include "tests/support/scenes/part_scenes.h"
#include "tests/support/scenes/scenes.h"

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

/// HU from -1000 to 1500 in voxels of 1 mm: a step across x, met straight on by the camera.
std::shared_ptr<const Volume> step() {
    return test::makeVolume({30, 30, 30}, dvec3(1), [](int i, int, int) { return i < 15 ? -1000 : 1500; });
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
    add("materials of parts", [](Scene& s) {
        s.parts = {test::anyParts(*s.volume, 2, 1), {{2, s.transferFunction}}};
        s.parts.curves[0].transferFunction.nodes[0].albedo = vec3(0.5f);
    });
    return cases;
}

/// Plain scenes with a step, each changed in one way.
struct Cases : std::vector<Case> {
    template <class Change>
    void add(const char* name, Change&& change) {
        push_back({name, plain()});
        back().scene.volume = step();
        change(back().scene);
    }
};

/// All opaque, and from `hu` on shiny and bright.
void shineAbove(Scene& s, float hu) {
    s.transferFunction.nodes = {{.hu = 0, .opacity = 1}, {.hu = hu, .opacity = 1}, {.hu = 32000, .opacity = 1}};
    s.transferFunction.nodes.back().emission = vec3(1);
    s.transferFunction.nodes.back().specular = vec3(1);
}

/// Scenes that speak of an effect which cannot show in them.
Cases withoutInfluence() {
    Cases cases;
    cases.add("lights with a place", [](Scene& s) { s.lights.push_back(RectangleLight{.radiance = vec3(0)}); });
    cases.add("lights with a place", [](Scene& s) {
        s.phaseG = 0.8f;  // so sharp that light is also looked for where it is scattered to
        s.lights.insert(s.lights.begin(), SphereLight{.radiusMm = 2, .radiance = vec3(0), .visible = true});
    });
    cases.add("clipping", [](Scene& s) { s.clip.box = ClipBox{dvec3(-1), dvec3(31)}; });
    cases.add("emission", [](Scene& s) { shineAbove(s, 1501); });
    cases.add("highlights", [](Scene& s) {
        shineAbove(s, 1501);
        s.gradientFactor = 1;
        s.lights.push_back(RectangleLight{.centreMm = {0, -50, 0}});
    });
    cases.add("surface reflection", [](Scene& s) { s.gradientFactor = 1e-6f; });
    cases.add("materials of parts", [](Scene& s) {
        s.parts = {test::anyParts(*s.volume, 2, 1), {{1, s.transferFunction}, {2, s.transferFunction, 0.0f}}};
    });
    for (const char* name : {"shadows", "surface reflection", "emission", "lights with a place", "multiple scattering",
                             "light from all around", "directed scattering", "search along scattering"})
        cases.add(name, [](Scene& s) {
            s.transferFunction.nodes = {{.hu = 20150, .opacity = 0}, {.hu = 20151, .opacity = 1, .emission = vec3(1)}};
            s.model = Model::multipleScattering;
            s.gradientFactor = 1;
            s.phaseG = 0.5f;
            s.lights.push_back(SphereLight{.radiusMm = 2});
            s.environment.radiance = vec3(1);
        });
    for (const char* name : {"shadows", "surface reflection", "lights with a place", "multiple scattering"})
        cases.add(name, [](Scene& s) {
            s.model = Model::multipleScattering;
            s.gradientFactor = 1;
            s.lights = {SphereLight{.radiusMm = 2, .radiance = vec3(0)}, DirectionalLight{{0, 0, -1}, vec3(0)}};
        });
    for (const char* name : {"shadows", "surface reflection", "lights with a place", "multiple scattering"})
        cases.add(name, [](Scene& s) {
            s.transferFunction.nodes[0].albedo = vec3(0);
            s.model = Model::multipleScattering;
            s.gradientFactor = 1;
            s.lights.push_back(SphereLight{.radiusMm = 2});
        });
    return cases;
}

/// Returns the scenes with an effect that can just show.
Cases withLittleInfluence() {
    Cases cases;
    cases.add("lights with a place", [](Scene& s) { s.lights.push_back(RectangleLight{.radiance = {0, 0, 1e-30f}}); });
    cases.add("clipping", [](Scene& s) { s.clip.box = ClipBox{dvec3(-1), dvec3(31, 31, 29.9)}; });
    cases.add("clipping", [](Scene& s) { s.clip.planes = {{{0.1, 0, 0}, {-1, 0, 0}}}; });
    cases.add("emission", [](Scene& s) { shineAbove(s, 1499); });
    cases.add("highlights", [](Scene& s) {
        shineAbove(s, 1499);
        s.gradientFactor = 1;
    });
    cases.add("surface reflection", [](Scene& s) { s.gradientFactor = 0.05f; });
    for (const char* name : {"shadows", "surface reflection", "emission", "multiple scattering"})
        cases.add(name, [](Scene& s) {  // only voxels of 1500 HU are opaque
            s.transferFunction.nodes = {{.hu = 1500, .opacity = 0}, {.hu = 1500, .opacity = 1, .emission = vec3(1)}};
            s.model = Model::multipleScattering;
            s.gradientFactor = 1;
        });
    cases.add("multiple scattering", [](Scene& s) {  // light from within alone
        s.model = Model::multipleScattering;
        s.transferFunction.nodes[0].emission = vec3(1e-3f);
        s.lights.clear();
    });
    return cases;
}

bool sameBits(const Film& a, const Film& b) {
    for (int y = 0; y < a.size().y; ++y)
        for (int x = 0; x < a.size().x; ++x)
            if (a.pixel(x, y).mean != b.pixel(x, y).mean)
                return false;
    return true;
}

/// The image of `scene` with more compiled in than it needs.
Film renderedWith(const Scene& scene, std::uint32_t features) {
    const auto prepared = test::prepared(scene);
    prepared->flat.features |= features;
    if (scene.model == Model::multipleScattering && has(features, kBounces))
        prepared->flat.maxBounces = scene.maxBounces;
    return test::sampled(prepared, 32);
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

    void whatCannotShowIsOffAndLeavesEveryBit() {
        for (const Case& one : withoutInfluence()) {
            const Effect found = effect(one.scene, one.name);
            QVERIFY2(!found.needed, (one.name + ": " + found.reason).c_str());
            const Film lean = renderedWith(one.scene, 0);
            QVERIFY2(sameBits(lean, renderedWith(one.scene, kFeatureMasks - 1)), one.name.c_str());
        }
    }

    void whatCanJustShowIsNeeded() {
        for (const Case& one : withLittleInfluence())
            QVERIFY2(effect(one.scene, one.name).needed, one.name.c_str());
    }

    /// A dark lamp among lights and environment light: leaving it out changes no random number.
    void aDarkLampIsLeftOutToTheBit() {
        Scene scene = plain();
        scene.environment.radiance = vec3(1);
        const Film without = test::render(scene, 32);
        for (int place = 0; place < 2; ++place) {
            Scene dark = scene;
            dark.lights.insert(dark.lights.begin() + place, SphereLight{.radiusMm = 20, .radiance = vec3(0)});
            QVERIFY(!effect(dark, "lights with a place").needed);
            QVERIFY(sameBits(test::render(dark, 32), without));
            QVERIFY(sameBits(renderedWith(dark, kFeatureMasks - 1), without));
        }
        for (const Effect& other : needs(plain()))
            QVERIFY(!other.couldBeLeftOut);
    }

    /// Highlights that cannot show still decide where light is looked for: other samples would be another image.
    void whatTheVolumeHoldsNeverChangesTheOrderOfSamples() {
        for (const Case& one : withoutInfluence())
            if (one.name == "highlights") {
                QVERIFY(test::prepared(one.scene)->flat.sampleDirections);
                const Effect search = effect(one.scene, "search along scattering");
                QVERIFY(search.needed && search.couldBeLeftOut);
            }
    }

    /// Sums along straight rays know no light but their own and that behind them.
    void modelsWithoutScatteringSayWhatTheyDoNotHave() {
        for (const Model model :
             {Model::absorption, Model::emission, Model::emissionAbsorption, Model::maximumIntensity}) {
            for (Case& one : onePerEffect()) {
                if (one.name == "depth of field" || one.name == "clipping" || one.name == "materials of parts")
                    continue;  // these are about which rays there are, or are refused
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
    void effectsWithoutInfluenceLeaveTheImageBitIdentical() {
        const Film lean = renderedWith(plain(), 0);
        for (const Feature feature : {kSurface, kPlacedLights, kEnvironment, kEmission, kBounces})
            QVERIFY2(sameBits(lean, renderedWith(plain(), feature)), qPrintable(QString::number(feature)));
    }

    /// What shadows do is measured against light that nothing holds up: between there and here, no event changes.
    void shadowsCanBeLeftOutToSeeWhatTheyDo() {
        for (const Estimator estimator : kEstimators) {
            Scene scene = plain();
            scene.estimator = estimator;
            const Effect shadows = effect(scene, "shadows");
            QVERIFY(shadows.needed && shadows.leaveOut != nullptr);
            Scene without = scene;
            shadows.leaveOut(without);
            QVERIFY(!effect(without, "shadows").needed);
            const Film dark = renderedWith(scene, 0), bright = renderedWith(without, 0);
            double shadowed = 0, unshadowed = 0, met = 0;
            for (int y = 0; y < dark.size().y; ++y)
                for (int x = 0; x < dark.size().x; ++x) {
                    shadowed += dark.pixel(x, y).mean.x, unshadowed += bright.pixel(x, y).mean.x;
                    met += unshadowed > 0;
                    QVERIFY(dark.pixel(x, y).mean.x <= bright.pixel(x, y).mean.x * (1 + 1e-6));
                }
            QVERIFY2(shadowed < 0.8 * unshadowed && met > 0, qPrintable(QString::number(shadowed / unshadowed)));
        }
    }

    /// The next event on a path is left out by choice: a scene can be given it, one at a time, as long as it may show.
    void oneMoreEventCanBeBroughtIn() {
        Scene scene = plain();
        for (const int events : {2, 3}) {
            const Effect more = effect(scene, "one more event");
            QVERIFY(!more.needed && more.bringIn != nullptr);
            more.bringIn(scene);
            QVERIFY(scene.model == Model::multipleScattering && bool(scene.check()));
            QCOMPARE(scene.maxBounces, events);
        }
        Scene many = scene, dark = plain(), march = plain(), projection = plain();
        many.maxBounces = 1000;
        dark.lights.clear();
        march.estimator = Estimator::kroesMarch;
        projection.model = Model::emission;
        for (const Scene& none : {many, dark, march, projection})
            QVERIFY(effect(none, "one more event").bringIn == nullptr);
    }

    /// The model in which rays leave surfaces outside their soft edge is told apart from the exact one.
    void raysFromOutsideSoftEdgesCanBeLeftOut() {
        const std::string name = "rays outside soft edges";
        Scene scene = plain();
        scene.rayOrigin = RayOrigin::outsideEdge;
        QVERIFY(!effect(scene, name).needed);  // no surfaces
        scene.gradientFactor = 3;
        const Effect outside = effect(scene, name);
        QVERIFY(outside.needed);
        Scene exact = scene;
        outside.leaveOut(exact);
        QVERIFY(exact.rayOrigin == RayOrigin::event && !effect(exact, name).needed);
        QVERIFY(!sameBits(test::render(scene, 32), test::render(exact, 32)));
        scene.estimator = Estimator::kroesMarch;
        QVERIFY(!effect(scene, name).needed);
    }

    void effectsWithInfluenceChangeTheImage() {
        const Film lean = renderedWith(plain(), 0);
        for (const Case& one : onePerEffect())
            QVERIFY2(!sameBits(lean, renderedWith(one.scene, 0)), one.name.c_str());
    }

    /// What an effect's leaveOut makes of its scene is the scene without it, bit by bit.
    void leavingAnEffectOutGivesTheImageWithoutIt() {
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
        scene.environment.rotationDegrees = 40;  // of no image
        scene.model = Model::multipleScattering;
        scene.maxBounces = 1;
        QVERIFY(sameBits(lean, renderedWith(scene, 0)));
    }
};

QTEST_GUILESS_MAIN(NeedsTest)
#include "needs_test.moc"
