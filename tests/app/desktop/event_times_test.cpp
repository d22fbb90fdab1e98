/// The window answers at once: its thread is never busy for long with one event, whatever is loaded, rendered or
/// edited. Counted is the processor time of that thread alone, so a busy machine changes nothing.

#include <QSlider>
#include <QTest>
#include <cmath>

#include "app/presenters/tissue_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/event_times.h"
#include "tests/support/desktop/the.h"
#include "tests/support/desktop/tissue_hand.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/dicom/shared_data.h"
#include "tests/support/scenes/sky_file.h"
#include "ui/light/light_panel.h"
#include "ui/looks/look_panel.h"
#include "ui/text/to_qt.h"
#include "ui/theme/theme.h"

namespace pdr::app {

constexpr double kFrameMs = 16;  ///< time of a frame on a screen with 60 frames per second
constexpr double kNoticedMs = 200;
#ifdef __SANITIZE_ADDRESS__
constexpr bool kTimed = false;  ///< times of an instrumented program say nothing of the program
#else
constexpr bool kTimed = true;
#endif

class TestEventTimes : public QObject {
    Q_OBJECT

  private slots:
    void loadingRenderingAndEditing_data();
    void loadingRenderingAndEditing();
};

static test::TimedApplication& application() {
    return *static_cast<test::TimedApplication*>(qApp);
}

static void check(const char* during) {
    const test::TimedApplication& app = application();
    QVERIFY2(!app.times.empty(), during);
    const double p99 = app.at(0.99, &test::EventTime::processorMs), most = app.at(1, &test::EventTime::processorMs);
    qInfo("%s: %zu events, processor time p50 %.2f ms, p99 %.2f ms, most %.2f ms", during, app.times.size(),
          app.at(0.5, &test::EventTime::processorMs), p99, most);
    QVERIFY2(!kTimed || p99 <= kFrameMs, (during + (": \n" + app.longest(8))).c_str());
    QVERIFY2(!kTimed || most <= kNoticedMs, (during + (": \n" + app.longest(8))).c_str());
    application().times.clear();
}

void TestEventTimes::loadingRenderingAndEditing_data() {
    QTest::addColumn<bool>("real");
    QTest::newRow("a phantom") << false;
    QTest::newRow("a chest") << true;
}

void TestEventTimes::loadingRenderingAndEditing() {
    QFETCH(bool, real);
    QTemporaryDir folder;
    QString series = folder.filePath("series");
    if (real) {
        PDR_NEEDS_SHARED_CT();
        series = ui::toQt(test::sharedCt() / "chest_contrast");
    } else {
        QVERIFY(writePhantomSeries(ui::fromQt(series), "Head of a phantom"));
    }
    Trial trial(makeCpuDevice(1), *bundledLooks());
    ui::MainWindow& window = trial.desktop.window();
    window.resize(1000, 700);
    application().times.clear();

    trial.openAndWait(series);
    check("loading");

    const std::size_t shown = trial.frames.size();
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.size() > shown, test::kPatience);
    check("rendering");

    const QPoint middle = window.viewport().rect().center();
    QTest::mousePress(&window.viewport(), Qt::LeftButton, {}, middle);
    for (int i = 0; i < 60; ++i) {
        const QPoint to = middle + QPoint(int(150 * std::sin(0.1 * i)), 0);
        QCoreApplication::postEvent(
            &window.viewport(), new QMouseEvent(QEvent::MouseMove, to, window.viewport().mapToGlobal(to), Qt::NoButton,
                                                Qt::LeftButton, {}));
        QTest::qWait(8);
    }
    QTest::mouseRelease(&window.viewport(), Qt::LeftButton, {}, middle);
    check("turning");

    auto* slider = test::the<ui::LookPanel>(window).findChild<QSlider*>();
    for (int i = 0; i < 60; ++i) {
        QMetaObject::invokeMethod(
            slider, [slider, i] { slider->setValue(i % 20); }, Qt::QueuedConnection);
        QTest::qWait(8);
    }
    check("brightening");

    for (int i = 0; i < 30; ++i) {
        const auto edit = [&, i] {
            emit trial.desktop.presenter<TissuePresenter>().dragTool().dragged({0.001 * i, 0}, {}, i < 29);
        };
        QMetaObject::invokeMethod(&window, edit, Qt::QueuedConnection);
        QTest::qWait(8);
    }
    check("editing the tissue");

    const QString sky = folder.filePath("sky.exr");
    test::writeSky(ui::fromQt(sky), {2048, 1024}, [](int x, int y) { return vec3(float(x % 7), float(y), 1); });
    application().times.clear();
    QMetaObject::invokeMethod(
        &window, [&] { emit test::the<ui::LightPanel>(window).skyChosen(sky); }, Qt::QueuedConnection);
    QTRY_VERIFY_WITH_TIMEOUT(trial.desktop.document().setup().look.environment.image, test::kPatience);
    trial.waitForNewest();
    check("lighting by a picture");

    for (const int key : {Qt::Key_F5, Qt::Key_2, Qt::Key_T, Qt::Key_E, Qt::Key_F6, Qt::Key_F11, Qt::Key_Escape}) {
        QCoreApplication::postEvent(&window.viewport(), new QKeyEvent(QEvent::KeyPress, key, {}));
        QTest::qWait(300);
    }
    QMetaObject::invokeMethod(
        &window, [&] { ui::applyTheme(*qApp, ui::ThemeChoice::light); }, Qt::QueuedConnection);
    QTest::qWait(300);
    qInfo("panels, views and colours: most\n%s", application().longest(5).c_str());
}

}  // namespace pdr::app

int main(int argc, char** argv) {
    pdr::test::TimedApplication application(argc, argv);
    pdr::ui::applyTheme(application, pdr::ui::ThemeChoice::dark);
    pdr::app::TestEventTimes test;
    return QTest::qExec(&test, argc, argv);
}

#include "event_times_test.moc"
