/// What the hand does to the window costs no sample: messages, panels and sizes leave the image as it is, one that is
/// held as well.

#include <QDockWidget>
#include <QTest>
#include <QToolButton>
#include <functional>

#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/looks/look_panel.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// Something that is done to the window, and undone or not.
struct WindowAction {
    const char* name;
    std::function<void(ui::MainWindow&)> act;
};

static void toggle(ui::MainWindow& window, const char* action) {
    window.findChild<QAction*>(action)->trigger();
}

static WindowAction panel(const char* name, const char* action) {
    return {name, [action](ui::MainWindow& window) { toggle(window, action); }};
}

/// Returns actions each of which used to change the image's size.
static std::vector<WindowAction> windowActions() {
    using Window = ui::MainWindow;
    return {
        {"a message comes", [](Window& window) { window.message().showNotice("one\ntwo\nthree"); }},
        {"Esc closes it", [](Window& window) { QTest::keyClick(&window, Qt::Key_Escape); }},
        panel("accuracy opens", "AccuracyPanel"),
        panel("accuracy closes", "AccuracyPanel"),
        panel("series", "SeriesPanel"),
        panel("appearance closes", "LookPanel"),
        panel("appearance opens", "LookPanel"),
        panel("rendering", "RenderingPanel"),
        panel("tissue", "TissuePanel"),
        panel("light takes the place of tissue", "LightPanel"),
        panel("camera", "CameraPanel"),
        panel("cut", "CutPanel"),
        panel("cut closes", "CutPanel"),
        panel("the side bar closes", "sideBarPanel"),
        panel("the side bar opens", "sideBarPanel"),
        panel("effects", "EffectsPanel"),
        panel("nodes", "NodesPanel"),
        panel("nodes close", "NodesPanel"),
        panel("full screen", "alone"),
        panel("a window again", "alone"),
        {"wider", [](Window& window) { window.resize(1300, 700); }},
        {"narrower", [](Window& window) { window.resize(860, 640); }},
        {"as before", [](Window& window) { window.resize(Trial::kWindowSize); }},
        {"the side bar at the other side",
         [](Window& window) {
             window.addDockWidget(Qt::LeftDockWidgetArea, window.findChild<QDockWidget*>("sideBar"));
         }},
        {"and back",
         [](Window& window) {
             window.addDockWidget(Qt::RightDockWidgetArea, window.findChild<QDockWidget*>("sideBar"));
         }},
        {"groups of looks fold",
         [](Window& window) {
             for (QToolButton* heading : test::the<ui::LookPanel>(window).findChildren<QToolButton*>())
                 if (heading->accessibleName().startsWith("Looks: "))
                     heading->click();
         }},
        panel("no name", "hideName"),
        panel("the name again", "hideName"),
    };
}

class TestKeptImage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void noWindowActionCostsASample_data();
    void noWindowActionCostsASample();
    void panelsNeverStretchTheImage();
    void theNextEditFillsTheView();
    void theImageIsFittedToTheViewWhenThatIsAskedFor();

  private:
    QTemporaryDir folder_;
    QString series_;
};

void TestKeptImage::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

static const Frame& last(const Trial& trial) {
    return *trial.frames.back();
}

void TestKeptImage::noWindowActionCostsASample_data() {
    QTest::addColumn<bool>("held");
    QTest::newRow("rendering") << false;
    QTest::newRow("held") << true;
}

/// The size is settled after 0.2 s.
void TestKeptImage::noWindowActionCostsASample() {
    QFETCH(bool, held);
    Trial trial(makeCpuDevice(1), *bundledLooks());
    trial.openAndWait(series_);
    QTRY_VERIFY_WITH_TIMEOUT(last(trial).status.samplesPerPixel > 5, test::kPatience);
    ui::MainWindow& window = trial.desktop.window();
    RenderBridge& bridge = trial.desktop.bridge();
    if (held) {
        bridge.setPaused(true);
        (void)trial.heldSamples();
    }
    const Scene& scene = trial.desktop.document().scene();
    std::uint64_t revision = scene.revision;
    ivec2 size = last(trial).size;
    std::uint64_t samples = last(trial).status.samplesPerPixel;
    QStringList lost;
    for (const WindowAction& action : windowActions()) {
        action.act(window);
        QTest::qWait(400);
        const Frame& frame = last(trial);
        const std::uint64_t now = frame.status.samplesPerPixel;
        if (scene.revision != revision || frame.revision != revision || frame.size != size || frame.coarse ||
            now < samples || (held && now != samples))
            lost << QString("%1: %2 samples, then %3").arg(action.name).arg(samples).arg(now);
        samples = now;
        size = frame.size;
        revision = scene.revision;
    }
    QVERIFY2(lost.isEmpty(), qPrintable(lost.join("; ")));
    QCOMPARE(bridge.paused(), held);
}

/// The view keeps its size, so that image and screen agree pixel by pixel, and no sample is lost.
void TestKeptImage::panelsNeverStretchTheImage() {
    Trial trial;
    ui::MainWindow& window = trial.desktop.window();
    window.resize(1366, 768);
    trial.openAndWait(series_);
    const Document& document = trial.desktop.document();
    const QSize view = window.viewport().sizeInPixels();
    QCOMPARE(view, QSize(document.scene().film.x, document.scene().film.y));
    std::uint64_t samples = last(trial).status.samplesPerPixel;
    const std::uint64_t revision = last(trial).revision;
    const char* const names[] = {"TissuePanel", "LightPanel", "CameraPanel", "RenderingPanel", "LookPanel"};
    for (int i = 0; i < 20; ++i) {
        toggle(window, names[i % std::size(names)]);
        QTest::qWait(50);
        QCOMPARE(window.viewport().sizeInPixels(), view);
        QCOMPARE(last(trial).revision, revision);
        QVERIFY(last(trial).status.samplesPerPixel >= samples);
        samples = last(trial).status.samplesPerPixel;
    }
}

/// An image that begins anew has the view's own pixels.
void TestKeptImage::theNextEditFillsTheView() {
    Trial trial;
    trial.openAndWait(series_);
    ui::MainWindow& window = trial.desktop.window();
    Document& document = trial.desktop.document();
    const ivec2 before = document.scene().film;
    window.resize(1000, 640);
    QTest::qWait(400);
    QVERIFY(document.scene().film == before);
    document.setBrightness(1);  // changes what is shown, not what is computed
    QVERIFY(document.scene().film == before);
    document.undo();
    QVERIFY(document.scene().film == before);
    document.setView(StandardView::left);
    const QSize view = window.viewport().sizeInPixels();
    QVERIFY(document.scene().film == ivec2(view.width(), view.height()));
}

void TestKeptImage::theImageIsFittedToTheViewWhenThatIsAskedFor() {
    Trial trial;
    trial.openAndWait(series_);
    ui::MainWindow& window = trial.desktop.window();
    window.resize(1000, 640);
    QTest::qWait(400);
    QAction* fit = window.findChild<QAction*>("fitImage");
    QVERIFY(fit);
    fit->trigger();
    const QSize view = window.viewport().sizeInPixels();
    QVERIFY(trial.desktop.document().scene().film == ivec2(view.width(), view.height()));
    trial.waitForNewest();
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestKeptImage)
#include "kept_image_test.moc"
