/// Sums along rays through parts of the patient with curves and colours of their own, against brute force.

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

Scene partedScene(Model model, float extinctionPerMm, unsigned seed, bool masked) {
    Scene scene = test::plainScene(test::bumpyVolume({31, 22, 19}, {0.7, 1.1, 2.3}, seed), 1);
    scene.lights.clear();
    scene.model = model;
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

template <FlatModel Model>
Projected projectedOn(const FlatScene& flat, const Ray& ray) {
    return project<Model>(flat, ray, backdrop<Model>(flat, PathSegment{}));
}

Projected projectedOn(const FlatScene& flat, const Ray& ray) {
    switch (flat.optics.model) {
        case FlatModel::absorption:
            return projectedOn<FlatModel::absorption>(flat, ray);
        case FlatModel::emission:
            return projectedOn<FlatModel::emission>(flat, ray);
        default:
            return projectedOn<FlatModel::emissionAbsorption>(flat, ray);
    }
}

dvec3 truthOf(const Scene& scene, const Ray& ray, double stepMm) {
    const test::RayTruth truth = test::rayTruth(scene, ray, stepMm);
    const dvec3 behind(scene.environment.radiance);
    switch (scene.model) {
        case Model::absorption:
            return std::exp(-truth.depth) * behind;
        case Model::emission:
            return truth.emitted + behind;
        default:
            return truth.absorbed + std::exp(-truth.depth) * behind;
    }
}

double worst(dvec3 value, dvec3 truth) {
    const dvec3 off = glm::abs(value - truth) / truth;
    return std::max({off.x, off.y, off.z});
}

template <FlatModel Model>
void compareLanes(const FlatScene& flat, const std::vector<Ray>& rays) {
    auto batch = std::make_unique<ProjectionBatch>();
    for (const Ray& ray : rays)
        batch->add(ray, backdrop<Model>(flat, PathSegment{}));
    batch->template project<Model>(flat);
    for (std::size_t i = 0; i < rays.size(); ++i)
        QVERIFY(batch->result(int(i)).radiance == projectedOn<Model>(flat, rays[i]).radiance);
}

}  // namespace

class PartedSumsTest : public QObject {
    Q_OBJECT

  private slots:
    void everyRayKeepsItsBound_data() {
        QTest::addColumn<Model>("model");
        QTest::addColumn<float>("extinction");
        QTest::addColumn<bool>("masked");
        for (const bool masked : {false, true}) {
            const char* said = masked ? ", masked" : "";
            QTest::addRow("absorption%s", said) << Model::absorption << 0.5f << masked;
            QTest::addRow("emission%s", said) << Model::emission << 0.5f << masked;
            QTest::addRow("thin%s", said) << Model::emissionAbsorption << 0.02f << masked;
            QTest::addRow("middling%s", said) << Model::emissionAbsorption << 0.7f << masked;
            QTest::addRow("thick%s", said) << Model::emissionAbsorption << 15.0f << masked;
        }
    }
    void everyRayKeepsItsBound() {
        QFETCH(Model, model);
        QFETCH(float, extinction);
        QFETCH(bool, masked);
        double furthest = 0;
        for (unsigned seed = 1; seed <= 3; ++seed) {
            Scene scene = partedScene(model, extinction, seed, masked);
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
                    const double off = worst(dvec3(found.radiance), truth);
                    QVERIFY2(found.withinTolerance && off <= relativeTolerance(levels) + kRounding,
                             qPrintable(QString("%1 at %2 levels").arg(off).arg(levels)));
                    furthest = std::max(furthest, off / relativeTolerance(levels));
                }
            }
        }
        qInfo("furthest: %.2f of the bound", furthest);
    }

    void lanesSeeAsOneRayDoes() {
        for (unsigned seed = 1; seed <= 4; ++seed)
            for (const Model model : {Model::absorption, Model::emission, Model::emissionAbsorption}) {
                const Scene scene = partedScene(model, 0.7f, seed, seed % 2 == 0);
                const auto prepared = Flattener().prepare(scene);
                const std::vector<Ray> rays = test::raysThrough(*scene.volume, 200, seed);
                if (model == Model::absorption)
                    compareLanes<FlatModel::absorption>(prepared->flat, rays);
                else if (model == Model::emission)
                    compareLanes<FlatModel::emission>(prepared->flat, rays);
                else
                    compareLanes<FlatModel::emissionAbsorption>(prepared->flat, rays);
            }
    }

    /// Tissue that shines as brightly as what lies behind it cannot be seen, whatever its parts are.
    void furnaceIsInvisible() {
        Scene scene = partedScene(Model::emissionAbsorption, 2, 1, false);
        scene.environment = {vec3(1), true};
        const auto white = [](TransferFunction& curve) {
            for (TransferNode& node : curve.nodes)
                node.albedo = vec3(1);
        };
        white(scene.transferFunction);
        for (PartCurve& part : scene.parts.curves)
            white(part.transferFunction);
        const auto prepared = Flattener().prepare(scene);
        for (const Ray& ray : test::raysThrough(*scene.volume, 60, 4))
            QVERIFY(worst(dvec3(projectedOn(prepared->flat, ray).radiance), dvec3(1)) <=
                    relativeTolerance(scene.toleranceLevels) + kRounding);
    }
};

QTEST_GUILESS_MAIN(PartedSumsTest)
#include "parted_sums_test.moc"
