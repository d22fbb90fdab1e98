/// The light panel under mouse and keys: what it emits, what it shows, and that the light comes from where its handle
/// is.

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "render/scene/orbit.h"
#include "tests/support/desktop/contrast.h"
#include "tests/support/desktop/named_widget.h"
#include "ui/light/light_panel.h"
#include "ui/theme/theme.h"

namespace pdr::ui {

namespace {

Camera obliqueCamera() {
    return orbited(standardView(StandardView::anterior, dvec3(0), 100, 1), {0.2, -0.15});
}

/// A panel on the screen, and what it has emitted.
struct Lit {
    Lit() {
        panel.setLighting({{standardPanels(54, 2, 5)}, {vec3(0.05f), false}}, obliqueCamera());
        QObject::connect(&panel, &LightPanel::lightingEdited, [this](const Lighting& lighting, bool moving) {
            last = lighting;
            ++(moving ? moves : rests);
        });
        panel.resize(316, 700);
        panel.show();
    }

    template <class Widget>
    Widget& named(const QString& name) const {
        return test::named<Widget>(panel, name);
    }
    QPushButton& button(const QString& text) {
        for (QPushButton* each : panel.findChildren<QPushButton*>())
            if (each->text() == text)
                return *each;
        qFatal("no button is called %s", qPrintable(text));
    }
    void drag(QPointF from, QPointF to) {
        LightSphere& sphere = panel.sphere();
        QTest::mousePress(&sphere, Qt::LeftButton, {}, from.toPoint());
        for (const double part : {0.5, 1.0})
            QTest::mouseMove(&sphere, (from + part * (to - from)).toPoint());
        QTest::mouseRelease(&sphere, Qt::LeftButton, {}, to.toPoint());
    }
    /// Returns the direction of the lamp `index`, as the viewer sees it.
    dvec3 seen(std::size_t index) const {
        const dmat3 view = rigAxes(LightRig::Follows::camera, obliqueCamera());
        return glm::transpose(view) * rigAxes(last.rig.follows, obliqueCamera()) * lampsOf(last.rig)[index].from;
    }

    LightPanel panel;
    Lighting last;
    int moves = 0, rests = 0;
};

}  // namespace

class TestLightPanel : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { applyTheme(*qApp, ThemeChoice::dark); }
    void settersAreSilent();
    void placesAndDirectionsAreEachOther();
    void theBallIsBrightestUnderTheHandle();
    void aDragTakesTheLampAlong_data();
    void aDragTakesTheLampAlong();
    void besideTheLampsAllAreTurned();
    void whatComesFromOutsideEndsTheDrag();
    void keysMoveChooseAndTurn();
    void aRigIsChosenByItsButton();
    void aRigIsMeantForTheView();
    void slidersChangeTheChosenLamp();
    void aLampThatIsOffComesBack();
    void tyingMovesNothing();
    void numbersAreTypedAndWrongOnesAreNotTaken();
    void panelsComeAndGo();
    void everyControlIsReachedAndNamed();
    void handlesAndTextStandOut();
};

void TestLightPanel::settersAreSilent() {
    Lit lit;
    lit.panel.setLighting(litBy({}, NamedRig::operatingLamp), Camera{});
    lit.panel.setLighting({{{RigPanel{}}}, {vec3(0)}}, obliqueCamera());
    QCOMPARE(lit.moves + lit.rests, 0);
}

void TestLightPanel::placesAndDirectionsAreEachOther() {
    Lit lit;
    LightSphere& sphere = lit.panel.sphere();
    for (int azimuth = -170; azimuth <= 180; azimuth += 10)
        for (int elevation = -80; elevation <= 80; elevation += 10) {
            const double a = glm::radians(double(azimuth)), e = glm::radians(double(elevation));
            const dvec3 from(std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e));
            QVERIFY(glm::length(sphere.directionAt(sphere.handleOf(from)) - from) < 1e-6);
        }
    QVERIFY(sphere.directionAt({-1000, -1000}).z < -0.99);  // beyond the ring: right behind
    const QPointF middle = QRectF(sphere.rect()).center();
    QVERIFY(glm::length(sphere.directionAt(middle) - dvec3(0, 0, 1)) < 1e-9);
    QVERIFY(sphere.handleOf({0, 1, 0}).y() < middle.y() && sphere.handleOf({1, 0, 0}).x() > middle.x());
}

