/// Sines and related functions in the kernel's own arithmetic: as accurate as stated, and the same bits on any
/// processor.

#include "render/kernel/turns.h"

#include <QTest>
#include <cmath>
#include <random>

#include "render/kernel/attenuation.h"

using namespace pdr;

namespace {

/// Bits of many results, folded into one number.
class Fold {
  public:
    void add(float value) { folded_ = (folded_ ^ std::uint32_t(bitsOf(value))) * 0x100000001B3ull; }
    std::uint64_t value() const { return folded_; }

  private:
    std::uint64_t folded_ = 0xCBF29CE484222325ull;
};

/// visit(angle) for about a million of them: evenly over three turns, and ever smaller ones.
template <class Visit>
void forAngles(Visit&& visit) {
    for (int i = -1'500'000; i <= 1'500'000; i += 3)
        visit(float(i) * 1e-6f);
    for (float angle = 1; angle > 1e-30f; angle *= 0.99f) {
        visit(angle);
        visit(-angle);
    }
}

}  // namespace

class TurnsTest : public QObject {
    Q_OBJECT

  private slots:
    void circlePointsLieOnTheCircle() {
        double worst = 0, worstTiny = 0;
        forAngles([&](float turns) {
            const CirclePoint<float> got = circlePoint(turns);
            const double angle = 2 * M_PI * double(turns);
            worst = std::max({worst, std::fabs(got.cosine - std::cos(angle)), std::fabs(got.sine - std::sin(angle))});
            if (turns != 0 && std::fabs(turns) < 0.125f)
                worstTiny = std::max(worstTiny, std::fabs(got.sine / std::sin(angle) - 1));
        });
        QVERIFY2(worst < 1e-7 && worstTiny < 1.5e-7, qPrintable(QString("%1, relative %2").arg(worst).arg(worstTiny)));
    }

    void quarterTurnsAreExact() {
        for (int quarter = -8; quarter <= 8; ++quarter) {
            const CirclePoint<float> got = circlePoint(0.25f * float(quarter));
            QCOMPARE(got.cosine, float(quarter % 2 != 0 ? 0 : quarter % 4 == 0 ? 1 : -1));
            QCOMPARE(got.sine, float(quarter % 2 == 0 ? 0 : (quarter + 8) % 4 == 1 ? 1 : -1));
        }
    }

    /// Points of all directions, some very near an axis, at any distance.
    void anglesAreThoseOfTheArcTangent() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> turn(-0.5, 0.5), octave(-60, 60), tiny(-30, 0);
        double worst = 0;
        for (int i = 0; i < 1'000'000; ++i) {
            const double angle = 2 * M_PI * (i % 2 ? turn(random) : (i / 2 % 5 - 2) * 0.25 + std::exp2(tiny(random)));
            const double far = std::exp2(octave(random));
            const float x = float(far * std::cos(angle)), y = float(far * std::sin(angle));
            const double off = turnsTo(x, y) - std::atan2(double(y), double(x)) / (2 * M_PI);
            worst = std::max(worst, std::fabs(off - std::round(off)));  // behind (0, 0) it may be either end
        }
        QVERIFY2(worst < 5e-8, qPrintable(QString::number(worst)));
        QCOMPARE(turnsTo(0.0f, 0.0f), 0.0f);
    }

    /// 1 - exp(-depth) and back, for depths of any size.
    void depthsAndWhatTheyTakeAreInverse() {
        double worst = 0, worstBack = 0;
        for (double depth = 1e-30; depth < 80; depth *= 1.0001) {
            const double truth = -std::expm1(-double(float(depth)));
            const float taken = attenuation(float(depth)).taken;
            worst = std::max(worst, std::fabs(taken / truth - 1));
            if (taken < 1)
                worstBack = std::max(worstBack, std::fabs(depthThatTakes(taken) / -std::log1p(-double(taken)) - 1));
        }
        QVERIFY2(worst < 3e-7 && worstBack < 4e-7, qPrintable(QString("%1, back %2").arg(worst).arg(worstBack)));
    }

    void lanesComputeTheBitsOfOneNumber() {
        std::mt19937 random(6);
        std::uniform_real_distribution<float> any(-3, 3);
        for (int i = 0; i < 100'000; ++i) {
            FloatLanes a, b;
            for (int lane = 0; lane < kLanes; ++lane) {
                a[lane] = any(random);
                b[lane] = any(random);
            }
            const CirclePoint<FloatLanes> point = circlePoint(a);
            const FloatLanes turns = turnsTo(a, b), depth = depthThatTakes(a * a / 9.1f);
            for (int lane = 0; lane < kLanes; ++lane) {
                QCOMPARE(bitsOf(point.cosine[lane]), bitsOf(circlePoint(float(a[lane])).cosine));
                QCOMPARE(bitsOf(point.sine[lane]), bitsOf(circlePoint(float(a[lane])).sine));
                QCOMPARE(bitsOf(turns[lane]), bitsOf(turnsTo(float(a[lane]), float(b[lane]))));
                QCOMPARE(bitsOf(depth[lane]), bitsOf(depthThatTakes(a[lane] * a[lane] / 9.1f)));
            }
        }
    }

    /// What a library or a fused product and sum would change.
    void everyProcessorComputesTheseBits() {
        Fold fold;
        forAngles([&](float angle) {
            const CirclePoint<float> point = circlePoint(angle);
            fold.add(point.cosine);
            fold.add(point.sine);
            fold.add(turnsTo(point.cosine, angle));
            fold.add(attenuation(max(angle, -angle)).taken);
        });
        QCOMPARE(fold.value(), std::uint64_t(16072285504818772101ull));
    }
};

QTEST_APPLESS_MAIN(TurnsTest)
#include "turns_test.moc"
