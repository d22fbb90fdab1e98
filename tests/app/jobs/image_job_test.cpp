/// An image that is made beside the session: it is that of a batch render, whole or not there at all, and whatever
/// goes wrong is said.

#include <QDir>
#include <QImage>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "app/document/document.h"
#include "app/jobs/image_job.h"
#include "app/looks/looks.h"
#include "render/device/device_list.h"
#include "render/film/display/tone_map.h"
#include "render/film/file/image_file.h"
#include "render/session/batch_render.h"
#include "render/volume/phantom.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/patience.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// Returns a task for an image of a head, wider than high.
static ImageTask task(const QString& file, std::uint64_t samples) {
    Document document(*bundledLooks());
    document.open(std::make_shared<const Volume>(headPhantom({32, 32, 32}, dvec3(6))));
    ImageTask task;
    task.scene = document.scene();
    task.scene.film = {52, 30};
    task.display = document.display();
    task.display.denoised = false;
    task.stop = {.levels = 0.2, .samples = samples};
    task.file = file;
    task.device = [] { return openDevice("cpu", 1); };
    return task;
}

/// Returns a task whose image never reaches its target.
static ImageTask endless(const QString& file) {
    ImageTask endless = task(file, 0);
    endless.scene.film = {400, 300};
    return endless;
}

/// What a device of another number of threads makes of it, without a job.
static Film batch(const ImageTask& task) {
    const auto device = makeCpuDevice(2);
    [&] { QVERIFY(device->upload(task.scene)); }();
    const auto film = *device->film(task.scene.film, task.scene.revision, task.scene.schedule);
    const Stops stops{.samples = task.stop.samples};
    [&] { QVERIFY(BatchRender(*film, stops, {task.display.exposure}).run({}, [](const BatchState&) {})); }();
    return **film->film();
}

static std::vector<std::uint8_t> bytesOf(const QString& file) {
    const QImage image = QImage(file).convertToFormat(QImage::Format_RGBX8888);
    return {image.constBits(), image.constBits() + image.sizeInBytes()};
}

class TestImageJob : public QObject {
    Q_OBJECT

  private slots:
    void init() { place_ = std::make_unique<QTemporaryDir>(); }
    void itIsTheImageOfABatchRender();
    void theFilmIsThatOfABatchRender();
    void unfinishedItSaysSoUnlessItIsToldNotTo();
    void itTellsHowFarItIs();
    void cancelledItLeavesNoFile_data();
    void cancelledItLeavesNoFile();
    void itMayBeForgottenWhileItWorks();
    void anotherOneHasToWait();
    void itGoesBesideANameThatWasTaken();
    void aGpuThatIsLostDoesNotEndIt();
    void whatGoesWrongIsSaid_data();
    void whatGoesWrongIsSaid();
    void aSceneThatCannotBeRenderedIsRefused();

  private:
    QString path(const QString& name) const { return place_->filePath(name); }
    QStringList files() const { return QDir(place_->path()).entryList(QDir::Files | QDir::Hidden); }
    /// What came of it: the error, or nothing.
    Error outcome(ImageJob& job, const ImageTask& task);

    std::unique_ptr<QTemporaryDir> place_;
};

Error TestImageJob::outcome(ImageJob& job, const ImageTask& task) {
    QSignalSpy finished(&job, &ImageJob::finished), saved(&job, &ImageJob::saved);
    Error error;
    const auto connection = connect(&job, &ImageJob::failed, this, [&](const Error& failure) { error = failure; });
    job.make(task);
    [&] { QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, test::kPatience); }();
    disconnect(connection);
    [&] { QCOMPARE(saved.count(), error.what.empty() ? 1 : 0); }();
    return error;
}

void TestImageJob::itIsTheImageOfABatchRender() {
    ImageJob job;
    const ImageTask wanted = task(path("head.png"), 3);
    QCOMPARE(outcome(job, wanted).text(), std::string());
    QVERIFY(bytesOf(wanted.file) == toneMap(batch(wanted), wanted.display));
    const QImage image(wanted.file);
    QCOMPARE(image.text("pdrender/samplesPerPixel"), QString("3"));
    QCOMPARE(image.text("pdrender/device"), QString("cpu"));
    QVERIFY(image.text("pdrender/camera").contains("perspective"));
    QCOMPARE(files(), QStringList("head.png"));
}

