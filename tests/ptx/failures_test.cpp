/// What a GPU that fails is told as, and what a failure leaves behind.

#include <QTest>

#include <QRegularExpression>

#include "tests/ptx/image_run.h"

using namespace pdr;
using test::images;

namespace {

/// Returns the launches of the last of the three images, with their blocks and threads.
QStringList lastLaunches(const test::ProgramRun& run, qsizetype count) {
    static const QRegularExpression line("^launch .*$", QRegularExpression::MultilineOption);
    QStringList all;
    const QString told = run.err;
    for (auto each = line.globalMatch(told); each.hasNext();)
        all << each.next().captured();
    return all.last(count > 0 ? count : all.size() / 3);
}

}  // namespace

class FailuresTest : public QObject {
    Q_OBJECT

  private slots:
    /// "auto" renders on the CPU where the GPU cannot, and says why and what its user can do.
    void eachCauseHasASentenceOfItsOwn_data() {
        QTest::addColumn<QString>("settings");
        QTest::addColumn<QString>("cause");
        QTest::addColumn<QString>("next");
        const auto row = [](const char* settings, const char* cause, const char* next) {
            QTest::newRow(cause) << settings << cause << next;
        };
        row("CAPABILITY=70", "the GPU is too old for this program", "a newer GPU");
        row("DRIVER=12080", "it knows CUDA 12.8, 13.0 is needed", "Install a newer driver");
        row("FAIL=cudaGetDeviceCount:1:803", "parts of the driver are of different versions", "Restart the computer");
        row("MEMORY_MB=0", "its memory is too small", "close programs");
        row("FAIL=cudaLaunchKernel:1:2", "the memory of the GPU is taken: 8.", "Close programs");
        row("FAIL=cudaHostAlloc:1:2", "there is not enough memory for images", "Close programs");
        row("FAIL=cudaLaunchKernel:1:209", "has code for the GPU (a launch: ", "a build of this program for this GPU");
        row("CAPABILITY=130 FAIL=cudaFuncGetAttributes:3:218", "(preparing it: ", "Install a newer driver");
        row("FAIL=cudaStreamCreateWithFlags:1:46", "another program has the GPU to itself", "Close that program");
        row("FAIL=cudaDeviceSynchronize:1:702", "the driver stopped the GPU", "a smaller image");
        row("FAIL=cudaDeviceSynchronize:1:214", "the memory of the GPU has lost bits", "Restart the computer");
        row("FAIL=cudaDeviceSynchronize:1:719", "the GPU was lost (a launch: ", "Start the program again");
        row("FAIL=cudaMemsetAsync:1:999", "the GPU failed (clearing memory: ", "Try again");
        row("FAIL=cudaGetDeviceProperties:1:999", "the GPU failed (asking what it is: ", "Try again");
    }
    void eachCauseHasASentenceOfItsOwn() {
        QFETCH(const QString, settings);
        QFETCH(const QString, cause);
        QFETCH(const QString, next);
        const test::ProgramRun run = images(settings, "auto");
        QVERIFY2(run.out.startsWith("the CPU instead: ") && run.out.contains(cause.toUtf8()) &&
                     run.out.contains(next.toUtf8()) && run.out.endsWith("\nright\nright\nright\n"),
                 qPrintable(run.out + run.err));
    }

    void aComputerWithoutAGpuIsNoFailure() {
        QCOMPARE(images("DEVICES=0", "auto").out, QByteArray("right\nright\nright\n"));
        QVERIFY(images("DEVICES=0").out.contains("there is no GPU of NVIDIA's"));
    }

    /// Without machine code for a GPU its driver translates the program: kernels before they are launched, while it is
    /// said, and once.
    void whatTheDriverTranslatesIsSaid() {
        const auto run = images("TRACE=1 CAPABILITY=130");
        QVERIFY(run.out.endsWith("right\nright\nright\n"));
        QCOMPARE(run.err.count("\npreparing\n"), 1);
        QVERIFY(run.err.indexOf("\npreparing\n") < run.err.indexOf("cudaFuncGetAttributes"));
        QVERIFY(run.err.lastIndexOf("cudaFuncGetAttributes") < run.err.indexOf("\nprepared\n"));
        const QStringList launches = lastLaunches(run, 0);
        QVERIFY(launches.size() > 10);
        for (const QString& launch : launches)
            QVERIFY2(launch.endsWith(", prepared"), qPrintable(launch));
    }

    void nothingIsPreparedWhereMachineCodeFits() {
        const auto run = images("TRACE=1 CAPABILITY=" PDR_EMBEDDED_CODE);
        QVERIFY(run.out.endsWith("right\nright\nright\n"));
        QVERIFY(!run.err.contains("preparing") && !run.err.contains("cudaFuncGetAttributes"));
    }

    /// After a question for the number of blocks that failed once, kernels get as many as ever.
    void aFailureThatPassesCostsNoThreads() {
        const QStringList usual = lastLaunches(images("TRACE=1"), 0);
        QVERIFY(usual.size() > 10);
        for (int n = 1; n <= 3; ++n) {
            const auto run = images(QString("TRACE=1 FAIL=cudaOccupancyMaxActiveBlocksPerMultiprocessor:%1:2").arg(n));
            QVERIFY(run.out.endsWith("\nright\nright\n") && !run.out.startsWith("right"));
            QCOMPARE(lastLaunches(run, usual.size()), usual);
        }
    }
};

QTEST_APPLESS_MAIN(FailuresTest)
#include "failures_test.moc"
