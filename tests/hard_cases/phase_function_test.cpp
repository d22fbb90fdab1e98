/// Hard cases 18 to 20: the phase function at its extremes. Each naive form is written out and must fail.

#include <QTest>

#include <array>

#include "render/kernel/random.h"
#include "render/kernel/transport/phase.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

/// The textbook's cosine, in single precision.
float textbookCosine(float g, float u) {
    const float s = (1 - g * g) / (1 - g + 2 * g * u);
    return (1 + g * g - s * s) / (2 * g);
}

float textbookEval(float g, float cosine) {
    const float denominator = 1 + g * g - 2 * g * cosine;
    return (1 - g * g) / (4 * kPi * denominator * std::sqrt(denominator));
}

/// Returns the phase function in extended precision; x = 1 - cosTheta.
long double exactEval(long double g, long double x) {
    const long double denominator = (1 - g) * (1 - g) + 2 * g * x;
    return (1 - g) * (1 + g) / (4 * M_PIl * denominator * std::sqrt(denominator));
}

/// Probability that 1 - cosTheta is at most x; no division by g and no difference of like numbers.
double cumulative(double g, double x) {
    const double a = 1 - g, b = std::sqrt(a * a + 2 * g * x);
    return (1 - g * g) * x / (a * b * (a + b));
}

/// The angle's 1 - cos between a and b, from single-precision directions.
double oneMinusCos(vec3 a, vec3 b) {
    const dvec3 difference = dvec3(a) - dvec3(b);
    return 0.5 * glm::dot(difference, difference);
}

void addExtremeG() {
    QTest::addColumn<float>("g");
    for (const float size : {0.0f, 1e-8f, 1e-4f, 0.1f, 0.9f, 0.999f, 0.9999f, 1 - 0x1p-24f})
        for (const float g : {size, -size})
            QTest::addRow("g = %.9g", double(g)) << g;
}

}  // namespace

class PhaseFunctionTest : public QObject {
    Q_OBJECT

  private slots:
    /// Case 18, the textbook: 0/0 at g = 0, wrong by 1 at 1e-8, cosines beyond 1 at 0.999.
    void textbookSamplingLosesItsDigits() {
        QVERIFY(std::isnan(textbookCosine(0, 0.3f)));
        double worst = 0;
        int outside = 0;
        for (int i = 0; i < 100'000; ++i) {
            const float u = (float(i) + 0.5f) * 1e-5f;
            worst = std::max(worst, std::fabs(double(textbookCosine(1e-8f, u)) - (2 * double(u) - 1)));
            outside += std::fabs(textbookCosine(0.999f, u)) > 1;
        }
        QVERIFY2(worst > 0.5 && outside > 50, qPrintable(QString("%1, %2").arg(worst).arg(outside)));
    }

    /// Case 18. Mean cosine g, second Legendre moment g^2, and 64 equally likely bins. False alarm below 1e-4 in all.
    void extremeGGivesCosinesBeyondOne_data() { addExtremeG(); }
    void extremeGGivesCosinesBeyondOne() {
        QFETCH(float, g);
        // Backward scattering is forward scattering seen from the other side.
        const vec3 travel(0, 0, 1), peak = g < 0 ? -travel : travel;
        test::Sample first, second;
        std::array<double, 64> bins{};
        RandomStream random = Random(4, 1, 0).stream(Dimension::filter);
        for (int i = 0; i < 100'000; ++i) {
            const vec3 direction = phaseSample(g, -travel, random.pair());
            QVERIFY(std::fabs(glm::length(dvec3(direction)) - 1) < 1e-6);
            const double x = oneMinusCos(peak, direction), cosine = 1 - x;
            first.add(cosine - std::fabs(double(g)));
            second.add(1.5 * cosine * cosine - 0.5 - double(g) * double(g));
            ++bins[std::clamp(int(64 * cumulative(std::fabs(double(g)), x)), 0, 63)];
        }
        // Beside the noise: what rounding of a direction to float does to its cosine.
        QVERIFY(std::fabs(first.mean()) < test::allowedZ(64) * first.standardError() + 1e-7);
        QVERIFY(std::fabs(second.mean()) < test::allowedZ(64) * second.standardError() + 2e-7);
        if (1 - std::fabs(g) > 1e-5f)  // else most directions round to straight on
            QVERIFY2(test::uniformP(bins) > 1e-6, qPrintable(QString::number(test::uniformP(bins))));
    }

