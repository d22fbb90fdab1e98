#include <QtTest>

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

#include <algorithm>
#include <csignal>
#include <vector>

#include "render/base/health.h"
#include "tests/support/exr_channels.h"
#include "tests/support/scenes/ball_scene.h"

using pdr::test::BallScene;
using pdr::test::ProgramRun;

/// The images that the command line makes, and when it stops.
class CliImagesTest : public QObject {
    Q_OBJECT

    BallScene ball_;

    QString at(const QString& name) const { return ball_.at(name); }
    QString scene() const { return ball_.scene(); }

    /// All pixels of an OpenEXR file, without its header: that one tells the seconds.
    static std::vector<float> exrPixels(const QString& path) { return pdr::test::exrValues(path.toStdString()); }

  private slots:
    void pngIsDenoisedWhereThatIsAskedForAndExrNever() {
        const auto render = [&](const QStringList& options) {
            const ProgramRun result = BallScene::run(QStringList{"render", scene(), "-o", at("s.png"), "-o",
                                                                 at("s.exr"), "--samples", "16", "--size", "192x160"} +
                                                     options);
            return result.code == 0 ? QImage(at("s.png")) : QImage();
        };
        const QImage raw = render({});
        const std::vector<float> film = exrPixels(at("s.exr"));
        const QImage denoised = render({"--denoised"});
        QVERIFY(!raw.isNull() && raw.text("pdrender/denoised").isEmpty());
        QVERIFY2(denoised.text("pdrender/denoised").startsWith("95 % of the tissue within "),
                 qPrintable(denoised.text("pdrender/denoised")));
        QVERIFY(raw != denoised);
        QVERIFY(film == exrPixels(at("s.exr")));
        QVERIFY(render({"--denoised", "--model", "emissionAbsorption"}).text("pdrender/denoised").isEmpty());
    }

    /// Noise of the scan is taken off on request alone, and the image, its file and the program say so.
    void aDenoisedScanIsSaid() {
        const auto render = [&](const QStringList& options) {
            return BallScene::run(QStringList{"render", scene(), "-o", at("ct.png"), "--samples", "2"} + options);
        };
        const ProgramRun plain = render({});
        QCOMPARE(plain.code, 0);
        QVERIFY(!plain.err.contains("denoised") && QImage(at("ct.png")).text("pdrender/remarks").isEmpty());
        const ProgramRun denoised = render({"--ct-denoised"});
        QCOMPARE(denoised.code, 0);
        QVERIFY(denoised.err.contains("the CT is denoised for this image"));
        QCOMPARE(QImage(at("ct.png")).text("pdrender/remarks"), QString("CT denoised"));
        QByteArray wanting = BallScene::contents(scene());
        wanting.replace("\"camera\"", "\"ctDenoised\": true, \"camera\"");
        BallScene::write(at("quiet.json"), wanting);
        QCOMPARE(BallScene::run({"render", at("quiet.json"), "-o", at("ct.png"), "--samples", "2"}).code, 0);
        QCOMPARE(QImage(at("ct.png")).text("pdrender/remarks"), QString("CT denoised"));
    }

    /// What is printed is true of the file.
    void denoisedIsSaidOfWhatIsDenoised() {
        for (const auto& [name, options] :
             {std::pair("a.png", QStringList()), std::pair("a.png", QStringList{"--denoised"}),
              std::pair("a.exr", QStringList{"--denoised"}),
              std::pair("a.png", QStringList{"--denoised", "--model", "maximumIntensity"})}) {
            const ProgramRun result = BallScene::run(
                QStringList{"render", scene(), "-o", at(name), "--samples", "16", "--size", "192x160"} + options);
            QCOMPARE(result.code, 0);
            QCOMPARE(result.out.contains("denoised:"), !QImage(at(name)).text("pdrender/denoised").isEmpty());
        }
    }

    /// Wherever the file is not a denoised image with a bound, it is said why.
    void whatIsNotDenoisedIsSaid() {
        const auto said = [&](const char* name, const QStringList& options) {
            return BallScene::run(QStringList{"render", scene(), "-o", at(name), "--denoised"} + options).err;
        };
        const QStringList usual{"--samples", "16", "--size", "192x160"};
        QVERIFY(!said("a.png", usual).contains("denoised"));
        QVERIFY(said("a.png", usual + QStringList{"--model", "absorption"}).contains("the image is not denoised"));
        QVERIFY(said("a.exr", usual).contains("nothing is denoised"));
        QVERIFY(said("a.png", {"--samples", "3", "--size", "192x160"}).contains("off is not known"));
        QVERIFY(said("a.png", {"--samples", "16", "--size", "20x16"}).contains("off is not known"));
    }

