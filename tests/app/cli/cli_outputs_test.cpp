#include <QtTest>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <csignal>
#include <functional>

#include "tests/support/patience.h"
#include "tests/support/places.h"

/// What becomes of the images of `pdrender-cli render` when something goes wrong after hours.
class CliOutputsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;
    QProcess process_;

    QString at(const QString& name) const { return folder_->filePath(name); }
    QString scene() const { return at("scene.json"); }
    static bool isImage(const QString& path) { return !QImage(path).isNull(); }
    QStringList parts() const { return QDir(folder_->path()).entryList({"*.part"}, QDir::Files | QDir::Hidden); }

    static void write(const QString& path, const QByteArray& bytes) {
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("the test cannot write its files");
    }
    static QByteArray contents(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    /// `before` is what the new process does before it becomes the program.
    void start(const QStringList& arguments, const std::function<void()>& before = {}) {
        process_.setWorkingDirectory(folder_->path());
        process_.setChildProcessModifier(before);
        process_.start(PDR_BINARY_DIR "/bin/pdrender-cli", arguments);
    }
    int exitCode() {
        if (!process_.waitForFinished(pdr::test::kPatience))
            qFatal("pdrender-cli did not end");
        return process_.exitStatus() == QProcess::NormalExit ? process_.exitCode() : -1;
    }
    int run(const QStringList& arguments, const std::function<void()>& before = {}) {
        start(arguments, before);
        return exitCode();
    }

    /// Waits until the first samples have been taken.
    void waitForRendering() {
        QByteArray said;
        while (!said.contains("rendering") &&
               process_.waitForReadyRead(pdr::test::kPatience))  // of standard error, see init()
            said += process_.readAllStandardError();
    }

    /// Renders until `signal` after `change` was made, which happens while samples are taken.
    int renderWhile(const QStringList& arguments, int signal, const std::function<void()>& change) {
        start(QStringList{"render", scene(), "--samples", "1000000000", "--json"} + arguments,
              [] { std::signal(SIGHUP, SIG_DFL); });
        waitForRendering();
        change();
        ::kill(pid_t(process_.processId()), signal);
        return exitCode();
    }

  private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        process_.setReadChannel(QProcess::StandardError);
        write(at("block.raw"), QByteArray(2 * 8 * 8 * 8, '\0'));
        write(scene(), R"({ "format": "pdrender-scene", "version": 1,
            "volume": { "raw": "block.raw", "size": [8, 8, 8], "spacingMm": [1, 1, 1] },
            "transferFunction": { "extinctionPerMm": 0.5, "nodes": [ { "hu": -100, "opacity": 0 }, { "hu": 0, "opacity": 1 } ] },
            "lights": [ { "type": "directional", "direction": [1, 1, -1], "irradiance": 3 } ],
            "camera": { "eyeMm": [4, -20, 4], "targetMm": [4, 4, 4], "fovDegrees": 25 },
            "film": { "width": 48, "height": 40 } })");
    }
    void cleanup() { QVERIFY(parts().isEmpty()); }

    /// A limit on the size of files fails one output as a full disk does.
    void anOutputThatFailsDoesNotLoseTheOthers() {
        const int code = run(
            {"render", scene(), "--samples", "4", "--size", "200x200", "--json", "-o", "big.exr", "-o", "small.png"},
            [] {
                std::signal(SIGXFSZ, SIG_DFL);  // which would end the program, and leave half a file
                const rlimit small{60000, 60000};
                ::setrlimit(RLIMIT_FSIZE, &small);
            });
        QCOMPARE(code, 1);
        QVERIFY(isImage(at("small.png")));
        QVERIFY(!QFile::exists(at("big.exr")));
        QVERIFY(process_.readAllStandardError().contains("big.exr"));
        const QJsonObject facts = QJsonDocument::fromJson(process_.readAllStandardOutput()).object();
        QCOMPARE(facts["outputs"].toArray(), QJsonArray{"small.png"});
    }

    void anImageWhoseNameWasTakenGoesBesideIt() {
        const int code = renderWhile({"-o", "a.png"}, SIGINT, [this] { QDir(folder_->path()).mkdir("a.png"); });
        QCOMPARE(code, 1);
        QVERIFY(isImage(at("a-2.png")));
        const QByteArray said = process_.readAllStandardError();
        QVERIFY2(said.contains("a.png: this is a folder") && said.contains("a-2.png"), said.constData());
    }

    void anImageWhoseFolderIsGoneComesHere() {
        QDir(folder_->path()).mkdir("gone");
        write(at("a.png"), "not to be replaced");
        const int code =
            renderWhile({"-o", "gone/a.png", "-o", "b.png"}, SIGINT, [this] { QDir(at("gone")).removeRecursively(); });
        QCOMPARE(code, 1);
        QVERIFY(isImage(at("a-2.png")) && isImage(at("b.png")));
        QCOMPARE(contents(at("a.png")), QByteArray("not to be replaced"));
        const QJsonObject facts = QJsonDocument::fromJson(process_.readAllStandardOutput()).object();
        QCOMPARE(facts["outputs"].toArray(), (QJsonArray{"a-2.png", "b.png"}));
    }

    /// A closed session of a remote shell is no reason to lose what was rendered.
    void aHangUpWritesWhatIsThere() {
        QCOMPARE(renderWhile({"-o", "a.png"}, SIGHUP, [] {}), 1);
        QVERIFY(isImage(at("a.png")));
    }

    /// nohup lets a program go on.
    void aHangUpThatIsToBeIgnoredIsIgnored() {
        start({"render", scene(), "--samples", "1000000000", "-o", "a.png"}, [] { std::signal(SIGHUP, SIG_IGN); });
        waitForRendering();
        ::kill(pid_t(process_.processId()), SIGHUP);
        QVERIFY(!process_.waitForFinished(500));
        ::kill(pid_t(process_.processId()), SIGINT);
        QCOMPARE(exitCode(), 1);
    }

    void aReaderOfMessagesThatIsGoneLosesNoImage() {
        start({"render", scene(), "--samples", "1000000000", "-o", "a.png"});
        waitForRendering();
        process_.closeReadChannel(QProcess::StandardError);
        ::kill(pid_t(process_.processId()), SIGINT);
        QCOMPARE(exitCode(), 1);
        QVERIFY(isImage(at("a.png")));
    }

    void theScenesOwnFilesAreNotOverwritten() {
        QCOMPARE(run({"render", scene(), "--samples", "1", "-o", "sky.exr"}), 0);
        QFile::rename(at("block.raw"), at("block.exr"));
        QJsonObject document = QJsonDocument::fromJson(contents(scene())).object();
        QJsonObject volume = document["volume"].toObject();
        volume["raw"] = "block.exr";
        document["volume"] = volume;
        document["lights"] = QJsonArray{QJsonObject{{"type", "environment"}, {"image", "sky.exr"}, {"radiance", 3}}};
        write(scene(), QJsonDocument(document).toJson());
        QFile::link("sky.exr", at("link.exr"));
        const QByteArray sky = contents(at("sky.exr")), block = contents(at("block.exr"));
        for (const char* output : {"sky.exr", "./sky.exr", "link.exr", "block.exr"}) {
            QCOMPARE(run({"render", scene(), "--samples", "100000", "-o", "a.png", "-o", output}), 1);
            const QByteArray said = process_.readAllStandardError();
            QVERIFY2(said.contains(output) && said.contains("is read"), said.constData());
        }
        QCOMPARE(contents(at("sky.exr")), sky);
        QCOMPARE(contents(at("block.exr")), block);
        QCOMPARE(run({"render", scene(), "--samples", "1", "-o", "other.exr"}), 0);
    }

    void endingsMayBeInCapitals() {
        QCOMPARE(run({"render", scene(), "--samples", "1", "-o", "a.PNG", "-o", "b.Exr"}), 0);
        QCOMPARE(contents(at("a.PNG")).left(4), QByteArray("\x89PNG"));
        QCOMPARE(contents(at("b.Exr")).left(4), QByteArray("v/1\1", 4));
    }

    void aNameThatIsTooLongIsToldBeforeRendering() {
        const QString tooLong = QString(252, 'a') + ".png";
        QCOMPARE(run({"render", scene(), "--samples", "1000000000", "-o", tooLong}), 1);
        const QByteArray said = process_.readAllStandardError();
        QVERIFY2(said.contains("File name too long") && said.contains("Choose a shorter name"), said.constData());
        QCOMPARE(run({"render", scene(), "--samples", "1", "-o", tooLong.mid(1)}), 0);
        QVERIFY(isImage(at(tooLong.mid(1))));
    }

    void aLongNameThatWasTakenIsCutForAnother() {
        const QString longest = QString(249, 'a') + QString::fromUtf8("é") + ".png";  // 255 bytes
        const int code = renderWhile({"-o", longest}, SIGINT, [&] { QDir(folder_->path()).mkdir(longest); });
        QCOMPARE(code, 1);
        QVERIFY(isImage(at(QString(249, 'a') + "-2.png")));
    }

    void whatAccuracyCannotWriteIsToldBeforeRendering() {
        QVERIFY(QDir(folder_->path()).mkpath("report/accuracy.svg"));
        QCOMPARE(run({"accuracy", scene(), "-o", "report", "--time-limit", "100000"}), 1);
        const QByteArray said = process_.readAllStandardError();
        QVERIFY2(said.contains("accuracy.svg: this is a folder") && !said.contains("picture.png"), said.constData());
    }

    /// Qt would look for another folder, and write another file.
    void namesThatAreNoTextAreRefused() {
        const QString folder = "\"$(printf 'M\\374ller')\"";
        for (const QString& words : {"info " + folder, "render scene.json --samples 1 -o " + folder + ".png"}) {
            process_.setWorkingDirectory(folder_->path());
            process_.setChildProcessModifier({});
            process_.start("/bin/sh", {"-c", "exec '" PDR_BINARY_DIR "/bin/pdrender-cli' " + words});
            QCOMPARE(exitCode(), 2);
            const QByteArray said = process_.readAllStandardError();
            QVERIFY2(said.contains("no UTF-8") && said.contains("Rename it"), said.constData());
        }
    }

    void whatMayNotBeReplacedIsToldBeforeRendering() {
        write(at("a.png"), "old");
        ::chmod(at("a.png").toUtf8().constData(), 0444);
        ::chmod(folder_->path().toUtf8().constData(), 0777);
        const int code = run({"render", scene(), "--samples", "1000000000", "-o", "a.png"}, [] {
            if (::geteuid() == 0 && ::setuid(65534) != 0)
                ::_exit(99);
        });
        QCOMPARE(code, 1);
        QVERIFY(process_.readAllStandardError().contains("a.png: this file may not be written"));
        QCOMPARE(contents(at("a.png")), QByteArray("old"));
    }

    void imagesAreTheOwnersAlone() {
        QCOMPARE(run({"render", scene(), "--samples", "1", "-o", "a.png", "-o", "a.exr"}), 0);
        for (const char* name : {"a.png", "a.exr"}) {
            struct stat facts {};
            QCOMPARE(::stat(at(name).toUtf8().constData(), &facts), 0);
            QCOMPARE(facts.st_mode & 0777, mode_t(0600));
        }
    }
};

QTEST_GUILESS_MAIN(CliOutputsTest)
#include "cli_outputs_test.moc"
