#include <QtTest>

#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <unistd.h>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <algorithm>
#include <csignal>
#include <vector>

#include "render/base/health.h"
#include "render/base/version.h"
#include "tests/support/places.h"

/// What a run of the program left.
struct Run {
    int code = -1;
    QByteArray out, err;
};

/// A ball of 12 voxels' radius in air, as a raw file, and a scene that shows it.
class CliTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString at(const QString& name) const { return folder_.filePath(name); }
    QString scene() const { return at("scene.json"); }

    static QString program() { return PDR_BINARY_DIR "/bin/pdrender-cli"; }

    static Run run(const QStringList& arguments) {
        QProcess process;
        process.start(program(), arguments);
        if (!process.waitForFinished(120'000))
            qFatal("pdrender-cli did not end");
        return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1, process.readAllStandardOutput(),
                process.readAllStandardError()};
    }

    static QByteArray contents(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    static void write(const QString& path, const QByteArray& bytes) {
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("the test cannot write its files");
    }

    /// All pixels of an OpenEXR file, without its header: that one tells the seconds.
    static std::vector<float> exrPixels(const QString& path) {
        Imf::InputFile file(path.toUtf8().constData());
        const Imath::Box2i box = file.header().dataWindow();
        const int width = box.max.x + 1, height = box.max.y + 1;
        std::vector<float> values(std::size_t(width) * std::size_t(height) * 6);
        Imf::FrameBuffer frame;
        float* next = values.data();
        for (const char* channel : {"R", "G", "B", "error.R", "error.G", "error.B"})
            frame.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(next++), 24, std::size_t(24 * width)));
        file.setFrameBuffer(frame);
        file.readPixels(0, height - 1);
        return values;
    }

  private slots:
    void initTestCase() {
        QByteArray voxels;
        for (int z = 0; z < 32; ++z)
            for (int y = 0; y < 32; ++y)
                for (int x = 0; x < 32; ++x) {
                    const int r2 = (x - 16) * (x - 16) + (y - 16) * (y - 16) + (z - 16) * (z - 16);
                    const qint16 hu = r2 < 144 ? 1000 : -1000;
                    voxels.append(reinterpret_cast<const char*>(&hu), 2);
                }
        write(at("ball.raw"), voxels);
        write(scene(), R"({ "format": "pdrender-scene", "version": 1,
            "volume": { "raw": "ball.raw", "size": [32, 32, 32], "spacingMm": [1, 1, 1] },
            "transferFunction": { "extinctionPerMm": 0.5, "nodes": [ { "hu": 0, "opacity": 0 }, { "hu": 500, "opacity": 1 } ] },
            "lights": [ { "type": "directional", "direction": [1, 1, -1], "irradiance": 3 },
                        { "type": "environment", "radiance": 0.2, "visible": false } ],
            "camera": { "eyeMm": [16, -80, 16], "targetMm": [16, 16, 16], "fovDegrees": 25 },
            "film": { "width": 48, "height": 40 } })");
    }

    void versionAndHelpGoToStandardOutput() {
        QCOMPARE(run({"--version"}).out, QByteArray("PD-Render " PDR_VERSION "\n"));
        QVERIFY(run({"--help"}).out.contains("pdrender-cli render"));
        const Run help = run({"render", "--help"});
        QCOMPARE(help.code, 0);
        QVERIFY(help.out.contains("--samples"));
    }

    void wrongUsageIsTwo_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("named");
        const auto row = [](const char* name, const QStringList& arguments, const char* named) {
            QTest::newRow(name) << arguments << QByteArray(named);
        };
        row("nothing", {}, "say what to do");
        row("no such command", {"paint"}, "paint");
        row("no input", {"render", "-o", "a.png"}, "needs one folder");
        row("two inputs", {"render", "a", "b", "-o", "a.png"}, "needs one folder");
        row("no output", {"render", "a"}, "-o");
        row("foreign extension", {"render", "a", "-o", "a.jpg"}, "a.jpg");
        row("no such option", {"render", "a", "-o", "a.png", "--sample", "3"}, "sample");
        row("size", {"render", "a", "-o", "a.png", "--size", "10"}, "--size");
        row("size too large", {"render", "a", "-o", "a.png", "--size", "20000x1"}, "--size");
        row("samples", {"render", "a", "-o", "a.png", "--samples", "0"}, "--samples");
        row("samples as text", {"render", "a", "-o", "a.png", "--samples", "many"}, "--samples");
        row("seconds", {"render", "a", "-o", "a.png", "--seconds", "-1"}, "--seconds");
        row("levels", {"render", "a", "-o", "a.png", "--levels", "0"}, "--levels");
        row("error", {"render", "a", "-o", "a.png", "--error", "nan"}, "--error");
        row("exposure", {"render", "a", "-o", "a.png", "--exposure", "0"}, "--exposure");
        row("threads", {"render", "a", "-o", "a.png", "--threads", "0"}, "--threads");
        row("device", {"render", "a", "-o", "a.png", "--device", "abacus"}, "--device");
        row("view", {"render", "a", "-o", "a.png", "--view", "above"}, "--view");
        row("effects without input", {"effects"}, "needs one folder");
        row("effects of two", {"effects", "a", "b"}, "needs one folder");
        row("effects do not stop", {"effects", "a", "--samples", "3"}, "samples");
        row("preset", {"render", "a", "-o", "a.png", "--preset", "MR brain"}, "CT soft tissue");
    }

    void wrongUsageIsTwo() {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, named);
        const Run result = run(arguments);
        QCOMPARE(result.code, 2);
        QVERIFY(result.out.isEmpty());
        QVERIFY2(result.err.contains(named), result.err.constData());
    }

    void aDeviceThatIsNotThereIsSaidAtOnce() {
        const Run result = run({"render", scene(), "-o", at("device.png"), "--device", "cuda:77"});
        QCOMPARE(result.code, 1);
        QVERIFY2(result.err.contains("cuda:77"), result.err.constData());
        QVERIFY(!QFile::exists(at("device.png")));
        for (const char* name : {"cpu", "auto"})
            QCOMPARE(run({"render", scene(), "-o", at("device.png"), "--samples", "1", "--device", name}).code, 0);
    }

    void aBadInputIsNamedAndNothingIsWritten() {
        for (const QString& input : {at("none"), at("ball.raw"), at("empty")}) {
            QDir(folder_.path()).mkdir("empty");
            const Run result = run({"render", input, "-o", at("bad.png")});
            QCOMPARE(result.code, 1);
            QVERIFY2(result.err.contains(input.toUtf8()), result.err.constData());
            QVERIFY(!QFile::exists(at("bad.png")));
        }
    }

    void aBadFieldIsNamed() {
        write(at("wrong.json"), contents(scene()).replace("\"irradiance\": 3", "\"irradiance\": -3"));
        const Run result = run({"render", at("wrong.json"), "-o", at("bad.png")});
        QCOMPARE(result.code, 1);
        QVERIFY2(result.err.contains("lights[0].irradiance"), result.err.constData());
    }

    void anOutputThatCannotBeWrittenIsToldBeforeRendering() {
        const Run noFolder = run({"render", scene(), "-o", at("none/a.png"), "--samples", "1000000"});
        QCOMPARE(noFolder.code, 1);
        QVERIFY2(noFolder.err.contains("none/a.png"), noFolder.err.constData());
        QDir(folder_.path()).mkdir("locked");
        QFile::setPermissions(at("locked"), QFile::ReadOwner | QFile::ExeOwner);
        if (::geteuid() == 0)
            QSKIP("root may write everywhere, so a folder without permission cannot be tried");
        QCOMPARE(run({"render", scene(), "-o", at("locked/a.png"), "--samples", "1000000"}).code, 1);
    }

    void picturesAreWrittenAndJsonTellsHow() {
        const Run result = run({"render", scene(), "-o", at("a.png"), "-o", at("a.exr"), "--samples", "32", "--json"});
        QVERIFY2(result.code == 0, result.err.constData());
        const QJsonObject facts = QJsonDocument::fromJson(result.out).object();
        QCOMPARE(facts["samplesPerPixel"].toInt(), 32);
        QCOMPARE(facts["width"].toInt(), 48);
        QCOMPARE(facts["stoppedBy"].toString(), QString("samples"));
        QCOMPARE(facts["outputs"].toArray().size(), 2);
        QVERIFY(facts["seconds"].toDouble() > 0 && facts["samplesPerSecond"].toDouble() > 0);
        QVERIFY(facts["relativeError"].toDouble() > 0 && facts["relativeError"].toDouble() < 1);
        const QImage image(at("a.png"));
        QCOMPARE(image.size(), QSize(48, 40));
        QVERIFY(qGreen(image.pixel(24, 20)) > 20);
        QCOMPARE(image.pixel(0, 0), qRgb(0, 0, 0));
        QVERIFY(QFile::exists(at("a.exr")));
    }

    void optionsOverruleTheScene() {
        const Run result = run({"render", scene(), "-o", at("b.png"), "--samples", "64", "--size", "30x20", "--preset",
                                "bone", "--view", "left", "--seed", "9", "--json"});
        QVERIFY2(result.code == 0, result.err.constData());
        QCOMPARE(QImage(at("b.png")).size(), QSize(30, 20));
        QCOMPARE(QImage(at("b.png")).text("pdrender/seed"), QString("9"));
        QVERIFY(qGreen(QImage(at("b.png")).pixel(15, 10)) > 20);
    }

    void effectsAreListedWithReasonAndCost() {
        const Run plain = run({"effects", scene()});
        QCOMPARE(plain.code, 0);
        QVERIFY(plain.out.contains("the gradient factor is 0"));
        QVERIFY(plain.out.contains("no light is a panel or a ball"));
        QVERIFY(plain.out.contains("multipleScattering"));
        QVERIFY(!QRegularExpression(" -[0-9]").match(plain.out).hasMatch());  // no cost is negative
        const Run lit = run({"effects", scene(), "--preset", "CT bone", "--json"});
        QCOMPARE(lit.code, 0);
        const QJsonObject ledger = QJsonDocument::fromJson(lit.out).object();
        QCOMPARE(ledger["models"].toArray().size(), 6);
        QCOMPARE(ledger["model"].toString(), QString("singleScattering"));
        QStringList tried;
        for (const QJsonValue& effect : ledger["effects"].toArray())
            if (const QJsonObject band = effect["milliseconds"].toObject(); !band.isEmpty()) {
                tried << effect["name"].toString();
                QCOMPARE(effect["verdict"].toString(), QString("needed"));
                QVERIFY(effect["levels"].toDouble() > 0);  // that the picture changes by
                QVERIFY(band["low"].toDouble() <= band["median"].toDouble() &&
                        band["median"].toDouble() <= band["high"].toDouble());
            }
        QVERIFY(tried.contains("shadows") && tried.contains("lights with a place"));
    }

    /// Tissue too dense for multiple scattering is told before anybody counts samples, wherever health is told.
    void overDenseTissueIsToldEverywhere() {
        QFile file(scene());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QJsonObject document = QJsonDocument::fromJson(file.readAll()).object();
        QJsonObject curve = document["transferFunction"].toObject();
        curve["extinctionPerMm"] = 1e5;
        document["transferFunction"] = curve;
        document["model"] = "multipleScattering";
        write(at("dense.json"), QJsonDocument(document).toJson());
        const QStringList render{"render",        at("dense.json"), "-o",    at("dense.png"), "-o",
                                 at("dense.exr"), "--size",         "16x16", "--samples",     "2"};
        const Run told = run(render);
        QVERIFY2(told.code == 0 && told.out.contains("free paths between voxels"), told.err + told.out);
        const QJsonObject facts = QJsonDocument::fromJson(run(render + QStringList{"--json"}).out).object();
        QCOMPARE(facts["warnings"].toArray(), QJsonArray{"overDense"});
        QCOMPARE(QImage(at("dense.png")).text("pdrender/warnings"), QString("overDense"));
        QVERIFY(contents(at("dense.exr")).contains("overDense"));
        const Run single = run(render + QStringList{"--model", "singleScattering", "--json"});
        QVERIFY(QJsonDocument::fromJson(single.out).object()["warnings"].toArray().isEmpty());
        QVERIFY(QImage(at("dense.png")).text("pdrender/warnings").isEmpty());
    }

    void aSampleIsToldEventByEvent() {
        const Run told = run({"replay", scene(), "--preset", "CT bone", "--model", "multipleScattering", "--size", "40x40",
                              "--pixel", "20,20", "--sample", "3"});
        QVERIFY2(told.code == 0, told.err.constData());
        QVERIFY(told.out.contains("pixel 20,20 sample 3 seed"));
        QVERIFY(told.out.contains("event after") && told.out.contains("HU, extinction") &&
                told.out.contains("radiance ("));
        QCOMPARE(run({"replay", scene(), "--pixel", "5000,0"}).code, 1);
        QCOMPARE(run({"replay", scene(), "--pixel", "five"}).code, 2);
        QCOMPARE(run({"replay", scene()}).code, 2);
        QCOMPARE(run({"replay", scene(), "--pixel", "1,1", "--model", "maximumIntensity"}).code, 1);
    }

    void everyModelMakesItsOwnPicture() {
        QSet<QByteArray> pictures;
        for (const char* model : {"absorption", "emission", "emissionAbsorption", "singleScattering",
                                  "multipleScattering", "maximumIntensity"}) {
            const Run result = run({"render", scene(), "-o", at("m.png"), "--samples", "4", "--size", "30x30", "--preset",
                                    "CT bone", "--model", model, "--json"});
            QVERIFY2(result.code == 0, result.err.constData());
            const QJsonObject health = QJsonDocument::fromJson(result.out).object()["health"].toObject();
            QCOMPARE(health.size(), pdr::kFaults);
            for (const QJsonValue& fault : health)
                QCOMPARE(fault.toObject()["count"].toInt(-1), 0);
            const QImage image = QImage(at("m.png")).convertToFormat(QImage::Format_RGB888);
            pictures << QByteArray(reinterpret_cast<const char*>(image.constBits()), int(image.sizeInBytes()));
        }
        QCOMPARE(pictures.size(), 6);
        QCOMPARE(run({"render", scene(), "-o", at("m.png"), "--model", "shadows"}).code, 2);
    }

    void theBiasedEstimatorIsThereToBeComparedWith() {
        const QStringList common{"render", scene(), "--samples", "4", "--size", "30x30", "--preset", "CT bone"};
        QCOMPARE(run(common + QStringList{"-o", at("u.png")}).code, 0);
        const Run marched = run(common + QStringList{"-o", at("k.png"), "--estimator", "kroesMarch"});
        QVERIFY2(marched.code == 0, marched.err.constData());
        QVERIFY(QImage(at("u.png")) != QImage(at("k.png")));
        QCOMPARE(QImage(at("k.png")).text("pdrender/estimator"), QString("kroesMarch (biased)"));
        QVERIFY(!QImage(at("u.png")).textKeys().contains("pdrender/estimator"));
        const Run bounced = run(common + QStringList{"-o", at("k.png"), "--estimator", "kroesMarch", "--model",
                                                     "multipleScattering"});
        QCOMPARE(bounced.code, 1);
        QVERIFY(bounced.err.contains("one event"));
        QCOMPARE(run(common + QStringList{"-o", at("k.png"), "--estimator", "fast"}).code, 2);
        QCOMPARE(run({"replay", scene(), "--pixel", "1,1", "--estimator", "kroesMarch"}).code, 1);
    }

    void aLensIsFocusedOnWhatAPixelShows() {
        QCOMPARE(run({"render", scene(), "-o", at("l.png"), "--samples", "2", "--preset", "CT bone", "--aperture", "10",
                      "--focus", "32,24"}).code, 0);
        const Run nothing = run({"render", scene(), "-o", at("l.png"), "--samples", "2", "--preset", "CT bone",
                                 "--aperture", "10", "--focus", "0,0"});
        QCOMPARE(nothing.code, 1);
        QVERIFY(nothing.err.contains("nothing to focus on under pixel 0,0"));
        const Run outside = run({"render", scene(), "-o", at("l.png"), "--aperture", "10", "--focus", "5000,1"});
        QCOMPARE(outside.code, 1);
        QVERIFY2(outside.err.contains("outside the picture of 48 x 40"), outside.err.constData());
    }

    void surroundingsAreReadFromOpenExr() {
        QVERIFY(run({"render", scene(), "-o", at("sky.exr"), "--samples", "2", "--preset", "CT bone"}).code == 0);
        QFile file(scene());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QJsonObject document = QJsonDocument::fromJson(file.readAll()).object();
        document["lights"] = QJsonArray{QJsonObject{{"type", "environment"}, {"image", at("sky.exr")}, {"radiance", 3}}};
        const auto write = [&](const QString& name) {
            QFile out(at(name));
            return out.open(QIODevice::WriteOnly) && out.write(QJsonDocument(document).toJson()) > 0;
        };
        QVERIFY(write("lit.json"));
        const Run lit = run({"render", at("lit.json"), "-o", at("lit.png"), "--samples", "2"});
        QVERIFY2(lit.code == 0, lit.err.constData());
        document["lights"] = QJsonArray{QJsonObject{{"type", "environment"}, {"image", at("missing.exr")}}};
        QVERIFY(write("unlit.json"));
        const Run missing = run({"render", at("unlit.json"), "-o", at("lit.png"), "--samples", "2"});
        QCOMPARE(missing.code, 1);
        QVERIFY(missing.err.contains("missing.exr") && missing.err.contains("lights[0].image"));
    }

    void theErrorStopsAndDoesNotDependOnTheClock() {
        QStringList samples;
        for (int i = 0; i < 2; ++i) {
            const Run result = run({"render", scene(), "-o", at("e.png"), "--error", "0.05", "--json"});
            const QJsonObject facts = QJsonDocument::fromJson(result.out).object();
            QCOMPARE(facts["stoppedBy"].toString(), QString("error"));
            QVERIFY(facts["relativeError"].toDouble() <= 0.05);
            samples << QString::number(facts["samplesPerPixel"].toInt());
        }
        QCOMPARE(samples[0], samples[1]);
    }

    /// Thick fog before a panel: of the first samples none brings light. That is no picture without noise.
    void aPictureThatHasSeenNoLightYetIsNotDone() {
        write(at("fog.raw"), QByteArray(2 * 48 * 16 * 48, 1));
        write(at("backlit.json"), R"({ "format": "pdrender-scene", "version": 1, "model": "multipleScattering",
            "volume": { "raw": "fog.raw", "size": [48, 16, 48], "spacingMm": [1, 1, 1] },
            "transferFunction": { "extinctionPerMm": 6, "nodes": [ { "hu": 0, "opacity": 1, "albedo": 0.95 } ] },
            "lights": [ { "type": "rectangle", "centreMm": [24, 60, 24], "normal": [0, -1, 0], "up": [0, 0, 1],
                          "widthMm": 40, "heightMm": 40, "radiance": 1000 } ],
            "camera": { "eyeMm": [24, -80, 24], "targetMm": [24, 8, 24], "fovDegrees": 5 },
            "film": { "width": 8, "height": 8 } })");
        for (const char* seed : {"1", "2", "3", "4", "5", "6"}) {
            const Run result = run({"render", at("backlit.json"), "-o", at("fog.png"), "--error", "0.05", "--samples",
                                    "80", "--seed", seed, "--json"});
            const QJsonObject facts = QJsonDocument::fromJson(result.out).object();
            QCOMPARE(facts["stoppedBy"].toString(), QString("samples"));
            QVERIFY(facts["relativeError"].isNull() || facts["relativeError"].toDouble() > 1);
            if (facts["relativeError"].isNull()) {
                QCOMPARE(facts["unseenShare"].toDouble(), 3 / (80.0 * 64));
                QCOMPARE(QImage(at("fog.png")).text("pdrender/relativeError"), QString("unknown"));
            }
        }
        const Run told = run({"render", at("backlit.json"), "-o", at("fog.png"), "--samples", "16"});
        QVERIFY2(told.out.contains("no light was seen so far. At most 1 in 341 samples brings some."), told.out);
        // Without a light there is nothing to wait for, and no part for chance.
        QByteArray dark = contents(at("backlit.json"));
        dark.replace("1000 }", "0 }");
        write(at("dark.json"), dark);
        const Run black = run({"render", at("dark.json"), "-o", at("fog.png"), "--error", "0.05", "--json"});
        const QJsonObject facts = QJsonDocument::fromJson(black.out).object();
        QCOMPARE(facts["stoppedBy"].toString(), QString("error"));
        QCOMPARE(facts["samplesPerPixel"].toInt(), 64);
        QCOMPARE(facts["relativeError"].toDouble(-1), 0.0);
    }

    /// Empty ground beside the tissue says nothing about the tissue.
    void theErrorIsThatOfTheTissue() {
        const auto facts = [&](const char* size) {
            const Run result = run({"render", scene(), "-o", at("w.png"), "--samples", "64", "--size", size, "--json"});
            return QJsonDocument::fromJson(result.out).object();
        };
        const QJsonObject square = facts("40x40"), wide = facts("400x40");
        QVERIFY(std::fabs(wide["relativeError"].toDouble() / square["relativeError"].toDouble() - 1) < 0.05);
        QVERIFY(std::fabs(wide["displayError"].toDouble() / square["displayError"].toDouble() - 1) < 0.05);
        QVERIFY(std::abs(wide["tissuePixels"].toInt() - square["tissuePixels"].toInt()) < 20);
    }

    void grayLevelsStop() {
        const Run result = run({"render", scene(), "-o", at("e.png"), "--levels", "16", "--json"});
        const QJsonObject facts = QJsonDocument::fromJson(result.out).object();
        QCOMPARE(facts["stoppedBy"].toString(), QString("levels"));
        QVERIFY(facts["displayError"].toDouble(-1) > 8 && facts["displayError"].toDouble() <= 16);
        const Run early = run({"render", scene(), "-o", at("e.png"), "--samples", "31", "--json"});
        QVERIFY(QJsonDocument::fromJson(early.out).object()["displayError"].isNull());
    }

    /// Before hours are spent, not after: the address space is what a picture of 16384 x 16384 may not have.
    void aPictureThatDoesNotFitIsRefused() {
        QProcess process;
        process.start("/bin/sh", {"-c", QString("ulimit -v 8000000; exec \"$0\" render \"$1\" -o \"$2\" --size "
                                                "16384x16384 --threads 2 --samples 1"),
                                  program(), scene(), at("huge.png")});
        QVERIFY(process.waitForFinished(60'000));
        const QByteArray said = process.readAllStandardError();
        QCOMPARE(process.exitCode(), 1);
        QVERIFY2(said.contains("16384 x 16384 pixels needs 78.4 GB of memory") && said.contains("are free"), said);
        QVERIFY(!QFile::exists(at("huge.png")));
    }

    void theClockStops() {
        const Run result = run({"render", scene(), "-o", at("t.png"), "--seconds", "0.3", "--json"});
        const QJsonObject facts = QJsonDocument::fromJson(result.out).object();
        QCOMPARE(facts["stoppedBy"].toString(), QString("seconds"));
        QVERIFY(facts["seconds"].toDouble() < 5);
    }

    void thePictureIsTheSameOnAnyNumberOfThreads() {
        std::vector<std::vector<float>> pictures;
        for (const char* threads : {"1", "2", "4"}) {
            const QString name = at(QString("threads%1").arg(threads));
            const Run result = run(
                {"render", scene(), "-o", name + ".png", "-o", name + ".exr", "--samples", "70", "--threads", threads});
            QVERIFY2(result.code == 0, result.err.constData());
            pictures.push_back(exrPixels(name + ".exr"));
        }
        QVERIFY(*std::max_element(pictures[0].begin(), pictures[0].end()) > 0);
        QVERIFY(pictures[1] == pictures[0]);
        QVERIFY(pictures[2] == pictures[0]);
    }

    void ctrlCWritesWhatIsThere() {
        QProcess process;
        process.start(program(), {"render", scene(), "-o", at("c.png"), "--seconds", "100", "--json"});
        QVERIFY(process.waitForStarted());
        QTest::qWait(1500);
        ::kill(pid_t(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(20'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 1);
        const QJsonObject facts = QJsonDocument::fromJson(process.readAllStandardOutput()).object();
        QCOMPARE(facts["stoppedBy"].toString(), QString("interrupted"));
        QCOMPARE(QImage(at("c.png")).text("pdrender/samplesPerPixel"),
                 QString::number(facts["samplesPerPixel"].toInt()));
    }

    void aDicomFolderBecomesAPicture() {
        const Run example = run({"example", at("phantom")});
        QVERIFY2(example.code == 0, example.err.constData());
        const Run result = run({"render", at("phantom"), "-o", at("p.png"), "--size", "64x64", "--samples", "8"});
        QVERIFY2(result.code == 0, result.err.constData());
        QVERIFY(qGreen(QImage(at("p.png")).pixel(32, 32)) > 10);
        QCOMPARE(run({"render", at("phantom"), "-o", at("p.png"), "--series", "1.2.3"}).code, 1);
    }

    void nothingIsLeftBehind() {
        QVERIFY(QDir(folder_.path()).entryList({"*.part"}, QDir::Files | QDir::Hidden).isEmpty());
    }
};

QTEST_GUILESS_MAIN(CliTest)
#include "cli_test.moc"
