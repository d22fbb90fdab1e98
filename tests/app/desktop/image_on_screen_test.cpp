/// The image on the screen: its letters are its own, what is saved is what was seen, and what is closed is gone.

#include <QDir>
#include <QElapsedTimer>
#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <functional>
#include <initializer_list>
#include <utility>

#include "app/presenters/saving_presenter.h"
#include "app/presenters/series_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/the.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/series/series_panel.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// A device that takes a while for each iteration, so that a test can look between an edit and its image.
static std::shared_ptr<test::Mishaps> slow(double secondsPerIteration) {
    auto mishaps = std::make_shared<test::Mishaps>();
    mishaps->iterationSeconds = secondsPerIteration;
    return mishaps;
}

/// The strip on the left and the corner of the cube, as they stand on the screen.
static QImage margins(Trial& trial) {
    QImage shown = trial.desktop.window().viewport().grab().toImage();
    QImage strips(shown.width(), 100, QImage::Format_RGB32);
    QPainter painter(&strips);
    painter.drawImage(0, 0, shown, 0, shown.height() / 2 - 50);
    painter.drawImage(shown.width() - 100, 0, shown, shown.width() - 100, shown.height() - 100);
    return strips;
}

static QAction* saveAction(Trial& trial) {
    for (QAction* action : trial.desktop.window().findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(QKeySequence::Save))
            return action;
    return nullptr;
}

class TestImageOnScreen : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void anEditNamesNothingNewBeforeItsImageIsThere();
    void theLettersAreThoseOfTheFrame();
    void whatIsSavedIsWhatWasSeen();
    void aSavedImageSaysWhatItShowsUnlessItIsToldNotTo();
    void whatTheLastImageTookIsToldUntilThisOneKnows();
    void afterAFailureNothingStaysUpAndSavingSaysSo();
    void aFailureAnswersTheSaveThatWaits();
    void closingAnswersTheSaveThatWaits();
    void aClosedPatientIsFreedAndNotRenderedOn();
    void whileAMaskIsMadeAPatientIsClosedAndFreed();
    void anotherSeriesClosesTheFirstBeforeItIsRead();

  private:
    QTemporaryDir folder_;
    QString series_;
};

void TestImageOnScreen::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

void TestImageOnScreen::anEditNamesNothingNewBeforeItsImageIsThere() {
    Trial trial(test::failing(slow(0.05)));
    trial.openAndWait(series_);
    Document& document = trial.desktop.document();
    ui::MainWindow& window = trial.desktop.window();
    const std::initializer_list<std::pair<const char*, std::function<void()>>> edits{
        {"view", [&] { document.setView(StandardView::posterior); }},
        {"reset", [&] { window.menuActions().firstView->trigger(); }},
        {"undo", [&] { document.undo(); }},
        {"redo", [&] { document.redo(); }},
        {"look", [&] { document.chooseLook(1); }},
        {"estimator", [&] { document.setEstimator(Estimator::kroesMarch); }},
        {"turned", [&] { QTest::keyClick(&window.viewport(), Qt::Key_Right); }}};
    for (const auto& [name, edit] : edits) {
        document.setView(StandardView::left);
        document.setView(StandardView::superior);
        document.undo();
        trial.waitForNewest();
        const QImage before = margins(trial);
        const QString status = trial.said();
        edit();
        QVERIFY2(margins(trial) == before, name);
        emit trial.desktop.bridge().pausedChanged(false);  // the status is written anew
        QVERIFY2(trial.said() == status, name);
    }
}

/// The letters belong to the frame for every frame that is shown, while the user makes all kinds of edits faster than
/// the device renders.
void TestImageOnScreen::theLettersAreThoseOfTheFrame() {
    Trial trial(test::failing(slow(0.02)));
    trial.openAndWait(series_);
    Document& document = trial.desktop.document();
    ui::Viewport& viewport = trial.desktop.window().viewport();
    std::size_t compared = 0;
    const auto compare = [&] {
        const auto& frame = trial.desktop.bridge().lastFrame();
        const EdgeLetters painted = viewport.letters(), right = ui::edgeLetters(frame->camera);
        QVERIFY(painted.left == right.left && painted.right == right.right);
        QVERIFY(painted.top == right.top && painted.bottom == right.bottom);
        compared += frame->revision == document.scene().revision;
    };
    const auto wait = [&](int ms) {
        QElapsedTimer timer;
        for (timer.start(); timer.elapsed() < ms; QTest::qWait(5))
            compare();
    };
    int look = 0;
    for (const StandardView view : {StandardView::posterior, StandardView::left, StandardView::superior}) {
        document.setView(view);
        wait(60);
        QTest::keyClick(&viewport, Qt::Key_Right);
        wait(30);
        document.chooseLook(++look % 2);
        wait(100);
        document.undo();
        trial.waitForNewest();
        const std::size_t before = compared;
        compare();
        QCOMPARE(compared, before + 1);
    }
    for (const auto& frame : trial.frames)
        QCOMPARE(QString::fromStdString(frame->lookName).isEmpty(), false);
}

