/// The desktop and what makes its images: devices, and what they are compared with.

#include <QImage>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "app/presenters/saving_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/the.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/rendering/render_panel.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

static const QComboBox* device(Trial& trial) {
    for (const QComboBox* box : test::the<ui::RenderPanel>(trial.desktop.window()).findChildren<QComboBox*>())
        if (box->accessibleName() == "Device")
            return box;
    return nullptr;
}

class TestDesktopDevices : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void aDeviceThatFailsIsSaidAndTheImageGoesOn();
    void aDeviceThatIsNotThereIsSaidAndTheImageGoesOn();
    void aGpuThatIsBeingPreparedIsSaid();
    void anotherDeviceGoesOnFromTheSamples();
    void theStatusSaysWhatTheImageIsMadeBy();
    void aComparisonIsSaidPlainly();
    void theDeviceAndThePaceAreKept();

  private:
    QTemporaryDir folder_;
    QString series_;
};

void TestDesktopDevices::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

void TestDesktopDevices::aDeviceThatFailsIsSaidAndTheImageGoesOn() {
    auto mishaps = std::make_shared<test::Mishaps>();
    Trial trial(test::failing(mishaps));
    QCOMPARE(device(trial)->currentData().toString(), "failing");
    trial.openAndWait(series_);
    QVERIFY(trial.desktop.window().message().isHidden());
    mishaps->gone = true;
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->device == "cpu", test::kPatience);
    const QString text = trial.desktop.window().message().text();
    QVERIFY2(text.contains("the device is lost") && text.contains("Rendering continues on the CPU."), qPrintable(text));
    QTRY_COMPARE_WITH_TIMEOUT(device(trial)->currentData().toString(), "cpu", test::kPatience);
    const std::size_t frames = trial.frames.size();
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.size() > frames, test::kPatience);
}

void TestDesktopDevices::aDeviceThatIsNotThereIsSaidAndTheImageGoesOn() {
    Trial trial;
    trial.openAndWait(series_);
    test::the<ui::RenderPanel>(trial.desktop.window()).setDevices({"cpu", "abacus"}, {"CPU", "abacus"});
    test::the<ui::RenderPanel>(trial.desktop.window()).setDevice("abacus");
    emit test::the<ui::RenderPanel>(trial.desktop.window()).deviceChosen("abacus");
    QTRY_VERIFY_WITH_TIMEOUT(trial.desktop.window().message().text().contains("abacus"), test::kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(device(trial)->currentData().toString(), "cpu",
                              test::kPatience);  // what is really in use
    const std::size_t frames = trial.frames.size();
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.size() > frames, test::kPatience);
}

void TestDesktopDevices::aGpuThatIsBeingPreparedIsSaid() {
    Trial trial;
    const auto said = [&] { return trial.desktop.window().status().text(); };
    const QString preparing = "Preparing the GPU...";
    trial.desktop.bridge().tellPreparing(true);  // before there is an image
    QCOMPARE(said(), preparing);
    trial.desktop.bridge().tellPreparing(false);
    QVERIFY(said().isEmpty());
    trial.openAndWait(series_);
    trial.desktop.bridge().tellPreparing(true);
    trial.desktop.bridge().setPaused(true);
    QCOMPARE(said(), preparing);
    trial.desktop.bridge().tellPreparing(false);
    QVERIFY(!said().isEmpty() && said() != preparing);
}

void TestDesktopDevices::anotherDeviceGoesOnFromTheSamples() {
    Trial trial(test::failing(std::make_shared<test::Mishaps>()));
    trial.openAndWait(series_);
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->status.samplesPerPixel >= 3, test::kPatience);
    emit test::the<ui::RenderPanel>(trial.desktop.window()).deviceChosen("cpu");
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->device == "cpu", test::kPatience);
    const auto first = std::find_if(trial.frames.begin(), trial.frames.end(),
                                    [](const auto& frame) { return frame->device == "cpu"; });
    QVERIFY((*first)->status.samplesPerPixel > (*(first - 1))->status.samplesPerPixel);
    QTRY_COMPARE_WITH_TIMEOUT(device(trial)->currentData().toString(), "cpu", test::kPatience);
}

void TestDesktopDevices::theStatusSaysWhatTheImageIsMadeBy() {
    Trial trial;
    trial.openAndWait(series_);
    QTRY_VERIFY_WITH_TIMEOUT(trial.said().contains("per frame on the CPU, efficiency "), test::kPatience);
    QVERIFY(!trial.said().contains("comparison"));
}

void TestDesktopDevices::aComparisonIsSaidPlainly() {
    Trial trial;
    trial.openAndWait(series_);
    ui::RenderPanel& panel = test::the<ui::RenderPanel>(trial.desktop.window());
    Document& document = trial.desktop.document();
    emit panel.estimatorChosen(Estimator::kroesMarch);
    QVERIFY(document.scene().estimator == Estimator::kroesMarch);
    trial.waitForNewest();
    QVERIFY2(trial.said().contains("comparison: march of 3 voxels, biased"), qPrintable(trial.said()));
    QTest::keyClick(&trial.desktop.window(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.scene().estimator == Estimator::unbiased);
    trial.waitForNewest();
    QVERIFY(!trial.said().contains("comparison"));

    emit panel.scheduleChosen({.kind = Schedule::Kind::kroes});
    QTRY_VERIFY_WITH_TIMEOUT(trial.said().contains("comparison: Exposure Render's schedule K1, blurred"),
                             test::kPatience);
    QSignalSpy saved(&trial.desktop.presenter<SavingPresenter>().saver(), &ImageSaver::saved);
    trial.desktop.presenter<SavingPresenter>().save(trial.folder.filePath("picture.png"), ui::Annotate::sides);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
    QCOMPARE(QImage(trial.folder.filePath("picture.png")).text("pdrender/schedule"), "Exposure Render's K1, blurred");
}

void TestDesktopDevices::theDeviceAndThePaceAreKept() {
    const QTemporaryDir kept;
    const QString file = kept.filePath("settings.ini");
    {
        Desktop desktop(*bundledLooks(), makeCpuDevice(1), file);
        QCOMPARE(Settings(file).device(), "auto");
        QVERIFY(test::the<ui::RenderPanel>(desktop.window()).pace() == FrameBudget{.automatic = true});
        emit test::the<ui::RenderPanel>(desktop.window()).deviceChosen("cpu");
        emit test::the<ui::RenderPanel>(desktop.window()).paceChosen({false, 12, 3.5});
    }
    Desktop desktop(*bundledLooks(), makeCpuDevice(1), file);
    QCOMPARE(Settings(file).device(), "cpu");
    QVERIFY((test::the<ui::RenderPanel>(desktop.window()).pace() == FrameBudget{false, 12, 3.5}));
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestDesktopDevices)
#include "desktop_devices_test.moc"
