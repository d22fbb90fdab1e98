#include <QImage>
#include <QTest>

#include "render/volume/file/label_nrrd.h"
#include "tests/support/scenes/ball_scene.h"

using namespace pdr;
using test::BallScene;
using test::ProgramRun;

/// `pdrender-cli render --part` gives parts of the patient a look of their own, or says why it cannot.
class PartLooksTest : public QObject {
    Q_OBJECT

    BallScene ball_;
    QString labels_;

    ProgramRun render(const QString& image, const QStringList& options) const {
        return BallScene::run(
            QStringList{"render", ball_.scene(), "-o", ball_.at(image), "--samples", "16", "--annotations", "none"} +
            options);
    }

  private slots:
    /// The part "upper" is the half of the ball that is nearer to the head.
    void initTestCase() {
        LabelMap map;
        map.geometry = VolumeGeometry::aligned({32, 32, 32}, dvec3(1), dvec3(0.5));
        map.labels.assign(map.geometry.voxelCount(), 0);
        std::fill(map.labels.begin() + map.labels.size() / 2, map.labels.end(), std::uint8_t(1));
        map.parts = {{"upper", {200, 40, 40}}};
        labels_ = ball_.at("halves.seg.nrrd");
        QVERIFY(bool(writeLabelFile(map, labels_.toStdString())));
    }

    void aPartHasALookOfItsOwn() {
        QCOMPARE(render("none.png", {}).code, 0);
        const ProgramRun made = render("part.png", {"--labels", labels_, "--part", "upper=Muscles"});
        QVERIFY2(made.code == 0, made.err.constData());
        const QImage none(ball_.at("none.png")), part(ball_.at("part.png"));
        const auto apart = [&](int top) {
            int most = 0;
            for (int y = top; y < top + 4; ++y)
                most = std::max(most, std::abs(qBlue(none.pixel(24, y)) - qBlue(part.pixel(24, y))));
            return most;
        };
        QVERIFY2(apart(15) > 12, qPrintable(QString::number(apart(15))));
        QVERIFY2(apart(28) < 8, qPrintable(QString::number(apart(28))));
    }

    void sumsAlongRaysShowIt() {
        const QStringList sum{"--model", "absorption"};
        QCOMPARE(render("sum.png", sum).code, 0);
        const ProgramRun made =
            render("sum-part.png", sum + QStringList{"--labels", labels_, "--part", "upper=Muscles"});
        QVERIFY2(made.code == 0, made.err.constData());
        QVERIFY(QImage(ball_.at("sum.png")) != QImage(ball_.at("sum-part.png")));
    }

    QByteArray sceneWith(const QByteArray& parts) const {
        QByteArray text = BallScene::contents(ball_.scene());
        return text.replace("\"lights\"", "\"parts\": " + parts + ", \"lights\"");
    }

