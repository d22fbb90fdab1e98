/// Tests how lights and surfaces are sampled: densities against the directions that are really found, and what the
/// samples bring against closed forms. Numbers are addressed with fixed seeds; allowedZ over all comparisons of this
/// file, 1e-6 for a distribution.

#include <QTest>

#include <functional>

#include "render/kernel/transport/direct_light.h"
#include "tests/physics/gauss_legendre.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

constexpr int kComparisons = 40;
constexpr double kAlarm = 1e-6;
constexpr int kSamples = 1 << 20;

FlatLight ballLight(float radius) {
    FlatLight light{.type = LightType::sphere, .radiance = vec3(1)};
    light.radius = radius;
    return light;
}

FlatLight panelLight(vec3 halfU, vec3 halfV) {
    FlatLight light{.type = LightType::rectangle, .radiance = vec3(1)};
    light.normal = glm::normalize(glm::cross(halfU, halfV));
    light.halfU = halfU;
    light.halfV = halfV;
    light.area = 4 * glm::length(halfU) * glm::length(halfV);
    return light;
}

LightSample sampled(const FlatLight& light, vec3 from, vec2 u) {
    return sampleLight<kPlacedLights>(light, from, u);
}

/// f(sample) over many samples of `light` as seen from `from`, which is measured from the light's centre.
test::Sample overSamples(const FlatLight& light, vec3 from, const std::function<double(const LightSample&)>& f) {
    RandomStream random = Random(5, 1, 0).stream(0, BounceDimension::light);
    test::Sample sample;
    for (int i = 0; i < 4 * kSamples; ++i)
        sample.add(f(sampled(light, from, random.pair())));
    return sample;
}

void verifyMean(const test::Sample& got, double truth, double finds = 0.004) {
    const double allowed = test::allowedZ(kComparisons);
    QVERIFY2(std::fabs(got.mean() - truth) < allowed * got.standardError() + 2e-6 * truth,
             qPrintable(QString("%1 +- %2 instead of %3").arg(got.mean()).arg(got.standardError()).arg(truth)));
    QVERIFY2((allowed + 1.2816) * got.standardError() <= finds * truth, "the comparison has no power");
}

/// Verifies that both ways of finding a light give the same distance and density for the same direction.
void verifyBothWaysAgree(const FlatLight& light, vec3 from) {
    RandomStream random = Random(6, 1, 0).stream(0, BounceDimension::light);
    int missed = 0;
    for (int i = 0; i < 20000; ++i) {
        const LightSample sample = sampled(light, from, random.pair());
        const LightHit hit = intersectLight(light, from, sample.wi);
        missed += !hit.met;  // rounding at the rim
        if (!hit.met)
            continue;
        QVERIFY(std::fabs(sample.pdf / hit.pdf - 1) < 1e-4f);
        const float rim = light.type == LightType::sphere ? 0.02f * light.radius : 0;
        QVERIFY(std::fabs(sample.distance - hit.distance) < 1e-4f * hit.distance + rim);
        QVERIFY(std::fabs(sample.radiance.x * sample.pdf - 1) < 1e-5f);  // the light's own, which is 1
    }
    QVERIFY(missed < 20);
}

/// Integral of the density with which a scattered ray is said to be found by the light's own samples.
double integralOfDensity(const FlatLight& light, vec3 from, dvec3 axis, double leastCosine) {
    const dvec3 s = glm::normalize(glm::cross(axis, dvec3(0.3, 0.5, -0.8))), t = glm::cross(axis, s);
    constexpr int kSteps = 2000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = leastCosine + (1 - leastCosine) * (i + 0.5) / kSteps,
                     sine = std::sqrt(1 - cosine * cosine);
        for (int k = 0; k < kSteps; ++k) {
            const double angle = 2 * M_PI * (k + 0.5) / kSteps;
            const LightHit hit =
                intersectLight(light, from, vec3(axis * cosine + (s * std::cos(angle) + t * std::sin(angle)) * sine));
            sum += hit.met && hit.distance > 0 ? hit.pdf : 0;
        }
    }
    return sum * 2 * M_PI * (1 - leastCosine) / kSteps / kSteps;
}

/// Directions about the normal, by height and angle: what surfacePdf promises each bin, and what surfaceSample brings.
/// Bin 0 stands for all that is sent below the surface.
constexpr int kHeights = 12, kAngles = 12;

