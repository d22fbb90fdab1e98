#include <QTest>

#include <QDirIterator>
#include <QFile>

#include "render/scene/field_check.h"
#include "render/scene/field_table.h"
#include "render/scene/fields/light_fields.h"
#include "render/scene/fields/named_look_fields.h"
#include "render/scene/fields/parts_fields.h"
#include "render/scene/fields/scene_fields.h"
#include "render/scene/fields/volume_fields.h"
#include "tests/support/places.h"
#include "tests/support/random_fields.h"

using namespace pdr;

namespace {

/// Returns a random scene that passes its checks.
SceneFile anySceneFile(unsigned seed) {
    for (test::RandomFields random(seed);;) {
        SceneFile file;
        Scene& scene = file.scene;
        describe(random, scene);
        std::ranges::sort(scene.transferFunction.nodes, {}, &TransferNode::hu);
        if (scene.window.lowHu > scene.window.highHu)
            std::swap(scene.window.lowHu, scene.window.highHu);
        if (scene.clip.box && scene.clip.box->lowMm.x > scene.clip.box->highMm.x)
            std::swap(scene.clip.box->lowMm, scene.clip.box->highMm);
        std::vector<LightFields> lights;
        random.list({"lights", ""}, lights);
        for (LightFields& light : lights) {
            if (const auto* around = std::get_if<EnvironmentFields>(&light)) {
                scene.environment = around->environment;
                file.environmentImage = around->image.value_or("");
            } else {
                std::visit(
                    [&](const auto& one) {
                        if constexpr (std::is_constructible_v<Light, decltype(one)>)
                            scene.lights.push_back(one);
                    },
                    light);
            }
        }
        file.source.dicomFolder = "ct of \"somebody\"";
        if (seed % 2 == 0) {
            file.source = {};
            VolumeFields volume;
            do
                describe(random, volume);
            while (volume.dicom);
            file.source.raw = volume.file;
            file.source.raw.path = "voxels.raw";
        }
        if (seed % 3 == 0) {
            std::vector<PartMaterialFields> materials;
            random.list({"materials", ""}, materials);
            for (PartMaterialFields& one : materials) {
                std::ranges::sort(one.transferFunction.nodes, {}, &TransferNode::hu);
                const int label = int(scene.parts.curves.size()) * 60 + 15;
                scene.parts.curves.push_back({std::uint8_t(label), one.transferFunction, one.gradientFactor});
            }
            file.parts.resampling = seed % 2 ? Resampling::nearest : Resampling::refused;
            if (seed % 4 < 2)
                file.parts.labels = "somebody's labels.nrrd";
            else
                file.parts.rules = seed % 5 ? segment::PartRules{segment::PartRule::vessels}
                                            : segment::PartRules{segment::PartRule::vessels, segment::PartRule::shells};
        }
        if (scene.check() && FieldCheck::check(scene))
            return file;
    }
}

/// Returns whether a scene file is equal after writing and reading, apart from what files do not hold.
bool comesBack(const SceneFile& file, std::string& why) {
    const Result<SceneFile> read = sceneFromText(sceneText(file), "a test", "");
    if (!read) {
        why = read.error().text();
        return false;
    }
    why = sceneText(file) + sceneText(*read);
    return read->scene == file.scene && read->source == file.source && read->parts == file.parts &&
           read->environmentImage == file.environmentImage;
}

std::string tableOf(const std::string& name) {
    Scene scene;
    NamedLook look;
    const auto is = [&](const char* other) { return name == other; };
    return is("scene")         ? FieldTable::of(scene)
           : is("volume")      ? FieldTable::of<VolumeFields>()
           : is("parts")       ? FieldTable::of<PartsFields>()
           : is("material")    ? FieldTable::of<PartMaterialFields>()
           : is("transfer")    ? FieldTable::of<TransferFunction>()
           : is("node")        ? FieldTable::of<TransferNode>()
           : is("window")      ? FieldTable::of<HuWindow>()
           : is("phase")       ? FieldTable::of(PhaseField{scene.phaseG})
           : is("surface")     ? FieldTable::of(SurfaceField{scene.gradientFactor, scene.rayOrigin})
           : is("directional") ? FieldTable::of<DirectionalLight>()
           : is("rectangle")   ? FieldTable::of<RectangleLight>()
           : is("sphere")      ? FieldTable::of<SphereLight>()
           : is("environment") ? FieldTable::of<EnvironmentFields>()
           : is("visible")     ? FieldTable::of<Visible>()
           : is("clip")        ? FieldTable::of<Clip>()
           : is("box")         ? FieldTable::of<ClipBox>()
           : is("plane")       ? FieldTable::of<ClipPlane>()
           : is("freehand")    ? FieldTable::of<FreehandCut>()
           : is("corner")      ? FieldTable::of<ImagePoint>()
           : is("camera")      ? FieldTable::of<Camera>()
           : is("schedule")    ? FieldTable::of<Schedule>()
           : is("film")        ? FieldTable::of(FilmField{scene.film})
           : is("look")        ? FieldTable::of(look)
           : is("suits")       ? FieldTable::of<Suits>()
           : is("cut")         ? FieldTable::of<CutHint>()
           : is("panel")       ? FieldTable::of<RigPanel>()
           : is("styles")      ? FieldTable::of<PartStyles>()
           : is("style")       ? FieldTable::of<PartStyle>()
           : is("rig")         ? FieldTable::of(RigFields{look.look.rig, look.look.environment})
                               : "there is no table of this name\n";
}

}  // namespace