    void everyModelMakesItsOwnImage() {
        QSet<QByteArray> images;
        for (const char* model : {"absorption", "emission", "emissionAbsorption", "singleScattering",
                                  "multipleScattering", "maximumIntensity"}) {
            const ProgramRun result = BallScene::run({"render", scene(), "-o", at("m.png"), "--samples", "4", "--size",
                                                      "30x30", "--look", "Bone", "--model", model, "--json"});
            QVERIFY2(result.code == 0, result.err.constData());
            const QJsonObject health = QJsonDocument::fromJson(result.out).object()["health"].toObject();
            QCOMPARE(health.size(), pdr::kFaults);
            for (const QJsonValue& fault : health)
                QCOMPARE(fault.toObject()["count"].toInt(-1), 0);
            const QImage image = QImage(at("m.png")).convertToFormat(QImage::Format_RGB888);
            images << QByteArray(reinterpret_cast<const char*>(image.constBits()), int(image.sizeInBytes()));
        }
        QCOMPARE(images.size(), 6);
        QCOMPARE(BallScene::run({"render", scene(), "-o", at("m.png"), "--model", "shadows"}).code, 2);
    }

    void theBiasedEstimatorIsThereToBeComparedWith() {
        const QStringList common{"render", scene(), "--samples", "4", "--size", "30x30", "--look", "Bone"};
        QCOMPARE(BallScene::run(common + QStringList{"-o", at("u.png")}).code, 0);
        const ProgramRun marched = BallScene::run(common + QStringList{"-o", at("k.png"), "--estimator", "kroesMarch"});
        QVERIFY2(marched.code == 0, marched.err.constData());
        QVERIFY(QImage(at("u.png")) != QImage(at("k.png")));
        QCOMPARE(QImage(at("k.png")).text("pdrender/estimator"), QString("kroesMarch (biased)"));
        QVERIFY(!QImage(at("u.png")).textKeys().contains("pdrender/estimator"));
        const ProgramRun bounced = BallScene::run(
            common + QStringList{"-o", at("k.png"), "--estimator", "kroesMarch", "--model", "multipleScattering"});
        QCOMPARE(bounced.code, 1);
        QVERIFY(bounced.err.contains("one event"));
        QCOMPARE(BallScene::run(common + QStringList{"-o", at("k.png"), "--estimator", "fast"}).code, 2);
        QCOMPARE(BallScene::run({"replay", scene(), "--pixel", "1,1", "--estimator", "kroesMarch"}).code, 1);
    }

    void aLensIsFocusedOnWhatAPixelShows() {
        QCOMPARE(BallScene::run({"render", scene(), "-o", at("l.png"), "--samples", "2", "--look", "Bone", "--aperture",
                                 "10", "--focus", "32,24"})
                     .code,
                 0);
        const ProgramRun nothing = BallScene::run({"render", scene(), "-o", at("l.png"), "--samples", "2", "--look",
                                                   "Bone", "--aperture", "10", "--focus", "0,0"});
        QCOMPARE(nothing.code, 1);
        QVERIFY(nothing.err.contains("nothing to focus on under pixel 0,0: no tissue at this point"));
        const ProgramRun outside =
            BallScene::run({"render", scene(), "-o", at("l.png"), "--aperture", "10", "--focus", "5000,1"});
        QCOMPARE(outside.code, 1);
        QVERIFY2(outside.err.contains("outside the image of 48 x 40"), outside.err.constData());
    }

