/// Images saved as they are on the screen.

#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <memory>

#include "app/presenters/saving_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

class TestSavedImage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void theImageIsSaved_data();
    void theImageIsSaved();
    void anImageThatCannotBeWrittenIsSaid();
    void anUnknownFormatIsSaid();
    void aSavedImageSaysWhatTheScreenSays();

    void cleanupTestCase() { trial_.reset(); }

  private:
    QTemporaryDir folder_;
    QString series_;
    std::unique_ptr<Trial> trial_;  ///< a window for those that save what it shows, whatever that is
};

void TestSavedImage::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
    trial_ = std::make_unique<Trial>();
    trial_->openAndWait(series_);
}

void TestSavedImage::theImageIsSaved_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("magic");
    QTest::newRow("png") << "picture.png" << QByteArray("\x89PNG");
    QTest::newRow("exr") << "picture.EXR" << QByteArray("\x76\x2f\x31\x01");
}

void TestSavedImage::theImageIsSaved() {
    QFETCH(QString, name);
    QFETCH(QByteArray, magic);
    QSignalSpy saved(&trial_->desktop.presenter<SavingPresenter>().saver(), &ImageSaver::saved);
    const QString path = trial_->folder.filePath(name);
    trial_->desktop.presenter<SavingPresenter>().save(path, ui::Annotate::sides);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray content = file.readAll();
    QVERIFY(content.startsWith(magic));
    QVERIFY(!content.contains("Phantom^Head") && !content.contains("PHANTOM"));
}

/// The saved error agrees with that on the screen within a factor of two: the image is judged anew for the file, while
/// samples are added.
void TestSavedImage::aSavedImageSaysWhatTheScreenSays() {
    Trial trial;
    trial.openAndWait(series_);
    trial.desktop.bridge().setStop({.levels = 0.2});
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->denoisedError, test::kPatience);
    const QString file = trial.folder.filePath("saved.png");
    QSignalSpy saved(&trial.desktop.presenter<SavingPresenter>().saver(), &ImageSaver::saved);
    trial.desktop.presenter<SavingPresenter>().saver().save(file);
    QTRY_VERIFY_WITH_TIMEOUT(!saved.isEmpty(), test::kPatience);
    const QString text = QImage(file).text("pdrender/denoised");
    const QRegularExpressionMatch within = QRegularExpression("^95 % of the tissue within ([0-9.]+) of").match(text);
    QVERIFY2(within.hasMatch(), qPrintable(text));
    const auto judged = std::ranges::find_if(trial.frames.rbegin(), trial.frames.rend(),
                                             [](const auto& frame) { return frame->denoisedError.has_value(); });
    const double ratio = within.captured(1).toDouble() / (*judged)->denoisedError->levelsAtMost;
    QVERIFY2(ratio > 0.5 && ratio < 2, qPrintable(QString::number(ratio)));
}

void TestSavedImage::anImageThatCannotBeWrittenIsSaid() {
    trial_->desktop.presenter<SavingPresenter>().save(trial_->folder.filePath("no/such/folder/picture.png"),
                                                      ui::Annotate::sides);
    QTRY_VERIFY_WITH_TIMEOUT(trial_->desktop.window().message().text().contains("picture.png"), test::kPatience);
}

void TestSavedImage::anUnknownFormatIsSaid() {
    trial_->desktop.presenter<SavingPresenter>().save(trial_->folder.filePath("picture.jpg"), ui::Annotate::sides);
    QVERIFY(trial_->desktop.window().message().text().contains(".png or .exr"));
    QVERIFY(!QFileInfo::exists(trial_->folder.filePath("picture.jpg")));
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestSavedImage)
#include "saved_image_test.moc"
