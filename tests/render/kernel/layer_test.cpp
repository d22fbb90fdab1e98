/// What a ray's quadrature is made of: attenuation, cubics, and the bound on how a layer is seen through itself.

#include <QTest>

#include <random>

#include "render/kernel/quadrature/layer.h"

using namespace pdr;

namespace {

/// Coefficients between 0 and 1: wild, nearly straight, or nearly constant.
Cubic<float> randomCubic(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0, 1);
    const float spread = std::pow(10.0f, -4 * unit(random)), base = (1 - spread) * unit(random);
    const auto coefficient = [&] { return base + spread * unit(random); };
    Cubic<float> cubic{coefficient(), coefficient(), coefficient(), coefficient()};
    if (random() % 3 == 0)
        cubic.b1 = cubic.b0 + (cubic.b3 - cubic.b0) * 0.3f, cubic.b2 = cubic.b0 + (cubic.b3 - cubic.b0) * 0.6f;
    return cubic;
}

double valueAt(const Cubic<float>& cubic, double s) {
    const double r = 1 - s;
    return r * r * r * cubic.b0 + 3 * r * r * s * cubic.b1 + 3 * r * s * s * cubic.b2 + s * s * s * cubic.b3;
}

OpticsAlong<float> along(const Cubic<float>& fraction, float extinction, float rise) {
    return {fraction, fraction.mean(), extinction, rise, extinction + rise * fraction.mean()};
}

}  // namespace

class LayerTest : public QObject {
    Q_OBJECT

  private slots:
    void attenuationIsExact() {
        for (double depth = 1e-9; depth < 86; depth *= 1.01) {
            const Attenuation<float> behind = attenuation(float(depth));
            const double exact = double(float(depth));
            QVERIFY(std::fabs(behind.left / std::exp(-exact) - 1) < 3e-7);
            QVERIFY(std::fabs(behind.taken / -std::expm1(-exact) - 1) < 3e-7);
        }
        QCOMPARE(attenuation(0.0f).left, 1.0f);
        QCOMPARE(attenuation(0.0f).taken, 0.0f);
        for (const float depth : {88.0f, 1e3f, 1e30f, std::numeric_limits<float>::infinity()}) {
            QCOMPARE(attenuation(depth).left, 0.0f);
            QCOMPARE(attenuation(depth).taken, 1.0f);
        }
    }

    void lightIsAbsorbedBeforeTheMiddle() {
        for (double depth = 1e-6; depth < 1e5; depth *= 1.01) {
            const float d = float(depth);
            const long double a = (long double)(d) / 2;
            const double exact = d < 1e-2 ? double(a / 6 - a * a * a / 90) : double((1 / std::tanh(a) - 1 / a) / 2);
            const double got = absorbedBeforeMiddle(d, attenuation(d));
            QVERIFY2(std::fabs(got / exact - 1) < 1e-6,
                     qPrintable(QString("%1 at depth %2").arg(got / exact).arg(depth)));
        }
    }

    void splitPartsAreTheCubic() {
        std::mt19937 random(1);
        std::uniform_real_distribution<float> unit(0, 1);
        for (int i = 0; i < 2000; ++i) {
            const Cubic<float> cubic = randomCubic(random);
            Cubic<float> before, behind;
            const float at = unit(random), s = unit(random);
            cubic.split(at, before, behind);
            QVERIFY(std::fabs(valueAt(before, s) - valueAt(cubic, double(at) * s)) < 5e-7);
            QVERIFY(std::fabs(valueAt(behind, s) - valueAt(cubic, at + (1.0 - at) * s)) < 5e-7);
        }
    }

    void monotoneCubicIsFoundWhereItHasAValue() {
        std::mt19937 random(2);
        std::uniform_real_distribution<float> unit(0, 1);
        for (int i = 0; i < 20000; ++i) {
            float c[4] = {unit(random), unit(random), unit(random), unit(random)};
            if (i % 3 == 0)
                c[1] = c[0];
            if (i % 5 == 0)
                c[2] = c[1];
            std::sort(c, c + 4);
            Cubic<float> cubic{c[0], c[1], c[2], c[3]};
            if (random() % 2)
                cubic = {c[3], c[2], c[1], c[0]};
            QVERIFY(cubic.monotone());
            const float level = c[0] + (c[3] - c[0]) * unit(random);
            const float s = cubic.whereIs(level, true);
            QVERIFY(s >= 0 && s <= 1);
            QVERIFY2(std::fabs(valueAt(cubic, s) - level) < 5e-7,
                     qPrintable(QString::number(valueAt(cubic, s) - level)));
        }
    }

    void maximumOfACubicIsExact() {
        std::mt19937 random(3);
        for (int i = 0; i < 2000; ++i) {
            const Cubic<float> cubic = randomCubic(random);
            double highest = 0;
            for (int k = 0; k <= 1000; ++k)
                highest = std::max(highest, valueAt(cubic, k / 1000.0));
            QVERIFY(cubic.maximum() > highest - 5e-7 && cubic.maximum() < highest + 1e-5);
        }
        QCOMPARE((Cubic<float>{7, 7, 7, 7}.maximum()), 7.0f);
    }

    /// Compares with the midpoint rule, for all depths: the share that is seen, its bound, and the mean without
    /// attenuation.
    void boundOfALayerHolds() {
        std::mt19937 random(4);
        std::uniform_real_distribution<float> unit(0, 1);
        double tightest = 0;
        for (int i = 0; i < 4000; ++i) {
            const Cubic<float> fraction = randomCubic(random);
            const float extinction = random() % 3 ? unit(random) : 0;
            const float rise = random() % 3 ? unit(random) - extinction : 0.0f;
            const OpticsAlong<float> way = along(fraction, extinction, rise);
            if (!(way.meanExtinction > 1e-4f))
                continue;
            const float depth = std::pow(10.0f, 5 * unit(random) - 2);
            constexpr int kParts = 4000;
            double passed = 0, seen = 0, taken = 0, weighted = 0, total = 0;
            for (int k = 0; k < kParts; ++k) {
                const double x = valueAt(fraction, (k + 0.5) / kParts), sigma = extinction + double(rise) * x;
                const double part = depth * sigma / way.meanExtinction / kParts;
                const double here = std::exp(-passed) * -std::expm1(-part);
                seen += here * x, taken += here, passed += part;
                weighted += part * x, total += part;
            }
            const Layer<float> layer = layerAlong(way, depth, sourceAlong(way));
            const double off = std::fabs(layer.fraction - seen / taken);
            QVERIFY2(off <= layer.bound * 1.001 + 1e-5, qPrintable(QString("%1, bound %2").arg(off).arg(layer.bound)));
            if (layer.bound > 1e-3 && depth > 0.1f)
                tightest = std::max(tightest, off / layer.bound);
            QVERIFY(std::fabs(extinctionWeightedFraction(way) - weighted / total) < 2e-6);
        }
        // A bound that is never approached costs steps.
        QVERIFY2(tightest > 0.3, qPrintable(QString::number(tightest)));
    }
};

QTEST_APPLESS_MAIN(LayerTest)
#include "layer_test.moc"