void TestLightPanel::theBallIsBrightestUnderTheHandle() {
    Lit lit;
    LightSphere& sphere = lit.panel.sphere();
    const dvec3 from = glm::normalize(dvec3(-0.5, 0.4, 0.7));
    sphere.setLamps({{"one", from, 1, vec3(1)}, {"off", {0, 0, -1}, 0, vec3(1)}});
    sphere.setCurrent(1);
    const QImage image = sphere.grab().toImage();
    const double ratio = image.devicePixelRatio();
    const auto greyAt = [&](QPointF place) { return qGray(image.pixel((place * ratio).toPoint())); };
    const QPointF handle = sphere.handleOf(from), middle = QRectF(sphere.rect()).center();
    const QPointF out = (handle - middle) / std::hypot(handle.x() - middle.x(), handle.y() - middle.y());
    const int beside = greyAt(handle + 12 * QPointF(-out.y(), out.x()));
    QVERIFY2(beside > greyAt(middle) && beside > greyAt(middle - 25 * out) + 40, qPrintable(QString::number(beside)));
}

void TestLightPanel::aDragTakesTheLampAlong_data() {
    QTest::addColumn<bool>("patient");
    QTest::addColumn<QPointF>("to");
    QTest::newRow("over the ball") << false << QPointF(15, -20);
    QTest::newRow("behind, tied to the patient") << true << QPointF(70, 20);
}

void TestLightPanel::aDragTakesTheLampAlong() {
    QFETCH(bool, patient);
    QFETCH(QPointF, to);
    Lit lit;
    if (patient)
        lit.panel.setLighting(
            {tiedTo(lit.panel.lighting().rig, LightRig::Follows::patient, obliqueCamera()), {vec3(0.05f), false}},
            obliqueCamera());
    LightSphere& sphere = lit.panel.sphere();
    const dvec3 key = glm::normalize(dvec3(-0.9, 1.0, 0.9));
    const QPoint place = (QRectF(sphere.rect()).center() + to).toPoint();
    lit.drag(sphere.handleOf(key), place);
    QVERIFY(lit.moves >= 1);
    QCOMPARE(lit.rests, 1);
    QVERIFY(glm::length(lit.seen(0) - sphere.directionAt(place)) < 1e-9);
    QVERIFY((lit.seen(0).z < 0) == patient);
    const Lighting before{{standardPanels(54, 2, 5)}, {}};
    QCOMPARE(lit.last.rig.panels[0].radiance, 54.f);
    QVERIFY(patient || lit.last.rig.panels[1] == before.rig.panels[1]);
}

void TestLightPanel::besideTheLampsAllAreTurned() {
    Lit lit;
    LightSphere& sphere = lit.panel.sphere();
    const QPointF middle = QRectF(sphere.rect()).center();
    const auto apart = [](const LightRig& rig) {
        const auto lamps = lampsOf(rig);
        return glm::dot(lamps[0].from, lamps[1].from);
    };
    const double before = apart(lit.panel.lighting().rig);
    lit.drag(middle + QPointF(0, 25), middle + QPointF(30, 25));
    QVERIFY(lit.moves >= 1 && lit.rests == 1);
    QVERIFY(std::abs(apart(lit.last.rig) - before) < 1e-9);
    QVERIFY(lit.seen(0).x > -0.4);  // the key was farther to the left
}

void TestLightPanel::whatComesFromOutsideEndsTheDrag() {
    Lit lit;
    LightSphere& sphere = lit.panel.sphere();
    const QPointF key = sphere.handleOf(glm::normalize(dvec3(-0.9, 1.0, 0.9)));
    QTest::mousePress(&sphere, Qt::LeftButton, {}, key.toPoint());
    QTest::mouseMove(&sphere, key.toPoint() + QPoint(5, 5));
    lit.panel.setLighting(litBy({}, NamedRig::rim), obliqueCamera());
    const int before = lit.moves + lit.rests;
    QTest::mouseMove(&sphere, key.toPoint() + QPoint(25, 5));
    QTest::mouseRelease(&sphere, Qt::LeftButton, {}, key.toPoint());
    QCOMPARE(lit.moves + lit.rests, before);
}

