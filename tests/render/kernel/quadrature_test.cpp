/// The models without scattering against closed forms and against brute force, ray by ray.

#include <QTest>

#include "render/device/cpu/projection_batch.h"
#include "render/film/display/tone_map.h"
#include "render/prepare/flatten_optics.h"
#include "tests/support/scenes/ray_reference.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

/// What lies behind the volume, the same all around.
template <FlatModel Model>
vec3 behind(const PreparedScene& prepared) {
    return backdrop<Model>(prepared.flat, PathSegment{});
}

/// Rounding in single precision, relative; not part of the stated bound.
constexpr double kRounding = 1e-5;

Scene sceneOf(std::shared_ptr<const Volume> volume, Model model, TransferFunction function) {
    Scene scene = test::plainScene(std::move(volume), 1);
    scene.lights.clear();
    scene.model = model;
    scene.transferFunction = std::move(function);
    return scene;
}

/// Bands, a vertical step, a narrow ramp, and colours that change with the HU.
TransferFunction variedFunction(float extinctionPerMm) {
    return {extinctionPerMm,
            {{.hu = -700, .opacity = 0, .albedo = {0.1f, 0.2f, 0.3f}},
             {.hu = -300, .opacity = 0.3f, .albedo = {0.9f, 0.3f, 0.1f}},
             {.hu = 100, .opacity = 0.05f, .albedo = {0.8f, 0.2f, 0.1f}, .emission = vec3(0.2f)},
             {.hu = 100, .opacity = 0.5f, .albedo = {0.2f, 0.9f, 0.3f}},
             {.hu = 400, .opacity = 0.5f, .albedo = {0.2f, 0.3f, 0.9f}},
             {.hu = 401, .opacity = 0, .albedo = {0.9f, 0.9f, 0.9f}},
             {.hu = 900, .opacity = 0.9f, .albedo = {1, 0.9f, 0.1f}}}};
}

/// Returns a ray along +x through the middle of a volume, over its whole box.
Ray alongX(const Volume& volume) {
    const dvec3 spacing = volume.geometry().spacingMm();
    const vec3 size(volume.size());
    return {{-0.5f, size.y / 2 - 0.5f, size.z / 2 - 0.5f}, vec3(float(1 / spacing.x), 0, 0), float(size.x * spacing.x)};
}

vec3 radianceOf(const Scene& scene, const Ray& ray) {
    const auto prepared = Flattener().prepare(scene);
    switch (scene.model) {
        case Model::absorption:
            return project<FlatModel::absorption>(prepared->flat, ray, behind<FlatModel::absorption>(*prepared))
                .radiance;
        case Model::emission:
            return project<FlatModel::emission>(prepared->flat, ray, behind<FlatModel::emission>(*prepared)).radiance;
        default:
            return project<FlatModel::emissionAbsorption>(prepared->flat, ray,
                                                          behind<FlatModel::emissionAbsorption>(*prepared))
                .radiance;
    }
}

float highestHuOn(const std::shared_ptr<const Volume>& volume, const Ray& ray) {
    Scene scene = sceneOf(volume, Model::maximumIntensity, variedFunction(1));
    scene.window = {-1000, 3000};
    const auto prepared = Flattener().prepare(scene);
    RayMaximum<float> walk;
    walk.start(prepared->flat, {ray.origin.x, ray.origin.y, ray.origin.z},
               {ray.direction.x, ray.direction.y, ray.direction.z}, ray.length);
    while (walk.going())
        walk.step(prepared->flat);
    return walk.result().value[0];
}

bool close(double value, double truth, double relative) {
    return std::fabs(value - truth) <= relative * std::fabs(truth);
}

#define VERIFY_CLOSE(value, truth, relative) \
    QVERIFY2(close(value, truth, relative),  \
             qPrintable(                     \
                 QString("%1 instead of %2, off by %3 %4").arg(value).arg(truth).arg((value) / (truth)-1).arg(note)))

dvec3 truthOf(const Scene& scene, const Ray& ray, double stepMm) {
    const test::RayTruth truth = test::rayTruth(scene, ray, stepMm);
    const double left = std::exp(-truth.depth);
    const dvec3 environment(scene.environment.radiance);
    switch (scene.model) {
        case Model::absorption:
            return left * environment;
        case Model::emission:
            return truth.emitted + environment;
        default:
            return truth.absorbed + left * environment;
    }
}

}  // namespace