void TestImageOnScreen::whatIsSavedIsWhatWasSeen() {
    Trial trial(test::failing(slow(0.2)));
    trial.openAndWait(series_);
    QSignalSpy saved(&trial.desktop.presenter<SavingPresenter>().saver(), &ImageSaver::saved);
    const QString file = trial.folder.filePath("front.png");
    trial.desktop.presenter<SavingPresenter>().save(file, ui::Annotate::sides);
    trial.desktop.document().setView(StandardView::posterior);
    trial.waitForNewest();
    const auto frames = trial.frames.size();
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.size() > frames + 1, test::kPatience);
    const QString text = trial.desktop.window().message().text();
    QVERIFY2(saved.count() == 0 && !QFile::exists(file), "a back view was saved as front.png");
    QVERIFY2(text.contains("Not saved, because") && text.contains("front.png"), qPrintable(text));
}

/// Corners of what is saved.
void TestImageOnScreen::aSavedImageSaysWhatItShowsUnlessItIsToldNotTo() {
    Trial trial;
    trial.openAndWait(series_);
    ui::MainWindow& window = trial.desktop.window();
    window.menuActions().pause->trigger();
    QSignalSpy saved(&trial.desktop.presenter<SavingPresenter>().saver(), &ImageSaver::saved);
    const auto image = [&](ui::Annotate annotate) {
        const int before = saved.count();
        trial.desktop.presenter<SavingPresenter>().save(trial.folder.filePath("picture.png"), annotate);
        [&] { QTRY_COMPARE_WITH_TIMEOUT(saved.count(), before + 1, test::kPatience); }();
        return QImage(trial.folder.filePath("picture.png"));
    };
    const QImage plain = image(ui::Annotate::none), captioned = image(ui::Annotate::sides),
                 named = image(ui::Annotate::patient);
    QCOMPARE(captioned.size(), plain.size());
    const int w = plain.width() / 3, h = plain.height() / 3;
    const QRect who(0, 0, w, h), what(0, 2 * h, w, h), cube(2 * w, 2 * h, w, h), middle(w, h, w, h);
    QVERIFY(plain.copy(what) != captioned.copy(what) && plain.copy(cube) != captioned.copy(cube));
    QVERIFY(plain.copy(middle) == captioned.copy(middle) && plain.copy(who) == captioned.copy(who));
    QVERIFY(named.copy(who) != captioned.copy(who) && named.copy(what) == captioned.copy(what));
    QCOMPARE(captioned.text("pdrender/device"), QString("cpu"));
    QCOMPARE(captioned.text("pdrender/bias"), QString("none known"));
    QVERIFY(captioned.text("pdrender/camera").contains("perspective"));
    QVERIFY(captioned.text("pdrender/effects").contains("shadows"));
    QVERIFY(!captioned.text("pdrender/look").isEmpty());
    window.menuActions().captioned->trigger();
    QVERIFY(!Settings(trial.folder.filePath("settings.ini")).captioned());
}

void TestImageOnScreen::whatTheLastImageTookIsToldUntilThisOneKnows() {
    Trial trial(test::failing(slow(0.2)));
    trial.desktop.document().setDenoised(false);  // noisy images know their error after 32 samples, 6 s here
    trial.openAndWait(series_);
    QVERIFY(trial.frames.back()->steps.empty());
    QVERIFY(!trial.said().contains("the last time"));
    const Frame& frame = *trial.frames.back();
    const QSize view = trial.desktop.window().viewport().sizeInPixels();
    trial.desktop.settings().keepPlanningSeconds(QString::fromStdString(frame.device + "/" + frame.lookName),
                                                 90.0 / (view.width() * view.height()));
    trial.desktop.window().menuActions().pause->trigger();
    QVERIFY2(trial.said().contains(QString::fromUtf8("±8 took 1.5 min the last time")), qPrintable(trial.said()));
}

/// A scene that cannot be rendered.
static void fail(Trial& trial) {
    Camera camera = trial.desktop.document().scene().camera;
    camera.apertureMm = -1;
    trial.desktop.document().setCamera(camera, false);
}

