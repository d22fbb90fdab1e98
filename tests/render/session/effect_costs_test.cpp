/// The effects of an image: what each costs and brings, measured step by step.

#include <QTest>

#include "render/session/effect_costs.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

constexpr Calibration::Effort kEffort{.longestSide = 32, .seconds = 1};

/// Returns the cost table of a lit ball, with all effects measured.
EffectCosts measured(const Scene& scene) {
    const auto with = makeCpuDevice(1), without = makeCpuDevice(1);
    Calibration calibration(scene, {}, {*with, *without}, kEffort);
    while (!calibration.isDone())
        if (!calibration.step())
            qFatal("the CPU has failed");
    return calibration.effectCosts();
}

Scene litBumps() {
    return test::plainScene(test::bumpyVolume({30, 30, 30}, dvec3(1), 1), 0.3f);
}

bool isOrdered(const Foretold& told) {
    return told.low <= told.value && told.value <= told.high;
}

}  // namespace

class EffectCostsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Shadows change the image of lit tissue; a lamp that shines on nothing does not.
    void influenceSaysWhatCouldBeLeftOut() {
        Scene scene = litBumps();
        scene.lights.push_back(SphereLight{.radiusMm = 1, .radiance = vec3(1e-6f)});
        int tried = 0;
        for (const TriedEffect& row : measured(scene).effects) {
            QCOMPARE(row.trial.has_value(), row.canBeTried());
            if (!row.trial)
                continue;
            ++tried;
            const bool lamp = row.effect.name == "lights with a place";
            QVERIFY2(isUnseen(row.trial->change) == lamp, row.effect.name.c_str());
            QVERIFY(isOrdered(row.trial->change.mean) && isOrdered(row.trial->change.ninetyFifth));
            QVERIFY(row.trial->time && isOrdered(*row.trial->time));
            QVERIFY(row.trial->share.high < 1);
            if (row.effect.name == "one more event")  // is not there, and is measured as if it were
                QVERIFY(!row.effect.needed && row.trial->change.mean.low > 1 && row.trial->share.middle > 0);
        }
        QCOMPARE(tried, 3);
    }

    /// A few bright pixels are seen, however many dark ones there are.
    void whatFewPixelsShowIsSeen() {
        QVERIFY(isUnseen({{0.01, 0, 0.02}, {0, 0, 0.1}}));
        QVERIFY(!isUnseen({{0.3, 0.2, 0.4}, {0, 0, 0}}));
        QVERIFY(!isUnseen({{0.01, 0, 0.02}, {0.3, 0, 0.6}}));
    }

    void whatSavesTimeIsNotLeftOut() {
        TriedEffect row{needs(litBumps()).front(), EffectTrial{}};
        QVERIFY(row.couldBeLeftOut());
        row.trial->share = {-0.3, -0.2, -0.1};
        QVERIFY(!row.couldBeLeftOut());
        row.trial.reset();
        QVERIFY(!row.couldBeLeftOut());
        const TriedEffect left{needs(litBumps()).back(), EffectTrial{}};  // one more event, which is not there
        QVERIFY(!left.effect.needed && !left.couldBeLeftOut());
    }

    void aSceneWithoutEffectsIsDoneAtOnce() {
        Scene scene = litBumps();
        scene.lights.clear();
        scene.environment.visible = false;
        const EffectCosts effectCosts = measured(scene);
        QVERIFY(effectCosts.complete && effectCosts.effects.size() == needs(scene).size());
        for (const TriedEffect& row : effectCosts.effects)
            QVERIFY(!row.effect.needed && !row.trial);
    }

    /// Without the environment less noise is left, and events are cheaper: both make the image come sooner.
    void whatMakesNoiseAndCostsTimeMakesTheImageLate() {
        Scene scene = litBumps();
        scene.environment = {vec3(0.5f), false};
        for (const TriedEffect& row : measured(scene).effects)
            if (row.effect.name == "light from all around") {
                QVERIFY(row.trial && row.trial->time);
                QVERIFY2(row.trial->time->high < 1, qPrintable(QString::number(row.trial->time->high)));
                return;
            }
        QFAIL("there is no sky");
    }
};

QTEST_APPLESS_MAIN(EffectCostsTest)
#include "effect_costs_test.moc"
