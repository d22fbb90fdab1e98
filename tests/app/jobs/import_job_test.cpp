/// Reading beside the window.

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <new>
#include <system_error>

#include "app/jobs/import_job.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

class TestImportJob : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void aSeriesIsScannedAndLoaded();
    void aSeriesIsNotReadBeforeTheOneBeforeIsFreed();
    void aSeriesThatIsNotLetGoOfIsAnError();
    void aMissingFolderIsAnErrorWithAWayOut();
    void anEmptyFolderIsAnError();
    void progressIsTold();
    void cancelEndsTheJobWithoutAResult();
    void aNewJobCancelsTheOld();
    void cancelWithoutAJobSaysNothing();
    void aWrongIndexDoesNothing();
    void theJobMayEndWhileItReads();
    void whateverIsThrownIsAFailureInWords_data();
    void whateverIsThrownIsAFailureInWords();
    void aThreadThatCannotBeStartedIsSaid();

  private:
    QTemporaryDir folder_;
    QString series_;
};

void TestImportJob::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_));
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

/// A job that has scanned the folder, and holds the volume that it loaded last.
struct ScannedFolder {
    explicit ScannedFolder(const QString& folder,
                           std::chrono::milliseconds patience = std::chrono::milliseconds(test::kPatience))
        : job(patience) {
        QObject::connect(&job, &ImportJob::loaded,
                         [this](std::shared_ptr<const Volume> loaded, int) { volume = std::move(loaded); });
        job.scanFolder(folder);
        [this] { QTRY_COMPARE_WITH_TIMEOUT(scanned.count(), 1, test::kPatience); }();
    }
    ImportJob job;
    QSignalSpy scanned{&job, &ImportJob::scanned}, finished{&job, &ImportJob::finished};
    std::shared_ptr<const Volume> volume;
};

void TestImportJob::aSeriesIsScannedAndLoaded() {
    ScannedFolder folder(series_);
    QCOMPARE(folder.job.scan().series.size(), std::size_t(1));
    folder.job.loadSeries(0);
    QTRY_VERIFY_WITH_TIMEOUT(folder.volume, test::kPatience);
    QVERIFY(folder.volume->size() == ivec3(64, 57, 64));
    QCOMPARE(folder.finished.count(), 2);
}

void TestImportJob::aSeriesIsNotReadBeforeTheOneBeforeIsFreed() {
    ScannedFolder folder(series_);
    folder.job.loadSeries(0);
    QTRY_VERIFY_WITH_TIMEOUT(folder.volume, test::kPatience);
    QCOMPARE(folder.finished.count(), 2);
    folder.job.loadSeries(0);
    QTest::qWait(300);
    QCOMPARE(folder.finished.count(), 2);
    folder.volume.reset();
    QTRY_VERIFY_WITH_TIMEOUT(folder.volume, test::kPatience);
}

/// Whoever keeps a volume is a fault of the program; the user hears of it instead of waiting for ever.
void TestImportJob::aSeriesThatIsNotLetGoOfIsAnError() {
    ScannedFolder folder(series_, std::chrono::milliseconds(50));
    folder.job.loadSeries(0);
    QTRY_VERIFY_WITH_TIMEOUT(folder.volume, test::kPatience);
    Error error;
    QObject::connect(&folder.job, &ImportJob::failed, [&](const Error& failure) { error = failure; });
    folder.job.loadSeries(0);
    QTRY_VERIFY_WITH_TIMEOUT(!error.what.empty(), test::kPatience);
    QVERIFY(error.what.find("still in memory") != std::string::npos && !error.hint.empty());
}

static Error errorOf(const QString& folder) {
    ImportJob job;
    Error error;
    QObject::connect(&job, &ImportJob::failed, [&](const Error& failure) { error = failure; });
    job.scanFolder(folder);
    [&] { QTRY_VERIFY_WITH_TIMEOUT(!error.what.empty(), test::kPatience); }();
    return error;
}

void TestImportJob::aMissingFolderIsAnErrorWithAWayOut() {
    const Error error = errorOf(folder_.filePath("nowhere"));
    QVERIFY(!error.hint.empty());
    QVERIFY(error.where.find("nowhere") != std::string::npos);
}

void TestImportJob::anEmptyFolderIsAnError() {
    const QTemporaryDir empty;
    QVERIFY(!errorOf(empty.path()).hint.empty());
}

