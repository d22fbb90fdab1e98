#include <QtTest>

#include <QFile>

#include "render/scene/preset.h"
#include "tests/support/places.h"

using namespace pdr;

static const char* kNames[] = {"ct_bone", "ct_soft_tissue", "ct_angio", "ct_lung"};

static QByteArray text(const QString& name) {
    QFile file(QStringLiteral(PDR_SOURCE_DIR "/resources/presets/%1.json").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

static Preset bone() {
    return *presetFromJson(text("ct_bone").toStdString(), "ct_bone");
}

static Scene sceneWith(double sizeMm) {
    Scene scene;
    scene.volume = std::make_shared<const Volume>(
        VolumeGeometry::aligned({2, 2, 2}, dvec3(sizeMm / 2), dvec3(sizeMm / 4)), Voxels(8));
    scene.camera = standardView(StandardView::anterior, scene.volume->geometry().centreMm(),
                                scene.volume->geometry().radiusMm(), 1);
    return scene;
}

/// Irradiance of a small panel on a plane that faces it at the volume's centre, up to a constant.
static double shareAtCentre(const RectangleLight& light, dvec3 centre) {
    const dvec3 away = light.centreMm - centre;
    return light.radiance.y * light.widthMm * light.heightMm / glm::dot(away, away);
}

class PresetTest : public QObject {
    Q_OBJECT

  private slots:
    void theFourPresetsCanBeRenderedAsTheyAre() {
        for (const char* name : kNames) {
            const auto preset = presetFromJson(text(name).toStdString(), name);
            QVERIFY2(bool(preset), preset ? "" : preset.error().text().c_str());
            const auto ok = withPreset(sceneWith(200), *preset).check();
            QVERIFY2(bool(ok), ok ? "" : ok.error().text().c_str());
        }
    }

    void airIsClearInEveryPreset() {
        for (const char* name : kNames)
            QCOMPARE(presetFromJson(text(name).toStdString(), name)->look.transferFunction.at(-1000).opacity, 0.0f);
    }

    void mistakesNameTheField() {
        const auto wrong = presetFromJson(text("ct_bone").replace("\"key\":", "\"main\":").toStdString(), "ct_bone");
        QVERIFY(!wrong);
        QCOMPARE(wrong.error().where, std::string("ct_bone, lights.main"));
        const auto window = presetFromJson(text("ct_bone").replace("1800", "100").toStdString(), "ct_bone");
        QVERIFY(!window);
        QCOMPARE(window.error().where, std::string("ct_bone, window.highHu"));
        const auto dark =
            presetFromJson(text("ct_bone").replace("\"exposure\": ", "\"exposure\": -").toStdString(), "x");
        QVERIFY(!dark);
        QCOMPARE(dark.error().where, std::string("x, exposure"));
    }

    void aPresetChangesTheLookAndNothingElse() {
        Scene before = sceneWith(200);
        before.seed = 7;
        before.film = {10, 20};
        const Scene after = withPreset(before, bone());
        QVERIFY(after.volume == before.volume && after.camera == before.camera && after.film == before.film);
        QVERIFY(after.seed == 7 && after.revision == before.revision);
        QVERIFY(after.transferFunction == bone().look.transferFunction);
        QVERIFY(after.window == bone().look.window && after.window != HuWindow{});
        QVERIFY(!after.environment.visible);
    }

    void theLightAtTheCentreDoesNotDependOnTheSize() {
        const Scene small = sceneWith(50), large = sceneWith(500);
        const auto a = panelsOf(bone().look.rig, small.volume->geometry(), small.camera);
        const auto b = panelsOf(bone().look.rig, large.volume->geometry(), large.camera);
        QCOMPARE(a.size(), std::size_t(3));
        for (std::size_t i = 0; i < a.size(); ++i)
            QCOMPARE(shareAtCentre(std::get<RectangleLight>(a[i]), small.volume->geometry().centreMm()),
                     shareAtCentre(std::get<RectangleLight>(b[i]), large.volume->geometry().centreMm()));
    }

    void theRigFollowsTheCamera() {
        for (const StandardView view : {StandardView::anterior, StandardView::left, StandardView::superior}) {
            Scene scene = sceneWith(200);
            const VolumeGeometry& geometry = scene.volume->geometry();
            scene.camera = standardView(view, geometry.centreMm(), geometry.radiusMm(), 1);
            const Camera& camera = scene.camera;
            const auto rig = panelsOf(bone().look.rig, geometry, camera);
            const auto from = [&](int i) { return std::get<RectangleLight>(rig[i]).centreMm - geometry.centreMm(); };
            QVERIFY(glm::dot(from(0), camera.right()) < 0 && glm::dot(from(0), camera.imageUp()) > 0);
            QVERIFY(glm::dot(from(1), camera.right()) > 0);
            QVERIFY(glm::dot(from(0), camera.forward()) < 0 && glm::dot(from(2), camera.forward()) > 0);
            for (int i = 0; i < 3; ++i)
                QVERIFY(glm::dot(std::get<RectangleLight>(rig[i]).normal, from(i)) < 0);
        }
    }

    void theRigOfThePatientStaysWhereItIsFromTheFront() {
        Scene scene = sceneWith(200);
        const VolumeGeometry& geometry = scene.volume->geometry();
        LightRig rig = bone().look.rig;
        const auto front = panelsOf(rig, geometry, scene.camera);
        rig.follows = LightRig::Follows::patient;
        for (const StandardView view : {StandardView::anterior, StandardView::left, StandardView::superior}) {
            const Camera camera = standardView(view, geometry.centreMm(), 2 * geometry.radiusMm(), 1);
            QVERIFY(panelsOf(rig, geometry, camera) == front);
        }
    }

    void aDarkPanelIsLeftOut() {
        LightRig rig = bone().look.rig;
        rig.fill = 0;
        const Scene scene = sceneWith(200);
        QCOMPARE(panelsOf(rig, scene.volume->geometry(), scene.camera).size(), std::size_t(2));
    }
};

QTEST_APPLESS_MAIN(PresetTest)
#include "preset_test.moc"
