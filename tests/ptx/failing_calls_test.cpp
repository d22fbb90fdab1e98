/// Each call of the CUDA runtime fails once: a sentence or the right image comes of it, never a crash, a hang or a
/// wrong image, and the device then works again. And so on machines that are not as one would like them.

#include <QTest>

#include <QRegularExpression>

#include "tests/ptx/image_run.h"

using namespace pdr;
using test::images;

namespace {

/// Returns the names of all calls, in order.
QStringList calls() {
    static const QRegularExpression line("^call \\d+ (\\w+): 0$", QRegularExpression::MultilineOption);
    QStringList names;
    const QString told = images("TRACE=1").err;
    for (auto each = line.globalMatch(told); each.hasNext();)
        names << each.next().captured(1);
    return names;
}

}  // namespace

class FailingCallsTest : public QObject {
    Q_OBJECT

  private slots:
    void withoutFailuresAllPicturesAreRight() {
        for (const char* settings : {"", "STREAMS=late", "CAPABILITY=75", "CAPABILITY=120", "DEVICES=2"})
            QCOMPARE(images(settings).out, QByteArray("right\nright\nright\n"));
    }

    void eachCallMayFailOnce() {
        const QStringList names = calls();
        QVERIFY(names.size() > 200);
        for (const char* error : {"999", "2"})
            for (int n = 0; n < names.size(); ++n) {
                const test::ProgramRun run = images(QString("FAIL=%1:%2").arg(n + 1).arg(error));
                const QString what = names[n] + " " + QString::number(n + 1) + ": " + run.out + run.err;
                QVERIFY2(run.code == 0 && !run.err.contains("ptx: "), qPrintable(what));
                const bool isOpen = run.out.count('\n') == 3;
                QVERIFY2(!isOpen || run.out.count("right\n") >= 2, qPrintable(what));  // all but its own
            }
    }

    void aLostDeviceIsNeverAWrongPicture() {
        const qsizetype count = calls().size();
        for (qsizetype n = 1; n <= count; n += 7) {
            const test::ProgramRun run = images(QString("FAIL=%1:719").arg(n));
            QVERIFY2(run.code == 0 && !run.err.contains("ptx: "), qPrintable(run.out + run.err));
        }
    }
};

QTEST_APPLESS_MAIN(FailingCallsTest)
#include "failing_calls_test.moc"