    /// A scene file names the labels, from its own folder, and the materials: the image is that of --part.
    void aSceneFileHasParts() {
        const QByteArray curve = R"({ "extinctionPerMm": 0.5, "nodes": [ { "hu": 0, "opacity": 0 },
            { "hu": 500, "opacity": 1, "albedo": [0.9, 0.1, 0.1] } ] })";
        BallScene::write(ball_.at("parts.json"), sceneWith(R"({ "labels": "halves.seg.nrrd", "materials": [
            { "label": 1, "transferFunction": )" + curve + ", \"gradientFactor\": 2 } ] }"));
        BallScene::write(ball_.at("red.json"), R"({ "format": "pdrender-look", "version": 1, "name": "Red",
            "transferFunction": )" + curve + R"(, "surface": { "gradientFactor": 2 }, "lights": {} })");
        const auto image = [&](const QString& name, const QStringList& arguments) {
            const ProgramRun made = BallScene::run(
                QStringList{"render", "-o", ball_.at(name), "--samples", "8", "--annotations", "none"} + arguments);
            return made.code == 0 ? QImage(ball_.at(name)) : QImage();
        };
        const QImage file = image("file.png", {ball_.at("parts.json")});
        const QImage option =
            image("option.png", {ball_.scene(), "--labels", labels_, "--part", "upper=" + ball_.at("red.json")});
        QVERIFY(!file.isNull() && file == option);
        QVERIFY(file != image("plain.png", {ball_.scene()}));
    }

    void aSceneFileLacksItsLabels() {
        const QByteArray curve =
            R"("transferFunction": { "extinctionPerMm": 1, "nodes": [ { "hu": 0, "opacity": 0 } ] })";
        const auto explained = [&](const QByteArray& parts, const char* what) {
            BallScene::write(ball_.at("lacking.json"), sceneWith(parts));
            const ProgramRun run =
                BallScene::run({"render", ball_.at("lacking.json"), "-o", ball_.at("a.png"), "--samples", "1"});
            QCOMPARE(run.code, 1);
            QVERIFY2(run.err.contains(what), run.err.constData());
        };
        explained(R"({ "labels": "nowhere.nrrd" })", "nowhere.nrrd");
        explained(R"({ "labels": "halves.seg.nrrd", "materials": [ { "label": 2, )" + curve + " } ] }",
                  "there is no part 2 among the 1 of the label map");
        explained(R"({ "labels": "halves.seg.nrrd", "materials": [ { "label": 300, )" + curve + " } ] }",
                  "parts.materials[0].label");
        explained(R"({ "labels": "halves.seg.nrrd", "find": "vessels" })", "either a label map");
        explained("{ }", "either a label map");
        QVERIFY(!QFile::exists(ball_.at("a.png")));
    }

    /// The brightness is that of the parts as they are shown.
    void exposureKnowsParts() {
        BallScene::write(ball_.at("glowing.json"),
                         sceneWith(R"({ "labels": "halves.seg.nrrd", "materials": [ { "label": 1,
            "transferFunction": { "extinctionPerMm": 0.5, "nodes": [ { "hu": 0, "opacity": 0 },
            { "hu": 500, "opacity": 1, "emission": 3 } ] } } ] })"));
        const auto brightness = [&](const QString& scene) {
            const ProgramRun run = BallScene::run({"render", scene, "-o", ball_.at("e.png"), "--samples", "64",
                                                   "--exposure", "auto", "--annotations", "none"});
            const QImage image(ball_.at("e.png"));
            return run.code == 0 ? qGreen(image.pixel(24, 28)) : -1;
        };
        const int plain = brightness(ball_.scene()), glowing = brightness(ball_.at("glowing.json"));
        QVERIFY2(plain > 30 && glowing < plain / 2, qPrintable(QString("%1 %2").arg(plain).arg(glowing)));
    }

    /// A look that shows parts does so here as in the window: the same image as of --part, and --part goes first.
    void aLookShowsParts() {
        const auto curve = [](const char* albedo) {
            return QByteArray(R"({ "extinctionPerMm": 0.5, "nodes": [ { "hu": 0, "opacity": 0 },
                { "hu": 500, "opacity": 1, "albedo": )") +
                   albedo + " } ] }";
        };
        const auto look = [&](const char* name, const QByteArray& fields) {
            BallScene::write(ball_.at(name),
                             R"({ "format": "pdrender-look", "version": 1, "name": "A look", "lights": {},
                )" + fields + " }");
            return ball_.at(name);
        };
        const QByteArray plain = "\"transferFunction\": " + curve("[0.9, 0.8, 0.7]");
        const QByteArray red = "\"transferFunction\": " + curve("[0.9, 0.1, 0.1]");
        const QString common = look("common.json", plain), reddened = look("red.json", red);
        const QString styled =
            look("styled.json", plain + R"(, "parts": { "styles": [ { "part": "upper", )" + red + " } ] }");
        QByteArray said;
        const auto image = [&](const QString& name, const QStringList& options) {
            const ProgramRun made = render(name, options);
            said = made.err;
            return made.code == 0 ? QImage(ball_.at(name)) : QImage();
        };
        const QImage byLook = image("look.png", {"--look", styled, "--labels", labels_});
        const QImage byPart =
            image("by_part.png", {"--look", common, "--labels", labels_, "--part", "upper=" + reddened});
        QVERIFY(!byLook.isNull() && byLook == byPart);
        const QImage without = image("without.png", {"--look", styled});
        QVERIFY2(said.contains("The look shows parts of the scan"), said.constData());
        QVERIFY(without != byLook && without == image("common.png", {"--look", common}));
        QVERIFY(without == image("first.png", {"--look", styled, "--labels", labels_, "--part", "upper=" + common}));
        QVERIFY(without == image("alike.png", {"--look", common, "--labels", labels_}));
        QVERIFY2(said.contains("look as all tissue does"), said.constData());
    }

    /// The file says it, too.
    void whatIsHiddenIsSaid() {
        BallScene::write(
            ball_.at("hiding.json"),
            R"({ "format": "pdrender-look", "version": 1, "name": "A look", "lights": {}, "transferFunction":
            { "extinctionPerMm": 0.5, "nodes": [ { "hu": 0, "opacity": 0 }, { "hu": 500, "opacity": 1 } ] },
            "parts": { "rest": "hidden", "styles": [ { "part": "upper", "state": "ghost" } ] } })");
        const QByteArray expected = "Hidden: rest of the body. Ghost: upper.";
        const ProgramRun made = render("hiding.png", {"--look", ball_.at("hiding.json"), "--labels", labels_});
        QVERIFY2(made.code == 0 && made.err.contains("note: " + expected), made.err.constData());
        QCOMPARE(QImage(ball_.at("hiding.png")).text("pdrender/notShown").toUtf8(), expected);
    }

    void whatCannotBeIsExplained() {
        const ProgramRun unknown = render("a.png", {"--labels", labels_, "--part", "lower=Muscles"});
        QCOMPARE(unknown.code, 1);
        QVERIFY2(unknown.err.contains("no part has the name \"lower\"") && unknown.err.contains("There are: upper."),
                 unknown.err.constData());
        const ProgramRun sums =
            render("a.png", {"--labels", labels_, "--part", "upper=Muscles", "--model", "emissionAbsorption"});
        QCOMPARE(sums.code, 1);
        QVERIFY2(sums.err.contains("knows no materials of parts"), sums.err.constData());
        const ProgramRun sourceless = render("a.png", {"--part", "upper=Muscles"});
        QCOMPARE(sourceless.code, 2);
        QVERIFY2(sourceless.err.contains("needs to know where the parts come from"), sourceless.err.constData());
        QCOMPARE(render("a.png", {"--labels", labels_, "--part", "upper=Nothing"}).code, 2);
        QVERIFY(!QFile::exists(ball_.at("a.png")));
    }
};

QTEST_GUILESS_MAIN(PartLooksTest)
#include "part_looks_test.moc"
