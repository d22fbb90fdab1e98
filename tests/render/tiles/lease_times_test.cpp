#include <QTest>

#include "render/tiles/lease_times.h"

using namespace pdr;

/// What leases are found to take.
class LeaseTimesTest : public QObject {
    Q_OBJECT

  private slots:
    void lineIsFound() {
        LeaseTimes times;
        for (int i = 0; i < 300; ++i) {
            const double work = 1000.0 * (1 + i % 7);
            times.add(work, 0.003 + 2e-6 * work);
        }
        QVERIFY(qAbs(times.secondsBefore() - 0.003) < 1e-9);
        QVERIFY(qAbs(times.secondsPerWork() - 2e-6) < 1e-12);
    }

    void newTimesReplaceOldOnes() {
        LeaseTimes times;
        for (int i = 0; i < 1000; ++i) {
            const double work = 1000.0 * (1 + i % 7);
            times.add(work, i < 300 ? 1 : 0.003 + 2e-6 * work);
        }
        QVERIFY(qAbs(times.secondsBefore() - 0.003) < 1e-4);
    }

    void nothingIsNegativeAndNothingIsMadeUp() {
        LeaseTimes times;
        QCOMPARE(times.secondsPerWork(), 0.0);
        QCOMPARE(times.secondsBefore(), 0.0);
        for (int i = 0; i < 10; ++i)
            times.add(1000, 0.5);  // all alike
        QCOMPARE(times.secondsPerWork(), 0.0005);
        QCOMPARE(times.secondsBefore(), 0.0);
        LeaseTimes falling;
        falling.add(1000, 2);
        falling.add(3000, 1);
        QVERIFY(falling.secondsPerWork() >= 0 && falling.secondsBefore() >= 0);
        LeaseTimes steep;
        steep.add(1000, 1);
        steep.add(2000, 5);
        QVERIFY(steep.secondsPerWork() >= 0 && steep.secondsBefore() >= 0);
    }
};

QTEST_APPLESS_MAIN(LeaseTimesTest)
#include "lease_times_test.moc"
