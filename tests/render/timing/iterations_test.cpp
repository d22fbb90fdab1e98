#include <QTest>
#include <cmath>

#include "render/timing/iterations.h"

using namespace pdr;

class IterationsTest : public QObject {
    Q_OBJECT

    static double efficiency(double n, double iteration, double other) {
        return n * iteration / (n * iteration + other);
    }

  private slots:
    void nIsTheLeastThatReachesTheEfficiency() {
        for (const double target : {0.1, 0.5, 0.9, 0.97, 0.995})
            for (const double other : {1e-5, 1e-3, 0.0137}) {
                const std::uint32_t n = iterationsForEfficiency(target, 4e-4, other);
                QVERIFY(efficiency(n, 4e-4, other) >= target * (1 - 1e-9));
                QVERIFY(n == 1 || efficiency(n - 1, 4e-4, other) < target);
            }
    }

    /// GTX 560 Ti, 60 x 34: T_p = 0.400 ms, T_t + T_c = 0.922 ms.
    void paperNeedsTwentyOneIterationsForNineTenths() {
        QCOMPARE(iterationsForEfficiency(0.9, 0.400e-3, 0.922e-3), 21u);
        QCOMPARE(iterationsForEfficiency(0.9, 1e-3, 1e-3), 9u);
        QCOMPARE(iterationsForEfficiency(0.99, 1e-3, 1e-3), 99u);
    }

    void frameRateSetsTheCap() {
        QCOMPARE(iterationsForFrameRate(100, 1e-3, 1e-3), 9u);
        QCOMPARE(iterationsForFrameRate(100, 1e-3, 1.5e-3), 8u);
        QCOMPARE(iterationsPerFrame(0.99, 100, 1e-3, 1e-3), 9u);
        QCOMPARE(iterationsPerFrame(0.5, 100, 1e-3, 1e-3), 1u);
        QCOMPARE(iterationsPerFrame(0.8, 10, 1e-3, 1e-3), 4u);
    }

    void oneIterationIsTakenWhereNotEvenOneFits() {
        QCOMPARE(iterationsForFrameRate(30, 1, 0.001), 1u);
        QCOMPARE(iterationsForFrameRate(30, 0.001, 1), 1u);
        QCOMPARE(iterationsPerFrame(0.99, 30, 0, 1), 1u);
    }

    /// An image that takes a second cannot come 30 times in one; the time then goes into samples.
    void aRateThatCannotBeHeldIsNotPaidFor() {
        QCOMPARE(iterationsPerFrame(0.99, 30, 0.1, 1), 40u);
        QCOMPARE(iterationsPerFrame(0.5, 30, 0.1, 1), 10u);
        QCOMPARE(iterationsPerFrame(0.99, 10, 0.05, 0.05), 1u);
        QCOMPARE(iterationsPerFrame(0.99, 30, 1, 0.001), 1u);
    }

    void timesThatAreNothingOrNoNumbersDoNoHarm() {
        QCOMPARE(iterationsForEfficiency(0.9, 0, 1e-3), kMostIterationsPerFrame);
        QCOMPARE(iterationsForEfficiency(1, 1e-3, 1e-3), kMostIterationsPerFrame);
        QCOMPARE(iterationsForEfficiency(0.9, 1e-12, 1e-3), kMostIterationsPerFrame);
        QCOMPARE(iterationsForFrameRate(30, 0, 0), kMostIterationsPerFrame);
        QCOMPARE(iterationsForEfficiency(0.9, 1e-3, 0), 1u);
        QCOMPARE(iterationsForEfficiency(0, 1e-3, 1e-3), 1u);
        QCOMPARE(iterationsForEfficiency(0.9, 1e-3, NAN), 1u);
        QCOMPARE(iterationsPerFrame(NAN, NAN, NAN, NAN), 1u);
    }
};

QTEST_GUILESS_MAIN(IterationsTest)
#include "iterations_test.moc"
