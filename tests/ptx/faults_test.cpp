/// What this room watches, it sees: each planted fault of checks/faults.cu is told, and sound programs are not.

#include <QTemporaryDir>
#include <QTest>

#include "tests/support/program_run.h"

using namespace pdr;

class FaultsTest : public QObject {
    Q_OBJECT

    /// Runs a case of ptx_faults with settings, "STREAMS=late RACES=1", and returns its output behind its errors.
    static QString told(const QString& name, const QString& settings) {
        const test::ProgramRun run = test::runProgram("../tests/ptx_faults", {name}, [&](QProcess& process) {
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            for (const QString& setting : settings.split(' ', Qt::SkipEmptyParts))
                environment.insert("PDR_PTX_" + setting.section('=', 0, 0), setting.section('=', 1));
            process.setProcessEnvironment(environment);
        });
        return run.err + run.out;
    }

  private slots:
    void eachFaultIsTold_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("settings");
        QTest::addColumn<QString>("text");
        const auto fault = [](const char* row, const char* name, const char* settings, const char* text) {
            QTest::newRow(row) << QString(name) << QString(settings) << QString(text);
        };
        fault("behind an allocation", "beyond", "", "4 bytes at 400 of an allocation of 400 bytes");
        fault("it loses the device", "beyond", "STREAMS=late", "status 700");
        fault("freed", "freed", "", "which was freed");
        fault("misaligned", "misaligned", "STREAMS=late", "status 716");
        fault("two threads", "race", "RACES=1", "another thread of the launch writes");
        fault("unset", "unset", "UNSET=1", "what nobody has written");
        fault("no event", "noEvent", "RACES=1", "neither waits for the other");
        fault("no event, late", "noEvent", "RACES=1 STREAMS=late", "neither waits for the other");
        fault("read early", "readEarly", "STREAMS=late", "has not waited for");
        fault("written early", "writtenEarly", "STREAMS=late", "has not waited for");
        fault("the host follows", "hostFollows", "", "follows an address of the device's");
        fault("lanes apart", "lanesApart", "", "lanes wait for each other");
        fault("a failing call", "sound", "FAIL=cudaDeviceSynchronize:1:719", "status 719");
        fault("a failing call by number", "sound", "FAIL=1", "status");
    }
    void eachFaultIsTold() {
        QFETCH(QString, name);
        QFETCH(QString, settings);
        QFETCH(QString, text);
        const QString all = told(name, settings);
        QVERIFY2(all.contains(text), qPrintable(all));
    }

    void soundProgramsAreSilent_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("settings");
        QTest::addColumn<QString>("text");
        for (const char* settings : {"", "STREAMS=late WARPS=inOrder", "STREAMS=atRandom WARPS=atRandom FILL=ones",
                                     "RACES=1 UNSET=1", "RACES=1 STREAMS=late", "BY_ADDRESS=1 FILL=zeros"}) {
            const auto sound = [&](const char* name, const char* text) {
                QTest::addRow("%s %s", name, settings) << QString(name) << QString(settings) << QString(text);
            };
            sound("sound", "status 0 sum 100\n");
            sound("atomics", "status 0 sum 1280\n");
            sound("arithmetic", "0 of 15876 differ\n");
            sound("lanesTogether", "status 0");
        }
    }
    void soundProgramsAreSilent() {
        QFETCH(QString, name);
        QFETCH(QString, settings);
        QFETCH(QString, text);
        const QString all = told(name, settings);
        QVERIFY2(all.startsWith(text), qPrintable(all));
    }

    /// Four warps of addOne begin with 128 lanes, and 100 go on behind the branch.
    void countsTellWhichLanesWereBusy() {
        const QTemporaryDir folder;
        QVERIFY(told("sound", "COUNTS=" + folder.path()).startsWith("status 0"));
        QFile file(folder.filePath("counts.txt"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
        while (!lines.isEmpty() && !lines.front().contains("addOne"))
            lines.removeFirst();
        QVERIFY(lines.size() > 3 && lines[0].endsWith(" 1"));
        const auto number = [&](int line, int word) { return lines[line].section(' ', word, word).toInt(); };
        QCOMPARE(number(1, 4), 4);
        QCOMPARE(number(1, 5), 128);
        QCOMPARE(number(2, 4), 4);
        QCOMPARE(number(2, 5), 100);
        // The PTX is there, and the branch is the last line of the first block.
        QFile text(folder.filePath(lines[0].section(' ', 2, 2) + ".ptx"));
        QVERIFY(text.open(QIODevice::ReadOnly));
        const QStringList ptx = QString::fromUtf8(text.readAll()).split('\n');
        QVERIFY2(ptx.value(number(1, 2) - 1).contains("bra"), qPrintable(ptx.value(number(1, 2) - 1)));
    }

    void aSettingThatIsNotKnownEndsTheProgram() {
        QVERIFY(told("sound", "STREAMS=sometimes").contains("is not known"));
        QVERIFY(told("sound", "FAIL=cudaFree").contains("has no number"));
    }
};

QTEST_APPLESS_MAIN(FaultsTest)
#include "faults_test.moc"