class QuadratureTest : public QObject {
    Q_OBJECT

  private slots:
    /// The HU rise by 100 a voxel and the opacity with them: depth = extinction * mean opacity * length.
    void opticalDepthOfARampIsExact() {
        const QString note;
        const auto volume = test::makeVolume({11, 4, 3}, {1, 1, 1}, [](int i, int, int) { return 100 * i; });
        const Scene scene =
            sceneOf(volume, Model::absorption, {0.3f, {{.hu = 0, .opacity = 0}, {.hu = 1000, .opacity = 1}}});
        // Half a voxel at either end is constant: 0 and 1.
        VERIFY_CLOSE(radianceOf(scene, alongX(*volume)).x, std::exp(-0.3 * (10 * 0.5 + 0.5)), 1e-6);
        const float s = std::sqrt(0.5f);
        const Ray oblique{{1.25f, 0.1f, 0.3f}, {s, s / 4, s / 8}, 10};
        const double mean = (1.25 + 5 * double(s)) / 10;
        VERIFY_CLOSE(radianceOf(scene, oblique).x, std::exp(-0.3 * 10 * mean), 1e-6);
    }

    /// Source and extinction both linear in the way: int sigma c ds is a cubic's integral.
    void emissionOfARampIsExact() {
        const QString note;
        const auto volume = test::makeVolume({11, 4, 3}, {1, 1, 1}, [](int i, int, int) { return 100 * i; });
        const TransferFunction function{
            0.3f, {{.hu = 0, .opacity = 0, .albedo = vec3(0.2f)}, {.hu = 1000, .opacity = 1, .albedo = vec3(0.8f)}}};
        // int_0^10 0.3 (x / 10) (0.2 + 0.06 x) dx, and the half voxel at the end.
        VERIFY_CLOSE(radianceOf(sceneOf(volume, Model::emission, function), alongX(*volume)).x,
                     0.03 * (0.2 * 50 + 0.06 * 1000 / 3) + 0.3 * 0.5 * 0.8, 2e-6);
    }

    void constantSlabIsTheClosedForm() {
        const auto volume = test::makeVolume({9, 5, 5}, {1, 1, 1}, [](int, int, int) { return 7; });
        for (const float extinction : {1e-6f, 1e-3f, 0.1f, 1.0f, 30.0f, 1e3f, 1e6f}) {
            const QString note = QString("at %1 per mm").arg(extinction);
            Scene scene = sceneOf(volume, Model::emissionAbsorption,
                                  {extinction, {{.albedo = vec3(0.5f), .emission = vec3(0.2f)}}});
            scene.transferFunction.nodes[0].opacity = 1;
            const double depth = 9.0 * extinction;
            VERIFY_CLOSE(radianceOf(scene, alongX(*volume)).x, 0.7 * -std::expm1(-depth), 2e-3);
            scene.toleranceLevels = 1e-3f;
            VERIFY_CLOSE(radianceOf(scene, alongX(*volume)).x, 0.7 * -std::expm1(-depth), 2e-5);
            scene.model = Model::emission;
            VERIFY_CLOSE(radianceOf(scene, alongX(*volume)).x, 0.7 * depth, 2e-6);
            scene.model = Model::absorption;
            if (depth < 80)
                VERIFY_CLOSE(radianceOf(scene, alongX(*volume)).x, std::exp(-depth), 1e-5);
            else
                QVERIFY(radianceOf(scene, alongX(*volume)).x < 1e-34f);
        }
    }

