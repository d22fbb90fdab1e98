#include <QtTest>

#include <unistd.h>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include "render/base/version.h"
#include "tests/support/scenes/ball_scene.h"
#include "tests/support/test_tool.h"

using pdr::test::BallScene;
using pdr::test::ProgramRun;

/// What the command line is told, and what it tells.
class CliTest : public QObject {
    Q_OBJECT

    BallScene ball_;

    QString at(const QString& name) const { return ball_.at(name); }
    QString scene() const { return ball_.scene(); }

  private slots:
    void versionAndHelpGoToStandardOutput() {
        QCOMPARE(BallScene::run({"--version"}).out, QByteArray("PD-Render " PDR_VERSION "\n"));
        QVERIFY(BallScene::run({"--help"}).out.contains("pdrender-cli render"));
        const ProgramRun help = BallScene::run({"render", "--help"});
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
        row("tone curve", {"render", "a", "-o", "a.png", "--tone-curve", "film"}, "--tone-curve");
        row("exposure", {"render", "a", "-o", "a.png", "--exposure", "0"}, "--exposure");
        row("threads", {"render", "a", "-o", "a.png", "--threads", "0"}, "--threads");
        row("device", {"render", "a", "-o", "a.png", "--device", "abacus"}, "--device");
        row("view", {"render", "a", "-o", "a.png", "--view", "above"}, "--view");
        row("accuracy without a folder", {"accuracy", "a"}, "-o");
        row("accuracy of no time", {"accuracy", "a", "-o", "b", "--time-limit", "0"}, "time-limit");
        row("effects without input", {"effects"}, "needs one folder");
        row("effects of two", {"effects", "a", "b"}, "needs one folder");
        row("effects do not stop", {"effects", "a", "--samples", "3"}, "samples");
        row("look", {"render", "a", "-o", "a.png", "--look", "MR brain"}, "Heart and great vessels");
    }