    /// Case 19. Straight on and straight back: 1 + g^2 - 2 g cos is a difference of like numbers.
    void textbookDensityCancelsStraightOn() {
        QVERIFY(std::fabs(textbookEval(0.999f, 1) / double(exactEval(0.999f, 0)) - 1) > 0.05);
        QVERIFY(!std::isfinite(textbookEval(0.99995f, 1)) ||
                std::fabs(textbookEval(0.99995f, 1) / double(exactEval(0.99995f, 0)) - 1) > 0.5);
    }
    void densityIsExactAtEveryAngle_data() { addExtremeG(); }
    void densityIsExactAtEveryAngle() {
        QFETCH(float, g);
        for (const double towardsPeak : {0.0, 1e-9, 1e-7, 1e-4, 0.01, 1.0, 1.9, 1.9999, 2.0}) {
            const double x = towardsPeak, sine = std::sqrt(x * (2 - x));
            const vec3 travel(0, 0, 1), peak = g < 0 ? -travel : travel;
            const vec3 towards = vec3(dvec3(sine, 0, 0) + dvec3(peak) * (1 - x));
            // Judged by the directions as they are, in single precision.
            const double truth = double(exactEval(std::fabs(g), oneMinusCos(peak, towards)));
            const double found = phaseEval(g, -travel, towards);
            QVERIFY2(std::fabs(found / truth - 1) < 2e-6,
                     qPrintable(QString("%1 instead of %2 at %3").arg(found).arg(truth).arg(x)));
        }
    }

    /// Case 20. Frisvad's frame without the sign, and the cross product with a fixed axis, break near one pole.
    void frameAroundAPoleDegenerates() {
        const auto frisvad = [](vec3 n, vec3& s, vec3& t) {
            const float a = 1 / (1 + n.z), b = -n.x * n.y * a;
            s = {1 - n.x * n.x * a, b, -n.x};
            t = {b, 1 - n.y * n.y * a, -n.y};
        };
        const auto crossed = [](vec3 n, vec3& s, vec3& t) {
            s = glm::normalize(glm::cross(vec3(0, 0, 1), n));
            t = glm::cross(n, s);
        };
        const auto error = [](vec3 n, auto&& frame) {
            vec3 s, t;
            frame(n, s, t);
            const auto off = [](float value) { return std::isfinite(value) ? std::fabs(value) : 1e9f; };
            return std::max({off(glm::dot(s, s) - 1), off(glm::dot(t, t) - 1), off(glm::dot(s, t)), off(glm::dot(n, s)),
                             off(glm::dot(n, t)), off(glm::dot(glm::cross(n, s), t) - 1)});
        };
        QVERIFY(error({0, 0, -1}, frisvad) > 1 && error({0, 0, 1}, crossed) > 1);
        QVERIFY(error({4e-4f, 3e-4f, -1}, frisvad) > 1e-3f);  // a unit vector to the last digit
        const float tiny = 1e-40f;                            // denormal
        for (const float z : {1.0f, -1.0f, std::nextafter(1.0f, 0.0f), std::nextafter(-1.0f, 0.0f), 0.0f, -0.0f, tiny})
            for (const float x : {0.0f, -0.0f, tiny, -tiny, 1e-20f, 1e-4f, -4e-4f}) {
                const float rest = std::sqrt(std::max(0.0f, 1 - z * z - x * x));
                for (const vec3 n : {vec3(x, rest, z), vec3(-rest, x, z)})
                    QVERIFY2(error(n, orthonormalBasis<float>) < 1e-6f,
                             qPrintable(QString("%1 at %2 %3 %4")
                                            .arg(error(n, orthonormalBasis<float>))
                                            .arg(n.x)
                                            .arg(n.y)
                                            .arg(n.z)));
            }
    }
};

QTEST_GUILESS_MAIN(PhaseFunctionTest)
#include "phase_function_test.moc"
