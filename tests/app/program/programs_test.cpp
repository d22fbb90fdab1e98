#include <QtTest>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <QImageReader>
#include <QProcess>
#include <QTemporaryDir>

#include <functional>

#include "app/program/program.h"
#include "render/base/version.h"
#include "tests/support/patience.h"
#include "tests/support/places.h"
#include "tests/support/program_run.h"

namespace {

constexpr const char* kPrograms[] = {"pdrender", "pdrender-cli", "pdrender-bench", "pdrender-node"};

using pdr::test::ProgramRun;
using Before = std::function<void()>;  ///< what the new process does before it becomes the program

ProgramRun run(const QString& program, const QStringList& arguments, const Before& before = {},
               const QString& out = {}) {
    return pdr::test::runProgram(program, arguments, [&](QProcess& process) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* display : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
            environment.remove(display);
        process.setProcessEnvironment(environment);
        process.setChildProcessModifier(before);
        if (!out.isEmpty())
            process.setStandardOutputFile(out);
    });
}

/// Runs a program in an address space of `megabytes`.
ProgramRun runIn(int megabytes, const QString& program, const QStringList& arguments) {
    return run(program, arguments, [megabytes] {
        const rlimit limit{rlim_t(megabytes) << 20, rlim_t(megabytes) << 20};
        ::setrlimit(RLIMIT_AS, &limit);
    });
}

}  // namespace

