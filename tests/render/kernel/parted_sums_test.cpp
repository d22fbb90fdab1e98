/// Absorption along rays through parts of the patient with curves of their own, against brute force.

#include <QTest>

#include "render/device/cpu/projection_batch.h"
#include "render/prepare/flatten.h"
#include "render/prepare/flatten_optics.h"
#include "tests/support/scenes/masks.h"
#include "tests/support/scenes/part_scenes.h"
#include "tests/support/scenes/ray_reference.h"

using namespace pdr;

namespace {

/// Rounding in single precision, relative; not part of the stated bound.
constexpr double kRounding = 5e-5;

/// A curve without steps, which brute force would need far smaller steps for; its colour changes with the HU.
TransferFunction gentle(float extinctionPerMm, float from, float to, vec3 thin, vec3 dense) {
    return {extinctionPerMm,
            {{.hu = from, .opacity = 0, .albedo = thin},
             {.hu = (from + to) / 2, .opacity = 0.4f, .albedo = dense},
             {.hu = to, .opacity = 1, .albedo = thin}}};
}

Scene partedScene(float extinctionPerMm, unsigned seed, bool masked) {
    Scene scene = test::plainScene(test::bumpyVolume({31, 22, 19}, {0.7, 1.1, 2.3}, seed), 1);
    scene.lights.clear();
    scene.model = Model::absorption;
    scene.environment = {vec3(0.3f), true};
    scene.transferFunction = gentle(0.6f * extinctionPerMm, -700, 1100, {0.9f, 0.3f, 0.1f}, {0.8f, 0.7f, 0.6f});
    scene.parts.map = test::anyParts(*scene.volume, 6, seed);
    scene.parts.curves = {{1, gentle(extinctionPerMm, -400, 600, {0.2f, 0.9f, 0.3f}, {0.1f, 0.8f, 0.9f})},
                          {2, gentle(0.2f * extinctionPerMm, -1000, 300, {0.2f, 0.3f, 0.9f}, {0.9f, 0.9f, 0.1f})},
                          {4, scene.transferFunction},
                          {5, gentle(1.4f * extinctionPerMm, 0, 700, {0.7f, 0.1f, 0.8f}, {0.3f, 0.5f, 0.2f})}};
    scene.parts.curves[2].transferFunction.nodes[1].albedo = vec3(0.1f);  // in colour alone
    if (masked)
        scene.mask = test::anyMask(*scene.volume, seed);
    return scene;
}

Projected projectedOn(const FlatScene& flat, const Ray& ray) {
    constexpr FlatModel kModel = FlatModel::absorption;
    return project<kModel>(flat, ray, backdrop<kModel>(flat, PathSegment{}));
}

dvec3 truthOf(const Scene& scene, const Ray& ray, double stepMm) {
    return std::exp(-test::rayTruth(scene, ray, stepMm).depth) * dvec3(scene.environment.radiance);
}

}  // namespace

class PartedSumsTest : public QObject {
    Q_OBJECT

  private slots:
    void everyRayKeepsItsBound_data() {
        QTest::addColumn<float>("extinction");
        QTest::addColumn<bool>("masked");
        for (const bool masked : {false, true}) {
            const char* said = masked ? ", masked" : "";
            QTest::addRow("thin%s", said) << 0.02f << masked;
            QTest::addRow("middling%s", said) << 0.5f << masked;
            QTest::addRow("thick%s", said) << 3.0f << masked;
        }
    }
    void everyRayKeepsItsBound() {
        QFETCH(float, extinction);
        QFETCH(bool, masked);
        double furthest = 0;
        for (unsigned seed = 1; seed <= 3; ++seed) {
            Scene scene = partedScene(extinction, seed, masked);
            QVERIFY(scene.check());
            for (Ray ray : test::raysThrough(*scene.volume, 4, seed)) {
                ray.length = std::min(ray.length, 40 / extinction);  // what lies behind does not show
                const dvec3 truth = truthOf(scene, ray, std::min(2e-3, 8e-3 / extinction));
                if (!(truth.x > 1e-12))
                    continue;
                for (const float levels : {4.0f, 0.25f, 0.01f}) {
                    scene.toleranceLevels = levels;
                    const auto prepared = Flattener().prepare(scene);
                    const Projected found = projectedOn(prepared->flat, ray);
                    const double off = test::worst(dvec3(found.radiance), truth);
                    QVERIFY2(found.withinTolerance && off <= relativeTolerance(levels) + kRounding,
                             qPrintable(QString("%1 at %2 levels").arg(off).arg(levels)));
                    furthest = std::max(furthest, off / relativeTolerance(levels));
                }
            }
        }
        qInfo("furthest: %.2f of the bound", furthest);
    }

    void lanesSeeAsOneRayDoes() {
        for (unsigned seed = 1; seed <= 4; ++seed) {
            const Scene scene = partedScene(0.7f, seed, seed % 2 == 0);
            const auto prepared = Flattener().prepare(scene);
            const std::vector<Ray> rays = test::raysThrough(*scene.volume, 200, seed);
            auto batch = std::make_unique<ProjectionBatch>();
            for (const Ray& ray : rays)
                batch->add(ray, backdrop<FlatModel::absorption>(prepared->flat, PathSegment{}));
            batch->project<FlatModel::absorption>(prepared->flat);
            for (std::size_t i = 0; i < rays.size(); ++i)
                QVERIFY(batch->result(int(i)).radiance == projectedOn(prepared->flat, rays[i]).radiance);
        }
    }
};

QTEST_GUILESS_MAIN(PartedSumsTest)
#include "parted_sums_test.moc"
