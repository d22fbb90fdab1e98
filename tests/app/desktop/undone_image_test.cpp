/// Undo and redo of every kind of edit bring back the image with all its samples, in the window.

#include <QTest>
#include <functional>

#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// An edit of a document.
struct UndoneEdit {
    const char* name;
    std::function<void(Document&)> act;
};

static std::vector<UndoneEdit> edits() {
    return {
        {"view", [](Document& document) { document.setView(StandardView::left); }},
        {"look", [](Document& document) { document.chooseLook(document.look() == 1 ? 2 : 1); }},
        {"tissue",
         [](Document& document) {
             Look look = document.setup().look;
             look.transferFunction.extinctionPerMm *= 0.9f;
             document.setLook(look);
         }},
        {"light",
         [](Document& document) {
             Look look = document.setup().look;
             look.environment.radiance *= 1.5f;
             document.setLook(look);
         }},
        {"cut",
         [](Document& document) {
             Clip clip;
             clip.planes = {ClipPlane{document.scene().camera.targetMm, {1, 0, 0}}};
             document.setClip(clip);
         }},
        {"model", [](Document& document) { document.setModel(Model::multipleScattering); }},
        {"background", [](Document& document) { document.setBackground(vec3(0.5f)); }},
    };
}

class TestUndoneImage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void undoAndRedoBringBackTheImage();
    void anotherSeriesBeginsAnew();

  private:
    QTemporaryDir folder_;
    QString series_;
};

void TestUndoneImage::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

/// Waits until the newest image is worth keeping, and returns its samples.
static std::uint64_t waitForSamples(Trial& trial) {
    trial.waitForNewest();
    const auto last = [&]() -> const Frame& { return *trial.frames.back(); };
    [&] { QTRY_VERIFY_WITH_TIMEOUT(last().seconds > 1 && last().status.samplesPerPixel > 8, test::kPatience); }();
    return last().status.samplesPerPixel;
}

/// Returns the first frame of the document's newest scene.
static std::shared_ptr<const Frame> firstFrame(Trial& trial) {
    const std::uint64_t revision = trial.desktop.document().scene().revision;
    const auto found = [&] {
        return std::ranges::find_if(trial.frames, [&](const auto& frame) { return frame->revision == revision; });
    };
    return QTest::qWaitFor([&] { return found() != trial.frames.end(); }, test::kPatience) ? *found() : nullptr;
}

void TestUndoneImage::undoAndRedoBringBackTheImage() {
    Trial trial;
    trial.openAndWait(series_);
    Document& document = trial.desktop.document();
    for (const UndoneEdit& edit : edits()) {
        const std::uint64_t before = waitForSamples(trial);
        edit.act(document);
        const std::uint64_t after = waitForSamples(trial);
        document.undo();
        std::shared_ptr<const Frame> frame = firstFrame(trial);
        QVERIFY2(frame && !frame->coarse && frame->status.samplesPerPixel >= before, edit.name);
        document.redo();
        frame = firstFrame(trial);
        QVERIFY2(frame && !frame->coarse && frame->status.samplesPerPixel >= after, edit.name);
        document.undo();
        trial.waitForNewest();
    }
}

void TestUndoneImage::anotherSeriesBeginsAnew() {
    Trial trial;
    trial.openAndWait(series_);
    const std::uint64_t before = waitForSamples(trial);
    const std::size_t frames = trial.frames.size();
    trial.openAndWait(series_);
    for (std::size_t i = frames; i < trial.frames.size(); ++i)
        if (trial.frames[i]->revision > trial.frames[frames - 1]->revision)
            QVERIFY(trial.frames[i]->status.samplesPerPixel < before);
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestUndoneImage)
#include "undone_image_test.moc"
