/// An image of another size, ordered in the window: made while the session goes on, with the same view.

#include <QDir>
#include <QImage>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include "app/presenters/saving_presenter.h"
#include "render/device/device_list.h"
#include "render/film/display/tone_map.h"
#include "render/session/batch_render.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/series/series_panel.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

class TestOrderedImage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void itIsTheSceneOfTheWindowAndTheSessionGoesOn();
    void theButtonCancelsIt();
    void escapeDoesNot();
    void anotherSeriesEndsIt();
    void closingTheWindowAsksWhileItIsMade();
    void theProgramMayEndWhileItIsMade();
    void whatGoesWrongIsSaid();

  private:
    ui::ImageOrder endless(const Trial& trial) const {
        return {trial.folder.filePath("large.png"), QSize(1500, 1000), {.levels = 0.2}};
    }

    QTemporaryDir folder_;
    QString series_;
};

static QPushButton* cancelButton(Trial& trial) {
    return trial.desktop.window().status().findChild<QPushButton*>();
}

static bool isMade(Trial& trial) {
    return trial.said().contains("rendering the image");
}

static QStringList images(const Trial& trial) {
    return QDir(trial.folder.path()).entryList({"*.png"}, QDir::Files | QDir::Hidden);
}

void TestOrderedImage::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

void TestOrderedImage::itIsTheSceneOfTheWindowAndTheSessionGoesOn() {
    Trial trial;
    trial.openAndWait(series_);
    trial.desktop.document().setDenoised(false);
    const Document& document = trial.desktop.document();
    const Scene shown = document.scene();
    auto& saving = trial.desktop.presenter<SavingPresenter>();
    QSignalSpy saved(&saving.job(), &ImageJob::saved);
    const std::uint64_t samples = trial.frames.back()->status.samplesPerPixel;
    const QString file = trial.folder.filePath("tall.png");
    trial.desktop.presenter<SavingPresenter>().render(
        {file, QSize(60, 90), {.levels = 0.2, .samples = 4}, ui::Annotate::none});
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
    QVERIFY(trial.said().contains("Saved as"));
    QVERIFY(document.scene() == shown && !document.canUndo());
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->status.samplesPerPixel > samples, test::kPatience);
    QCOMPARE(trial.frames.back()->revision, shown.revision);
    QVERIFY(trial.frames.back()->size == shown.film);

    Scene scene = shown;
    scene.film = {60, 90};
    const auto device = makeCpuDevice(2);
    QVERIFY(device->upload(scene));
    const auto film = *device->film(scene.film, scene.revision, scene.schedule);
    QVERIFY(BatchRender(*film, {.samples = 4}, document.display()).run({}, [](const BatchState&) {}));
    const QImage image = QImage(file).convertToFormat(QImage::Format_RGBX8888);
    const std::vector<std::uint8_t> expected = toneMap(**film->film(), document.display());
    QVERIFY(std::equal(expected.begin(), expected.end(), image.constBits(), image.constBits() + image.sizeInBytes()));
}

void TestOrderedImage::theButtonCancelsIt() {
    Trial trial;
    trial.openAndWait(series_);
    trial.desktop.presenter<SavingPresenter>().render(endless(trial));
    QTRY_VERIFY_WITH_TIMEOUT(isMade(trial) && cancelButton(trial)->isVisible(), test::kPatience);
    const std::size_t frames = trial.frames.size();
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.size() > frames, test::kPatience);
    cancelButton(trial)->click();
    QVERIFY(!trial.desktop.presenter<SavingPresenter>().job().isRunning());
    QVERIFY2(trial.said().contains("no image was saved"), qPrintable(trial.said()));
    QVERIFY(!cancelButton(trial)->isVisible());
    QVERIFY(trial.desktop.document().hasVolume());
    QCOMPARE(images(trial), QStringList());
}

/// Escape closes messages, but must not cancel an image that is being rendered.
void TestOrderedImage::escapeDoesNot() {
    Trial trial;
    trial.openAndWait(series_);
    trial.desktop.presenter<SavingPresenter>().render(endless(trial));
    QTest::keyClick(&trial.desktop.window(), Qt::Key_Escape);
    QVERIFY(trial.desktop.presenter<SavingPresenter>().job().isRunning());
}

/// Opening another series cancels the image: its volume could not be read as long as the image holds the first one.
void TestOrderedImage::anotherSeriesEndsIt() {
    Trial trial;
    trial.openAndWait(series_);
    trial.desktop.presenter<SavingPresenter>().render(endless(trial));
    QTRY_VERIFY_WITH_TIMEOUT(isMade(trial), test::kPatience);
    trial.frames.clear();
    emit test::the<ui::SeriesPanel>(trial.desktop.window()).seriesChosen(0);
    QVERIFY(!trial.desktop.presenter<SavingPresenter>().job().isRunning());
    QTRY_VERIFY_WITH_TIMEOUT(!trial.frames.empty(), test::kPatience);
    QCOMPARE(images(trial), QStringList());
}

void TestOrderedImage::closingTheWindowAsksWhileItIsMade() {
    Trial trial;
    trial.openAndWait(series_);
    trial.desktop.presenter<SavingPresenter>().render(endless(trial));
    QTRY_VERIFY_WITH_TIMEOUT(isMade(trial), test::kPatience);
    int asked = 0;
    const auto closedWith = [&](QMessageBox::StandardButton answer) {
        QTimer::singleShot(0, &trial.desktop.window(), [&asked, answer] {
            auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            QVERIFY(question && question->text().contains("still rendering"));
            ++asked;
            question->button(answer)->click();
        });
        return trial.desktop.window().close();
    };
    QVERIFY(!closedWith(QMessageBox::No));
    QVERIFY(trial.desktop.presenter<SavingPresenter>().job().isRunning());
    QVERIFY(closedWith(QMessageBox::Yes));
    QCOMPARE(asked, 2);
    trial.desktop.window().show();
    cancelButton(trial)->click();
    QVERIFY(trial.desktop.window().close());  // without a question
}

void TestOrderedImage::theProgramMayEndWhileItIsMade() {
    const QTemporaryDir place;
    {
        Trial trial;
        trial.openAndWait(series_);
        trial.desktop.presenter<SavingPresenter>().render(
            {place.filePath("large.png"), QSize(1500, 1000), {.levels = 0.2}});
        QTRY_VERIFY_WITH_TIMEOUT(isMade(trial), test::kPatience);
    }
    QCOMPARE(QDir(place.path()).entryList(QDir::Files | QDir::Hidden), QStringList());
}

void TestOrderedImage::whatGoesWrongIsSaid() {
    Trial trial;
    trial.openAndWait(series_);
    const auto said = [&] { return trial.desktop.window().message().text(); };
    trial.desktop.presenter<SavingPresenter>().render({trial.folder.filePath("head.jpg"), QSize(30, 30), {}});
    QTRY_VERIFY_WITH_TIMEOUT(said().contains(".png or .exr"), test::kPatience);
    trial.desktop.presenter<SavingPresenter>().render({trial.folder.filePath("nowhere/head.png"), QSize(30, 30), {}});
    QTRY_VERIFY_WITH_TIMEOUT(said().contains("nowhere"), test::kPatience);
    QVERIFY(trial.desktop.document().hasVolume());
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestOrderedImage)
#include "ordered_image_test.moc"