/// What holds for every program: its words, its exit codes, its end.
class ProgramsTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString at(const QString& name) const { return folder_.filePath(name); }
    QString scene() const { return at("scene.json"); }

    static void eachProgram() {
        QTest::addColumn<QString>("program");
        for (const char* program : kPrograms)
            QTest::newRow(program) << program;
    }

    static void write(const QString& path, const QByteArray& bytes) {
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("the test cannot write its files");
    }

    /// Nodes are started again, or not, by what their codes say (app/node/exit_codes.h).
    static bool isNode(const QString& program) { return program == "pdrender-node"; }

  private slots:
    /// Air around a block: large enough for memory to run short in several places.
    void initTestCase() {
        constexpr int kEdge = 256;
        QByteArray voxels(2 * kEdge * kEdge * kEdge, '\0');
        write(at("block.raw"), voxels);
        write(scene(), R"({ "format": "pdrender-scene", "version": 1,
            "volume": { "raw": "block.raw", "size": [256, 256, 256], "spacingMm": [1, 1, 1] },
            "transferFunction": { "extinctionPerMm": 0.5, "nodes": [ { "hu": -100, "opacity": 0 }, { "hu": 0, "opacity": 1 } ] },
            "lights": [ { "type": "directional", "direction": [1, 1, -1], "irradiance": 3 } ],
            "camera": { "eyeMm": [128, -600, 128], "targetMm": [128, 128, 128], "fovDegrees": 25 },
            "film": { "width": 64, "height": 48 } })");
    }

    void helpExplainsEveryOptionOnStandardOutput_data() {
        QTest::addColumn<QString>("program");
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QByteArray>("option");
        const auto row = [](const char* name, const char* program, const QStringList& words, const char* option) {
            QTest::newRow(name) << program << words << QByteArray(option);
        };
        row("pdrender", "pdrender", {"--help"}, "--screenshot");
        row("pdrender -h", "pdrender", {"-h"}, "--threads");
        row("pdrender-cli", "pdrender-cli", {"--help"}, "render");
        row("pdrender-cli render", "pdrender-cli", {"render", "--help"}, "--samples");
        row("pdrender-cli help render", "pdrender-cli", {"help", "render"}, "--samples");
        row("pdrender-cli help info", "pdrender-cli", {"help", "info"}, "--json");
        row("pdrender-bench", "pdrender-bench", {"--help"}, "selftest");
        row("pdrender-bench -h", "pdrender-bench", {"-h"}, "paper");
        row("pdrender-bench help", "pdrender-bench", {"help"}, "rebound");
        for (const char* command : {"picture", "rebound", "filtering", "bits", "paper", "parity", "selftest"})
            row(command, "pdrender-bench", {command, "--help"}, "--device D   ");
        row("pdrender-node", "pdrender-node", {"--help"}, "--make-certificates");
        row("pdrender-node -h", "pdrender-node", {"-h"}, "--coordinator");
        row("frames", "pdrender-bench", {"frames", "-h"}, "--threads N   ");
        row("trackers", "pdrender-bench", {"help", "trackers"}, "--rays N   ");
        row("prediction", "pdrender-bench", {"help", "prediction"}, "--seeds N   ");
        row("accuracy-cost", "pdrender-bench", {"help", "accuracy-cost"}, "--rounds N   ");
    }

    void helpExplainsEveryOptionOnStandardOutput() {
        QFETCH(QString, program);
        QFETCH(QStringList, words);
        QFETCH(QByteArray, option);
        const ProgramRun help = run(program, words);
        QVERIFY2(help.code == 0, help.err.constData());
        QVERIFY2(help.out.contains(option), help.out.constData());
        QVERIFY(help.err.isEmpty());
    }

    void versionIsPrinted_data() { eachProgram(); }
    void versionIsPrinted() {
        QFETCH(QString, program);
        for (const char* word : {"--version", "-v"}) {
            const ProgramRun version = run(program, {word});
            QVERIFY2(version.code == 0, version.err.constData());
            QCOMPARE(version.out, QByteArray("PD-Render " PDR_VERSION "\n"));
            QVERIFY(version.err.isEmpty());
        }
    }

    void wrongUsageIsTwo_data() { eachProgram(); }
    void wrongUsageIsTwo() {
        QFETCH(QString, program);
        const ProgramRun wrong = run(program, {"--frob"});
        QCOMPARE(wrong.code, isNode(program) ? 64 : 2);
        QVERIFY2(wrong.err.contains("frob") && wrong.err.contains("--help"), wrong.err.constData());
        QVERIFY(wrong.out.isEmpty());
    }

    void withoutADisplayTheOtherProgramIsNamed() {
        const ProgramRun none = run("pdrender", {});
        QCOMPARE(none.code, 1);
        QVERIFY2(none.err.contains("display") && none.err.contains("pdrender-cli"), none.err.constData());
        const ProgramRun dead = run("pdrender", {}, [] { ::setenv("QT_QPA_PLATFORM", "nowhere", 1); });
        QCOMPARE(dead.code, 1);
        QVERIFY2(dead.err.contains("pdrender-cli"), dead.err.constData());
    }

    void whatCannotBePrintedIsAnError_data() { eachProgram(); }
    void whatCannotBePrintedIsAnError() {
        QFETCH(QString, program);
        for (const char* word : {"--version", "--help"}) {
            const ProgramRun full = run(program, {word}, {}, "/dev/full");
            QCOMPARE(full.code, isNode(program) ? 70 : 1);
            QVERIFY2(full.err.contains("could not be written"), full.err.constData());
            const ProgramRun closed = run(program, {word}, [] { ::close(STDOUT_FILENO); });
            QCOMPARE(closed.code, isNode(program) ? 70 : 1);
            QVERIFY2(closed.err.contains("could not be written"), closed.err.constData());
        }
    }

    /// With standard output closed, the next file that is opened must not take its number and receive what is printed.
    void aClosedStandardOutputSpoilsNoImage() {
        const ProgramRun closed = run("pdrender-cli", {"render", scene(), "-o", at("closed.png"), "--samples", "1"},
                                      [] { ::close(STDOUT_FILENO); });
        QCOMPARE(closed.code, 1);
        QFile file(at("closed.png"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(!file.readAll().contains("samples per pixel in"));
    }

    void shortOfMemoryIsASentence_data() {
        QTest::addColumn<QString>("program");
        QTest::addColumn<QStringList>("words");
        const auto row = [](const char* name, const char* program, const QStringList& words) {
            QTest::newRow(name) << program << words;
        };
        row("render", "pdrender-cli", {"render", scene(), "-o", at("short.png"), "--samples", "1", "--threads", "4"});
        row("effects", "pdrender-cli", {"effects", scene(), "--threads", "4", "--size", "16x12"});
        row("replay", "pdrender-cli", {"replay", scene(), "--pixel", "32,24"});
        row("bench", "pdrender-bench", {"picture", scene(), "--samples", "1", "--threads", "4"});
    }

    /// The limits begin where memory is just enough to load the program. Below that the loader reports the error.
    void shortOfMemoryIsASentence() {
        QFETCH(QString, program);
        QFETCH(QStringList, words);
#if defined(__SANITIZE_ADDRESS__)
        QSKIP("the address sanitizer alone needs more than any of these limits");
#endif
        int failures = 0;
        for (const int megabytes : {44, 52, 60, 68, 76, 84, 92, 100, 104, 108, 116, 132}) {
            const ProgramRun small = runIn(megabytes, program, words);
            QVERIFY2(small.code >= 0,
                     qPrintable(QString("a signal at %1 MB: %2").arg(megabytes).arg(QString(small.err))));
            QVERIFY2(small.code == 0 || !small.err.isEmpty(), qPrintable(QString("silence at %1 MB").arg(megabytes)));
            failures += small.code != 0;
        }
        QVERIFY(failures > 0);  // else nothing was tried
        QVERIFY(!QDir(folder_.path()).exists("short.png") || QImageReader::imageFormat(at("short.png")) == "png");
    }

    /// The limit is read from the outside, while the program runs.
    void coreDumpsAreSwitchedOff_data() {
        QTest::addColumn<QString>("program");
        QTest::addColumn<QStringList>("words");
        QTest::newRow("pdrender") << "pdrender" << QStringList{};
        QTest::newRow("pdrender-cli") << "pdrender-cli"
                                      << QStringList{"render", scene(), "-o", at("core.png"), "--seconds", "100"};
        QTest::newRow("pdrender-bench") << "pdrender-bench" << QStringList{"picture", scene(), "--samples", "1000000"};
        QTest::newRow("pdrender-node") << "pdrender-node" << QStringList{"--listen", "127.0.0.1:0"};
    }

    void coreDumpsAreSwitchedOff() {
        QFETCH(QString, program);
        QFETCH(QStringList, words);
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("QT_QPA_PLATFORM", "offscreen");
        process.setProcessEnvironment(environment);
        process.start(PDR_BINARY_DIR "/bin/" + program, words);
        QVERIFY(process.waitForStarted(pdr::test::kPatience));
        const auto limit = [&] {
            QFile limits(QString("/proc/%1/limits").arg(process.processId()));
            if (limits.open(QIODevice::ReadOnly))
                for (const QByteArray& line : limits.readAll().split('\n'))
                    if (line.startsWith("Max core file size"))
                        return line.simplified();
            return QByteArray();
        };
        QTRY_COMPARE_WITH_TIMEOUT(limit(), QByteArray("Max core file size 0 0 bytes"), pdr::test::kPatience);
        process.kill();
        QVERIFY(process.waitForFinished(pdr::test::kPatience));
    }

    void memoryIsNotDumped() {
        const pid_t child = ::fork();
        if (child == 0) {
            pdr::app::keepMemoryPrivate();
            ::_exit(::prctl(PR_GET_DUMPABLE) == 0 ? 0 : 1);
        }
        int status = -1;
        QCOMPARE(::waitpid(child, &status, 0), child);
        QCOMPARE(status, 0);
    }
};

QTEST_GUILESS_MAIN(ProgramsTest)
#include "programs_test.moc"