void TestImageJob::theFilmIsThatOfABatchRender() {
    ImageJob job;
    const ImageTask wanted = task(path("head.EXR"), 3);
    QCOMPARE(outcome(job, wanted).text(), std::string());
    const auto image = readExr(ui::fromQt(wanted.file));
    QVERIFY(image && image->size == wanted.scene.film);
    const Film film = batch(wanted);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 52; ++x)
            QVERIFY(image->pixels[std::size_t(y * 52 + x)] == vec3(film.pixel(x, y).mean));
}

void TestImageJob::unfinishedItSaysSoUnlessItIsToldNotTo() {
    ImageJob job;
    ImageTask plain = task(path("plain.png"), 3), captioned = task(path("captioned.png"), 3);
    plain.scene.film = captioned.scene.film = {300, 200};
    captioned.annotations = ui::Annotations{captioned.scene.camera, {}, {}};
    QVERIFY(outcome(job, plain).what.empty() && outcome(job, captioned).what.empty());
    QVERIFY(bytesOf(plain.file) != bytesOf(captioned.file));
    const QRect texts(0, 120, 100, 80), elsewhere(140, 60, 60, 60);
    const QImage without(plain.file), with(captioned.file);
    QVERIFY(without.copy(texts) != with.copy(texts) && without.copy(elsewhere) == with.copy(elsewhere));
}

void TestImageJob::itTellsHowFarItIs() {
    ImageJob job;
    QList<double> fractions;
    QString last;
    connect(&job, &ImageJob::progressed, this, [&](double fraction, const QString& step) {
        fractions << fraction;
        last = step;
    });
    job.make(endless(path("head.png")));
    QTRY_VERIFY_WITH_TIMEOUT(last.contains(" left"), test::kPatience);
    QVERIFY2(last.startsWith("rendering the image"), qPrintable(last));
    QVERIFY(fractions.front() == 0 && fractions.back() > 0 && fractions.back() < 1);
}

void TestImageJob::cancelledItLeavesNoFile_data() {
    QTest::addColumn<bool>("there");
    QTest::newRow("new") << false;
    QTest::newRow("an older one stays") << true;
}

void TestImageJob::cancelledItLeavesNoFile() {
    QFETCH(bool, there);
    const QString file = path("head.png");
    if (there) {
        QFile older(file);
        QVERIFY(older.open(QIODevice::WriteOnly) && older.write("older") == 5);
    }
    ImageJob job;
    QSignalSpy cancelled(&job, &ImageJob::cancelled), saved(&job, &ImageJob::saved);
    QSignalSpy progressed(&job, &ImageJob::progressed), failed(&job, &ImageJob::failed);
    job.make(endless(file));
    QTRY_VERIFY_WITH_TIMEOUT(progressed.count() > 2, test::kPatience);
    job.cancel();
    QCOMPARE(cancelled.count(), 1);
    QVERIFY(!job.isRunning());
    QVERIFY(outcome(job, task(path("next.png"), 1)).what.empty());  // made when the first has ended
    QCOMPARE(failed.count(), 0);
    QCOMPARE(saved.count(), 1);
    QCOMPARE(files(), there ? QStringList({"head.png", "next.png"}) : QStringList("next.png"));
    QFile older(file);
    QVERIFY(!there || (older.open(QIODevice::ReadOnly) && older.readAll() == "older"));
}

void TestImageJob::itMayBeForgottenWhileItWorks() {
    for (int i = 0; i < 5; ++i) {
        ImageJob job;
        job.make(endless(path("head.png")));
        QTest::qWait(20 * i);
    }
    QCOMPARE(files(), QStringList());
}