    /// Between voxels 4 and 5 the HU pass 500 exactly in the middle, where the tissue changes.
    void twoLayersMeetWhereTheStepIs() {
        const QString note;
        const auto volume = test::makeVolume({10, 5, 5}, {1, 1, 1}, [](int i, int, int) { return i < 5 ? 0 : 1000; });
        Scene scene = sceneOf(
            volume, Model::absorption,
            {1,
             {{.hu = 500, .opacity = 0.2f, .albedo = vec3(0.4f)}, {.hu = 500, .opacity = 0.9f, .albedo = vec3(0.8f)}}});
        VERIFY_CLOSE(radianceOf(scene, alongX(*volume)).x, std::exp(-5 * 0.2 - 5 * 0.9), 1e-6);
        scene.model = Model::emissionAbsorption;
        scene.toleranceLevels = 1e-3f;
        VERIFY_CLOSE(radianceOf(scene, alongX(*volume)).x,
                     0.4 * -std::expm1(-1.0) + std::exp(-1.0) * 0.8 * -std::expm1(-4.5), 2e-5);
        // A quarter of the way up, and nothing before: the step is at 4.25.
        scene.transferFunction.nodes = {{.hu = 250, .opacity = 0}, {.hu = 250, .opacity = 1}};
        scene.model = Model::absorption;
        VERIFY_CLOSE(radianceOf(scene, alongX(*volume)).x, std::exp(-5.25), 1e-6);
        // Backwards it is the same.
        Ray back = alongX(*volume);
        back.origin.x = 9.5f;
        back.direction.x = -1;
        VERIFY_CLOSE(radianceOf(scene, back).x, std::exp(-5.25), 1e-6);
    }

    void nearlyVerticalStepIsAStep() {
        const QString note;
        const auto volume = test::makeVolume({10, 5, 5}, {1, 1, 1}, [](int i, int, int) { return 40 * i; });
        const Scene scene =
            sceneOf(volume, Model::absorption, {1, {{.hu = 100, .opacity = 0}, {.hu = 100.00004f, .opacity = 1}}});
        VERIFY_CLOSE(radianceOf(scene, alongX(*volume)).x, std::exp(-7.0), 2e-6);
    }

    /// A volume that lies exactly at a step shows its right-hand side, everywhere.
    void aStepIsRightContinuous() {
        const QString note;
        const auto volume = test::makeVolume({6, 6, 6}, {1, 1, 1}, [](int, int, int) { return 300; });
        const Scene clear =
            sceneOf(volume, Model::absorption, {1, {{.hu = 300, .opacity = 1}, {.hu = 300, .opacity = 0}}});
        const Scene opaque =
            sceneOf(volume, Model::absorption, {1, {{.hu = 300, .opacity = 0}, {.hu = 300, .opacity = 1}}});
        for (const Ray& ray : test::raysThrough(*volume, 50, 3)) {
            QCOMPARE(radianceOf(clear, ray).x, 1.0f);
            VERIFY_CLOSE(radianceOf(opaque, ray).x, std::exp(-ray.length), 2e-6);
        }
    }

    /// Tissue that shines as brightly as what lies behind it cannot be seen.
    void furnaceIsInvisible() {
        const QString note;
        const auto volume = test::bumpyVolume({23, 17, 14}, {0.7, 1.1, 2.3}, 1);
        for (const float levels : {0.25f, 0.01f})
            for (const float extinction : {1e-6f, 1e-2f, 1.0f, 1e2f, 1e6f}) {
                Scene scene = sceneOf(volume, Model::emissionAbsorption, variedFunction(extinction));
                for (TransferNode& node : scene.transferFunction.nodes)
                    node.albedo = vec3(1), node.emission = vec3(0);
                scene.environment = {vec3(1), true};
                scene.toleranceLevels = levels;
                for (const Ray& ray : test::raysThrough(*volume, 40, 4))
                    VERIFY_CLOSE(radianceOf(scene, ray).y, 1.0, relativeTolerance(levels) + kRounding);
            }
    }

