/// The desktop as a whole, on files: from a folder to an image that grows better, and never a window that waits.

#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/dicom/shared_data.h"
#include "tests/support/patience.h"
#include "ui/series/series_panel.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// Measures how long the event loop is busy with one thing at most, or blocked by it. The time in which this thread
/// could have run and other programs held the processors is left out.
class StallWatch : public QObject {
  public:
    StallWatch() {
        since_.start();
        startTimer(1);
    }
    double longestMs() const { return longestMs_; }

  protected:
    void timerEvent(QTimerEvent*) override {
        const double queued = queuedMs();
        longestMs_ = std::max(longestMs_, 1e-6 * double(since_.nsecsElapsed()) - (queued - queuedBefore_));
        queuedBefore_ = queued;
        since_.start();
    }

  private:
    /// What this thread has waited for a processor, all in all: the second number of Linux' schedstat, in nanoseconds.
    static double queuedMs() {
        QFile file("/proc/thread-self/schedstat");
        if (!file.open(QIODevice::ReadOnly))
            return 0;
        return 1e-6 * file.readAll().split(' ').value(1).toDouble();
    }

    QElapsedTimer since_;
    double queuedBefore_ = queuedMs();
    double longestMs_ = 0;
};

class TestDesktop : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void aFolderBecomesAnImageThatGrowsBetter();
    void theWindowNeverWaitsForReadingOrRendering();
    void aDragIsSeenWhileTheHandMoves();
    void pauseHoldsTheSamples();
    void undoBringsTheFirstViewBack();
    void aFailedFolderIsSaidAndTheImageStays();
    void theTitleNamesTheSeriesButNotThePatient();
    void onlyTheWindowIsKept();
    void aRealChestIsShown();

  private:
    QTemporaryDir folder_;
    QString series_;
};

void TestDesktop::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

void TestDesktop::aFolderBecomesAnImageThatGrowsBetter() {
    Trial trial;
    trial.openAndWait(series_);
    QCOMPARE(test::the<ui::SeriesPanel>(trial.desktop.window()).current(), 0);
    const std::uint64_t first = trial.frames.back()->status.samplesPerPixel;
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->status.samplesPerPixel > first + 3, test::kPatience);
    const Frame& frame = *trial.frames.back();
    QVERIFY(frame.size == trial.desktop.document().scene().film);
    QVERIFY(*std::max_element(frame.rgba.begin(), frame.rgba.end() - 1) > 60);
    // The head is in the middle, dark ground around it.
    const QImage shown = trial.desktop.window().viewport().grab().toImage();
    QCOMPARE(shown.pixelColor(shown.width() / 8, shown.height() / 8), QColor(Qt::black));
}

/// What really blocks would do so every time: the best of three counts.
void TestDesktop::theWindowNeverWaitsForReadingOrRendering() {
    double best = 1e6;
    for (int attempt = 0; attempt < 3 && best > 100; ++attempt) {
        Trial trial;
        QTest::qWait(200);  // the first painting of a window is not what is measured
        StallWatch watch;
        trial.openAndWait(series_);
        for (int i = 0; i < 30; ++i) {
            QTest::keyClick(&trial.desktop.window().viewport(), Qt::Key_Right);
            QTest::qWait(10);
        }
        trial.desktop.window().resize(800 + 50 * attempt, 450);
        trial.desktop.document().chooseLook(1);
        QTest::qWait(500);
        best = std::min(best, watch.longestMs());
    }
    QVERIFY2(best <= 100, qPrintable(QString("stalled for %1 ms").arg(best)));
}

