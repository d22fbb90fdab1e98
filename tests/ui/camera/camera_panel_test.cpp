/// The camera panel: what it emits and what it shows.

#include <QColorDialog>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include "render/scene/edit/camera_edits.h"
#include "tests/support/desktop/contrast.h"
#include "tests/support/desktop/named_widget.h"
#include "ui/camera/camera_panel.h"
#include "ui/camera/camera_text.h"
#include "ui/theme/theme.h"

namespace pdr::ui {
namespace {

/// A panel, and what it has emitted.
struct Seen {
    Seen() {
        panel.setCamera(camera);
        QObject::connect(&panel, &CameraPanel::cameraEdited, [this](const Camera& edited) {
            camera = edited;
            ++edits;
        });
        QObject::connect(&panel, &CameraPanel::backgroundChosen, [this](const std::optional<QColor>& colour) {
            background = colour;
            ++backgrounds;
        });
    }

    template <class Widget>
    Widget& named(const QString& name) const {
        return test::named<Widget>(panel, name);
    }
    void choose(const QString& name, int index) {
        QComboBox& box = named<QComboBox>(name);
        box.setCurrentIndex(index);
        emit box.activated(index);
    }

    CameraPanel panel;
    Camera camera = standardView(StandardView::anterior, {10, 20, 30}, 200, 1);
    std::optional<QColor> background;
    int edits = 0, backgrounds = 0;
};

}  // namespace

class TestCameraPanel : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { applyTheme(*qApp, ThemeChoice::dark); }
    void settersAreSilent();
    void projectionAndFieldOfViewAreThoseOfTheLens();
    void theApertureSaysWhatIsSharp();
    void allSharpIsAPinhole();
    void viewsAreChosenByButtons();
    void aBackgroundIsChosenOrGivenUp();
    void everyControlIsNamedAndTextStandsOut();
};

void TestCameraPanel::settersAreSilent() {
    Seen seen;
    seen.panel.setCamera(withType(seen.camera, Camera::Type::orthographic));
    seen.panel.setBackground(QColor(1, 2, 3));
    seen.panel.setBackground(std::nullopt);
    seen.panel.setPicking(true);
    QCOMPARE(seen.edits + seen.backgrounds, 0);
}

void TestCameraPanel::projectionAndFieldOfViewAreThoseOfTheLens() {
    Seen seen;
    const Camera before = seen.camera;
    QVERIFY(!seen.named<QDoubleSpinBox>("Height of what is seen").isEnabled());
    seen.choose("Projection", 1);
    QVERIFY(seen.camera == withType(before, Camera::Type::orthographic));
    QVERIFY(!seen.named<QDoubleSpinBox>("Field of view").isEnabled());
    seen.named<QDoubleSpinBox>("Height of what is seen").setValue(120);
    QCOMPARE(seen.camera.heightMm, 120.0);
    seen.choose("Projection", 0);
    seen.named<QDoubleSpinBox>("Field of view").setValue(20);
    QVERIFY(std::abs(seen.camera.heightInFocusMm() - 120) < 1e-9 && seen.camera.fovDegrees == 20);
    QCOMPARE(seen.edits, 4);
    QVERIFY(seen.camera.check());
}

void TestCameraPanel::theApertureSaysWhatIsSharp() {
    Seen seen;
    QLabel& sharp = seen.named<QLabel>("What is sharp");
    QVERIFY(sharp.text().startsWith("All is sharp"));
    seen.named<QDoubleSpinBox>("Aperture").setValue(25);
    const SharpDepths depths = sharpDepths(seen.camera);
    const double focus = seen.camera.focusDistanceMm();
    QCOMPARE(sharp.text(), sharpText(seen.camera));
    QVERIFY(sharp.text().contains(QString("%1 mm before").arg(focus - depths.nearMm, 0, 'f', 0)) ||
            sharp.text().contains(QString("%1 mm before").arg(focus - depths.nearMm, 0, 'f', 1)));
    seen.named<QDoubleSpinBox>("Aperture").setValue(0.1);
    QVERIFY(sharp.text().contains("on;"));
}

void TestCameraPanel::allSharpIsAPinhole() {
    Seen seen;
    seen.panel.setCamera(focusedAt(seen.camera, 300));
    for (QPushButton* button : seen.panel.findChildren<QPushButton*>())
        if (button->text() == "All sharp")
            button->click();
    QCOMPARE(seen.edits, 1);
    QVERIFY(seen.camera.apertureMm == 0 && seen.camera.focusMm == 0);
}

void TestCameraPanel::viewsAreChosenByButtons() {
    Seen seen;
    QList<StandardView> chosen;
    QObject::connect(&seen.panel, &CameraPanel::viewChosen, [&](StandardView view) { chosen << view; });
    for (const char* name : {"Front", "Back", "Left", "Right", "Head", "Feet"})
        seen.named<QPushButton>(QString("View from: %1").arg(name)).click();
    QCOMPARE(chosen, (QList{StandardView::anterior, StandardView::posterior, StandardView::left, StandardView::right,
                            StandardView::superior, StandardView::inferior}));
}

void TestCameraPanel::aBackgroundIsChosenOrGivenUp() {
    Seen seen;
    QComboBox& box = seen.named<QComboBox>("Background");
    seen.choose("Background", 2);
    QVERIFY(seen.background && seen.background->lightness() > 240);
    seen.choose("Background", 4);
    QVERIFY(!seen.background);
    QCOMPARE(seen.backgrounds, 2);
    const auto answer = [](bool take) {
        QTimer::singleShot(0, [take] {
            auto* dialog = qobject_cast<QColorDialog*>(QApplication::activeModalWidget());
            dialog->setCurrentColor(QColor(20, 60, 100));
            take ? dialog->accept() : dialog->reject();
        });
    };
    answer(false);
    seen.choose("Background", 3);
    QCOMPARE(seen.backgrounds, 2);
    QCOMPARE(box.currentIndex(), 4);  // as it was
    answer(true);
    seen.choose("Background", 3);
    QCOMPARE(seen.background, std::optional(QColor(20, 60, 100)));
    QCOMPARE(box.currentIndex(), 3);
    seen.panel.setBackground(QColor(0, 0, 0));
    QCOMPARE(box.currentIndex(), 0);
}

void TestCameraPanel::everyControlIsNamedAndTextStandsOut() {
    Seen seen;
    for (const QWidget* control : seen.panel.findChildren<QWidget*>()) {
        const auto* button = qobject_cast<const QAbstractButton*>(control);
        if (control->focusPolicy() != Qt::NoFocus && !control->inherits("QLineEdit") &&
            control->parentWidget()->parentWidget() == &seen.panel)
            QVERIFY2(!control->accessibleName().isEmpty() || (button && !button->text().isEmpty()),
                     control->metaObject()->className());
    }
    for (const QLabel* label : seen.panel.findChildren<QLabel*>())
        QVERIFY(test::contrast(label->palette().color(label->foregroundRole()),
                               label->palette().color(QPalette::Window)) >= 4.5);
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestCameraPanel)
#include "camera_panel_test.moc"