    void everyRayKeepsItsBound_data() {
        QTest::addColumn<Model>("model");
        QTest::addColumn<float>("extinction");
        QTest::addColumn<bool>("lit");
        QTest::newRow("absorption") << Model::absorption << 0.5f << true;
        QTest::newRow("emission") << Model::emission << 0.5f << true;
        QTest::newRow("thin") << Model::emissionAbsorption << 0.02f << true;
        QTest::newRow("middling") << Model::emissionAbsorption << 0.7f << false;
        QTest::newRow("thick") << Model::emissionAbsorption << 20.0f << true;
        QTest::newRow("nearly opaque") << Model::emissionAbsorption << 1000.0f << false;
        QTest::newRow("clear above, too") << Model::emissionAbsorption << 0.5f << false;
    }
    void everyRayKeepsItsBound() {
        QFETCH(Model, model);
        QFETCH(float, extinction);
        QFETCH(bool, lit);
        const auto volume = test::bumpyVolume({31, 22, 19}, {0.7, 1.1, 2.3}, 2);
        Scene scene = sceneOf(volume, model, variedFunction(extinction));
        scene.environment = {vec3(lit ? 0.3f : 0.0f), lit};
        if (QString(QTest::currentDataTag()) == "clear above, too")
            scene.transferFunction.nodes.push_back({.hu = 950, .opacity = 0});
        const double stepMm = std::min(4e-4, 8e-3 / extinction);
        for (const Ray& whole : test::raysThrough(*volume, 20, 5)) {
            // Behind an optical depth of some 30 nothing shows, and brute force would take hours.
            Ray ray = whole;
            if (extinction > 100)
                ray.length = std::min(ray.length, 1.5f);
            const dvec3 truth = truthOf(scene, ray, stepMm);
            if (!(truth.x > 1e-20))
                continue;
            for (const float levels : {4.0f, 0.25f, 0.01f}) {
                scene.toleranceLevels = levels;
                const double off = test::worst(dvec3(radianceOf(scene, ray)), truth);
                QVERIFY2(off <= relativeTolerance(levels) + 3 * kRounding,
                         qPrintable(QString("%1 at %2 levels").arg(off).arg(levels)));
            }
        }
    }

    /// The check above has power: a march in steps of half a millimetre does not pass it.
    void marchOfHalfAMillimetreFails() {
        const auto volume = test::bumpyVolume({31, 22, 19}, {0.7, 1.1, 2.3}, 2);
        Scene scene = sceneOf(volume, Model::emissionAbsorption, variedFunction(0.7f));
        int failed = 0;
        for (const Ray& ray : test::raysThrough(*volume, 25, 5)) {
            const dvec3 truth = truthOf(scene, ray, 1e-3);
            dvec3 marched(0);
            double left = 1;
            for (double t = 0.25; t < ray.length; t += 0.5) {
                const test::Optics optics = test::opticsAt(
                    scene.transferFunction, test::huAt(*volume, dvec3(ray.origin) + dvec3(ray.direction) * t));
                marched += left * -std::expm1(-0.5 * optics.extinction) * optics.source;
                left *= std::exp(-0.5 * optics.extinction);
            }
            failed += test::worst(marched, truth) > relativeTolerance(0.25) + 3 * kRounding;
        }
        QVERIFY2(failed >= 8, qPrintable(QString::number(failed)));
    }

    void highestHuIsExact() {
        for (const dvec3 spacing : {dvec3(1), dvec3(0.3, 1.1, 5)}) {
            const auto volume = test::bumpyVolume({33, 20, 21}, spacing, 7);
            for (const Ray& ray : test::raysThrough(*volume, 60, 8)) {
                const double truth = test::highestOn(*volume, ray, 2e-3), highest = highestHuOn(volume, ray);
                QVERIFY2(std::fabs(highest - truth) < 2e-2,
                         qPrintable(QString("%1 instead of %2").arg(highest).arg(truth)));
            }
        }
        // One HU more at a time, below 0 too: no cell is passed that has more to show.
        const auto stairs = test::makeVolume({96, 3, 3}, dvec3(1), [](int i, int, int) { return i / 8 - 6; });
        QCOMPARE(highestHuOn(stairs, alongX(*stairs)), 5.0f);
    }

    void smallestVolumesAreConstantAcross() {
        const QString note;
        for (const ivec3 size : {ivec3(1, 1, 1), ivec3(2, 1, 1), ivec3(1, 9, 1), ivec3(1, 1, 5), ivec3(5, 1, 3)}) {
            const auto volume = test::makeVolume(size, dvec3(2, 1, 0.5), [](int, int, int) { return 7; });
            const Scene scene = sceneOf(volume, Model::absorption, {0.3f, {{.hu = 0, .opacity = 1}}});
            for (const Ray& ray : test::raysThrough(*volume, 20, 9))
                VERIFY_CLOSE(radianceOf(scene, ray).x, std::exp(-0.3 * ray.length), 2e-6);
            Scene ramp =
                sceneOf(test::makeVolume(size, dvec3(2, 1, 0.5), [](int, int j, int k) { return 30 * (j + k); }),
                        Model::emissionAbsorption, variedFunction(1));
            ramp.transferFunction.nodes[0].hu = -1000;
            for (const Ray& ray : test::raysThrough(*ramp.volume, 5, 10))
                QVERIFY(test::worst(dvec3(radianceOf(ramp, ray)), truthOf(ramp, ray, 1e-3)) <
                        relativeTolerance(0.25) + kRounding);
        }
    }

