/// Parts of the scan in the window: found, listed, coloured on slices, shown in the image, and kept with a plan.

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/presenters/looks_presenter.h"
#include "app/presenters/parts_presenter.h"
#include "app/presenters/plan_presenter.h"
#include "app/presenters/slices_presenter.h"
#include "dicom/write/export.h"
#include "render/volume/file/label_nrrd.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/places.h"
#include "tests/support/scenes/vessel_phantoms.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

struct PartsTrial : Trial {
    using Trial::Trial;

    PartsPresenter& presenter = desktop.presenter<PartsPresenter>();
    ui::PartsPanel& panel = presenter.panel();
    QTreeWidget& list = *panel.findChild<QTreeWidget*>();
    Document& document = desktop.document();

    QAbstractButton& button(const QString& text) {
        for (auto* button : panel.findChildren<QAbstractButton*>())
            if (button->text().remove('&') == text)
                return *button;
        qFatal("no such button");
    }
    void wait() { QTRY_VERIFY_WITH_TIMEOUT(!presenter.job().isRunning(), test::kPatience); }
    void findVessels() {
        button("Find vessels").click();
        wait();
        QVERIFY2(document.scanParts(), qPrintable(desktop.window().message().text()));
    }
    QString notes() const {
        QStringList texts;
        for (const auto* label : panel.findChildren<QLabel*>())
            texts << label->text();
        return texts.join('\n');
    }
    /// Returns whether any pixel of the axial slice has a colour, once it is shown.
    bool axialIsColoured() {
        const auto& slice = desktop.presenter<SlicesPresenter>().view(AnatomicalPlane::axial).slice();
        if (!slice)
            return false;
        for (int y = 0; y < slice->image.height(); ++y)
            for (int x = 0; x < slice->image.width(); ++x)
                if (const QColor pixel = slice->image.pixelColor(x, y); pixel.red() > pixel.green() + 20)
                    return true;
        return false;
    }
};

}  // namespace

class PartsInWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        series_ = folder_.filePath("series");
        const dicom::ExportFacts facts{"Phantom^Aorta", "AORTA", "Test", "Aorta", "Made from formulas."};
        const auto written =
            dicom::writeSeries(test::scanOf(test::aortaBesideSpine()), facts, ui::fromQt(series_), noProgress);
        QVERIFY2(written, written ? "" : written.error().text().c_str());
    }

    void vesselsAreFoundAndShown() {
        PartsTrial trial;
        trial.openAndWait(series_);
        QVERIFY(trial.list.topLevelItemCount() == 0 && trial.panel.isEnabled());
        trial.desktop.presenter<SlicesPresenter>().showSlices();
        trial.findVessels();
        QCOMPARE(trial.list.topLevelItemCount(), 2);
        QVERIFY(trial.list.topLevelItem(1)->text(1).endsWith(" ml"));
        QVERIFY2(trial.notes().contains("Found by the program: check it."), qPrintable(trial.notes()));
        QTRY_VERIFY_WITH_TIMEOUT(trial.axialIsColoured(), test::kPatience);
        trial.button("Colours on the slices").click();
        QTRY_VERIFY_WITH_TIMEOUT(!trial.axialIsColoured(), test::kPatience);

        trial.list.topLevelItem(0)->setSelected(true);
        trial.button("Hide").click();
        QCOMPARE(trial.list.topLevelItem(0)->text(2), QString("hidden"));
        QVERIFY(trial.document.scene().parts.map);
        trial.waitForNewest();
        const Text said = trial.frames.back()->notShown;
        QVERIFY2(said.ends_with("Hidden: rest of the body."), said.c_str());
        trial.button("Show").click();
        QVERIFY(!trial.document.scene().parts.map && trial.document.look() >= 0);
        trial.document.undo();
        trial.document.undo();
        trial.document.undo();
        QVERIFY(!trial.document.scanParts() && trial.list.topLevelItemCount() == 0);
    }

    void aLookOffersToFindItsParts() {
        const std::vector<NamedLook> looks = fewLooksAnd("Bones and vessels");
        const int last = int(looks.size()) - 1;
        PartsTrial trial(makeCpuDevice(1), looks);
        trial.openAndWait(series_);
        trial.document.chooseLook(last);
        ui::MessageBar& message = trial.desktop.window().message();
        QVERIFY2(message.text().contains("shows vessels"), qPrintable(message.text()));
        QVERIFY(!trial.document.scene().parts.map);
        const LookImages& images = trial.desktop.presenter<LooksPresenter>().images();
        QTRY_VERIFY_WITH_TIMEOUT(!images.isRunning(), test::kPatience);
        QSignalSpy small(&images, &LookImages::made);
        click(message, "Find vessels");
        trial.wait();
        QVERIFY(trial.document.scene().parts.map && trial.document.look() == last);
        QCOMPARE(trial.document.scene().parts.curves.size(), std::size_t(1));
        QTRY_VERIFY_WITH_TIMEOUT(!small.isEmpty() && !images.isRunning(), test::kPatience);
        QCOMPARE(small.size(), 1);  // no other look shows vessels
        QCOMPARE(small[0][0].toInt(), last);
        trial.document.setModel(Model::absorption);
        QVERIFY(trial.document.scene().parts.map && !trial.notes().contains("shows no parts"));
        trial.document.setModel(Model::maximumIntensity);
        QVERIFY(!trial.document.scene().parts.map && trial.notes().contains("shows no parts"));
    }

    /// One rule after the other, until the scan has all parts of the look.
    void aLookOffersWhatIsStillMissing() {
        const std::vector<NamedLook> looks = fewLooksAnd("Bones, vessels and muscle");
        PartsTrial trial(makeCpuDevice(1), looks);
        trial.openAndWait(series_);
        trial.document.chooseLook(int(looks.size()) - 1);
        ui::MessageBar& message = trial.desktop.window().message();
        click(message, "Find vessels");
        trial.wait();
        QVERIFY2(message.text().contains("shows skin or muscle"), qPrintable(message.text()));
        click(message, "Find skin and muscle");
        trial.wait();
        QCOMPARE(trial.document.scene().parts.curves.size(), std::size_t(2));
        QVERIFY2(message.isHidden(), qPrintable(message.text()));
    }

    /// Each button asks for its own rule, which says why it finds nothing.
    void whatIsNotThereIsSaid() {
        PartsTrial trial;
        trial.openAndWait(series_);
        const auto said = [&](const char* name) {
            trial.button(name).click();
            trial.wait();
            return trial.desktop.window().message().text();
        };
        QVERIFY2(said("Find implants").contains("no metal is in this body"), qPrintable(said("Find implants")));
        QVERIFY2(said("Mirrored bone").contains("Mirrored bone cannot be found"), qPrintable(said("Mirrored bone")));
        QVERIFY(!trial.document.scanParts());
    }

    /// What was refused is said, and changes nothing.
    void aMapOfAnotherScanIsRefused() {
        PartsTrial trial;
        trial.openAndWait(series_);
        trial.findVessels();
        const std::shared_ptr<const ScanParts> before = trial.document.scanParts();
        LabelMap map = *before->map;
        map.geometry.patientFromIndex[3].y += 400;
        QVERIFY(bool(writeLabelFile(map, ui::fromQt(file("other.seg.nrrd")))));
        trial.presenter.open(file("other.seg.nrrd"));
        trial.wait();
        const QString said = trial.desktop.window().message().text();
        QVERIFY2(said.contains("another scan or patient") && said.contains("other.seg.nrrd"), qPrintable(said));
        QVERIFY(trial.document.scanParts() == before);
    }

    void escEndsASearch() {
        PartsTrial trial;
        trial.openAndWait(series_);
        trial.button("Find vessels").click();
        QVERIFY(trial.presenter.job().isRunning());  // what it finds is taken by the event loop
        QTest::keyClick(&trial.desktop.window(), Qt::Key_Escape);
        QVERIFY(!trial.presenter.job().isRunning());
        QVERIFY(!trial.document.scanParts() && !trial.document.canUndo());
        trial.findVessels();
        QVERIFY(trial.document.scanParts());
    }

    /// Its frame of reference and its patient are those of the scan, or nothing is loaded.
    void aSegmentationOfAnotherPatientIsRefused() {
        const QString files = PDR_SOURCE_DIR "/tests/oracle/labels/files/";
        PartsTrial trial;
        trial.openAndWait(files + "ct");
        QFile original(files + "binary.dcm");
        QVERIFY(original.open(QIODevice::ReadOnly));
        const QByteArray bytes = original.readAll();
        const auto said = [&](const QByteArray& was, const QByteArray& becomes) {
            QFile changed(file("seg.dcm"));
            const bool written = bytes.count(was) == 1 && changed.open(QIODevice::WriteOnly) &&
                                 changed.write(QByteArray(bytes).replace(was, becomes)) == bytes.size();
            changed.close();
            trial.presenter.open(file("seg.dcm"));
            trial.wait();
            return written ? trial.desktop.window().message().text() : "not written";
        };
        const QByteArray frame(
            "\x20\x00\x52\x00UI\x06\x00"
            "2.25.4",
            14),
            patient("\x10\x00\x20\x00LO\x02\x00L1", 10);
        const QString elsewhere = said(frame, QByteArray(frame).replace("2.25.4", "2.25.5"));
        QVERIFY2(elsewhere.contains("another frame of reference than the scan"), qPrintable(elsewhere));
        const QString anothers = said(patient, QByteArray(patient).replace("L1", "L2"));
        QVERIFY2(anothers.contains("names another patient than the scan"), qPrintable(anothers));
        QVERIFY(!trial.document.scanParts() && !trial.document.canUndo() && trial.list.topLevelItemCount() == 0);
        QVERIFY(said(frame, frame) != "not written");
        QVERIFY2(trial.document.scanParts(), qPrintable(trial.desktop.window().message().text()));
        QCOMPARE(trial.list.topLevelItemCount(), 4);
    }

    /// The voxels of another grid are taken only when that is asked for.
    void resamplingIsOffered() {
        PartsTrial trial;
        trial.openAndWait(series_);
        LabelMap map;
        map.geometry = VolumeGeometry::aligned({40, 30, 18}, {3.4, 3.4, 5.6}, {-66.3, -49.3, 2.1});
        map.labels.assign(map.geometry.voxelCount(), 1);
        map.parts = {{"liver", {40, 200, 40}}};
        QVERIFY(bool(writeLabelFile(map, ui::fromQt(file("coarse.seg.nrrd")))));
        trial.presenter.open(file("coarse.seg.nrrd"));
        trial.wait();
        ui::MessageBar& message = trial.desktop.window().message();
        QVERIFY2(message.text().contains("3.4 x 3.4 x 5.6 mm"), qPrintable(message.text()));
        QVERIFY(!trial.document.scanParts());
        click(message, "Resample");
        trial.wait();
        QVERIFY(trial.document.scanParts() && trial.list.topLevelItem(1)->text(0) == "liver");
    }

    void aPlanKeepsThem() {
        {
            PartsTrial trial;
            trial.openAndWait(series_);
            trial.findVessels();
            LabelMap map = *trial.document.scanParts()->map;
            map.parts[0].name = "aorta";
            QVERIFY(bool(writeLabelFile(map, ui::fromQt(file("aorta.seg.nrrd")))));
            trial.presenter.open(file("aorta.seg.nrrd"));
            trial.wait();
            trial.list.topLevelItem(0)->setSelected(true);
            trial.button("Ghost").click();
            QSignalSpy saved(&trial.desktop.presenter<PlanPresenter>().job(), &PlanJob::saved);
            trial.desktop.presenter<PlanPresenter>().save(file("parts.plan.json"));
            QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, test::kPatience);
        }
        QFile plan(file("parts.plan.json"));
        QVERIFY(plan.open(QIODevice::ReadOnly));
        const QByteArray text = plan.readAll();
        QVERIFY2(!text.contains("aorta") && text.contains("\"vessels\": 1"), text.right(400).constData());

        PartsTrial trial;
        trial.openAndWait(series_);
        trial.desktop.presenter<PlanPresenter>().open(file("parts.plan.json"));
        QTRY_VERIFY_WITH_TIMEOUT(trial.document.scanParts(), test::kPatience);  // the vessels alone
        QCOMPARE(trial.list.topLevelItemCount(), 2);
        const QString said = trial.desktop.window().message().text();
        QVERIFY2(said.contains("Open that label map again"), qPrintable(said));
        QCOMPARE(trial.list.topLevelItem(0)->text(2), QString("ghost"));
        trial.presenter.open(file("aorta.seg.nrrd"));
        trial.wait();
        QCOMPARE(trial.list.topLevelItemCount(), 3);
    }

    void theyGoWithTheirSeries() {
        PartsTrial trial;
        trial.openAndWait(series_);
        trial.findVessels();
        const std::weak_ptr<const ScanParts> held = trial.document.scanParts();
        trial.document.close();
        QVERIFY(trial.list.topLevelItemCount() == 0 && !trial.panel.isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(held.expired(), test::kPatience);
    }

  private:
    /// Few looks, and the bundled one of that name last.
    static std::vector<NamedLook> fewLooksAnd(const std::string& name) {
        std::vector<NamedLook> looks = fewLooks();
        const std::vector<NamedLook> all = *bundledLooks();
        looks.push_back(*std::ranges::find(all, name, &NamedLook::name));
        return looks;
    }
    static void click(const ui::MessageBar& message, const QString& offer) {
        for (auto* button : message.findChildren<QPushButton*>())
            if (button->text() == offer)
                button->click();
    }

    QString file(const char* name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;
    QString series_;
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::PartsInWindowTest)
#include "parts_in_window_test.moc"
