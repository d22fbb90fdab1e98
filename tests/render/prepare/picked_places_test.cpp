/// Picked places in random scenes: a fine march finds the light there that is stated, none is picked where no stretch
/// holds half of the light, and each is seen where it was picked.

#include <QTest>
#include <map>

#include "render/prepare/layers_under.h"
#include "render/prepare/tissue_behind.h"
#include "tests/support/scenes/axis_views.h"
#include "tests/support/scenes/marched_light.h"
#include "tests/support/scenes/masks.h"
#include "tests/support/scenes/plates.h"
#include "tests/support/scenes/random_scenes.h"

using namespace pdr;

namespace {

constexpr double kMarch = 2e-3;  ///< error of the march, as a share of the light

/// Returns the length of a layer along a direction that it may have at most, 2 mm or 1.5 voxels.
double windowOf(const Volume& volume, dvec3 direction) {
    const dvec3 perVoxel = direction / volume.geometry().spacingMm();  // the grids here lie along the patient's axes
    return std::max(2.0, 1.5 / glm::length(perVoxel));
}

/// A random scene that is as translucent as any, with cuts and masks.
Scene translucent(unsigned seed) {
    std::mt19937 random(seed);
    Scene scene = test::anyScene(seed);
    scene.transferFunction.extinctionPerMm *= float(std::pow(10, -0.5 * double(seed % 5)));
    scene.camera.type = seed % 2 ? Camera::Type::perspective : Camera::Type::orthographic;
    scene.camera.heightMm = 1.5 * scene.volume->geometry().radiusMm();
    if (seed % 4 == 1)
        scene.clip.planes = {{scene.volume->geometry().centreMm(), test::anyDirection(random)}};
    if (seed % 7 == 0)
        scene.mask = test::anyMask(*scene.volume, seed);
    return scene;
}

}  // namespace

class PickedPlacesTest : public QObject {
    Q_OBJECT

  private slots:
    /// A thousand clicks.
    void aPlaceHoldsItsLight() {
        std::map<SeenAt, int> counts;
        for (unsigned seed = 1; seed <= 75; seed += seed % 3 == 2 ? 2 : 1) {
            const Scene scene = translucent(seed);
            const auto prepared = test::prepared(scene);
            std::mt19937 random(seed + 1000);
            std::uniform_real_distribution<float> unit(0.15f, 0.85f);
            for (int i = 0; i < 20; ++i) {
                const vec2 point(unit(random), unit(random));
                const LayersUnder under = layersUnder(*prepared, point * vec2(scene.film));
                const test::MarchedLight light(scene, dvec2(point));
                ++counts[under.seen];
                QVERIFY2(std::fabs(light.met() - under.met) < kMarch,
                         qPrintable(QString("seed %1: %2, %3").arg(seed).arg(under.met).arg(light.met())));
                for (const SeenLayer& layer : under.layers) {
                    const double along = light.along(layer.placeMm);
                    QVERIFY(glm::distance(light.at(along), layer.placeMm) < 1e-3);
                    QVERIFY(light.metBefore(along + 1) - light.metBefore(along - 1) > 0.15 - kMarch);
                }
                // The quantiles miss the best stretch by at most two of their steps.
                constexpr double kMissed = 2.0 / 64 + kMarch;
                const auto [least, most] = light.mostWithin(windowOf(*scene.volume, under.direction));
                QVERIFY2(under.seen != SeenAt::place || most > 0.5 - kMarch, qPrintable(QString::number(most)));
                if (under.seen == SeenAt::place)
                    QVERIFY(under.layers[0].share > least - kMissed && under.layers[0].share < most + kMarch);
                QVERIFY(under.seen == SeenAt::place || least < 0.5 + kMissed);
            }
        }
        for (const SeenAt seen : {SeenAt::place, SeenAt::choice, SeenAt::fog, SeenAt::nothing})
            QVERIFY2(counts[seen] > 40, qPrintable(QString("%1: %2").arg(int(seen)).arg(counts[seen])));
    }

    /// The HU rise by 200 per mm from 50 mm down: the first 2 mm behind a place have the mean of 1 mm behind it.
    void theTissueLiesBehindThePlace() {
        Scene scene = test::platesScene({});
        scene.volume = test::makeVolume({8, 8, 200}, dvec3(0.5), [](int, int, int k) { return 100 * (100 - k); });
        scene.transferFunction = {1000, {{.hu = 0, .opacity = 0}, {.hu = 500, .opacity = 1}}};
        const auto prepared = test::prepared(scene);
        const LayersUnder under = layersUnder(*prepared, {4.5f, 4.5f});
        const double hu = 100 * (100 - (under.layers.at(0).placeMm.z / 0.5 - 0.5));
        const TissueBehind tissue = tissueBehind(*prepared, under.layers[0].placeMm, under.direction);
        QVERIFY(std::fabs(tissue.hu - (hu + 200)) < 2);
        QVERIFY(std::fabs(tissue.spread - 400 / std::sqrt(12.0)) < 2);
    }

    /// The crosshair is drawn by ViewGeometry, in 24 views and both projections.
    void aPlaceIsSeenWhereItWasPicked() {
        Scene scene = test::plainScene(test::bumpyVolume({60, 50, 40}, {1.5, 1.7, 2.5}, 5), 3);
        scene.transferFunction.nodes = {{.hu = 100, .opacity = 0}, {.hu = 400, .opacity = 1}};
        scene.film = {300, 200};
        int places = 0;
        for (const Camera::Type type : {Camera::Type::perspective, Camera::Type::orthographic})
            for (Camera camera : test::axisViews(type, 8, 80)) {
                const dvec3 centre = scene.volume->geometry().centreMm();
                camera.eyeMm += centre;
                camera.targetMm = centre;
                scene.camera = camera;
                const auto prepared = test::prepared(scene);
                const ViewGeometry view(camera, 1.5);
                for (const vec2 point : {vec2(150, 100), vec2(100.3f, 40.7f), vec2(201.5f, 150.5f), vec2(120, 170)})
                    for (const SeenLayer& layer : layersUnder(*prepared, point).layers) {
                        const dvec2 found = view.at(layer.placeMm).value() * dvec2(scene.film);
                        QVERIFY(glm::distance(found, dvec2(point)) < 0.01);
                        ++places;
                    }
            }
        QVERIFY2(places > 150, qPrintable(QString::number(places)));
    }
};

QTEST_GUILESS_MAIN(PickedPlacesTest)
#include "picked_places_test.moc"
