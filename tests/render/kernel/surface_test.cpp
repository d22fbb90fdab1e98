/// Surfaces by what their formulas say in words: what reflects as much either way, what is known where all directions
/// coincide, how often a place is a surface, and that samples have the density that is stated.

#include <QTest>

#include "render/kernel/transport/event.h"
#include "tests/support/scenes/scenes.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

const vec3 kNormal = glm::normalize(vec3(0.3f, -0.5f, 0.8f));

/// A unit vector at cosine `cosine` to the normal, turned by `angle` about it.
vec3 at(float cosine, float angle) {
    vec3 s, t;
    orthonormalBasis(kNormal, s, t);
    return kNormal * cosine + (s * std::cos(angle) + t * std::sin(angle)) * std::sqrt(1 - cosine * cosine);
}

Material shiny(float specular, float roughness, vec3 albedo = vec3(0.8f, 0.5f, 0.2f)) {
    return {.albedo = albedo, .specular = vec3(specular), .roughness = roughness};
}

bool close(double a, double b, double fraction) {
    return std::fabs(a - b) <= fraction * std::fabs(b);
}

/// The HU rise by 100 a voxel along x up to voxel 10, and by 300 from there on; spacing 2 x 1 x 1 mm.
Scene bentRamp() {
    Scene scene =
        test::plainScene(test::makeVolume({20, 8, 8}, {2, 1, 1},
                                          [](int i, int, int) { return i < 10 ? 100 * i : 1000 + 300 * (i - 10); }),
                         1);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 2000, .opacity = 1}};
    return scene;
}