/// Scenes, looks and sessions are written from the description that they are read by.
class SceneTextTest : public QObject {
    Q_OBJECT

  private slots:
    void testScenesComeBack() {
        int files = 0;
        for (QDirIterator each(QStringLiteral(PDR_SOURCE_DIR "/tests/scenes"), {"*.json"}, QDir::Files); each.hasNext();
             ++files) {
            const Result<SceneFile> file = readSceneFile(each.next().toStdString());
            QVERIFY2(file, file ? "" : file.error().text().c_str());
            std::string why;
            QVERIFY2(comesBack(*file, why), why.c_str());
        }
        QVERIFY(files >= 2);
    }

    void anySceneComesBack() {
        int images = 0, boxes = 0, lines = 0, orthographic = 0, raw = 0, parts = 0;
        for (unsigned seed = 1; seed <= 1000; ++seed) {
            const SceneFile file = anySceneFile(seed);
            std::string why;
            QVERIFY2(comesBack(file, why), (std::to_string(seed) + ": " + why).c_str());
            images += !file.environmentImage.empty();
            boxes += file.scene.clip.box.has_value();
            lines += !file.scene.clip.freehand.empty();
            orthographic += file.scene.camera.type == Camera::Type::orthographic;
            raw += !file.source.raw.path.empty();
            parts += !file.scene.parts.curves.empty();
        }
        QVERIFY(images > 20 && boxes > 100 && lines > 50 && orthographic > 300 && raw == 500);
        QVERIFY(parts > 100);
    }

    void numbersOfSinglePrecisionAreWrittenShort() {
        SceneFile file = anySceneFile(7);
        file.scene.phaseG = 0.3f;
        QVERIFY(sceneText(file).find("\"g\": 0.3\n") != std::string::npos);
    }

    void looksComeBack() {
        int looks = 0;
        for (QDirIterator each(QStringLiteral(PDR_SOURCE_DIR "/resources/looks"), {"*.json"}, QDir::Files);
             each.hasNext(); ++looks) {
            QFile file(each.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            const Result<NamedLook> look = lookFromJson(file.readAll().toStdString(), "a test");
            QVERIFY2(look, look ? "" : look.error().text().c_str());
            const Result<NamedLook> again = lookFromJson(lookText(*look), "a test");
            QVERIFY2(again && *again == *look, lookText(*look).c_str());
        }
        QVERIFY(looks >= 12);
    }

    void anyLookComesBack() {
        test::RandomFields random(2);
        for (int i = 0; i < 300;) {
            NamedLook look;
            describe(random, look);
            std::ranges::sort(look.look.transferFunction.nodes, {}, &TransferNode::hu);
            if (look.look.window.lowHu > look.look.window.highHu)
                std::swap(look.look.window.lowHu, look.look.window.highHu);
            if (!check(look.look))
                continue;
            ++i;
            const Result<NamedLook> again = lookFromJson(lookText(look), "a test");
            QVERIFY2(again, again ? "" : again.error().text().c_str());
            QVERIFY2(*again == look, lookText(look).c_str());
        }
    }

    /// With PDR_WRITE_MANUAL=1 the manual's tables are written anew instead.
    void theManualsTablesAreThoseOfTheFields_data() {
        QTest::addColumn<int>("tables");
        QTest::newRow("scene-file.md") << 3;
        QTest::newRow("scene-file-tissue.md") << 8;
        QTest::newRow("scene-file-view.md") << 9;
        QTest::newRow("look-file.md") << 7;
        QTest::newRow("scene-file-parts.md") << 2;
    }
    void theManualsTablesAreThoseOfTheFields() {
        QFETCH(int, tables);
        QFile manual(QStringLiteral(PDR_SOURCE_DIR "/resources/manual/") + QTest::currentDataTag());
        QVERIFY(manual.open(QIODevice::ReadOnly));
        const std::string text = manual.readAll().toStdString(), opening = "<!-- fields: ", closing = "<!-- end -->\n";
        manual.close();
        std::string wanted;
        std::size_t at = 0;
        int seen = 0;
        for (std::size_t next; (next = text.find(opening, at)) != std::string::npos; ++seen) {
            const std::size_t name = next + opening.size(), line = text.find('\n', name) + 1;
            const std::size_t end = text.find(closing, line);
            QVERIFY(end != std::string::npos);
            wanted += text.substr(at, line - at) + tableOf(text.substr(name, text.find(' ', name) - name)) + closing;
            at = end + closing.size();
        }
        wanted += text.substr(at);
        QCOMPARE(seen, tables);
        if (qEnvironmentVariableIsSet("PDR_WRITE_MANUAL")) {
            QVERIFY(manual.open(QIODevice::WriteOnly));
            manual.write(QByteArray::fromStdString(wanted));
            QSKIP("the manual was written");
        }
        QVERIFY2(wanted == text, "PDR_WRITE_MANUAL=1 scene_text_test writes the manual's tables anew");
    }
};

QTEST_GUILESS_MAIN(SceneTextTest)
#include "scene_text_test.moc"
