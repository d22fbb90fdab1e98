#include <QtTest>

#include <QDir>
#include <QFile>
#include <set>

#include "render/scene/named_look.h"
#include "tests/support/places.h"

using namespace pdr;

static QByteArray text(const QString& name) {
    QFile file(QStringLiteral(PDR_SOURCE_DIR "/resources/looks/%1.json").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

static NamedLook lookNamed(const QString& name) {
    return *lookFromJson(text(name).toStdString(), name.toStdString());
}

static NamedLook bone() {
    return lookNamed("bone");
}

static std::vector<NamedLook> allLooks() {
    std::vector<NamedLook> looks;
    for (const QString& file : QDir(PDR_SOURCE_DIR "/resources/looks").entryList({"*.json"}))
        looks.push_back(lookNamed(file.chopped(5)));
    return looks;
}

static Scene sceneWith(double sizeMm) {
    Scene scene;
    scene.volume = std::make_shared<const Volume>(
        VolumeGeometry::aligned({2, 2, 2}, dvec3(sizeMm / 2), dvec3(sizeMm / 4)), Voxels(8, 0));
    scene.camera = standardView(StandardView::anterior, scene.volume->geometry().centreMm(),
                                scene.volume->geometry().radiusMm(), 1);
    return scene;
}

/// Returns the irradiance of a small panel on a plane that faces it at the volume's centre, up to a constant.
static double shareAtCentre(const RectangleLight& light, dvec3 centre) {
    const dvec3 away = light.centreMm - centre;
    return light.radiance.y * light.widthMm * light.heightMm / glm::dot(away, away);
}

static Scene onScene(const Scene& scene, const NamedLook& look) {
    return withNamedLook(scene, look, scene.volume->geometry());
}

class NamedLookTest : public QObject {
    Q_OBJECT

  private slots:
    void everyLookCanBeRenderedAsItIs() {
        std::set<std::string> names;
        for (const NamedLook& look : allLooks()) {
            const auto ok = onScene(sceneWith(200), look).check();
            QVERIFY2(bool(ok), ok ? "" : ok.error().text().c_str());
            QVERIFY2(look.doesNotShow.ends_with('.') && look.group != LookGroup::own, look.name.c_str());
            names.insert(look.name);
        }
        QVERIFY(names.size() >= 12 && names.size() == allLooks().size());
    }

    /// Files from before tone curves had names show what they showed then.
    void aLookWithoutAToneCurveKeepsTheOldOne() {
        for (const QString& file : QDir(PDR_SOURCE_DIR "/resources/looks").entryList({"*.json"})) {
            QByteArray named = text(file.chopped(5));
            const NamedLook look = *lookFromJson(named.toStdString(), "");
            QVERIFY(look.look.display.curve == ToneCurve::keepsHue);
            QVERIFY(lookFromJson(lookText(look), "")->look == look.look);
            QVERIFY(named.contains(",\n  \"toneCurve\": \"keepsHue\""));
            const NamedLook old =
                *lookFromJson(named.replace(",\n  \"toneCurve\": \"keepsHue\"", "").toStdString(), "");
            QVERIFY(old.look.display.curve == ToneCurve::perChannel);
            QVERIFY(QByteArray::fromStdString(lookText(old)).contains("\"toneCurve\": \"perChannel\""));
        }
    }

    void airIsClearInEveryLook() {
        for (const NamedLook& look : allLooks())
            QCOMPARE(look.look.transferFunction.at(-1000).opacity, 0.0f);
    }

    /// Vessels are drawn so that a rim of 1 mm is like glass and 10 mm are opaque. Looks that show vessels as a part of the
    /// scan need not tell them from bone.
    void vesselsAreDrawnForTheirBlood() {
        int drawn = 0;
        for (const NamedLook& look : allLooks()) {
            if (!look.suits.contrast.value_or(false) || look.model != Model::singleScattering ||
                look.group == LookGroup::bones || !look.look.parts.empty())
                continue;
            ++drawn;
            for (const float blood : {250.0f, 365.0f, 420.0f, 600.0f}) {
                const TransferFunction function = fittedTo(look, blood).look.transferFunction;
                const double perMm = double(function.extinctionPerMm) * double(function.at(blood).opacity);
                QVERIFY2(1 - std::exp(-perMm) < 0.3 && 1 - std::exp(-10 * perMm) > 0.9, look.name.c_str());
            }
        }
        QVERIFY(drawn >= 2);
    }

    void aCurveForOtherBloodStaysInOrder() {
        for (const NamedLook& look : allLooks())
            for (const float blood : {-500.0f, 100.0f, 180.0f, 420.0f, 1000.0f, 3000.0f}) {
                const NamedLook fitted = fittedTo(look, blood);
                QVERIFY(check(fitted.look));
                QVERIFY(look.bloodHu || fitted == look);
                for (std::size_t i = 0; i < look.look.transferFunction.nodes.size(); ++i)
                    if (const TransferNode& node = look.look.transferFunction.nodes[i];
                        node.hu <= 60 || node.hu >= 1500)
                        QVERIFY(fitted.look.transferFunction.nodes[i] == node);
            }
        const NamedLook look = lookNamed("vessels_and_bone");
        const NamedLook there = fittedTo(look, 300), back = fittedTo(there, *look.bloodHu);
        for (std::size_t i = 0; i < look.look.transferFunction.nodes.size(); ++i)
            QVERIFY(std::abs(back.look.transferFunction.nodes[i].hu - look.look.transferFunction.nodes[i].hu) < 0.01f);
    }

    void looksAreOfferedWhereTheyMakeSense() {
        const segment::Findings head{150, 40, 0.2, {}}, chest{400, 3000, 0, 365.0f}, hip{350, 60, 30, {}};
        const auto suits = [](const char* name, const segment::Findings& findings) {
            return whyUnsuited(lookNamed(name), findings).empty();
        };
        QVERIFY(suits("bone", head) && !suits("bone", chest) && suits("bone", hip));
        QVERIFY(!suits("bone_beside_contrast", head) && suits("bone_beside_contrast", chest));
        QVERIFY(!suits("lung_vessels", head) && suits("lung_vessels", chest) && !suits("lung_vessels", hip));
        QVERIFY(!suits("heart", head) && suits("heart", chest));
        QVERIFY(!suits("implants", head) && suits("implants", hip));
        QVERIFY(suits("muscles_and_skull", head) && !suits("muscles_and_skull", chest));
        QCOMPARE(whyUnsuited(lookNamed("lung_vessels"), head), std::string("no lungs are in this scan"));
        for (const segment::Findings& findings : {head, chest, hip}) {
            int offered = 0;
            for (const NamedLook& look : allLooks())
                offered += whyUnsuited(look, findings).empty();
            QVERIFY(offered >= 6);
        }
    }

    void aCutTakesThatShareOfTheBody() {
        const VolumeGeometry box = VolumeGeometry::aligned({10, 20, 40}, {1, 2, 3}, {100, 200, 300});
        const auto place = [&](CutHint::Plane plane, float at) { return planeOf({plane, at}, box); };
        QCOMPARE(place(CutHint::Plane::coronal, 0.25f).pointMm.y, 199.0 + 0.25 * 40);
        QVERIFY(place(CutHint::Plane::coronal, 0.25f).normal == dvec3(0, -1, 0));
        QCOMPARE(place(CutHint::Plane::sagittal, 0.5f).pointMm.x, 99.5 + 5);
        QCOMPARE(place(CutHint::Plane::axial, 1).pointMm.z, 298.5);
        VolumeGeometry flipped = box;  // rows that run from the back to the front
        flipped.patientFromIndex[1] = -flipped.patientFromIndex[1];
        flipped.patientFromIndex[3].y = 238;
        QCOMPARE(planeOf({CutHint::Plane::coronal, 0.25f}, flipped).pointMm.y, 199.0 + 0.25 * 40);
    }

    void mistakesNameTheField() {
        const auto errorOf = [](const char* before, const char* after) {
            const QByteArray wrong = text("bone").replace(before, after);
            return wrong == text("bone") ? std::string("nothing was replaced")
                                         : lookFromJson(wrong.toStdString(), "bone").error().where;
        };
        QCOMPARE(errorOf("\"ambient\":", "\"main\":"), std::string("bone, lights.main"));
        QCOMPARE(errorOf("\"highHu\": 1800", "\"highHu\": 100"), std::string("bone, window.highHu"));
        QCOMPARE(errorOf("\"exposure\": ", "\"exposure\": -"), std::string("bone, exposure"));
        QCOMPARE(errorOf("\"bones\"", "\"ribs\""), std::string("bone, group"));
        QCOMPARE(errorOf("\"Bone\"", "\"\""), std::string("bone, name"));
        QCOMPARE(errorOf("\"exposure\"", "\"cut\": { \"plane\": \"coronal\", \"at\": 2 }, \"exposure\""),
                 std::string("bone, cut.at"));
        QCOMPARE(errorOf("\"exposure\"", "\"bloodHu\": 20, \"exposure\""), std::string("bone, bloodHu"));
        QCOMPARE(errorOf("pdrender-look", "pdrender-preset"), std::string("bone, format"));
    }

    void aLookChangesWhatItSaysAndNothingElse() {
        Scene before = sceneWith(200);
        before.seed = 7;
        before.film = {10, 20};
        const Scene after = onScene(before, bone());
        QVERIFY(after.volume == before.volume && after.camera == before.camera && after.film == before.film);
        QVERIFY(after.seed == 7 && after.revision == before.revision);
        QVERIFY(after.transferFunction == bone().look.transferFunction);
        QVERIFY(after.window == bone().look.window && after.window != HuWindow{});
        QVERIFY(!after.environment.visible);
        QVERIFY(onScene(before, lookNamed("skin")).model == Model::multipleScattering);
    }

    void aCutOfTheUsersOwnIsLeftAsItIs() {
        const VolumeGeometry box = VolumeGeometry::aligned({10, 20, 40}, {1, 2, 3}, {100, 200, 300});
        ImageSetup setup;
        setup.estimator = Estimator::kroesMarch;
        const ImageSetup heart = withNamedLook(setup, lookNamed("heart"), box);
        QCOMPARE(heart.clip.planes.size(), std::size_t(1));
        QVERIFY(heart.clip.planes[0] == planeOf(*lookNamed("heart").cut, box));
        QVERIFY(heart.estimator == Estimator::kroesMarch && heart.lookName == "Heart and great vessels");
        setup.clip.box = ClipBox{{0, 0, 0}, {1, 1, 1}};
        QVERIFY(withNamedLook(setup, lookNamed("heart"), box).clip == setup.clip);
        QVERIFY(withNamedLook(setup, lookNamed("mip"), box).estimator == Estimator::unbiased);
        Scene scene = sceneWith(200);  // likewise
        scene.estimator = Estimator::kroesMarch;
        QVERIFY(withNamedLook(scene, lookNamed("heart"), box).clip == heart.clip);
        QVERIFY(withNamedLook(scene, lookNamed("mip"), box).estimator == Estimator::unbiased);
        scene.clip = setup.clip;
        QVERIFY(withNamedLook(scene, lookNamed("heart"), box).clip == setup.clip);
    }

    void theLightAtTheCentreDoesNotDependOnTheSize() {
        const Scene small = sceneWith(50), large = sceneWith(500);
        const auto a = panelsOf(bone().look.rig, small.volume->geometry(), small.camera);
        const auto b = panelsOf(bone().look.rig, large.volume->geometry(), large.camera);
        QCOMPARE(a.size(), bone().look.rig.panels.size());
        for (std::size_t i = 0; i < a.size(); ++i)
            QCOMPARE(shareAtCentre(std::get<RectangleLight>(a[i]), small.volume->geometry().centreMm()),
                     shareAtCentre(std::get<RectangleLight>(b[i]), large.volume->geometry().centreMm()));
    }

    /// Relief is visible through its shadows: looks have a key light from the side that is less than half as large as
    /// far away, a fill light that leaves them dark, and an outline from behind.
    void whatIsLitIsLitFromTheSide() {
        int lit = 0;
        for (const NamedLook& look : allLooks()) {
            if (look.model != Model::singleScattering && look.model != Model::multipleScattering)
                continue;
            ++lit;
            const RigPanel &key = look.look.rig.panels[0], &fill = look.look.rig.panels[1],
                           &rim = look.look.rig.panels[2];
            const double aside = std::abs(key.from.x) / key.from.z;
            QVERIFY2(aside > 1.2 && key.from.y > 0 && key.edge < 0.45 * key.distance, look.name.c_str());
            QVERIFY2(irradianceOf(fill) < irradianceOf(key) / 7, look.name.c_str());
            QVERIFY2(rim.from.z < 0 && irradianceOf(rim) < irradianceOf(key), look.name.c_str());
        }
        QVERIFY(lit >= 12);
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
        rig.panels[1].radiance = 0;
        const Scene scene = sceneWith(200);
        QCOMPARE(panelsOf(rig, scene.volume->geometry(), scene.camera).size(), rig.panels.size() - 1);
    }
};

QTEST_APPLESS_MAIN(NamedLookTest)
#include "named_look_test.moc"