    void wrongUsageIsTwo() {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, named);
        const ProgramRun result = BallScene::run(arguments);
        QCOMPARE(result.code, 2);
        QVERIFY(result.out.isEmpty());
        QVERIFY2(result.err.contains(named), result.err.constData());
    }

    void aDeviceThatIsNotThereIsSaidAtOnce() {
        const ProgramRun result = BallScene::run({"render", scene(), "-o", at("device.png"), "--device", "cuda:77"});
        QCOMPARE(result.code, 1);
        QVERIFY2(result.err.contains("cuda:77"), result.err.constData());
        QVERIFY(!QFile::exists(at("device.png")));
        for (const char* name : {"cpu", "auto"})
            QCOMPARE(
                BallScene::run({"render", scene(), "-o", at("device.png"), "--samples", "1", "--device", name}).code,
                0);
    }

    void aBadInputIsNamedAndNothingIsWritten() {
        for (const QString& input : {at("none"), at("ball.raw"), at("empty")}) {
            QDir(ball_.path()).mkdir("empty");
            const ProgramRun result = BallScene::run({"render", input, "-o", at("bad.png")});
            QCOMPARE(result.code, 1);
            QVERIFY2(result.err.contains(input.toUtf8()), result.err.constData());
            QVERIFY(!QFile::exists(at("bad.png")));
        }
    }

    void aBadFieldIsNamed() {
        BallScene::write(at("wrong.json"),
                         BallScene::contents(scene()).replace("\"irradiance\": 3", "\"irradiance\": -3"));
        const ProgramRun result = BallScene::run({"render", at("wrong.json"), "-o", at("bad.png")});
        QCOMPARE(result.code, 1);
        QVERIFY2(result.err.contains("lights[0].irradiance"), result.err.constData());
    }

    void anOutputThatCannotBeWrittenIsToldBeforeRendering() {
        const ProgramRun noFolder = BallScene::run({"render", scene(), "-o", at("none/a.png"), "--samples", "1000000"});
        QCOMPARE(noFolder.code, 1);
        QVERIFY2(noFolder.err.contains("none/a.png"), noFolder.err.constData());
        QDir(ball_.path()).mkdir("locked");
        QFile::setPermissions(at("locked"), QFile::ReadOwner | QFile::ExeOwner);
        if (::geteuid() == 0)
            QSKIP("root may write everywhere, so a folder without permission cannot be tried");
        QCOMPARE(BallScene::run({"render", scene(), "-o", at("locked/a.png"), "--samples", "1000000"}).code, 1);
    }

    void imagesAreWrittenAndJsonTellsHow() {
        const ProgramRun result =
            BallScene::run({"render", scene(), "-o", at("a.png"), "-o", at("a.exr"), "--samples", "32", "--json"});
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
        const ProgramRun result =
            BallScene::run({"render", scene(), "-o", at("b.png"), "--samples", "64", "--size", "30x20", "--look",
                            "bone", "--view", "left", "--seed", "9", "--json"});
        QVERIFY2(result.code == 0, result.err.constData());
        QCOMPARE(QImage(at("b.png")).size(), QSize(30, 20));
        QCOMPARE(QImage(at("b.png")).text("pdrender/seed"), QString("9"));
        QVERIFY(qGreen(QImage(at("b.png")).pixel(15, 10)) > 20);
    }

    void effectsAreListedWithReasonAndCost() {
        const ProgramRun plain = BallScene::run({"effects", scene()});
        QCOMPARE(plain.code, 0);
        QVERIFY(plain.out.contains("the gradient factor is 0"));
        QVERIFY(plain.out.contains("no light is a rectangle or a sphere"));
        QVERIFY(plain.out.contains("multipleScattering"));
        for (const char* column : {"share", "mean change", "95 % below", "time without"})
            QVERIFY2(plain.out.contains(column), column);
        QVERIFY(!QRegularExpression(" -[0-9]").match(plain.out).hasMatch());  // no cost is negative
        const ProgramRun lit = BallScene::run({"effects", scene(), "--look", "Bone", "--json"});
        QCOMPARE(lit.code, 0);
        const QJsonObject effectCosts = QJsonDocument::fromJson(lit.out).object();
        QCOMPARE(effectCosts["models"].toArray().size(), 6);
        QVERIFY(effectCosts["seconds"].toDouble() > 0 && effectCosts["width"].toInt() > 0);
        QCOMPARE(effectCosts["model"].toString(), QString("singleScattering"));
        QStringList tried;
        for (const QJsonValue& effect : effectCosts["effects"].toArray())
            if (const QJsonObject band = effect["milliseconds"].toObject(); !band.isEmpty()) {
                tried << effect["name"].toString();
                const QString verdict = effect["verdict"].toString();
                QCOMPARE(verdict, QString(tried.last() == "one more event" ? "left out" : "needed"));
                QVERIFY(band["low"].toDouble() <= band["median"].toDouble() &&
                        band["median"].toDouble() <= band["high"].toDouble());
                QVERIFY(effect["share"].toObject()["high"].toDouble() < 1);
                QVERIFY(effect["meanLevels"].toObject()["value"].toDouble() > 0);  // that the image changes by
                for (const char* figure : {"meanLevels", "levels95", "timeWithout"}) {
                    const QJsonObject told = effect[figure].toObject();
                    QVERIFY2(told["low"].toDouble() <= told["value"].toDouble() &&
                                 told["value"].toDouble() <= told["high"].toDouble() && told["high"].toDouble() > 0,
                             figure);
                }
            }
        QVERIFY(tried.contains("shadows") && tried.contains("lights with a place") && tried.contains("one more event"));
    }

    void whatAccuracyCostsIsMeasuredAndToldOnOnePage() {
        const QString folder = at("report/of it");
        const ProgramRun run =
            BallScene::run({"accuracy", scene(), "-o", folder, "--time-limit", "1", "--size", "96x80"});
        QVERIFY2(run.code == 0, run.err.constData());
        QVERIFY(run.out.contains("as it is, denoised: "));
        const QJsonObject report = QJsonDocument::fromJson(BallScene::contents(folder + "/accuracy.json")).object();
        const QJsonArray ways = report["ways"].toArray();
        QCOMPARE(ways.size(), 6);
        QCOMPARE(report["others"].toArray().size(), 6);
        QVERIFY(ways[2].toObject()["measuredBias"].toObject().contains("levels"));
        QVERIFY(report["reference"].toObject()["samples"].toInt() >= 2 && report["complete"].toBool());
        double last = 0;
        for (const QJsonValue& step : ways[0].toObject()["steps"].toArray()) {
            QVERIFY(step["seconds"].toDouble() > last && step["levels"].toDouble() >= 0);
            last = step["seconds"].toDouble();
            if (const QString picture = step["picture"].toString(); !picture.isEmpty())
                QCOMPARE(QImage(folder + "/" + picture).size(), QSize(96, 80));
        }
        const QByteArray page = BallScene::contents(folder + "/accuracy.html");
        QVERIFY(BallScene::contents(folder + "/accuracy.svg").startsWith("<svg xmlns="));
        QVERIFY(page.contains("<svg") && page.contains("data:image/png;base64,") && !page.contains("src='http"));
        QVERIFY(BallScene::contents(folder + "/accuracy.csv").startsWith("picture,way,samples,seconds"));
        const ProgramRun nowhere = BallScene::run({"accuracy", scene(), "-o", scene() + "/report"});
        QVERIFY(nowhere.code == 1 && nowhere.err.contains("report"));
    }

    /// A decimal comma would part a number of a table in two.
    void tablesAreTheSameInAnyLanguage() {
        PDR_NEEDS_TOOL("localedef", "libc-bin");
        if (!QFile::exists("/usr/share/i18n/locales/de_DE"))
            PDR_SKIP_FOR_WANT_OF_DATA("no languages are here: ./bootstrap test installs the package locales");
        const QString locales = at("locales");
        QVERIFY(QDir().mkpath(locales));
        QProcess::execute("localedef", {"-i", "de_DE", "-f", "UTF-8", locales + "/de_DE.UTF-8"});
        QVERIFY(QFile::exists(locales + "/de_DE.UTF-8/LC_NUMERIC"));
        const QString folder = at("comma");
        const ProgramRun run = pdr::test::runProgram(
            "pdrender-cli", {"accuracy", scene(), "-o", folder, "--time-limit", "0.5", "--size", "16x16"},
            [&](QProcess& process) {
                QProcessEnvironment german = QProcessEnvironment::systemEnvironment();
                german.insert("LOCPATH", locales);
                german.insert("LC_ALL", "de_DE.UTF-8");
                process.setProcessEnvironment(german);
            });
        QVERIFY2(run.code == 0, run.err.constData());
        QString table = BallScene::contents(folder + "/accuracy.csv");
        const QStringList lines = table.remove(QRegularExpression("\"[^\"]*\"")).trimmed().split('\n');
        QVERIFY(lines.size() > 6);
        for (const QString& line : lines)
            QVERIFY2(line.count(',') == lines[0].count(','), qPrintable(line));
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
        BallScene::write(at("dense.json"), QJsonDocument(document).toJson());
        const QStringList render{"render",        at("dense.json"), "-o",    at("dense.png"), "-o",
                                 at("dense.exr"), "--size",         "16x16", "--samples",     "2"};
        const ProgramRun told = BallScene::run(render);
        QVERIFY2(told.code == 0 && told.out.contains("free paths between voxels"), told.err + told.out);
        const QJsonObject facts = QJsonDocument::fromJson(BallScene::run(render + QStringList{"--json"}).out).object();
        QCOMPARE(facts["warnings"].toArray(), QJsonArray{"overDense"});
        QCOMPARE(QImage(at("dense.png")).text("pdrender/warnings"), QString("overDense"));
        QVERIFY(BallScene::contents(at("dense.exr")).contains("overDense"));
        const ProgramRun single = BallScene::run(render + QStringList{"--model", "singleScattering", "--json"});
        QVERIFY(QJsonDocument::fromJson(single.out).object()["warnings"].toArray().isEmpty());
        QVERIFY(QImage(at("dense.png")).text("pdrender/warnings").isEmpty());
    }

    void aSampleIsToldEventByEvent() {
        const ProgramRun told = BallScene::run({"replay", scene(), "--look", "Bone", "--model", "multipleScattering",
                                                "--size", "40x40", "--pixel", "20,20", "--sample", "3"});
        QVERIFY2(told.code == 0, told.err.constData());
        QVERIFY(told.out.contains("pixel 20,20 sample 3 seed"));
        QVERIFY(told.out.contains("event after") && told.out.contains("HU, extinction") &&
                told.out.contains("radiance ("));
        QCOMPARE(BallScene::run({"replay", scene(), "--pixel", "5000,0"}).code, 1);
        QCOMPARE(BallScene::run({"replay", scene(), "--pixel", "five"}).code, 2);
        QCOMPARE(BallScene::run({"replay", scene()}).code, 2);
        QCOMPARE(BallScene::run({"replay", scene(), "--pixel", "1,1", "--model", "maximumIntensity"}).code, 1);
    }

    void nothingIsLeftBehind() {
        QVERIFY(QDir(ball_.path()).entryList({"*.part"}, QDir::Files | QDir::Hidden).isEmpty());
    }
};

QTEST_GUILESS_MAIN(CliTest)
#include "cli_test.moc"