    void lanesAndSingleRaysAgreeBitByBit() {
        const auto volume = test::bumpyVolume({61, 45, 38}, {0.7, 1.1, 2.3}, 1);
        const auto compare = [&]<FlatModel M>(Model model, float extinction) {
            Scene scene = sceneOf(volume, model, variedFunction(extinction));
            scene.environment = {vec3(0.1f, 0.2f, 0.3f), true};
            const auto prepared = Flattener().prepare(scene);
            const std::vector<Ray> rays = test::raysThrough(*volume, ProjectionBatch::kCapacity - 3, 6);
            auto batch = std::make_unique<ProjectionBatch>();
            for (const Ray& ray : rays)
                batch->add(ray, behind<M>(*prepared));
            batch->project<M>(prepared->flat);
            for (int i = 0; i < int(rays.size()); ++i) {
                const Projected one = project<M>(prepared->flat, rays[i], behind<M>(*prepared));
                QCOMPARE(batch->result(i).radiance.x, one.radiance.x);
                QCOMPARE(batch->result(i).radiance.y, one.radiance.y);
                QCOMPARE(batch->result(i).radiance.z, one.radiance.z);
                QCOMPARE(batch->result(i).withinTolerance, one.withinTolerance);
                QVERIFY(one.withinTolerance);
            }
        };
        for (const float extinction : {0.01f, 1.0f, 100.0f}) {
            compare.operator()<FlatModel::absorption>(Model::absorption, extinction);
            compare.operator()<FlatModel::emission>(Model::emission, extinction);
            compare.operator()<FlatModel::emissionAbsorption>(Model::emissionAbsorption, extinction);
        }
        compare.operator()<FlatModel::maximumIntensity>(Model::maximumIntensity, 1);
    }

    /// A tolerance that cannot be met is reported, and the ray ends in time.
    void rayThatCannotKeepItsToleranceSaysSo() {
        const auto volume = test::bumpyVolume({23, 17, 14}, {0.7, 1.1, 2.3}, 1);
        const auto prepared = test::prepared(sceneOf(volume, Model::emissionAbsorption, variedFunction(1)));
        QVERIFY(project<FlatModel::emissionAbsorption>(prepared->flat, alongX(*volume),
                                                       behind<FlatModel::emissionAbsorption>(*prepared))
                    .withinTolerance);
        prepared->flat.optics.quadrature = -1;  // not even an error of 0 will do
        QVERIFY(!project<FlatModel::emissionAbsorption>(prepared->flat, alongX(*volume),
                                                        behind<FlatModel::emissionAbsorption>(*prepared))
                     .withinTolerance);
    }

    /// No exposure and no colour makes relative errors of relativeTolerance(levels), of whatever sign in each channel,
    /// show as more than `levels`.
    void toleranceIsInDisplayLevels() {
        const auto display = [](double light) {
            return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
        };
        const auto alone = [&](double channel) { return display(-std::expm1(-channel)); };
        const auto keepingHue = [&](double channel, double another) {
            const double p = std::max(channel, another), n = -std::expm1(-p);
            const double towardsWhite = 1 - 1 / (1 + 0.12 * (p - n));
            return display(n * ((1 - towardsWhite) * channel / p + towardsWhite));
        };
        for (const double levels : {1e-3, 0.25, 1.0, 16.0}) {
            const double fraction = relativeTolerance(levels);
            double largest = 0;
            for (double radiance = 1e-5; radiance < 20; radiance *= 1.01)
                for (const double sign : {-1.0, 1.0}) {
                    const double off = radiance * (1 + sign * fraction);
                    largest = std::max(largest, std::abs(alone(off) - alone(radiance)));
                    for (double share = 0.1; share < 1.05; share += 0.1) {
                        const double another = radiance / share;
                        largest = std::max(largest, std::abs(keepingHue(off, another * (1 - sign * fraction)) -
                                                             keepingHue(radiance, another)));
                    }
                }
            QVERIFY2(largest <= levels * (1 + 1e-3) && largest > 0.75 * levels, qPrintable(QString::number(largest)));
        }
    }
};

QTEST_GUILESS_MAIN(QuadratureTest)
#include "quadrature_test.moc"