    void surroundingsAreReadFromOpenExr() {
        QVERIFY(BallScene::run({"render", scene(), "-o", at("sky.exr"), "--samples", "2", "--look", "Bone"}).code == 0);
        QFile file(scene());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QJsonObject document = QJsonDocument::fromJson(file.readAll()).object();
        document["lights"] =
            QJsonArray{QJsonObject{{"type", "environment"}, {"image", at("sky.exr")}, {"radiance", 3}}};
        const auto write = [&](const QString& name) {
            QFile out(at(name));
            return out.open(QIODevice::WriteOnly) && out.write(QJsonDocument(document).toJson()) > 0;
        };
        QVERIFY(write("lit.json"));
        const ProgramRun lit = BallScene::run({"render", at("lit.json"), "-o", at("lit.png"), "--samples", "2"});
        QVERIFY2(lit.code == 0, lit.err.constData());
        document["lights"] = QJsonArray{QJsonObject{{"type", "environment"}, {"image", at("missing.exr")}}};
        QVERIFY(write("unlit.json"));
        const ProgramRun missing = BallScene::run({"render", at("unlit.json"), "-o", at("lit.png"), "--samples", "2"});
        QCOMPARE(missing.code, 1);
        QVERIFY(missing.err.contains("missing.exr") && missing.err.contains("lights[0].image"));
    }

    void theErrorStopsAndDoesNotDependOnTheClock() {
        QStringList samples;
        for (int i = 0; i < 2; ++i) {
            const ProgramRun result =
                BallScene::run({"render", scene(), "-o", at("e.png"), "--error", "0.05", "--json"});
            const QJsonObject facts = QJsonDocument::fromJson(result.out).object();
            QCOMPARE(facts["stoppedBy"].toString(), QString("error"));
            QVERIFY(facts["relativeError"].toDouble() <= 0.05);
            samples << QString::number(facts["samplesPerPixel"].toInt());
        }
        QCOMPARE(samples[0], samples[1]);
    }

