#include <QTest>

#include <cmath>
#include <random>

#include "render/base/angles.h"

using namespace pdr;

/// The project's own elementary functions against the mathematical library's.
class AnglesTest : public QObject {
    Q_OBJECT

    static void isNear(double value, double truth, double scale) {
        QVERIFY2(std::abs(value - truth) <= 5e-16 * scale,
                 qPrintable(QString("%1 instead of %2").arg(value, 0, 'g', 17).arg(truth, 0, 'g', 17)));
    }

  private slots:
    void sineAndCosineAreThose() {
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> angles(0, M_PI);
        for (int i = 0; i < 20000; ++i) {
            const double angle = angles(random);
            const SineCosine both = sineCosine(angle);
            isNear(both.sine, std::sin(angle), 1);
            isNear(both.cosine, std::cos(angle), 1);
        }
    }

    void smallAnglesKeepTheirDigits() {
        for (double angle = 1e-300; angle < 0.1; angle *= 3) {
            isNear(sineCosine(angle).sine, std::sin(angle), std::sin(angle));
            isNear(tangent(angle), std::tan(angle), 2 * std::tan(angle));
            isNear(expMinusOne(-angle), std::expm1(-angle), angle);
        }
    }

    void tangentReachesTheHalfCircle() {
        for (double degrees = 1; degrees < 180; degrees += 0.7) {
            const double angle = degrees * (M_PI / 360);
            isNear(tangent(angle), std::tan(angle), 2 * (std::tan(angle) + 1 / std::cos(angle)));
        }
    }

    void expMinusOneIsThat() {
        for (double x = -1; x <= 1; x += 0.001)
            isNear(expMinusOne(x), std::expm1(x), 2 * std::abs(x) + 1e-300);
    }
};

QTEST_APPLESS_MAIN(AnglesTest)
#include "angles_test.moc"
