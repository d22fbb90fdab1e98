/// What the window's size does to the image: it has the screen's own pixels, is scaled while the size changes, and
/// nothing is rendered for a window that nobody sees, or for what is finished.

#include <QTest>

#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

class TestWindowSize : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void theImageHasTheScreensOwnPixels();
    void whatIsStretchedIsSaid();
    void aDragOfTheEdgeShowsTheImageAllTheWhile();
    void aHiddenWindowIsNotRenderedFor();
    void aFinishedImageHoldsAndGoesOnWithOneKey();
    void theKnobStopsRenderingAndGoesOn();
    void beforeTheFirstImageTheViewSaysWhatHappens();
    void aKeptWindowStaysOnTheScreen_data();
    void aKeptWindowStaysOnTheScreen();

  private:
    QTemporaryDir folder_;
    QString series_;
};

static std::uint64_t samplesOf(Trial& trial) {
    return trial.frames.back()->status.samplesPerPixel;
}

/// Opens a series and waits for some samples of the whole image.
static void openAndWait(Trial& trial, const QString& series) {
    trial.openAndWait(series);
    QTRY_VERIFY_WITH_TIMEOUT(samplesOf(trial) > 5, test::kPatience);
}

void TestWindowSize::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

/// On a screen with 1.5 physical pixels per logical one, too, the rendered pixels are painted unaltered.
void TestWindowSize::theImageHasTheScreensOwnPixels() {
    Trial trial;
    trial.desktop.window().resize(900, 500);  // so large that no text reaches the middle
    ui::Viewport& viewport = trial.desktop.window().viewport();
    QCOMPARE(viewport.devicePixelRatioF(), 1.5);
    trial.desktop.document().setDenoised(false);  // lines that smoothing takes away are marked
    openAndWait(trial, series_);
    QTest::keyClick(&viewport, Qt::Key_Space);
    (void)trial.heldSamples();
    const Frame& frame = *trial.frames.back();
    QCOMPARE(QSize(frame.size.x, frame.size.y), (QSizeF(viewport.size()) * 1.5).toSize());
    const QImage shown = viewport.grab().toImage();
    QCOMPARE(shown.size(), QSize(frame.size.x, frame.size.y));
    int lit = 0;
    for (int y = frame.size.y / 4; y < frame.size.y * 3 / 4; ++y)  // where nothing is written
        for (int x = frame.size.x / 4; x < frame.size.x * 3 / 4; ++x) {
            const std::uint8_t* rgba = &frame.rgba[4 * (std::size_t(y) * std::size_t(frame.size.x) + std::size_t(x))];
            QCOMPARE(shown.pixel(x, y), qRgb(rgba[0], rgba[1], rgba[2]));
            lit += rgba[0] > 60;
        }
    QVERIFY(lit > 100);
}

void TestWindowSize::whatIsStretchedIsSaid() {
    auto mishaps = std::make_shared<test::Mishaps>();
    mishaps->iterationSeconds = 0.05;
    Trial trial(test::failing(mishaps));
    trial.openAndWait(series_);
    QVERIFY(!trial.said().contains("stretched"));
    trial.desktop.document().setView(StandardView::left);
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->coarse, test::kPatience);
    const QSize view = trial.desktop.window().viewport().sizeInPixels();
    const QString text =
        QString::fromUtf8("%1 × %2 pixels stretched to %3 × %4")
            .arg(trial.frames.back()->size.x)
            .arg(trial.frames.back()->size.y)
            .arg(std::lround(double(view.height()) * trial.frames.back()->size.x / trial.frames.back()->size.y))
            .arg(view.height());
    QVERIFY2(trial.said().contains(text), qPrintable(trial.said()));
    trial.waitForNewest();
    QVERIFY(!trial.said().contains("stretched"));
}

void TestWindowSize::aDragOfTheEdgeShowsTheImageAllTheWhile() {
    Trial trial;
    openAndWait(trial, series_);
    Document& document = trial.desktop.document();
    ui::MainWindow& window = trial.desktop.window();
    const std::uint64_t revision = document.scene().revision, samples = samplesOf(trial);
    for (int i = 1; i <= 20; ++i) {
        window.resize(Trial::kWindowSize + QSize(10 * i, 0));
        QTest::qWait(5);
        const QImage shown = window.viewport().grab().toImage();
        const QImage middle = shown.copy(shown.width() / 3, shown.height() / 4, shown.width() / 3, shown.height() / 2);
        const QColor mean = middle.scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).pixelColor(0, 0);
        QVERIFY2(mean.lightness() > 15, qPrintable(QString::number(mean.lightness())));
    }
    QTest::qWait(400);
    QCOMPARE(document.scene().revision, revision);
    QVERIFY(samplesOf(trial) >= samples);
}

void TestWindowSize::aHiddenWindowIsNotRenderedFor() {
    auto mishaps = std::make_shared<test::Mishaps>();
    Trial trial(test::failing(mishaps));
    openAndWait(trial, series_);
    trial.desktop.document().setViewSize({60, 40});  // whose iterations are soon done
    const auto becomes = [&](bool rendered) {
        const auto seen = [&] {
            const int before = mishaps->accumulates;
            QTest::qWait(200);
            return (mishaps->accumulates != before) == rendered;
        };
        return QTest::qWaitFor(seen, test::kPatience);
    };
    QVERIFY(becomes(true));
    trial.desktop.window().hide();
    QVERIFY(becomes(false));
    trial.desktop.window().show();
    QVERIFY(becomes(true));
    trial.desktop.window().showMinimized();
    QVERIFY(becomes(false));
    trial.desktop.window().showNormal();
    QVERIFY(becomes(true));
    QVERIFY(!trial.desktop.bridge().paused());
}

