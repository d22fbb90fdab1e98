#include <QtTest>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include "render/scene/scene_file.h"
#include "tests/support/places.h"

using namespace pdr;

/// A scene that uses every field.
static const char* kFull = R"({
  "format": "pdrender-scene", "version": 1,
  "volume": { "raw": "volume.raw", "size": [4, 3, 2], "spacingMm": [1, 2, 3], "originMm": [7, 8, 9], "type": "uint8",
              "clampHu": [10, 20], "table": "hidden", "reconstruction": "cubic" },
  "transferFunction": { "extinctionPerMm": 2.5, "nodes": [
    { "hu": 0, "opacity": 0 },
    { "hu": 100, "opacity": 0.5, "albedo": [0.1, 0.2, 0.3], "emission": 4, "specular": 0.25, "roughness": 0.75 } ] },
  "model": "singleScattering",
  "estimator": "kroesMarch",
  "filtering": "fast",
  "window": { "lowHu": -50, "highHu": 350 },
  "visible": { "shown": ["lungs", "bones"], "hidden": ["liver"], "peelMm": 5 },
  "toleranceLevels": 0.5,
  "phase": { "g": 0.3 },
  "surface": { "gradientFactor": 6 },
  "lights": [
    { "type": "directional", "direction": [1, 2, -1.5], "irradiance": 3 },
    { "type": "environment", "radiance": [0.1, 0.2, 0.3], "nadir": 7, "visible": false },
    { "type": "rectangle", "centreMm": [1, 2, 3], "normal": [0, 0, 1], "up": [0, 1, 0], "widthMm": 4, "heightMm": 5,
      "radiance": 6 },
    { "type": "sphere", "centreMm": [1, 2, 3], "radiusMm": 4, "radiance": 5, "visible": true } ],
  "clip": { "box": { "lowMm": [0, 0, 0], "highMm": [1, 2, 3] }, "planes": [ { "pointMm": [4, 5, 6], "normal": [0, 1, 0] } ],
            "shadows": true },
  "camera": { "type": "orthographic", "eyeMm": [0, -10, 0], "targetMm": [0, 1, 2], "up": [1, 0, 0], "heightMm": 33,
              "apertureMm": 2, "focusMm": 12 },
  "film": { "width": 640, "height": 480 },
  "maxBounces": 1,
  "seed": 18446744073709551615
})";

/// Returns `document` with the value at `path` (names and list indices, separated by '.') replaced, or removed if
/// undefined.
static QJsonValue edited(QJsonValue value, QStringList path, const QJsonValue& by) {
    if (path.isEmpty())
        return by;
    const QString step = path.takeFirst();
    if (value.isArray()) {
        QJsonArray array = value.toArray();
        array[step.toInt()] = edited(array[step.toInt()], path, by);
        return array;
    }
    QJsonObject object = value.toObject();
    const QJsonValue inner = edited(object[step], path, by);
    if (inner.isUndefined())
        object.remove(step);
    else
        object[step] = inner;
    return object;
}

class SceneFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    Result<SceneFile> read(const QByteArray& text) {
        QFile file(folder_.filePath("scene.json"));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("the test cannot write its file");
        file.close();
        return readSceneFile(file.fileName().toStdString());
    }

  private slots:
    void everyFieldArrives() {
        const auto file = read(kFull);
        QVERIFY2(bool(file), file ? "" : file.error().text().c_str());
        const VolumeSource& source = file->source;
        QCOMPARE(QString::fromStdString(source.raw.path.string()), folder_.filePath("volume.raw"));
        QVERIFY(source.raw.size == ivec3(4, 3, 2) && source.raw.spacingMm == dvec3(1, 2, 3));
        QVERIFY(source.raw.originMm == dvec3(7, 8, 9) && source.raw.type == RawFile::Type::uint8);
        QVERIFY(source.clampHu == std::pair(10, 20) && source.reconstruction == Reconstruction::cubic);
        QVERIFY(source.table == Table::hidden);

        const Scene& scene = file->scene;
        QCOMPARE(scene.transferFunction.extinctionPerMm, 2.5f);
        QCOMPARE(scene.transferFunction.nodes.size(), std::size_t(2));
        QVERIFY(scene.transferFunction.nodes[0] == TransferNode{});
        QVERIFY((scene.transferFunction.nodes[1] ==
                 TransferNode{100, 0.5f, {0.1f, 0.2f, 0.3f}, vec3(4), vec3(0.25f), 0.75f}));
        QVERIFY((scene.window == HuWindow{-50, 350}));
        QVERIFY((scene.visible == Visible{{"bones", "lungs"}, {"liver"}, 5}));
        QVERIFY(scene.estimator == Estimator::kroesMarch);
        QVERIFY(scene.filtering == Filtering::fast);
        QCOMPARE(scene.toleranceLevels, 0.5f);
        QCOMPARE(scene.phaseG, 0.3f);
        QCOMPARE(scene.gradientFactor, 6.0f);
        QCOMPARE(scene.lights.size(), std::size_t(3));
        QVERIFY((std::get<DirectionalLight>(scene.lights[0]) == DirectionalLight{{1, 2, -1.5}, vec3(3)}));
        QVERIFY((std::get<RectangleLight>(scene.lights[1]) ==
                 RectangleLight{{1, 2, 3}, {0, 0, 1}, {0, 1, 0}, 4, 5, vec3(6)}));
        QVERIFY((std::get<SphereLight>(scene.lights[2]) == SphereLight{{1, 2, 3}, 4, vec3(5), true}));
        QVERIFY((scene.environment == Environment{{0.1f, 0.2f, 0.3f}, false, vec3(7)}));
        QVERIFY((scene.clip == Clip{ClipBox{{0, 0, 0}, {1, 2, 3}}, {ClipPlane{{4, 5, 6}, {0, 1, 0}}}, true}));
        QVERIFY((scene.camera == Camera{Camera::Type::orthographic, {0, -10, 0}, {0, 1, 2}, {1, 0, 0}, 35, 33, 2, 12}));
        QVERIFY(scene.film == ivec2(640, 480));
        QCOMPARE(scene.seed, 18446744073709551615u);
    }

    void fieldOfViewIsInDegrees() {
        const auto file = read(R"({ "format": "pdrender-scene", "version": 1, "volume": { "dicom": "ct" },
            "transferFunction": { "extinctionPerMm": 1, "nodes": [ { "hu": 0, "opacity": 1 } ] },
            "camera": { "eyeMm": [0, -10, 0], "targetMm": [0, 0, 0], "fovDegrees": 20.5 } })");
        QVERIFY2(bool(file), file ? "" : file.error().text().c_str());
        QCOMPARE(file->scene.camera.fovDegrees, 20.5);
    }

    void whatIsLeftOutHasItsDefault() {
        const auto file = read(R"({ "format": "pdrender-scene", "version": 1, "volume": { "dicom": "ct" },
            "transferFunction": { "extinctionPerMm": 1, "nodes": [ { "hu": 0, "opacity": 1 } ] },
            "camera": { "eyeMm": [0, -10, 0], "targetMm": [0, 0, 0] } })");
        QVERIFY2(bool(file), file ? "" : file.error().text().c_str());
        QCOMPARE(QString::fromStdString(file->source.dicomFolder.string()), folder_.filePath("ct"));
        QVERIFY(file->source.raw.path.empty() && !file->source.clampHu && file->source.seriesUid.empty());
        QVERIFY(file->source.reconstruction == Reconstruction::linear);
        QVERIFY(file->source.table == Table::shown);
        QVERIFY(file->scene.film == Scene{}.film && file->scene.seed == 1 &&
                file->scene.estimator == Estimator::unbiased && file->scene.filtering == Filtering::exact &&
                file->scene.lights.empty());
    }

    void everyMistakeNamesItsField_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QJsonValue>("value");
        QTest::addColumn<QString>("where");
        const auto row = [](const char* path, QJsonValue value, const char* where) {
            QTest::addRow("%s as %s", path, QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact).constData())
                << path << value << where;
        };
        const QJsonValue removed(QJsonValue::Undefined);
        row("format", "something", "format");
        row("version", 2, "version");
        row("colour", 1, "colour");
        row("volume", removed, "volume");
        row("volume.raw", removed, "volume.dicom");
        row("volume.dicom", "ct", "volume.dicom");
        row("volume.series", "1.2", "volume.series");
        row("volume.size", QJsonArray{4, 3}, "volume.size");
        row("volume.size", QJsonArray{4, 0, 3}, "volume.size");
        row("volume.size", QJsonArray{4, 1.5, 3}, "volume.size");
        row("volume.spacingMm", QJsonArray{1, 1, -1}, "volume.spacingMm");
        row("volume.spacingMm", QJsonArray{1, 1, 1e-7}, "volume.spacingMm");
        row("volume.spacingMm", QJsonArray{1, 2e6, 1}, "volume.spacingMm");
        row("volume.spacingMm", removed, "volume.spacingMm");
        row("volume.type", "int12", "volume.type");
        row("volume.clampHu", QJsonArray{20, 10}, "volume.clampHu");
        row("volume.clampHu", QJsonArray{0, 40000}, "volume.clampHu");
        row("volume.reconstruction", "quadratic", "volume.reconstruction");
        row("volume.table", "gone", "volume.table");
        row("transferFunction", removed, "transferFunction");
        row("transferFunction.extinctionPerMm", -1, "transferFunction.extinctionPerMm");
        row("transferFunction.nodes", QJsonArray{}, "transferFunction.nodes");
        row("transferFunction.nodes.1.hu", -1, "transferFunction.nodes[1].hu");
        row("transferFunction.nodes.1.opacity", 1.5, "transferFunction.nodes[1].opacity");
        row("transferFunction.nodes.1.opacity", removed, "transferFunction.nodes[1].opacity");
        row("transferFunction.nodes.0.albedo", QJsonArray{0, 0, 2}, "transferFunction.nodes[0].albedo");
        row("transferFunction.nodes.0.roughness", "rough", "transferFunction.nodes[0].roughness");
        row("transferFunction.nodes.0.shine", 1, "transferFunction.nodes[0].shine");
        row("model", "raytracing", "model");
        row("model", "multipleScattering", "estimator");
        row("model", "emission", "estimator");
        row("estimator", "quick", "estimator");
        row("filtering", "nearest", "filtering");
        row("visible.shown", "lungs", "visible.shown");
        row("visible.shown", QJsonArray{"lungs", "lungs"}, "visible.shown");
        row("visible.hidden", QJsonArray{"bones", 1}, "visible.hidden");
        row("visible.hidden", QJsonArray{""}, "visible.hidden");
        row("filtering", true, "filtering");
        row("window.lowHu", removed, "window.lowHu");
        row("window.lowHu", 350, "window.highHu");
        row("window.highHu", 40000, "window.highHu");
        row("toleranceLevels", 0, "toleranceLevels");
        row("toleranceLevels", 17, "toleranceLevels");
        row("phase.g", 1, "phase.g");
        row("surface.gradientFactor", -1, "surface.gradientFactor");
        row("lights", 3, "lights");
        row("lights.0.type", "lamp", "lights[0].type");
        row("lights.0.direction", QJsonArray{0, 0, 0}, "lights[0].direction");
        row("lights.0.irradiance", -3, "lights[0].irradiance");
        row("lights.0.radiance", 3, "lights[0].radiance");
        row("lights.1.image", 5, "lights[1].image");
        row("lights.1.nadir", -1, "lights[1].nadir");
        row("lights.3.radiusMm", 0, "lights[3].radiusMm");
        row("lights.3.visible", "yes", "lights[3].visible");
        row("clip.box.highMm", QJsonArray{0, 0, 1}, "clip.box.highMm");
        row("clip.planes.0.normal", QJsonArray{0, 0, 0}, "clip.planes[0].normal");
        row("clip.sphere", 1, "clip.sphere");
        row("lights.1.visible", 1, "lights[1].visible");
        row("lights.2.radiance", 1e31, "lights[2].radiance");
        row("lights.2.widthMm", 0, "lights[2].widthMm");
        row("lights.2.up", QJsonArray{0, 0, 3}, "lights[2].up");
        row("lights.2", QJsonObject{{"type", "environment"}, {"radiance", 1}}, "lights[2].type");
        row("camera", removed, "camera");
        row("camera.eyeMm", QJsonArray{0, 1, 2}, "camera.targetMm");
        row("camera.up", QJsonArray{0, 0, 0}, "camera.up");
        row("camera.heightMm", 0, "camera.heightMm");
        row("camera.fovDegrees", 20, "camera.fovDegrees");
        row("camera.apertureMm", 201, "camera.apertureMm");
        row("film.width", 0, "film.width");
        row("film.height", 20000, "film.height");
        row("maxBounces", 0, "maxBounces");
        row("maxBounces", 1.5, "maxBounces");
        row("seed", -1, "seed");
    }

    void everyMistakeNamesItsField() {
        QFETCH(QString, path);
        QFETCH(QJsonValue, value);
        QFETCH(QString, where);
        const QJsonDocument full = QJsonDocument::fromJson(QByteArray(kFull).replace("18446744073709551615", "1"));
        const QJsonValue wrong = edited(full.object(), path.split('.'), value);
        const auto file = read(QJsonDocument(wrong.toObject()).toJson());
        QVERIFY(!file);
        QCOMPARE(QString::fromStdString(file.error().where), folder_.filePath("scene.json") + ", " + where);
        QVERIFY(!file.error().what.empty());
    }

    void anErrorTellsTheRange() {
        const auto file = read(QByteArray(kFull).replace("\"irradiance\": 3", "\"irradiance\": -3"));
        QCOMPARE(QString::fromStdString(file.error().what), QString("holds -3, each number must be from 0 to 1e+30"));
    }

    void theLowestSpacingIsTold() {
        const auto file = read(QByteArray(kFull).replace("[1, 2, 3], \"originMm\"", "[1e-300, 2, 3], \"originMm\""));
        QVERIFY(!file);
        QCOMPARE(QString::fromStdString(file.error().what),
                 QString("holds 1e-300, each number must be from 1e-06 to 1e+06"));
        QVERIFY(bool(read(QByteArray(kFull).replace("[1, 2, 3], \"originMm\"", "[1e-6, 2, 3], \"originMm\""))));
    }

    /// The length of a direction matters, and the error text states it.
    void aDirectionThatIsTooLongIsToldItsLength() {
        const auto with = [this](const char* direction) {
            return read(QByteArray(kFull).replace("[1, 2, -1.5]", direction));
        };
        for (const char* direction : {"[1e100, 1e100, 1e100]", "[1e200, 0, 0]", "[0, 1e-101, 0]", "[1e-200, 0, 0]"}) {
            const auto file = with(direction);
            QVERIFY(!file);
            QCOMPARE(QString::fromStdString(file.error().what),
                     QString("is no direction: its length must be from 1e-100 to 1e+100"));
        }
        QCOMPARE(QString::fromStdString(with("[0, 0, 0]").error().what), QString("is no direction: it has no length"));
        QVERIFY(bool(with("[1e100, 0, 0]")) && bool(with("[0, 1e-100, 0]")));
    }

    /// A text is counted before it is parsed: a text that could take the parser long never reaches it.
    void textsThatWouldTakeLongAreRefusedBeforeTheyAreParsed() {
        const auto refused = [this](const QByteArray& text, const char* why) {
            const auto file = read(text);
            return !file && file.error().what.find(why) != std::string::npos;
        };
        QVERIFY(refused(QByteArray(5'000'000, '['), "deeper than 64"));
        QVERIFY(refused(QByteArray("{\"a\":").repeated(65), "deeper than 64"));
        QVERIFY(refused("[" + QByteArray("1,").repeated(1'000'001) + "1]", "more than 1000000 values"));
        QVERIFY(!refused(QByteArray(64, '[') + QByteArray(64, ']'), "deeper than"));
        QVERIFY(!refused("{\"" + QByteArray(100, '[') + "\\\"" + QByteArray(100, '{') + "\": 1}", "deeper than"));
        QVERIFY(!refused(QByteArray("[]").repeated(100), "deeper than"));
    }

    void anImageOfTheSurroundingsKnowsItsField() {
        const auto file =
            read(QByteArray(kFull).replace("\"radiance\": [0.1, 0.2, 0.3], \"nadir\": 7", "\"image\": \"sky.exr\""));
        QVERIFY2(bool(file), file ? "" : file.error().text().c_str());
        QCOMPARE(file->environmentField, std::string("lights[1].image"));
    }

    void aRawFileThatIsMissingKnowsItsField() {
        const auto file = read(kFull);
        const auto volume = fetchRawVolume(file->source);
        QVERIFY(!volume);
        QCOMPARE(QString::fromStdString(volume.error().where), folder_.filePath("volume.raw") + " (volume.raw)");
    }

    void aFieldWrittenTwiceIsRefused() {
        const auto file = read(QByteArray(kFull).replace("\"maxBounces\": 1", "\"maxBounces\": 1, \"maxBounces\": 1"));
        QVERIFY(!file);
        QVERIFY(file.error().what.find("twice") != std::string::npos);
    }

    void brokenJsonIsTold() {
        for (const char* text :
             {"", "{", "[]", "null", "{\"format\": \"pdrender-scene\"", "\xff\xfe", "{\"a\":1e999}"}) {
            const auto file = read(text);
            QVERIFY(!file);
            QVERIFY(file.error().where.find("scene.json") != std::string::npos);
        }
        QVERIFY(!read(QByteArray(200000, '[')));
    }

    void aMissingFileIsTold() {
        QVERIFY(!readSceneFile("/nowhere/scene.json"));
        QVERIFY(!readSceneFile(folder_.path().toStdString()));
    }

    void theYardstickSceneCanBeRead() {
        const auto file = readSceneFile(PDR_SOURCE_DIR "/tests/scenes/yardstick.json");
        QVERIFY2(bool(file), file ? "" : file.error().text().c_str());
        QVERIFY(file->source.clampHu == std::pair(150, 1500));
    }
};

QTEST_APPLESS_MAIN(SceneFileTest)
#include "scene_file_test.moc"