void TestImageOnScreen::afterAFailureNothingStaysUpAndSavingSaysSo() {
    Trial trial;
    trial.openAndWait(series_);
    const auto bright = [&] {
        const QImage shown = trial.desktop.window().viewport().grab().toImage();
        return shown.pixelColor(shown.width() / 2, shown.height() / 2).lightness() > 40 ||
               shown.pixelColor(shown.width() / 2, shown.height() / 3).lightness() > 40;
    };
    QVERIFY(bright());
    QVERIFY(saveAction(trial)->isEnabled());
    fail(trial);
    QTRY_VERIFY_WITH_TIMEOUT(trial.desktop.window().message().text().contains("camera.apertureMm"), test::kPatience);
    QVERIFY(!saveAction(trial)->isEnabled());
    const QImage shown = trial.desktop.window().viewport().grab().toImage();
    QCOMPARE(shown.pixelColor(shown.width() / 2, shown.height() / 3), QColor(Qt::black));
    QVERIFY(trial.said().isEmpty());

    QSignalSpy failed(&trial.desktop.presenter<SavingPresenter>().saver(), &ImageSaver::failed);
    trial.desktop.presenter<SavingPresenter>().save(trial.folder.filePath("none.png"), ui::Annotate::sides);
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, test::kPatience);
    QVERIFY(trial.desktop.window().message().text().contains("Not saved, because"));

    trial.desktop.document().undo();
    trial.waitForNewest();
    QTRY_VERIFY_WITH_TIMEOUT(saveAction(trial)->isEnabled(), test::kPatience);
}

void TestImageOnScreen::aFailureAnswersTheSaveThatWaits() {
    Trial trial(test::failing(slow(0.2)));
    trial.openAndWait(series_);
    QSignalSpy saved(&trial.desktop.presenter<SavingPresenter>().saver(), &ImageSaver::saved);
    QSignalSpy failed(&trial.desktop.presenter<SavingPresenter>().saver(), &ImageSaver::failed);
    trial.desktop.presenter<SavingPresenter>().save(trial.folder.filePath("front.png"), ui::Annotate::sides);
    fail(trial);
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, test::kPatience);
    trial.desktop.document().undo();
    trial.waitForNewest();
    QCOMPARE(saved.count(), 0);
}

void TestImageOnScreen::closingAnswersTheSaveThatWaits() {
    Trial trial(test::failing(slow(0.2)));
    trial.openAndWait(series_);
    QSignalSpy saved(&trial.desktop.presenter<SavingPresenter>().saver(), &ImageSaver::saved);
    QSignalSpy failed(&trial.desktop.presenter<SavingPresenter>().saver(), &ImageSaver::failed);
    trial.desktop.presenter<SavingPresenter>().save(trial.folder.filePath("first_patient.png"), ui::Annotate::sides);
    trial.desktop.presenter<SeriesPresenter>().close();
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, test::kPatience);
    trial.frames.clear();
    trial.openAndWait(series_);
    QTest::qWait(300);
    QCOMPARE(saved.count(), 0);
    QVERIFY(!QFile::exists(trial.folder.filePath("first_patient.png")));
}

void TestImageOnScreen::aClosedPatientIsFreedAndNotRenderedOn() {
    auto mishaps = std::make_shared<test::Mishaps>();
    Trial trial(test::failing(mishaps));
    trial.openAndWait(series_);
    trial.desktop.document().chooseLook(1);  // it is in the steps to undo, too
    trial.waitForNewest();
    const std::weak_ptr<const Volume> volume = trial.desktop.document().scene().volume;
    QVERIFY(!volume.expired());
    trial.desktop.presenter<SeriesPresenter>().close();
    QTRY_VERIFY_WITH_TIMEOUT(volume.expired(), test::kPatience);
    const int iterations = mishaps->accumulates;
    QTest::qWait(300);
    QCOMPARE(mishaps->accumulates.load(), iterations);
    trial.frames.clear();
    trial.openAndWait(series_);  // and what is opened next is shown
}

/// A mask that is not wanted any more gives back what is visible, which is an edit of its own.
void TestImageOnScreen::whileAMaskIsMadeAPatientIsClosedAndFreed() {
    Trial trial;
    trial.openAndWait(series_);
    Document& document = trial.desktop.document();
    const std::weak_ptr<const Volume> volume = document.scene().volume;
    Visible peeled;
    peeled.peelMm = 5;
    document.setVisible(peeled);
    trial.desktop.presenter<SeriesPresenter>().close();
    QTRY_VERIFY_WITH_TIMEOUT(volume.expired(), test::kPatience);
}

void TestImageOnScreen::anotherSeriesClosesTheFirstBeforeItIsRead() {
    Trial trial;
    trial.openAndWait(series_);
    const std::weak_ptr<const Volume> volume = trial.desktop.document().scene().volume;
    bool freed = false;
    QObject::connect(&trial.desktop.presenter<SeriesPresenter>().import(), &ImportJob::loaded,
                     [&] { freed = volume.expired(); });
    trial.frames.clear();
    emit test::the<ui::SeriesPanel>(trial.desktop.window()).seriesChosen(0);
    QVERIFY(!trial.desktop.document().hasVolume());
    QCOMPARE(test::the<ui::SeriesPanel>(trial.desktop.window()).patient(), QString());
    QTRY_VERIFY_WITH_TIMEOUT(!trial.frames.empty(), test::kPatience);
    QVERIFY(freed);
    QVERIFY(!test::the<ui::SeriesPanel>(trial.desktop.window()).patient().isEmpty());
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestImageOnScreen)
#include "image_on_screen_test.moc"
