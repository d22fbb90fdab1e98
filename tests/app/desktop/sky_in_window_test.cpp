/// An image of surroundings in the whole window: chosen from a file it lights the volume in the rig's place; undo
/// brings back the same bits; what cannot be read is said and changes nothing.

#include <QAbstractButton>
#include <QFile>
#include <QFileDialog>
#include <QSlider>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <limits>

#include "app/output/provenance.h"
#include "app/presenters/light_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/hand_on_window.h"
#include "tests/support/desktop/named_widget.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/scenes/sky_file.h"
#include "ui/light/light_panel.h"
#include "ui/looks/look_panel.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// A window with the phantom in it.
struct SkyTrial : Trial {
    explicit SkyTrial(const QString& series) { openAndWait(series); }

    QAbstractButton& button(const QString& text) {
        for (QAbstractButton* each : panel.findChildren<QAbstractButton*>())
            if (each->text() == text)
                return *each;
        qFatal("no button is called %s", qPrintable(text));
    }
    /// Takes `file` from the dialog of the panel, or gives up.
    void ask(const QString& file, bool accept = true) {
        QTimer::singleShot(0, &desktop.window(), [=] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            dialog->setDirectory(QFileInfo(file).path());
            dialog->selectFile(file);
            accept ? static_cast<QDialog*>(dialog)->accept() : dialog->reject();
        });
        button("Environment image...").click();
    }
    void choose(const QString& file) {
        ask(file);
        QTRY_VERIFY_WITH_TIMEOUT(environment().image, test::kPatience);
    }
    const Environment& environment() const { return document.setup().look.environment; }

    Document& document = desktop.document();
    ui::LightPanel& panel = test::the<ui::LightPanel>(desktop.window());
};

class TestSkyInWindow : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void anImageLightsTheVolumeAndUndoBringsTheSameBits();
    void givingUpTheDialogChangesNothing();
    void whatCannotBeReadIsSaidAndChangesNothing_data();
    void whatCannotBeReadIsSaidAndChangesNothing();
    void itIsTurnedDimmedAndTakenAway();
    void aRigTakesItsPlace();
    void itMayBeDropped();
    void aLookIsKeptWithoutIt();

  private:
    QString at(const char* name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;
};

void TestSkyInWindow::initTestCase() {
    QVERIFY(writePhantomSeries(ui::fromQt(at("series"))));
    const auto sunrise = [](int x, int y) { return x == 20 && y == 6 ? vec3(5000) : vec3(3, 4, 5) * 100.f; };
    test::writeSky(ui::fromQt(at("sky.exr")), {32, 16}, sunrise);
    test::writeSky(ui::fromQt(at("black.exr")), {8, 4}, [](int, int) { return vec3(0); });
    const float infinite = std::numeric_limits<float>::infinity();
    test::writeSky(ui::fromQt(at("infinite.exr")), {8, 4}, [=](int x, int) { return vec3(x == 5 ? infinite : 1); });
    QFile text(at("text.exr"));
    QVERIFY(text.open(QIODevice::WriteOnly) && text.write("a sky") > 0);
    QVERIFY(QFile::exists(at("sky.exr")) && QFile::exists(at("black.exr")) && QFile::exists(at("infinite.exr")));
}

void TestSkyInWindow::anImageLightsTheVolumeAndUndoBringsTheSameBits() {
    SkyTrial trial(at("series"));
    const ImageSetup before = trial.document.setup();
    const Film picture = rendered(trial.document);
    trial.choose(at("sky.exr"));
    QVERIFY(trial.document.scene().lights.empty() && trial.document.scene().environment.image);
    QVERIFY(!test::sameBits(rendered(trial.document), picture));
    QVERIFY(std::abs(strengthOf(trial.panel.lighting()) / strengthOf({before.look.rig, before.look.environment}) - 1) <
            1e-5);
    QCOMPARE(trial.environment().visible, before.look.environment.visible);
    QVERIFY(trial.button("Environment image...").isChecked());
    QCOMPARE(trial.document.undoText(), Text("Undo changing the light"));
    QCOMPARE(provenanceOf(trial.document.scene(), {}).sky, std::string("32 x 16, turned by 0 degrees"));
    trial.waitForNewest();
    QVERIFY(trial.desktop.bridge().lastFrame()->error.empty());
    trial.document.undo();
    QVERIFY(!trial.document.canUndo() && trial.document.setup() == before);
    QVERIFY(test::sameBits(rendered(trial.document), picture));
    QVERIFY(!trial.button("Environment image...").isChecked());
    QVERIFY(provenanceOf(trial.document.scene(), {}).sky.empty());
}