void TestDesktop::aDragIsSeenWhileTheHandMoves() {
    Trial trial;
    trial.openAndWait(series_);
    const std::uint64_t before = trial.desktop.document().scene().revision;
    ui::Viewport& viewport = trial.desktop.window().viewport();
    QTest::mousePress(&viewport, Qt::LeftButton, {}, QPoint(200, 200));
    std::vector<std::uint64_t> seen;
    const auto look = [&] {
        seen.clear();
        for (const auto& frame : trial.frames) {
            if (frame->revision > before && (seen.empty() || seen.back() != frame->revision))
                seen.push_back(frame->revision);
        }
        return seen.size();
    };
    constexpr int kMoves = 5000;  // some thirty on a machine that does nothing else
    for (int i = 1; i <= kMoves && look() < 3; ++i) {
        const QPointF place(200 + 2 * (i % 60), 200);
        QMouseEvent move(QEvent::MouseMove, place, viewport.mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&viewport, &move);
        QTest::qWait(8);  // a mouse tells 125 times a second
    }
    QVERIFY2(seen.size() >= 3, qPrintable(QString("%1 pictures while the user moved").arg(seen.size())));
    QVERIFY(std::is_sorted(seen.begin(), seen.end()));
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, QPoint(320, 200));
    trial.waitForNewest();
    QVERIFY(trial.frames.back()->size == trial.desktop.document().scene().film);
}

void TestDesktop::pauseHoldsTheSamples() {
    Trial trial;
    trial.openAndWait(series_);
    QTest::keyClick(&trial.desktop.window().viewport(), Qt::Key_Space);
    QVERIFY(trial.desktop.bridge().paused());
    const std::uint64_t held = trial.heldSamples();
    QTest::qWait(300);
    QCOMPARE(trial.frames.back()->status.samplesPerPixel, held);
    QTest::keyClick(&trial.desktop.window().viewport(), Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->status.samplesPerPixel > held, test::kPatience);
}

void TestDesktop::undoBringsTheFirstViewBack() {
    Trial trial;
    trial.openAndWait(series_);
    Document& document = trial.desktop.document();
    const Camera first = document.scene().camera;
    document.setView(StandardView::left);
    QTest::keyClick(&trial.desktop.window(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.scene().camera == first);
    trial.waitForNewest();
}

void TestDesktop::aFailedFolderIsSaidAndTheImageStays() {
    Trial trial;
    trial.openAndWait(series_);
    trial.desktop.open(trial.folder.filePath("nowhere"));
    QTRY_VERIFY_WITH_TIMEOUT(trial.desktop.window().message().text().contains("nowhere"), test::kPatience);
    QVERIFY(trial.desktop.document().hasVolume());
    const std::size_t frames = trial.frames.size();
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.size() > frames, test::kPatience);
}

void TestDesktop::theTitleNamesTheSeriesButNotThePatient() {
    Trial trial;
    QVERIFY(trial.desktop.window().windowTitle().contains("Not for diagnostic use"));
    trial.openAndWait(series_);
    const QString title = trial.desktop.window().windowTitle();
    QVERIFY(title.contains("Not for diagnostic use"));
    QVERIFY(title.contains("CT series 1"));
    // People write names into descriptions, and title bars are in task lists and recordings.
    QVERIFY(!title.contains("Head of a phantom"));
    QVERIFY(!title.contains("Phantom, Head"));
}

void TestDesktop::onlyTheWindowIsKept() {
    const QTemporaryDir kept;
    const QString file = kept.filePath("settings.ini");
    {
        Desktop desktop(*bundledLooks(), makeCpuDevice(1), file);
        desktop.window().show();
        desktop.open(series_);
        QTRY_VERIFY_WITH_TIMEOUT(desktop.document().hasVolume(), test::kPatience);
    }
    const QSettings settings(file, QSettings::IniFormat);
    QCOMPARE(settings.allKeys(), QStringList({"window/geometry", "window/state"}));
}

void TestDesktop::aRealChestIsShown() {
    PDR_NEEDS_SHARED_CT();
    Trial trial;
    trial.openAndWait(ui::toQt(test::sharedCt() / "chest_contrast"));
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->status.samplesPerPixel >= 3, test::kPatience);
    QVERIFY(trial.desktop.document().scene().volume->size() == ivec3(512, 512, 100));
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestDesktop)
#include "desktop_test.moc"