void TestLightPanel::keysMoveChooseAndTurn() {
    Lit lit;
    LightSphere& sphere = lit.panel.sphere();
    QTest::keyClick(&sphere, Qt::Key_PageDown);
    QCOMPARE(sphere.lamp().name, QString("Fill"));
    const dvec3 before = sphere.lamp().from;
    QTest::keyClick(&sphere, Qt::Key_Right);
    QVERIFY(sphere.lamp().from.x > before.x);
    QTest::keyClick(&sphere, Qt::Key_Up);
    QVERIFY(sphere.lamp().from.y > before.y);
    QCOMPARE(lit.rests, 2);
    const dvec3 key = lit.seen(0);
    QTest::keyClick(&sphere, Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(lit.seen(0).x < key.x - 0.01);
    for (int i = 0; i < 60; ++i)
        QTest::keyClick(&sphere, Qt::Key_Up);
    QVERIFY(sphere.lamp().from.y > 0.999);
}

void TestLightPanel::aRigIsChosenByItsButton() {
    Lit lit;
    for (const char* name :
         {"Sky", "Operating lamp", "Three-point light", "Headlight", "Large soft light", "Back light"}) {
        const int before = lit.rests;
        lit.button(name).click();
        QCOMPARE(lit.rests, before + 1);
        for (const QPushButton* each : lit.panel.findChildren<QPushButton*>())
            QVERIFY2(each->isChecked() == (each->text() == name), name);
    }
    LightSphere& sphere = lit.panel.sphere();
    QTest::keyClick(&sphere, Qt::Key_Left);
    QVERIFY(!lit.button("Back light").isChecked());
}

/// A rig is relative to the view even if the lamps then stay with the patient.
void TestLightPanel::aRigIsMeantForTheView() {
    Lit lit;
    lit.button("Headlight").click();
    const dvec3 inView = lit.seen(0);
    QComboBox& follows = lit.named<QComboBox>("What the lamps move with");
    emit follows.activated(1);
    lit.button("Back light").click();
    lit.button("Headlight").click();
    QVERIFY(lit.last.rig.follows == LightRig::Follows::patient);
    QVERIFY(glm::length(lit.seen(0) - inView) < 1e-9);
    QVERIFY(lit.button("Headlight").isChecked());
}

void TestLightPanel::slidersChangeTheChosenLamp() {
    Lit lit;
    QTest::keyClick(&lit.panel.sphere(), Qt::Key_PageDown);
    QSlider& strength = lit.named<QSlider>("Strength of the chosen lamp");
    const auto ofFill = [&] { return lampsOf(lit.panel.lighting().rig)[1]; };
    const double before = ofFill().irradiance;
    strength.setValue(strength.value() + 10);
    QVERIFY(std::abs(ofFill().irradiance / before - 2) < 0.1);
    QSlider& size = lit.named<QSlider>("Size of the chosen lamp");
    const double strong = ofFill().irradiance;
    size.setValue(0);
    QCOMPARE(ofFill().edge, 1.0);
    QVERIFY(std::abs(ofFill().irradiance / strong - 1) < 1e-5);
    QSlider& ambient = lit.named<QSlider>("Ambient light");
    ambient.setValue(0);
    QVERIFY(std::abs(lit.last.environment.radiance.x - 1) < 0.05f);
    ambient.setValue(ambient.minimum());
    QVERIFY(lit.last.environment.radiance == vec3(0));
    QCOMPARE(lit.moves, 0);
    strength.setSliderDown(true);
    strength.setSliderPosition(strength.value() + 5);
    QCOMPARE(lit.moves, 1);
    strength.setSliderDown(false);
    QCOMPARE(lit.moves, 1);
}

void TestLightPanel::aLampThatIsOffComesBack() {
    Lit lit;
    QSlider& strength = lit.named<QSlider>("Strength of the chosen lamp");
    strength.setValue(strength.minimum());
    QCOMPARE(lit.last.rig.panels[0].radiance, 0.f);
    QCOMPARE(strength.value(), strength.minimum());
    strength.setValue(20);
    QVERIFY(std::abs(lampsOf(lit.last.rig)[0].irradiance - 4) < 1e-5);
}

void TestLightPanel::tyingMovesNothing() {
    Lit lit;
    QComboBox& follows = lit.named<QComboBox>("What the lamps move with");
    follows.setCurrentIndex(1);
    emit follows.activated(1);
    QVERIFY(lit.last.rig.follows == LightRig::Follows::patient);
    const auto places = panelsOf(lit.last.rig, VolumeGeometry::aligned({2, 2, 2}, dvec3(1), dvec3(0)), obliqueCamera());
    const auto before =
        panelsOf({standardPanels(54, 2, 5)}, VolumeGeometry::aligned({2, 2, 2}, dvec3(1), dvec3(0)), obliqueCamera());
    for (std::size_t i = 0; i < 3; ++i)
        QVERIFY(glm::length(std::get<RectangleLight>(places[i]).centreMm -
                            std::get<RectangleLight>(before[i]).centreMm) < 1e-9);
}

void TestLightPanel::numbersAreTypedAndWrongOnesAreNotTaken() {
    Lit lit;
    QTableWidget& cells = lit.panel.table().cells();
    QCOMPARE(cells.rowCount(), 3);
    QCOMPARE(cells.item(0, PanelTable::azimuth)->text(), QString("-45"));
    cells.item(0, PanelTable::azimuth)->setText("120");
    QCOMPARE(lit.rests, 1);
    QVERIFY(std::abs(glm::degrees(std::atan2(lit.last.rig.panels[0].from.x, lit.last.rig.panels[0].from.z)) - 120) <
            1e-9);
    cells.item(0, PanelTable::edge)->setText("0,5");
    QCOMPARE(lit.last.rig.panels[0].edge, 0.5);
    QCOMPARE(lit.last.rig.panels[0].radiance, 54.f);  // the number that stands there, not the strength
    cells.item(2, PanelTable::name)->setText("Key");
    QCOMPARE(lampsOf(lit.last.rig).size(), std::size_t(2));
    const int before = lit.rests;
    const Lighting kept = lit.last;
    for (const char* wrong : {"", "wide", "0", "-1", "1e9", "nan", "inf"})
        cells.item(1, PanelTable::edge)->setText(wrong);
    QCOMPARE(lit.rests, before);
    QVERIFY(lit.panel.lighting() == kept);
    QCOMPARE(cells.item(1, PanelTable::edge)->text(), QString("3"));
}

void TestLightPanel::panelsComeAndGo() {
    Lit lit;
    for (int i = 3; i < int(LightRig::kMostPanels); ++i)
        lit.button("Add").click();
    QCOMPARE(lit.last.rig.panels.size(), LightRig::kMostPanels);
    QVERIFY(!lit.button("Add").isEnabled());
    while (lit.button("Remove").isEnabled())
        lit.button("Remove").click();
    QCOMPARE(lit.last.rig.panels.size(), std::size_t(1));
}

void TestLightPanel::everyControlIsReachedAndNamed() {
    Lit lit;
    for (const QWidget* control : lit.panel.findChildren<QWidget*>()) {
        if (control->focusPolicy() == Qt::NoFocus || qobject_cast<const QLineEdit*>(control))
            continue;
        const auto* button = qobject_cast<const QAbstractButton*>(control);
        QVERIFY2(!control->accessibleName().isEmpty() || (button && !button->text().isEmpty()) ||
                     control->inherits("QTableView") || control->inherits("QComboBoxListView") ||
                     control->inherits("QHeaderView"),
                 control->metaObject()->className());
    }
}

/// Every handle stands out against the ball and the ring, the chosen one as well.
void TestLightPanel::handlesAndTextStandOut() {
    Lit lit;
    LightSphere& sphere = lit.panel.sphere();
    for (const dvec3 from : {dvec3(-0.5, 0.4, 0.768), dvec3(0.5, -0.5, -0.707)})
        for (const int current : {0, 1}) {
            sphere.setLamps({{"seen", from, 1, vec3(1.12f, 0.99f, 0.8f)}, {"other", {0, -0.6, 0.8}, 0.5, vec3(1)}});
            sphere.setCurrent(current);
            const QImage image = sphere.grab().toImage();
            const QPointF handle = sphere.handleOf(from) * image.devicePixelRatio();
            double lightest = 0, darkest = 1;
            for (int i = 0; i < 12 * int(image.devicePixelRatio()); ++i) {
                const QColor colour = image.pixelColor((handle + QPointF(i, 0)).toPoint());
                lightest = std::max(lightest, test::luminance(colour));
                darkest = std::min(darkest, test::luminance(colour));
            }
            QVERIFY2((lightest + 0.05) / (darkest + 0.05) >= 3, qPrintable(QString::number(lightest / darkest)));
        }
    for (const QLabel* label : lit.panel.findChildren<QLabel*>())
        QVERIFY(test::contrast(label->palette().color(label->foregroundRole()),
                               label->palette().color(QPalette::Window)) >= 4.5);
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestLightPanel)
#include "light_panel_test.moc"
