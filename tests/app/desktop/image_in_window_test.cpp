/// The image in the window: look, brightness, denoising, error map and the error under the pointer.

#include <QHelpEvent>
#include <QTemporaryDir>
#include <QTest>
#include <QToolTip>
#include <cmath>

#include "render/film/levels_text.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/looks/look_panel.h"
#include "ui/text/language.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

class TestImageInWindow : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void aLookChangesTheImage();
    void brightnessWorksWithoutARestart();
    void aDenoisedImageIsMarkedAndOneKeyShowsTheRawOne();
    void linesThatSmoothingTookAwayAreMarkedInTheDenoisedImageAlone();
    void oneKeyShowsWhereTheImageIsStillRough();
    void whereTheMouseRestsItIsSaidHowGoodTheImageIsThere();

  private:
    QTemporaryDir folder_;
    QString series_;
};

void TestImageInWindow::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

void TestImageInWindow::aLookChangesTheImage() {
    Trial trial;
    trial.openAndWait(series_);
    // The mean colour of the image: after some samples its noise is far below a display level.
    const auto colour = [&] {
        trial.waitForNewest();
        if (!QTest::qWaitFor([&] { return trial.frames.back()->status.samplesPerPixel >= 8; }, test::kPatience))
            return dvec3(0);
        const auto& rgba = trial.frames.back()->rgba;
        dvec3 sum(0);
        for (std::size_t i = 0; i < rgba.size(); i += 4)
            sum += dvec3(rgba[i], rgba[i + 1], rgba[i + 2]);
        return sum / (double(rgba.size()) / 4);
    };
    const dvec3 bone = colour();
    Document& document = trial.desktop.document();
    document.chooseLook(int(document.looks().fitted().size()) - 1);
    const double change = glm::length(colour() - bone);
    QVERIFY2(glm::length(bone) > 0 && change > 1,
             qPrintable(QString("skin instead of bone changes %1 levels").arg(change)));
}

void TestImageInWindow::brightnessWorksWithoutARestart() {
    Trial trial;
    trial.openAndWait(series_);
    const auto light = [&] {
        double sum = 0;
        const auto& rgba = trial.frames.back()->rgba;
        for (std::size_t i = 0; i < rgba.size(); i += 4)
            sum += rgba[i] + rgba[i + 1] + rgba[i + 2];
        return sum;
    };
    const double before = light();
    const std::uint64_t samples = trial.frames.back()->status.samplesPerPixel;
    const std::uint64_t revision = trial.frames.back()->revision;
    test::the<ui::LookPanel>(trial.desktop.window()).findChild<QSlider*>()->setValue(20);
    QTRY_VERIFY_WITH_TIMEOUT(light() > 1.2 * before, test::kPatience);
    QCOMPARE(trial.frames.back()->revision, revision);
    QVERIFY(trial.frames.back()->status.samplesPerPixel >= samples);
}

void TestImageInWindow::aDenoisedImageIsMarkedAndOneKeyShowsTheRawOne() {
    Trial trial;
    trial.openAndWait(series_);
    QTRY_VERIFY_WITH_TIMEOUT(trial.said().contains(QString::fromUtf8("Denoised, image error ±")), test::kPatience);
    const auto number = [&] {
        return QString::fromUtf8("Denoised, image error ±%1 of 255 grey levels (95 % of the tissue)")
            .arg(ui::localNumber(levelsText(trial.frames.back()->denoisedError->levelsAtMost)));
    };
    QTRY_VERIFY2_WITH_TIMEOUT(trial.said().contains(number()), qPrintable(trial.said()), test::kPatience);
    QVERIFY2(!trial.said().contains("No known systematic error"), qPrintable(trial.said()));
    const std::uint64_t revision = trial.frames.back()->revision;
    QTest::keyClick(&trial.desktop.window().viewport(), Qt::Key_S);
    QTRY_VERIFY_WITH_TIMEOUT(!trial.frames.back()->denoised, test::kPatience);
    QVERIFY2(!trial.said().contains("Denoised, "), qPrintable(trial.said()));
    QVERIFY2(trial.said().contains("No known systematic error"), qPrintable(trial.said()));
    QCOMPARE(trial.frames.back()->revision, revision);
}