void TestImportJob::progressIsTold() {
    ImportJob job;
    QSignalSpy progressed(&job, &ImportJob::progressed), scanned(&job, &ImportJob::scanned);
    job.scanFolder(series_);
    QTRY_COMPARE_WITH_TIMEOUT(scanned.count(), 1, test::kPatience);
    QVERIFY(progressed.count() > 0);
    for (const QList<QVariant>& call : progressed) {
        QVERIFY(call[0].toDouble() >= 0 && call[0].toDouble() <= 1);
        QVERIFY(!call[1].toString().isEmpty());
    }
}

void TestImportJob::cancelEndsTheJobWithoutAResult() {
    ImportJob job;
    QSignalSpy scanned(&job, &ImportJob::scanned), failed(&job, &ImportJob::failed);
    QSignalSpy cancelled(&job, &ImportJob::cancelled), finished(&job, &ImportJob::finished);
    job.scanFolder(series_);
    job.cancel();
    QCOMPARE(cancelled.count(), 1);
    QCOMPARE(finished.count(), 1);
    QTest::qWait(300);
    QCOMPARE(scanned.count() + failed.count(), 0);
}

void TestImportJob::aNewJobCancelsTheOld() {
    ImportJob job;
    const QTemporaryDir empty;
    QSignalSpy scanned(&job, &ImportJob::scanned), failed(&job, &ImportJob::failed);
    job.scanFolder(empty.path());
    job.scanFolder(series_);
    QTRY_COMPARE_WITH_TIMEOUT(scanned.count(), 1, test::kPatience);
    QTest::qWait(100);
    QCOMPARE(failed.count(), 0);
    QCOMPARE(scanned[0][1].toString(), series_);
}

void TestImportJob::cancelWithoutAJobSaysNothing() {
    ImportJob job;
    QSignalSpy cancelled(&job, &ImportJob::cancelled), finished(&job, &ImportJob::finished);
    job.cancel();
    QCOMPARE(cancelled.count() + finished.count(), 0);
}

void TestImportJob::aWrongIndexDoesNothing() {
    ImportJob job;
    QSignalSpy finished(&job, &ImportJob::finished);
    job.loadSeries(-1);
    job.loadSeries(0);
    QTest::qWait(50);
    QCOMPARE(finished.count(), 0);
}

void TestImportJob::theJobMayEndWhileItReads() {
    for (int i = 0; i < 20; ++i) {
        ImportJob job;
        job.scanFolder(series_);
        QTest::qWait(i);
    }
}

/// A job whose work throws.
class Throwing : public ImportJob {
  public:
    using ImportJob::thread;
    void run(int what) {
        start([what](const Progress&, const std::stop_token&) -> std::function<void()> {
            if (what == 0)
                throw std::bad_alloc();
            if (what == 1)
                throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again), "a thread");
            throw 7;
        });
    }
};

void TestImportJob::whateverIsThrownIsAFailureInWords_data() {
    QTest::addColumn<int>("what");
    QTest::addColumn<QString>("words");
    QTest::newRow("no memory") << 0 << "memory";
    QTest::newRow("no thread") << 1 << "a thread";
    QTest::newRow("something") << 2 << "unknown";
}

void TestImportJob::whateverIsThrownIsAFailureInWords() {
    QFETCH(int, what);
    QFETCH(QString, words);
    Throwing job;
    QSignalSpy finished(&job, &ImportJob::finished), scanned(&job, &ImportJob::scanned);
    Error error;
    connect(&job, &ImportJob::failed, this, [&](const Error& failure) { error = failure; });
    job.run(what);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, test::kPatience);
    QVERIFY2(QString::fromStdString(error.what).contains(words), error.text().c_str());
    QVERIFY(!error.hint.empty());
    job.scanFolder(series_);  // and the next one is read
    QTRY_COMPARE_WITH_TIMEOUT(scanned.count(), 1, test::kPatience);
}

void TestImportJob::aThreadThatCannotBeStartedIsSaid() {
    Throwing job;
    QSignalSpy finished(&job, &ImportJob::finished), scanned(&job, &ImportJob::scanned);
    Error error;
    connect(&job, &ImportJob::failed, this, [&](const Error& failure) { error = failure; });
    job.thread().setStackSize(1);  // no system gives a thread so little
    job.scanFolder(series_);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, test::kPatience);
    QVERIFY(error.what.find("thread") != std::string::npos && !error.hint.empty());
    job.thread().setStackSize(0);  // as usual
    job.scanFolder(series_);
    QTRY_COMPARE_WITH_TIMEOUT(scanned.count(), 1, test::kPatience);
}

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::TestImportJob)
#include "import_job_test.moc"