std::vector<double> promised(const Material& material, vec3 view) {
    static const std::vector<test::QuadraturePoint> points = test::gaussLegendre(24);
    std::vector<double> bins(1 + kHeights * kAngles);
    for (int height = 0; height < kHeights; ++height)
        for (int angle = 0; angle < kAngles; ++angle)
            for (const test::QuadraturePoint& a : points)
                for (const test::QuadraturePoint& b : points) {
                    const double z = (height + a.at) / kHeights, turn = 2 * M_PI * (angle + b.at) / kAngles;
                    const double sine = std::sqrt(1 - z * z);
                    const vec3 towards(sine * std::cos(turn), sine * std::sin(turn), z);
                    bins[1 + height * kAngles + angle] += double(surfacePdf(material, {0, 0, 1}, view, towards)) *
                                                          a.weight * b.weight * 2 * M_PI / kHeights / kAngles;
                }
    return bins;
}

std::vector<double> found(const Material& material, vec3 view) {
    std::vector<double> bins(1 + kHeights * kAngles);
    RandomStream random = Random(8, 1, 0).stream(0, BounceDimension::direction);
    for (int i = 0; i < kSamples; ++i) {
        const float choice = random.pair().x;
        const vec3 towards = surfaceSample(material, {0, 0, 1}, view, choice, random.pair());
        const double turn = std::atan2(double(towards.y), double(towards.x)) / (2 * M_PI);
        const int height = std::min(int(towards.z * kHeights), kHeights - 1);
        const int angle = std::min(int((turn - std::floor(turn)) * kAngles), kAngles - 1);
        bins[towards.z <= 0 ? 0 : std::size_t(1 + height * kAngles + angle)] += 1;
    }
    return bins;
}

}  // namespace

class LightSamplingTest : public QObject {
    Q_OBJECT

  private slots:
    void densitiesIntegrateToOne() {
        for (const float radius : {0.5f, 3.0f, 4.9f}) {
            const vec3 from(3, 0, 4);
            const double leastCosine = std::sqrt(1 - double(radius) * radius / 25) - 0.01;
            const double whole = integralOfDensity(ballLight(radius), from, -glm::normalize(dvec3(from)), leastCosine);
            QVERIFY2(std::fabs(whole - 1) < 3e-3, qPrintable(QString::number(whole)));
        }
        const FlatLight panel = panelLight({2, 0, 0}, {0, 1.2f, 0.9f});
        for (const vec3 from : {vec3(0.5f, -3, 4), vec3(4, 0, 2)}) {
            const double whole = integralOfDensity(panel, from, -glm::normalize(dvec3(from)), 0);
            QVERIFY2(std::fabs(whole - 1) < 3e-3, qPrintable(QString::number(whole)));
        }
    }

    void bothWaysOfFindingALightAgree() {
        for (const float radius : {0.01f, 0.5f, 3.0f, 4.9f})
            verifyBothWaysAgree(ballLight(radius), {3, 0, 4});
        verifyBothWaysAgree(panelLight({2, 0, 0}, {0, 1.2f, 0.9f}), {0.5f, -3, 4});
        verifyBothWaysAgree(panelLight({0.02f, 0, 0}, {0, 0.03f, 0}), {1, 2, 3});
    }

    /// All of a ball's cone is equally likely: heights and angles in 16 x 16 bins.
    void ballFillsItsConeEvenly() {
        const FlatLight ball = ballLight(3);
        const dvec3 axis(0, 0, 1), from(0, 0, -5);
        const double cone = 1 - 0.8;  // 3, 4, 5
        std::vector<double> bins(256);
        overSamples(ball, vec3(from), [&](const LightSample& sample) {
            const dvec3 towards(sample.wi);
            const double height = glm::dot(towards - axis, towards - axis) / 2 / cone;
            const double turn = std::atan2(towards.y, towards.x) / (2 * M_PI) + 0.5;
            ++bins[std::size_t(std::min(15, int(16 * height)) * 16 + std::min(15, int(16 * turn)))];
            return height;
        });
        QVERIFY2(test::uniformP(bins) > kAlarm, qPrintable(QString::number(test::uniformP(bins))));
    }

    void panelIsFilledEvenly() {
        const FlatLight panel = panelLight({2, 0, 0}, {0, 1.2f, 0});
        const vec3 from(1, 3, 2);
        std::vector<double> bins(256);
        overSamples(panel, from, [&](const LightSample& sample) {
            const vec3 place = from + sample.wi * sample.distance;
            const double u = place.x / 4 + 0.5, v = place.y / 2.4 + 0.5;
            ++bins[std::size_t(std::clamp(int(16 * u), 0, 15) * 16 + std::clamp(int(16 * v), 0, 15))];
            return u;
        });
        QVERIFY2(test::uniformP(bins) > kAlarm, qPrintable(QString::number(test::uniformP(bins))));
    }