void TestImageInWindow::linesThatSmoothingTookAwayAreMarkedInTheDenoisedImageAlone() {
    Trial trial;
    trial.openAndWait(series_);
    const auto shown = [&](bool denoised, bool marked) {
        auto frame = std::make_shared<Frame>(*trial.frames.back());
        frame->rgba.assign(frame->rgba.size(), 0);
        frame->denoised = denoised;
        frame->errorMap = std::make_shared<const LevelErrorMap>(
            LevelErrorMap{frame->size, std::vector<std::uint8_t>(frame->rgba.size() / 4, kNoTissueBin)});
        frame->lostLines.clear();  // the frame before is one of these
        if (marked)
            frame->lostLines = {{.begin = vec2(20, 30), .end = vec2(60, 40), .darker = true}};
        emit trial.desktop.bridge().frameReady(frame);
        return trial.desktop.window().viewport().grab().toImage();
    };
    const QRect aboveWords(0, 0, 900, 200);
    QVERIFY(shown(true, true).copy(aboveWords) != shown(true, false).copy(aboveWords));
    QVERIFY(shown(false, true).copy(aboveWords) == shown(false, false).copy(aboveWords));
}

/// The error map is available while rendering is paused, too.
void TestImageInWindow::oneKeyShowsWhereTheImageIsStillRough() {
    Trial trial;
    trial.openAndWait(series_);
    ui::Viewport& viewport = trial.desktop.window().viewport();
    QVERIFY(!trial.frames.back()->errorMap);
    trial.desktop.bridge().setPaused(true);
    const std::uint64_t samples = trial.heldSamples();
    const QImage before = viewport.grab().toImage();
    QTest::keyClick(&viewport, Qt::Key_E);
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->errorMap, test::kPatience);
    QCOMPARE(trial.frames.back()->status.samplesPerPixel, samples);
    QVERIFY(viewport.grab().toImage() != before);
    QTest::keyClick(&viewport, Qt::Key_E);
    QTRY_VERIFY_WITH_TIMEOUT(!trial.frames.back()->errorMap, test::kPatience);
    QVERIFY(viewport.grab().toImage() == before);
}

/// The tip is available while rendering is paused, too; its millimetre is measured in the camera's plane of focus.
void TestImageInWindow::whereTheMouseRestsItIsSaidHowGoodTheImageIsThere() {
    Trial trial;
    trial.openAndWait(series_);
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->status.samplesPerPixel >= kSamplesToEstimate, test::kPatience);
    RenderBridge& bridge = trial.desktop.bridge();
    bridge.setPaused(true);
    trial.heldSamples();
    std::vector<LevelErrorsAt> found;
    connect(&bridge, &RenderBridge::errorFound, [&](QPointF, const LevelErrorsAt& errors) { found.push_back(errors); });
    ui::Viewport& viewport = trial.desktop.window().viewport();
    const QPoint middle = viewport.rect().center();
    QHelpEvent rest(QEvent::ToolTip, middle, viewport.mapToGlobal(middle));
    QCoreApplication::sendEvent(&viewport, &rest);
    QTRY_COMPARE_WITH_TIMEOUT(found.size(), std::size_t(1), test::kPatience);
    const Frame& frame = *trial.frames.back();
    QCOMPARE(found[0].side, int(std::lround(frame.size.y / frame.camera.heightInFocusMm())));
    QVERIFY(found[0].tissue && found[0].here > 0 && found[0].over <= found[0].here);
    QVERIFY2(QToolTip::text().startsWith(QString::fromUtf8("This pixel ±")), qPrintable(QToolTip::text()));
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestImageInWindow)
#include "image_in_window_test.moc"