    /// Thick fog before a panel: of the first samples none brings light. That is no image without noise.
    void anImageThatHasSeenNoLightYetIsNotDone() {
        BallScene::write(at("fog.raw"), QByteArray(2 * 48 * 16 * 48, 1));
        BallScene::write(at("backlit.json"),
                         R"({ "format": "pdrender-scene", "version": 1, "model": "multipleScattering",
            "volume": { "raw": "fog.raw", "size": [48, 16, 48], "spacingMm": [1, 1, 1] },
            "transferFunction": { "extinctionPerMm": 6, "nodes": [ { "hu": 0, "opacity": 1, "albedo": 0.95 } ] },
            "lights": [ { "type": "rectangle", "centreMm": [24, 60, 24], "normal": [0, -1, 0], "up": [0, 0, 1],
                          "widthMm": 40, "heightMm": 40, "radiance": 1000 } ],
            "camera": { "eyeMm": [24, -80, 24], "targetMm": [24, 8, 24], "fovDegrees": 5 },
            "film": { "width": 8, "height": 8 } })");
        for (const char* seed : {"1", "2", "3", "4", "5", "6"}) {
            const ProgramRun result = BallScene::run({"render", at("backlit.json"), "-o", at("fog.png"), "--error",
                                                      "0.05", "--samples", "80", "--seed", seed, "--json"});
            const QJsonObject facts = QJsonDocument::fromJson(result.out).object();
            QCOMPARE(facts["stoppedBy"].toString(), QString("samples"));
            QVERIFY(facts["relativeError"].isNull() || facts["relativeError"].toDouble() > 1);
            if (facts["relativeError"].isNull()) {
                QCOMPARE(facts["unseenShare"].toDouble(), 3 / (80.0 * 64));
                QCOMPARE(QImage(at("fog.png")).text("pdrender/relativeError"), QString("unknown"));
            }
        }
        const ProgramRun told = BallScene::run({"render", at("backlit.json"), "-o", at("fog.png"), "--samples", "16"});
        QVERIFY2(told.out.contains("no light was seen so far. At most 1 in 341 samples brings some."), told.out);
        // Without a light there is nothing to wait for, and no part for chance.
        QByteArray dark = BallScene::contents(at("backlit.json"));
        dark.replace("1000 }", "0 }");
        BallScene::write(at("dark.json"), dark);
        const ProgramRun black =
            BallScene::run({"render", at("dark.json"), "-o", at("fog.png"), "--error", "0.05", "--json"});
        const QJsonObject facts = QJsonDocument::fromJson(black.out).object();
        QCOMPARE(facts["stoppedBy"].toString(), QString("error"));
        QCOMPARE(facts["samplesPerPixel"].toInt(), 64);
        QCOMPARE(facts["relativeError"].toDouble(-1), 0.0);
    }

    /// Empty background beside the tissue must not change the tissue's error. Over seeds the errors vary by 1.4 % and
    /// 2.6 %, so the bounds are five standard deviations of their quotients; with the background they were 0.5 and
    /// less.
    void theErrorIsThatOfTheTissue() {
        const auto facts = [&](const char* size) {
            const ProgramRun result =
                BallScene::run({"render", scene(), "-o", at("w.png"), "--samples", "64", "--size", size, "--json"});
            return QJsonDocument::fromJson(result.out).object();
        };
        const QJsonObject square = facts("120x120"), wide = facts("480x120");
        QVERIFY(std::fabs(wide["relativeError"].toDouble() / square["relativeError"].toDouble() - 1) < 0.1);
        QVERIFY(std::fabs(wide["displayError"].toDouble() / square["displayError"].toDouble() - 1) < 0.19);
        QVERIFY(std::abs(wide["tissuePixels"].toInt() - square["tissuePixels"].toInt()) < 60);
    }

    void grayLevelsStop() {
        const ProgramRun result = BallScene::run({"render", scene(), "-o", at("e.png"), "--levels", "4", "--json"});
        const QJsonObject facts = QJsonDocument::fromJson(result.out).object();
        QCOMPARE(facts["stoppedBy"].toString(), QString("levels"));
        QVERIFY(facts["displayError"].toDouble(-1) > 2 && facts["displayError"].toDouble() <= 4);
        const ProgramRun early = BallScene::run({"render", scene(), "-o", at("e.png"), "--samples", "31", "--json"});
        QVERIFY(QJsonDocument::fromJson(early.out).object()["displayError"].isNull());
    }

    /// The error comes before hours are spent, not after: the address space is too small for an image of 16384 x 16384.
    void anImageThatDoesNotFitIsRefused() {
#if defined(__SANITIZE_ADDRESS__)
        QSKIP("the address sanitizer alone needs more than this limit");
#endif
        QProcess process;
        process.start("/bin/sh", {"-c",
                                  QString("ulimit -v 8000000; exec \"$0\" render \"$1\" -o \"$2\" --size "
                                          "16384x16384 --threads 2 --samples 1"),
                                  PDR_BINARY_DIR "/bin/pdrender-cli", scene(), at("huge.png")});
        QVERIFY(process.waitForFinished(pdr::test::kPatience));
        const QByteArray said = process.readAllStandardError();
        QCOMPARE(process.exitCode(), 1);
        QVERIFY2(said.contains("16384 x 16384 pixels needs 78.4 GB of memory") && said.contains("are free"), said);
        QVERIFY(!QFile::exists(at("huge.png")));
    }

    void theClockStops() {
        const ProgramRun result = BallScene::run({"render", scene(), "-o", at("t.png"), "--seconds", "0.3", "--json"});
        const QJsonObject facts = QJsonDocument::fromJson(result.out).object();
        QCOMPARE(facts["stoppedBy"].toString(), QString("seconds"));
        QVERIFY(facts["seconds"].toDouble() < 5);
    }

    void theImageIsTheSameOnAnyNumberOfThreads() {
        std::vector<std::vector<float>> images;
        for (const char* threads : {"1", "2", "4"}) {
            const QString name = at(QString("threads%1").arg(threads));
            const ProgramRun result = BallScene::run(
                {"render", scene(), "-o", name + ".png", "-o", name + ".exr", "--samples", "70", "--threads", threads});
            QVERIFY2(result.code == 0, result.err.constData());
            images.push_back(exrPixels(name + ".exr"));
        }
        QVERIFY(*std::max_element(images[0].begin(), images[0].end()) > 0);
        QVERIFY(images[1] == images[0]);
        QVERIFY(images[2] == images[0]);
    }

    void ctrlCWritesWhatIsThere() {
        QProcess process;
        process.start(PDR_BINARY_DIR "/bin/pdrender-cli",
                      {"render", scene(), "-o", at("c.png"), "--seconds", "100", "--json"});
        process.setReadChannel(QProcess::StandardError);
        QByteArray said;
        while (!said.contains("rendering") && process.waitForReadyRead(pdr::test::kPatience))
            said += process.readAllStandardError();
        ::kill(pid_t(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(pdr::test::kPatience));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 1);
        const QJsonObject facts = QJsonDocument::fromJson(process.readAllStandardOutput()).object();
        QCOMPARE(facts["stoppedBy"].toString(), QString("interrupted"));
        QCOMPARE(QImage(at("c.png")).text("pdrender/samplesPerPixel"),
                 QString::number(facts["samplesPerPixel"].toInt()));
    }

    void ctrlCReportsWhatWasMeasured() {
        QProcess process;
        process.start(PDR_BINARY_DIR "/bin/pdrender-cli",
                      {"accuracy", scene(), "-o", at("early"), "--time-limit", "1000"});
        process.setReadChannel(QProcess::StandardError);
        QByteArray said;
        while (!said.contains("reference") && process.waitForReadyRead(pdr::test::kPatience))
            said += process.readAllStandardError();
        ::kill(pid_t(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(pdr::test::kPatience));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 1);
        QVERIFY(BallScene::contents(at("early/accuracy.html")).contains("Interrupted"));
    }

    void aDicomFolderBecomesAnImage() {
        const ProgramRun example = BallScene::run({"example", at("phantom")});
        QVERIFY2(example.code == 0, example.err.constData());
        const ProgramRun result =
            BallScene::run({"render", at("phantom"), "-o", at("p.png"), "--size", "64x64", "--samples", "8"});
        QVERIFY2(result.code == 0, result.err.constData());
        QVERIFY(qGreen(QImage(at("p.png")).pixel(32, 32)) > 10);
        QCOMPARE(BallScene::run({"render", at("phantom"), "-o", at("p.png"), "--series", "1.2.3"}).code, 1);
    }

    void whatIsWrittenOverAPngIsChosen() {
        QCOMPARE(BallScene::run({"example", at("whose")}).code, 0);
        const auto render = [&](const QStringList& options) {
            const ProgramRun result = BallScene::run(QStringList{"render", at("whose"), "-o", at("n.png"), "-o",
                                                                 at("n.exr"), "--samples", "2", "--size", "480x360"} +
                                                     options);
            return result.code == 0 ? QImage(at("n.png")) : QImage();
        };
        const QImage none = render({"--annotations", "none"});
        const std::vector<float> film = exrPixels(at("n.exr"));
        const QImage usual = render({}), sides = render({"--annotations", "sides"}),
                     patient = render({"--annotations", "patient"});
        QVERIFY(!none.isNull() && !usual.isNull() && !patient.isNull());
        QVERIFY(film == exrPixels(at("n.exr")));
        QVERIFY(usual == sides && sides != none && patient != sides);
        const QRect who(0, 0, 160, 60), what(0, 260, 160, 100), middle(200, 120, 80, 80);
        QVERIFY(sides.copy(who) == none.copy(who) && patient.copy(who) != none.copy(who));
        QVERIFY(sides.copy(what) != none.copy(what) && sides.copy(middle) == none.copy(middle));
        QCOMPARE(BallScene::run({"render", at("whose"), "-o", at("n.png"), "--annotations", "all"}).code, 2);
        const ProgramRun raw = BallScene::run({"render", scene(), "-o", at("n.png"), "--annotations", "patient"});
        QVERIFY2(raw.code == 1 && raw.err.contains("a raw file knows no patient"), raw.err.constData());
    }

    /// The missing font is reported before anything is rendered.
    void withoutAFontThatIsSaid() {
        BallScene::write(at("fonts.conf"), "<fontconfig><dir>" + at("no fonts").toUtf8() + "</dir></fontconfig>");
        const auto run = [&](const QStringList& options) {
            QProcess process;
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert("FONTCONFIG_FILE", at("fonts.conf"));
            process.setProcessEnvironment(environment);
            process.start(PDR_BINARY_DIR "/bin/pdrender-cli",
                          QStringList{"render", scene(), "-o", at("f.png"), "--samples", "1"} + options);
            [&] { QVERIFY(process.waitForFinished(pdr::test::kPatience)); }();
            return std::pair(process.exitCode(), process.readAllStandardError());
        };
        const auto [code, said] = run({});
        QVERIFY2(code == 1 && said.contains("no font") && said.contains("--annotations none"), said.constData());
        QCOMPARE(run({"--annotations", "none"}).first, 0);
    }

    void nothingIsLeftBehind() {
        QVERIFY(QDir(ball_.path()).entryList({"*.part"}, QDir::Files | QDir::Hidden).isEmpty());
    }
};

QTEST_GUILESS_MAIN(CliImagesTest)
#include "cli_images_test.moc"