void TestWindowSize::aFinishedImageHoldsAndGoesOnWithOneKey() {
    Trial trial;
    RenderBridge& bridge = trial.desktop.bridge();
    trial.openAndWait(series_);
    trial.desktop.document().setViewSize({12, 8});  // small and dark: finished soon
    trial.desktop.document().setBrightness(-4);
    bridge.setPace({.iterations = 100});
    QTRY_VERIFY_WITH_TIMEOUT(bridge.reached(), test::kPatience);
    QVERIFY2(trial.said().contains("target reached (Space: continue)"), qPrintable(trial.said()));
    QVERIFY(!bridge.paused());
    const std::uint64_t held = trial.heldSamples();
    QTest::qWait(200);
    QCOMPARE(samplesOf(trial), held);
    QTest::keyClick(&trial.desktop.window().viewport(), Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(samplesOf(trial) > held, test::kPatience);
    QVERIFY(!trial.said().contains("target reached"));
    QTest::keyClick(&trial.desktop.window().viewport(), Qt::Key_Space);
    QVERIFY(bridge.paused());  // now it is a pause
}

/// The target is kept for the next time; undo leaves it alone.
void TestWindowSize::theKnobStopsRenderingAndGoesOn() {
    Trial trial;
    RenderBridge& bridge = trial.desktop.bridge();
    ui::AccuracyStrip& strip = trial.desktop.window().accuracyStatus().strip();
    trial.openAndWait(series_);
    trial.desktop.document().setViewSize({12, 8});
    bridge.setPace({.iterations = 8});
    const auto reached = [&](double levels) {
        const Frame& frame = *trial.frames.back();
        return bridge.reached() && frame.stop.levels == levels && frame.status.displayError <= levels;
    };
    QTest::keyClick(&strip, Qt::Key_Home);
    QTRY_VERIFY_WITH_TIMEOUT(reached(32), test::kPatience);
    QVERIFY(trial.said().contains("target reached"));
    QTest::keyClick(&strip, Qt::Key_End);
    QTest::keyClick(&strip, Qt::Key_Left);
    QTRY_VERIFY_WITH_TIMEOUT(reached(2), test::kPatience);
    QCOMPARE(trial.desktop.settings().target(), 2.0);
    trial.desktop.document().undo();
    QCOMPARE(strip.target(), 2.0);
}

void TestWindowSize::beforeTheFirstImageTheViewSaysWhatHappens() {
    Trial trial;
    ui::Viewport& viewport = trial.desktop.window().viewport();
    QString said;
    QObject::connect(&trial.desktop.document(), &Document::sceneChanged, &viewport, [&] {
        if (said.isEmpty())  // the mask of bones makes a second scene
            said = viewport.message();
    });
    trial.openAndWait(series_);
    QCOMPARE(said, "Preparing CT series 1...");
    QVERIFY(viewport.message().isEmpty());
}

/// What QWidget::saveGeometry() says of a window at `place`.
static QByteArray geometryOf(QRect place, bool maximised) {
    QByteArray kept;
    QDataStream stream(&kept, QIODevice::WriteOnly);
    stream.setVersion(QDataStream::Qt_4_0);
    stream << quint32(0x1D9D0CB) << quint16(3) << quint16(0) << place << place << qint32(0) << quint8(maximised)
           << quint8(0) << qint32(QGuiApplication::primaryScreen()->geometry().width()) << place;
    return kept;
}

void TestWindowSize::aKeptWindowStaysOnTheScreen_data() {
    QTest::addColumn<QRect>("place");
    QTest::addColumn<bool>("maximised");
    QTest::newRow("too high") << QRect(10, 10, 551, 32767) << false;
    QTest::newRow("far too large") << QRect(0, 0, 1 << 24, 1 << 24) << false;
    QTest::newRow("too large behind a maximised one") << QRect(0, 0, 32767, 32767) << true;
    QTest::newRow("beside the screen") << QRect(100000, 100000, 600, 400) << false;
}

void TestWindowSize::aKeptWindowStaysOnTheScreen() {
    QFETCH(QRect, place);
    QFETCH(bool, maximised);
    QTemporaryDir folder;
    Settings(folder.filePath("settings.ini")).keepWindow(geometryOf(place, maximised), {});
    const QRect room = QGuiApplication::primaryScreen()->availableGeometry();
    {
        Desktop desktop(*bundledLooks(), makeCpuDevice(1), folder.filePath("settings.ini"), 1);
        const QWidget& window = desktop.window();
        const QSize least = window.minimumSizeHint();
        const auto fits = [&](QRect kept) {
            return kept.width() <= std::max(room.width(), least.width()) &&
                   kept.height() <= std::max(room.height(), least.height()) && kept.intersects(room);
        };
        QVERIFY2(fits(window.geometry()), qPrintable(QDebug::toString(window.geometry())));
        QVERIFY2(fits(window.normalGeometry()), qPrintable(QDebug::toString(window.normalGeometry())));
        QCOMPARE(window.isMaximized(), maximised);
    }
    Desktop again(*bundledLooks(), makeCpuDevice(1), folder.filePath("settings.ini"), 1);
    QVERIFY(again.window().normalGeometry().height() <=
            std::max(room.height(), again.window().minimumSizeHint().height()));
}

}  // namespace pdr::app

int main(int argc, char** argv) {
    qputenv("QT_SCALE_FACTOR", "1.5");
    QApplication application(argc, argv);
    pdr::app::TestWindowSize test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_size_test.moc"
