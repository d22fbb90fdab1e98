/// An image in the window that others render along: it goes on when they come and go, and is the same.

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "app/presenters/saving_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/network/nearby_worker.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

class TestSharedImage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void itGoesOnWhenOthersComeAndGo();
    void itIsTheSameWhoeverRendersIt();
    void anotherDeviceIsSharedToo();
    void anImageThatIsSavedHasTheOthersUntilItIsDone();
    void nothingIsLeftWhenItIsClosed();

  private:
    QTemporaryDir folder_;
    QString series_;
};

static std::shared_ptr<WorkerPool> newPool() {
    return std::make_shared<WorkerPool>(1);
}

/// Returns whether no frame of an image has fewer samples than the one before.
static bool neverFallsBack(const Trial& trial) {
    for (std::size_t i = 1; i < trial.frames.size(); ++i) {
        const Frame &before = *trial.frames[i - 1], &now = *trial.frames[i];
        if (now.revision == before.revision && !now.coarse && !before.coarse &&
            now.status.samplesPerPixel < before.status.samplesPerPixel)
            return false;
    }
    return true;
}

static void waitForMore(Trial& trial, std::uint64_t samples) {
    const std::uint64_t enough = trial.frames.back()->status.samplesPerPixel + samples;
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->status.samplesPerPixel >= enough, test::kPatience);
}

void TestSharedImage::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

void TestSharedImage::itGoesOnWhenOthersComeAndGo() {
    Trial trial;
    trial.openAndWait(series_);
    waitForMore(trial, 3);
    QSignalSpy noticed(&trial.desktop.bridge(), &RenderBridge::noticed);
    const auto pool = newPool();
    trial.desktop.bridge().setPool(pool);
    waitForMore(trial, 2);
    {
        const test::NearbyWorker worker(pool, "one");
        QTRY_VERIFY_WITH_TIMEOUT(worker.status().results > 2, test::kPatience);
        waitForMore(trial, 2);
    }
    waitForMore(trial, 2);
    trial.desktop.bridge().setPool(nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(!pool->scene().scene, test::kPatience);  // it forgets the scan
    waitForMore(trial, 2);
    QVERIFY(neverFallsBack(trial));
    QVERIFY(noticed.isEmpty());
}

/// Returns the pixels of the image as it is after `samples` samples.
static QByteArray imageOf(const QString& series, std::uint64_t samples, const std::shared_ptr<WorkerPool>& pool) {
    Trial trial;
    trial.desktop.document().setDenoised(false);
    trial.desktop.bridge().setStop({.levels = kFinestTarget, .samples = samples});
    trial.desktop.bridge().setPool(pool);
    trial.openAndWait(series);
    [&] { QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->reached, test::kPatience); }();
    const Frame& last = *trial.frames.back();
    return {reinterpret_cast<const char*>(last.rgba.data()), qsizetype(last.rgba.size())};
}

void TestSharedImage::itIsTheSameWhoeverRendersIt() {
    constexpr std::uint64_t kSamples = 70;  // more than a block
    const QByteArray alone = imageOf(series_, kSamples, nullptr);
    const auto pool = newPool();
    const test::NearbyWorker one(pool, "one"), two(pool, "two");
    const QByteArray together = imageOf(series_, kSamples, pool);
    QVERIFY(!alone.isEmpty() && alone == together);
    QVERIFY(one.status().results + two.status().results > 0);
}

void TestSharedImage::anotherDeviceIsSharedToo() {
    Trial trial;
    trial.openAndWait(series_);
    const auto pool = newPool();
    trial.desktop.bridge().setPool(pool);
    const test::NearbyWorker worker(pool, "one");
    QTRY_VERIFY_WITH_TIMEOUT(worker.status().results > 0, test::kPatience);
    const std::uint64_t before = pool->scene().number;
    trial.desktop.bridge().setDevice("cpu");
    QTRY_VERIFY_WITH_TIMEOUT(pool->scene().number > before, test::kPatience);
    waitForMore(trial, 2);
    QVERIFY(pool->scene().scene);  // that of the new device
    const std::uint64_t results = worker.status().results;
    QTRY_VERIFY_WITH_TIMEOUT(worker.status().results > results, test::kPatience);
}

void TestSharedImage::anImageThatIsSavedHasTheOthersUntilItIsDone() {
    Trial trial;
    trial.openAndWait(series_);
    auto& saving = trial.desktop.presenter<SavingPresenter>();
    const auto pool = newPool();
    trial.desktop.bridge().setPool(pool);
    const test::NearbyWorker worker(pool, "one");
    QTRY_VERIFY_WITH_TIMEOUT(worker.status().results > 0, test::kPatience);
    QSignalSpy saved(&saving.job(), &ImageJob::saved);
    saving.render({folder_.filePath("saved.png"), QSize(300, 200), {.levels = kFinestTarget, .samples = 200}});
    QTRY_COMPARE_WITH_TIMEOUT(pool->scene().purpose, Purpose::finalRender, test::kPatience);
    const double before = worker.status().work;
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
    QVERIFY(worker.status().work > before);
    QCOMPARE(pool->scene().purpose, Purpose::viewport);
    const std::uint64_t results = worker.status().results;
    QTRY_VERIFY_WITH_TIMEOUT(worker.status().results > results, test::kPatience);
    QVERIFY(neverFallsBack(trial));
}

void TestSharedImage::nothingIsLeftWhenItIsClosed() {
    const auto pool = newPool();
    {
        Trial trial;
        trial.desktop.bridge().setPool(pool);
        trial.openAndWait(series_);
        QVERIFY(pool->scene().scene);
        trial.desktop.bridge().clear();
        QTRY_VERIFY_WITH_TIMEOUT(!pool->scene().scene, test::kPatience);
        trial.desktop.open(series_);
        QTRY_VERIFY_WITH_TIMEOUT(pool->scene().scene, test::kPatience);
    }
    QVERIFY(!pool->scene().scene);
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestSharedImage)
#include "shared_image_test.moc"
