/// Many files on all cores: what happens when one of them goes wrong.

#include <QTest>
#include <atomic>
#include <new>

#include "dicom/parallel.h"

using namespace pdr::dicom;

class ParallelTest : public QObject {
    Q_OBJECT

  private slots:
    void everyFileIsTakenOnce() {
        std::vector<std::atomic<int>> taken(1000);
        QVERIFY(onAllCores(
            1000, [&](std::size_t i, const GoOn&) { ++taken[i]; }, pdr::noProgress, "reading"));
        for (const auto& count : taken)
            QCOMPARE(count.load(), 1);
    }

    void whatOneThrowsReachesTheCaller() {
        std::atomic<int> taken = 0;
        const auto work = [&](std::size_t i, const GoOn&) {
            if (i == 10)
                throw std::bad_alloc();
            ++taken;
        };
        bool caught = false;
        try {
            (void)onAllCores(100000, work, pdr::noProgress, "reading");
        } catch (const std::bad_alloc&) {
            caught = true;
        }
        QVERIFY(caught);
        QVERIFY(taken < 99999);
    }
};

QTEST_GUILESS_MAIN(ParallelTest)
#include "parallel_test.moc"