void TestSkyInWindow::givingUpTheDialogChangesNothing() {
    SkyTrial trial(at("series"));
    const ImageSetup before = trial.document.setup();
    trial.ask(at("sky.exr"), false);
    QVERIFY(!trial.desktop.presenter<LightPresenter>().sky().isRunning());
    QVERIFY(!trial.document.canUndo() && trial.document.setup() == before);
    QVERIFY(!trial.button("Environment image...").isChecked());
}

void TestSkyInWindow::whatCannotBeReadIsSaidAndChangesNothing_data() {
    QTest::addColumn<QString>("said");
    QTest::newRow("text.exr") << "OpenEXR";
    QTest::newRow("black.exr") << "black";
    QTest::newRow("infinite.exr") << "(5, 0)";
    QTest::newRow("missing.exr") << "No such file";
}

void TestSkyInWindow::whatCannotBeReadIsSaidAndChangesNothing() {
    QFETCH(QString, said);
    SkyTrial trial(at("series"));
    const ImageSetup before = trial.document.setup();
    const ui::MessageBar& message = trial.desktop.window().message();
    emit trial.panel.skyChosen(at(QTest::currentDataTag()));
    QTRY_VERIFY_WITH_TIMEOUT(!message.text().isEmpty(), test::kPatience);
    QVERIFY2(message.text().contains(said), qPrintable(message.text()));
    QVERIFY2(message.text().contains(QTest::currentDataTag()), qPrintable(message.text()));
    QVERIFY(!trial.document.canUndo() && trial.document.setup() == before);
}

void TestSkyInWindow::itIsTurnedDimmedAndTakenAway() {
    SkyTrial trial(at("series"));
    auto& turn = test::named<QSlider>(trial.panel, "Rotation of the environment image");
    QVERIFY(turn.parentWidget()->isHidden());
    trial.choose(at("sky.exr"));
    const Environment chosen = trial.environment();
    QVERIFY(!turn.parentWidget()->isHidden());
    turn.setValue(90);
    QCOMPARE(trial.environment().rotationDegrees, 90.0);
    QCOMPARE(trial.document.undoText(), Text("Undo changing the light"));
    auto& around = test::named<QSlider>(trial.panel, "Ambient light");
    around.setValue(around.value() - 10);
    QVERIFY(std::abs(trial.environment().radiance.x / chosen.radiance.x - 0.5f) < 0.04f);  // the slider has steps
    QVERIFY(trial.environment().image == chosen.image);
    const Environment dimmed = trial.environment();
    trial.button("Remove image").click();
    QVERIFY(!trial.environment().image && trial.environment().radiance == dimmed.radiance);
    QVERIFY(trial.button("Remove image").isHidden());
    trial.document.undo();
    QVERIFY(trial.environment() == dimmed);
    trial.document.undo();
    trial.document.undo();
    QVERIFY(trial.environment() == chosen);
}

void TestSkyInWindow::aRigTakesItsPlace() {
    SkyTrial trial(at("series"));
    const double before = strengthOf(trial.panel.lighting());
    trial.choose(at("sky.exr"));
    trial.button("Sky").click();
    QVERIFY(!trial.environment().image && nameOf(trial.document.setup().look.rig) == NamedRig::sky);
    QVERIFY(std::abs(strengthOf(trial.panel.lighting()) / before - 1) < 1e-5);
    trial.document.undo();
    QVERIFY(trial.environment().image && trial.button("Environment image...").isChecked());
}

void TestSkyInWindow::itMayBeDropped() {
    SkyTrial trial(at("series"));
    emit trial.desktop.window().skyDropped(at("sky.exr"));
    QTRY_VERIFY_WITH_TIMEOUT(trial.environment().image, test::kPatience);
}

/// Files of looks hold no images; what is kept is as bright, and the window says so.
void TestSkyInWindow::aLookIsKeptWithoutIt() {
    SkyTrial trial(at("series"));
    trial.choose(at("sky.exr"));
    const Environment chosen = trial.environment();
    emit test::the<ui::LookPanel>(trial.desktop.window()).menu().saveWanted("mine");
    QVERIFY(!trial.environment().image && trial.environment().radiance == chosen.radiance);
    QVERIFY(trial.document.look() >= 0);
    QVERIFY(trial.desktop.window().message().text().contains("environment image"));
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestSkyInWindow)
#include "sky_in_window_test.moc"
