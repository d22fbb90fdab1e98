/// How much tissue hides a place: plates by formula, and random places of random scenes against a fine march.

#include "render/prepare/hidden_by.h"

#include <QTest>

#include "render/prepare/layers_under.h"
#include "tests/support/scenes/marched_light.h"
#include "tests/support/scenes/masks.h"
#include "tests/support/scenes/plates.h"
#include "tests/support/scenes/random_scenes.h"

using namespace pdr;

namespace {

HiddenBy hidden(const Scene& scene, dvec3 placeMm) {
    return hiddenBy(*test::prepared(scene), placeMm).value();
}

}  // namespace

class HiddenByTest : public QObject {
    Q_OBJECT

  private slots:
    void aPlateHidesWhatLiesBehind() {
        const Scene scene = test::platesScene({{100, 0.6}, {60, 0.3}});
        for (const auto& [z, depth, tissue] :
             {std::tuple(90.0, 0.0, 0.0), {40.0, 0.6, 1.0}, {10.0, 0.9, 2.0}, {-30.0, 0.9, 2.0}}) {
            const HiddenBy found = hidden(scene, {2, 2.3, z});
            QVERIFY(std::fabs(found.transmittance - std::exp(-depth)) < 1e-4);
            QVERIFY(std::fabs(found.tissueMm - tissue) < 1e-3);
            QCOMPARE(found.hidden(), depth > std::log(2.0));
            QVERIFY(!found.cutAway);
        }
    }

    void whatIsCutAwayIsKnown() {
        Scene scene = test::platesScene({{100, 3}});
        scene.clip.planes = {{{0, 0, 30}, {0, 0, 1}}};
        const HiddenBy before = hidden(scene, {2, 2, 40}), behind = hidden(scene, {2, 2, 20});
        QVERIFY(before.cutAway && before.transmittance == 1 && before.tissueMm == 0);
        QVERIFY(!behind.cutAway && behind.transmittance == 1 && behind.tissueMm == 0);
        scene.clip = {};
        scene.mask = maskOf({scene.volume->size(), ivec3(0)}, "",
                            [](dvec3 place) { return std::int16_t(place.z > 80 ? 0 : kSeen); });
        QVERIFY(hidden(scene, {2, 2, 50}).cutAway && hidden(scene, {2, 2, 20}).transmittance > 0.9999);
        QVERIFY(!hidden(scene, {2, 2, 20}).cutAway);
    }

    /// On the face of a cut light stops at once: the place is neither hidden nor cut away.
    void theFaceOfACutIsSeen() {
        Scene scene = test::platesScene({});
        scene.transferFunction = {1000, {{.hu = 0, .opacity = 1}}};
        scene.clip.planes = {{{0, 0, 50}, {0.1, -0.2, 1}}};
        for (const float x : {0.5f, 3.0f, 7.5f}) {
            const LayersUnder under = layersUnder(*test::prepared(scene), vec2(x, 4));
            const HiddenBy found = hidden(scene, under.layers.at(0).placeMm);
            QVERIFY(!found.cutAway && found.transmittance > 0.3);
            QVERIFY(!hidden(scene, under.layers.at(0).placeMm + dvec3(0, 0, 1e-4)).cutAway);
        }
    }

    /// Half of a layer's light stops before its place.
    void aPickedPlaceIsHiddenByTheLightBefore() {
        const double front = 0.3, back = 0.6;
        const Scene scene = test::platesScene({{150, test::depthFor(front)}, {60, test::depthFor(back, front)}});
        const LayersUnder under = layersUnder(*test::prepared(scene), vec2(3.2f, 5.1f));
        QVERIFY(std::fabs(hidden(scene, under.layers.at(0).placeMm).transmittance - (1 - front - back / 2)) < 1e-3);
    }

    /// A thousand places in and around random tissue, with cuts and masks, in both projections.
    void aFineMarchFindsTheSame() {
        int dashed = 0, solid = 0;
        for (unsigned seed = 1; seed <= 75; seed += seed % 3 == 2 ? 2 : 1) {
            std::mt19937 random(seed);
            Scene scene = test::anyScene(seed);
            const VolumeGeometry& geometry = scene.volume->geometry();
            scene.transferFunction.extinctionPerMm *= 0.1f;
            scene.camera.type = seed % 2 ? Camera::Type::perspective : Camera::Type::orthographic;
            scene.camera.heightMm = 2 * geometry.radiusMm();
            if (seed % 4 == 1)
                scene.clip.planes = {{geometry.centreMm(), test::anyDirection(random)}};
            if (seed % 5 == 0)
                scene.mask = test::anyMask(*scene.volume, seed);
            const auto prepared = test::prepared(scene);
            const ViewGeometry view(scene.camera, 1);
            std::uniform_real_distribution<double> unit(0, 1);
            for (int i = 0; i < 20; ++i) {
                const dvec3 index = dvec3(scene.volume->size()) * dvec3(unit(random), unit(random), unit(random)) - 0.5;
                const dvec3 place(geometry.patientFromIndex * dvec4(index, 1));
                const test::MarchedLight light(scene, view.at(place).value());
                const double left = 1 - light.metBefore(light.along(place));
                const double tissue = light.tissueBefore(light.along(place));
                const HiddenBy found = hiddenBy(*prepared, place).value();
                QVERIFY2(std::fabs(found.transmittance - left) < 2e-3,
                         qPrintable(QString("seed %1: %2, %3").arg(seed).arg(found.transmittance).arg(left)));
                QVERIFY2(std::fabs(found.tissueMm - tissue) < 0.1,
                         qPrintable(QString("seed %1: %2, %3 mm").arg(seed).arg(found.tissueMm).arg(tissue)));
                if (std::fabs(left - 0.5) > 2e-3)
                    QCOMPARE(found.hidden(), left < 0.5);
                ++(found.hidden() ? dashed : solid);
            }
        }
        QVERIFY2(dashed > 200 && solid > 200 && dashed + solid == 1000,
                 qPrintable(QString("%1 %2").arg(dashed).arg(solid)));
    }

    void nothingHidesWhereAllDepthsShow() {
        for (const Model model : {Model::absorption, Model::emission, Model::maximumIntensity}) {
            Scene scene = test::platesScene({{100, 3}});
            scene.model = model;
            const HiddenBy found = hidden(scene, {2, 2, 10});
            QVERIFY(found.transmittance == 1 && found.tissueMm == 0);
        }
    }

    void behindTheEyeNothingIsSeen() {
        QVERIFY(!hiddenBy(*test::prepared(test::platesScene({{100, 3}})), {2, 2, 1101}));
    }
};

QTEST_GUILESS_MAIN(HiddenByTest)
#include "hidden_by_test.moc"
