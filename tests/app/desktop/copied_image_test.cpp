/// What Ctrl+C puts on the clipboard is what is on the screen, and says what it is worth.

#include <QClipboard>
#include <QLineEdit>
#include <QMimeData>
#include <QTest>

#include <algorithm>

#include "app/presenters/annotating.h"
#include "app/presenters/clipboard_image.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/text/accuracy_text.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

class TestCopiedImage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init() { QGuiApplication::clipboard()->clear(); }
    void theCopyIsTheImageOnTheScreen();
    void anUnfinishedCopySaysSoUnlessItIsToldNotTo();
    void aFinishedCopySaysNothingOfThat();
    void aCoarseImageIsCopiedAtFullSize();
    void skinIsSpokenOfOnceForEachScanAndNoFace();
    void whatSelectsTextCopiesText();
    void withoutAnImageTheClipboardStays();

  private:
    QTemporaryDir folder_;
    QString series_;
};

/// The image on the clipboard after the key.
static QImage copied(Trial& trial) {
    QTest::keyClick(&trial.desktop.window(), Qt::Key_C, Qt::ControlModifier);
    return QGuiApplication::clipboard()->image();
}

static std::vector<std::uint8_t> bytesOf(const QImage& image) {
    const QImage plain = image.convertToFormat(QImage::Format_RGBX8888);
    return {plain.constBits(), plain.constBits() + plain.sizeInBytes()};
}

/// An image whose rendering holds, so that it stays the one on the screen.
static const Frame& heldFrame(Trial& trial) {
    trial.desktop.bridge().setPaused(true);
    trial.heldSamples();
    return *trial.desktop.bridge().lastFrame();
}

void TestCopiedImage::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

void TestCopiedImage::theCopyIsTheImageOnTheScreen() {
    Trial trial;
    trial.openAndWait(series_);
    trial.desktop.window().menuActions().captioned->trigger();
    const Frame& frame = heldFrame(trial);
    const QImage image = copied(trial);
    QCOMPARE(image.size(), trial.desktop.window().viewport().sizeInPixels());
    QVERIFY(bytesOf(image) == frame.rgba);
    QVERIFY(image.textKeys().isEmpty());
    QVERIFY2(!QGuiApplication::clipboard()->mimeData()->hasText(), "words go with the picture");
    QVERIFY(trial.said().contains("Copied"));
}

void TestCopiedImage::anUnfinishedCopySaysSoUnlessItIsToldNotTo() {
    Trial trial;
    trial.openAndWait(series_);
    const Frame& frame = heldFrame(trial);
    std::vector<std::uint8_t> annotated = frame.rgba;
    const QString words = ui::previewText(shownOf(frame), frame.stop.levels);
    QVERIFY(words.startsWith("Preview, not converged"));
    ui::Annotations all = annotationsOf(trial.desktop.workspace(), frame);
    QVERIFY(all.patient.join(' ').contains("Phantom"));
    all.patient.clear();
    all.texts << words;
    ui::annotate(all, frame.size, annotated);
    QVERIFY(annotated != frame.rgba);
    QVERIFY(bytesOf(copied(trial)) == annotated);
    trial.desktop.window().menuActions().captioned->trigger();
    QVERIFY(bytesOf(copied(trial)) == frame.rgba);
}

void TestCopiedImage::aFinishedCopySaysNothingOfThat() {
    Frame frame;
    frame.size = {300, 200};
    frame.rgba.assign(std::size_t(300 * 200 * 4), 200);
    frame.status.displayError = 3;
    frame.stop.levels = 4;
    std::vector<std::uint8_t> sides = frame.rgba;
    ui::annotate({frame.camera, {}, {}}, frame.size, sides);
    QVERIFY(bytesOf(copyOf(frame, frame.size, {})) == frame.rgba);
    QVERIFY(bytesOf(copyOf(frame, frame.size, ui::Annotations{frame.camera, {}, {}})) == sides);
    frame.stop.levels = 2;
    QVERIFY(bytesOf(copyOf(frame, frame.size, ui::Annotations{frame.camera, {}, {}})) != sides);
}

/// The left half is dark, the right one bright; so they are in the copy.
void TestCopiedImage::aCoarseImageIsCopiedAtFullSize() {
    Frame frame;
    frame.coarse = true;
    frame.size = {2, 1};
    frame.rgba = {0, 0, 0, 255, 240, 240, 240, 255};
    const QImage image = copyOf(frame, {30, 17}, {});
    QCOMPARE(image.size(), QSize(30, 17));
    QVERIFY(image.pixelColor(1, 8).red() < 20 && image.pixelColor(28, 8).red() > 220);
}

/// What is said when an image in that look leaves the window.
static QString saidOfCopy(Trial& trial, const std::string& look) {
    const auto& looks = trial.desktop.document().looks().fitted();
    const auto found = std::ranges::find(looks, look, &NamedLook::name);
    trial.desktop.document().chooseLook(int(found - looks.begin()));
    trial.waitForNewest();
    trial.desktop.window().message().clear();
    copied(trial);
    return trial.desktop.window().message().text();
}

/// The program does not know which part of the body a scan is of: a chest has no face.
void TestCopiedImage::skinIsSpokenOfOnceForEachScanAndNoFace() {
    const QString skin = "This image shows skin: share it like a photograph of the patient.";
    Trial trial(makeCpuDevice(1), *bundledLooks());
    trial.openAndWait(series_);
    QCOMPARE(saidOfCopy(trial, "Bone"), QString());
    QCOMPARE(saidOfCopy(trial, "MIP"), skin);
    QCOMPARE(saidOfCopy(trial, "Skin"), QString());
    trial.frames.clear();
    trial.openAndWait(series_);
    QCOMPARE(saidOfCopy(trial, "Skin"), skin);
}

void TestCopiedImage::whatSelectsTextCopiesText() {
    Trial trial;
    trial.openAndWait(series_);
    QLineEdit field("0.25", &trial.desktop.window());
    field.show();
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QGuiApplication::clipboard()->text(), QString("0.25"));
}

void TestCopiedImage::withoutAnImageTheClipboardStays() {
    Trial trial;
    QGuiApplication::clipboard()->setText("theirs");
    copied(trial);
    trial.desktop.window().menuActions().copy->trigger();
    QCOMPARE(QGuiApplication::clipboard()->text(), QString("theirs"));
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestCopiedImage)
#include "copied_image_test.moc"