/// The largest u of a thousandth's raster at which a place is a surface still.
double surfaceShare(const Scene& scene, vec3 position) {
    const auto prepared = test::prepared(scene);
    const float hu = hounsfield(prepared->flat.volume, position);
    int count = 0;
    for (int i = 0; i < 10'000; ++i)
        count += surfaceNormal(prepared->flat, prepared->flat.transferFunction, position, vec3(-1, 0, 0), hu,
                               (float(i) + 0.5f) / 10'000) != vec3(0);
    return count / 10'000.0;
}

}  // namespace

class SurfaceTest : public QObject {
    Q_OBJECT

  private slots:
    /// Seen, lit and facing the same way, GGX has 1 / (pi alpha^2) of its microfacets there, none hides another, and
    /// light crosses the gloss twice on its way to what lies below. alpha is the square of the roughness (Burley 2012).
    void straightOnItIsTheClosedForm() {
        for (const float roughness : {0.3f, 0.6f, 1.0f})
            for (const float specular : {0.04f, 0.5f}) {
                const vec3 got = surfaceEval(shiny(specular, roughness), kNormal, kNormal, kNormal);
                const double alpha = double(roughness) * double(roughness),
                             gloss = double(specular) / (4 * M_PI * alpha * alpha);
                const double below = (1 - double(specular)) * (1 - double(specular)) / M_PI;
                QVERIFY(close(got.x, gloss + 0.8 * below, 1e-5));
                QVERIFY(close(got.y, gloss + 0.5 * below, 1e-5));
                QVERIFY(close(got.z, gloss + 0.2 * below, 1e-5));
            }
    }

    /// Schlick 1994: F0 + (1 - F0) (1 - cos)^5.
    void fresnelIsSchlicks() {
        QVERIFY(close(fresnel(vec3(0.04f), 1.0f).x, 0.04, 1e-6));
        QVERIFY(close(fresnel(vec3(0.04f), 0.5f).x, 0.04 + 0.96 / 32, 1e-6));
        QVERIFY(close(fresnel(vec3(0.04f), 0.25f).x, 0.04 + 0.96 * std::pow(0.75, 5), 1e-6));
        QVERIFY(close(fresnel(vec3(0.04f), 0.0f).x, 1, 1e-6));
    }

    /// Helmholtz: light goes either way alike.
    void lightGoesEitherWayAlike() {
        for (const float roughness : {0.2f, 0.7f})
            for (const auto& [a, b] :
                 {std::pair(at(0.9f, 0), at(0.3f, 1)), {at(0.5f, 2), at(0.1f, 5)}, {at(1, 0), at(0.6f, 4)}}) {
                const Material material = shiny(0.2f, roughness);
                const double there = surfaceEval(material, kNormal, a, b).x / glm::dot(kNormal, b);
                const double back = surfaceEval(material, kNormal, b, a).x / glm::dot(kNormal, a);
                QVERIFY2(close(there, back, 1e-4), qPrintable(QString("%1 and %2").arg(there).arg(back)));
            }
    }

    /// The mean of f / density over samples is the integral of f: pi for the cosine, 2 pi / 3 for its square, and
    /// what the surface reflects of a beam is the same whether sampled by the surface or all around.
    void samplesHaveTheDensityThatIsStated() {
        for (const auto& [specular, roughness] : {std::pair(0.04f, 0.8f), {0.5f, 0.7f}, {0.9f, 0.6f}})
            for (const float cosine : {0.9f, 0.4f}) {
                const Material material = shiny(specular, roughness, vec3(0.3f));
                const vec3 view = at(cosine, 1);
                test::Sample one, two, reflected, evenly;
                for (std::uint64_t i = 0; i < 300'000; ++i) {
                    const Random random(7, 1, i);
                    const vec2 u = random.stream(Dimension::filter).pair(), v = random.stream(Dimension::lens).pair();
                    const vec3 towards = surfaceSample(material, kNormal, view, v.x, u);
                    const double density = surfacePdf(material, kNormal, view, towards);
                    const double up = density > 0 ? std::max(glm::dot(kNormal, towards), 0.0f) : 0;
                    one.add(density > 0 ? up / density : 0);
                    two.add(density > 0 ? up * up / density : 0);
                    reflected.add(density > 0 ? double(surfaceEval(material, kNormal, view, towards).x) / density : 0);
                    evenly.add(double(surfaceEval(material, kNormal, view, at(u.x, 2 * kPi * u.y)).x) * 2 * M_PI);
                }
                const double allowed = test::allowedZ(18),
                             error = std::hypot(reflected.standardError(), evenly.standardError());
                const QString where = QString("specular %1, cosine %2: ").arg(specular).arg(cosine);
                QVERIFY2(std::fabs(one.z(M_PI)) < allowed, qPrintable(where + QString::number(one.mean())));
                QVERIFY2(std::fabs(two.z(2 * M_PI / 3)) < allowed, qPrintable(where + QString::number(two.mean())));
                QVERIFY2(std::fabs(reflected.mean() - evenly.mean()) < allowed * error,
                         qPrintable(where + QString("%1 and %2").arg(reflected.mean()).arg(evenly.mean())));
                QVERIFY2(one.standardError() < 0.005 * M_PI, qPrintable(where + "no power"));
            }
    }

    /// P = opacity (1 - exp(-25 g^3 |gradient| / 4096)), the gradient per millimetre between the voxels on both sides:
    /// 50 HU/mm below the bend, 150 above, 100 on it.
    void surfacesAreAsFrequentAsTheirFormulaSays() {
        for (const float factor : {0.5f, 1.0f, 1.5f})
            for (const auto& [x, gradient, opacity] :
                 {std::tuple(5.0f, 50.0, 0.25), {15.0f, 150.0, 1.0}, {10.0f, 100.0, 0.5}}) {
                Scene scene = bentRamp();
                scene.gradientFactor = factor;
                const double g = factor, truth = opacity * -std::expm1(-25 * g * g * g * gradient / 4096);
                const double got = surfaceShare(scene, {x, 4, 4});
                QVERIFY2(std::fabs(got - truth) < 2e-4, qPrintable(QString("%1, must be %2").arg(got).arg(truth)));
            }
    }

    /// The normal points towards where the path came from, along the gradient in millimetres and not in voxels.
    void theNormalFacesTheViewer() {
        Scene scene = bentRamp();
        scene.volume = test::makeVolume({16, 16, 16}, {4, 1, 1}, [](int i, int j, int) { return 40 * i + 20 * j; });
        scene.gradientFactor = 100;
        const auto prepared = test::prepared(scene);
        const vec3 gradient = glm::normalize(vec3(10, 20, 0));
        for (const vec3 travel : {vec3(0, 1, 0), vec3(0, -1, 0), vec3(1, 0, 0)}) {
            const vec3 normal =
                surfaceNormal(prepared->flat, prepared->flat.transferFunction, vec3(8), -travel, 1500, 1e-3f);
            QVERIFY(glm::dot(normal, travel) < 0);
            QVERIFY(glm::length(glm::abs(normal) - gradient) < 1e-4f);
        }
    }
};

QTEST_GUILESS_MAIN(SurfaceTest)
#include "surface_test.moc"