void TestImageJob::anotherOneHasToWait() {
    ImageJob job;
    QSignalSpy saved(&job, &ImageJob::saved);
    Error error;
    connect(&job, &ImageJob::failed, this, [&](const Error& failure) { error = failure; });
    job.make(task(path("first.png"), 2));
    job.make(task(path("second.png"), 2));
    QVERIFY2(error.text().find("another image is being rendered") != std::string::npos, error.text().c_str());
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
    QCOMPARE(files(), QStringList("first.png"));
}

/// Hours of rendering are not lost with a name.
void TestImageJob::itGoesBesideANameThatWasTaken() {
    ImageTask wanted = task(path("head.png"), 3);
    wanted.device = [file = wanted.file] {
        QDir().mkpath(file);  // when it has been found free
        return openDevice("cpu", 1);
    };
    ImageJob job;
    const std::string said = outcome(job, wanted).text();
    QVERIFY2(said.find("head-2.png instead") != std::string::npos, said.c_str());
    QVERIFY2(said.find("not saved") == std::string::npos, said.c_str());
    QCOMPARE(files(), QStringList("head-2.png"));
    QVERIFY(bytesOf(path("head-2.png")) == toneMap(batch(wanted), wanted.display));
}

void TestImageJob::aGpuThatIsLostDoesNotEndIt() {
    const auto mishaps = std::make_shared<test::Mishaps>();
    mishaps->accumulates = 1;
    ImageTask wanted = task(path("head.png"), 40);
    std::vector<Error> told;
    wanted.device = [&]() -> Result<std::unique_ptr<Device>> {
        return withCpuAsSpare(test::failing(mishaps), 1, [&](const Error& why) { told.push_back(why); });
    };
    ImageJob job;
    QCOMPARE(outcome(job, wanted).text(), std::string());
    QVERIFY(bytesOf(wanted.file) == toneMap(batch(wanted), wanted.display));
    QCOMPARE(QImage(wanted.file).text("pdrender/device"), QString("cpu"));
    QVERIFY(told.size() == 1 && told[0].what == "the device is lost");
}

void TestImageJob::whatGoesWrongIsSaid_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("device");
    QTest::addColumn<QString>("words");
    QTest::newRow("no format") << "head.jpg" << 0 << ".png or .exr";
    QTest::newRow("no folder") << "no/such/folder/head.png" << 0 << "head.png";
    QTest::newRow("a folder") << "folder.png" << 0 << "folder.png";
    QTest::newRow("no device") << "head.png" << 1 << "no such thing";
    QTest::newRow("a device that is lost") << "head.png" << 2 << "the device is lost";
    QTest::newRow("a volume that does not fit") << "head.png" << 3 << "the volume needs 9.3 GB";
    QTest::newRow("no memory") << "head.png" << 4 << "memory";
}

void TestImageJob::whatGoesWrongIsSaid() {
    QFETCH(QString, name);
    QFETCH(int, device);
    QFETCH(QString, words);
    QVERIFY(QDir(place_->path()).mkdir("folder.png"));
    const auto mishaps = std::make_shared<test::Mishaps>();
    if (device == 2)
        mishaps->accumulates = 1;
    mishaps->tooSmall = device == 3;
    if (device == 4)
        mishaps->before = [](const std::string& verb) {
            if (verb == "film")
                throw std::bad_alloc();
        };
    ImageTask wanted = task(path(name), 40);
    wanted.device = [&]() -> Result<std::unique_ptr<Device>> {
        if (device == 1)
            return Error{"there is no such thing", "", "Take the CPU."};
        return test::failing(mishaps);
    };
    ImageJob job;
    const Error error = outcome(job, wanted);
    QVERIFY2(error.text().find(words.toStdString()) != std::string::npos, error.text().c_str());
    QVERIFY(!error.hint.empty());
    QCOMPARE(files(), QStringList());
}

void TestImageJob::aSceneThatCannotBeRenderedIsRefused() {
    ImageJob job;
    ImageTask wanted = task(path("head.png"), 1);
    wanted.scene.film = {0, 30};
    const Error error = outcome(job, wanted);
    QVERIFY2(error.text().find("film.width: is 0") != std::string::npos, error.text().c_str());
    QCOMPARE(files(), QStringList());
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestImageJob)
#include "image_job_test.moc"