    /// A plane whose normal makes the angle a with the direction to a ball gets pi (r / d)^2 cos a; its height above
    /// the plane, squared, averages to the mean over a disc: textbook moments of the cone.
    void ballBringsItsIrradianceAndMoments() {
        for (const float radius : {0.5f, 2.0f, 3.0f}) {
            const FlatLight ball = ballLight(radius);
            const vec3 from(0, 0, -5), normal(0.6f, 0, 0.8f);  // the ball of 3 just touches the horizon
            const double sine2 = double(radius) * radius / 25, cosine = std::sqrt(1 - sine2);
            verifyMean(overSamples(ball, from,
                                   [&](const LightSample& s) {
                                       return double(s.radiance.x) * std::max(0.0f, glm::dot(s.wi, normal));
                                   }),
                       M_PI * sine2 * 0.8);
            verifyMean(
                overSamples(ball, from, [&](const LightSample& s) { return double(s.radiance.x) * s.wi.z * s.wi.z; }),
                2 * M_PI * (1 - cosine * cosine * cosine) / 3);
            verifyMean(
                overSamples(ball, from,
                            [&](const LightSample& s) { return double(s.radiance.x) * s.wi.x * s.wi.x / sine2; }),
                M_PI * (2.0 / 3 - cosine + cosine * cosine * cosine / 3) / sine2);
        }
    }

    /// Straight below a corner of a panel of a x b at the distance 1: configuration factor of a plane element.
    void panelBringsItsConfigurationFactor() {
        for (const auto& [a, b] : {std::pair{1.0, 1.0}, {0.3, 2.0}, {1.5, 0.5}}) {
            const FlatLight panel = panelLight({0, float(b / 2), 0}, {float(a / 2), 0, 0});  // shines to -z
            const vec3 from(float(-a / 2), float(-b / 2), -1);
            const double A = a / std::sqrt(1 + a * a), B = b / std::sqrt(1 + b * b);
            const double factor =
                (A * std::atan(b / std::sqrt(1 + a * a)) + B * std::atan(a / std::sqrt(1 + b * b))) / 2;
            verifyMean(overSamples(panel, from,
                                   [](const LightSample& s) { return double(s.radiance.x) * std::max(0.0f, s.wi.z); }),
                       factor);  // over pi, times pi
        }
    }

    /// Directions of reflection are found as often as their density says; what it lacks goes below the surface.
    void surfacesAreSampledAsTheirDensitySays_data() {
        QTest::addColumn<float>("roughness");
        QTest::addColumn<float>("specular");
        QTest::addColumn<float>("cosine");
        for (const float roughness : {0.45f, 0.7f, 1.0f})
            for (const float specular : {0.0f, 0.04f, 0.9f})
                for (const float cosine : {0.25f, 0.9f})
                    QTest::addRow("roughness %g, specular %g, seen at %g", roughness, specular, cosine)
                        << roughness << specular << cosine;
    }
    void surfacesAreSampledAsTheirDensitySays() {
        QFETCH(float, roughness);
        QFETCH(float, specular);
        QFETCH(float, cosine);
        const Material material{vec3(0.6f), vec3(0), vec3(specular), roughness};
        const vec3 view(std::sqrt(1 - cosine * cosine), 0, cosine);
        const std::vector<double> expected = promised(material, view), bins = found(material, view);
        double above = 0, square = 0;
        int freedom = 0;
        for (std::size_t i = 1; i < bins.size(); ++i) {
            above += expected[i];
            if (expected[i] * kSamples < 20)
                continue;
            square += std::pow(bins[i] - expected[i] * kSamples, 2) / (expected[i] * kSamples);
            ++freedom;
        }
        const double whole = above + bins[0] / kSamples;
        QVERIFY2(std::fabs(whole - 1) < 0.001 + 5 * std::sqrt(bins[0]) / kSamples, qPrintable(QString::number(whole)));
        QVERIFY2(test::chiSquareP(square, freedom) > kAlarm, qPrintable(QString("%1 on %2").arg(square).arg(freedom)));
    }

    /// One of several light paths stands for all: the mean of each is what it was.
    void oneOfManyLightPathsStandsForAll() {
        const double strengths[] = {0.5, 3, 0, 1.25, 40};
        RandomStream random = Random(9, 1, 0).stream(0, BounceDimension::choice);
        test::Sample brought[5];
        for (int i = 0; i < kSamples; ++i) {
            LightReservoir choice(random.pair().x);
            for (int light = 0; light < 5; ++light)
                choice.offer(true, vec3(float(light)), 1, vec3(1, 2, 0.5f) * float(strengths[light]));
            for (int light = 0; light < 5; ++light)
                brought[light].add(choice.wi.x == float(light) ? choice.radianceOfAll().y : 0);
        }
        QCOMPARE(brought[2].mean(), 0.0);
        for (const int light : {1, 3, 4})
            verifyMean(brought[light], 2 * strengths[light], 0.05);
        verifyMean(brought[4], 80);
    }
};

QTEST_GUILESS_MAIN(LightSamplingTest)
#include "light_sampling_test.moc"
