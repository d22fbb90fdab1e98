/// Window and command line take the same road from a folder to an image: what the window saves of it, made anew, is
/// what `pdrender-cli render` writes, bit for bit, and what `pdrender-cli plan` renders of the window's plan.

#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include "app/document/part_edits.h"
#include "app/presenters/looks_presenter.h"
#include "app/presenters/parts_presenter.h"
#include "app/presenters/plan_presenter.h"
#include "app/presenters/saving_presenter.h"
#include "dicom/write/export.h"
#include "render/volume/file/label_nrrd.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "tests/support/program_run.h"
#include "tests/support/scenes/vessel_phantoms.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// Compares images and what their files say of them.
static void compare(const QImage& ofWindow, const QImage& ofLine) {
    for (const QString& key : ofLine.textKeys())
        if (key != "pdrender/seconds" && key != "pdrender/bias")  // both hang on the clock
            QVERIFY2(ofWindow.text(key) == ofLine.text(key),
                     qPrintable(key + ": " + ofWindow.text(key) + " / " + ofLine.text(key)));
    QCOMPARE(ofWindow, ofLine);
}

class TestSameImage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void theWindowsImageIsThatOfTheCommandLine_data();
    void theWindowsImageIsThatOfTheCommandLine();
    void aPlanWithPartsIsRenderedTheSame();

  private:
    QString saved(Trial& trial) const;
    void comparePlan(Trial& trial, const QStringList& scan, const QStringList& options) const;

    QTemporaryDir folder_;
    QString series_;
};

void TestSameImage::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_));
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

void TestSameImage::theWindowsImageIsThatOfTheCommandLine_data() {
    QTest::addColumn<QString>("look");  // empty: the one that the scan is opened with
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<bool>("denoised");
    QTest::newRow("as it is opened") << QString() << QStringList() << false;
    QTest::newRow("a part, denoised") << QString("Bones alone") << QStringList{"--look", "Bones alone", "--denoised"}
                                      << true;
    QTest::newRow("a cut") << QString("Heart and great vessels") << QStringList{"--look", "Heart and great vessels"}
                           << false;
    QTest::newRow("a look with another part")
        << QString("MIP") << QStringList{"--look", "MIP", "--show", "bones"} << false;
    QTest::newRow("another model") << QString("MIP") << QStringList{"--look", "MIP"} << false;
}

/// Seed, model, brightness, camera, look, cut and part are each side's own choice.
void TestSameImage::theWindowsImageIsThatOfTheCommandLine() {
    QFETCH(QString, look);
    QFETCH(QStringList, options);
    QFETCH(bool, denoised);
    Trial trial(makeCpuDevice(1), *bundledLooks());
    QSignalSpy brightness(&trial.desktop.presenter<LooksPresenter>().images(), &LookImages::made);
    trial.openAndWait(series_);
    Document& document = trial.desktop.document();
    QTRY_COMPARE_WITH_TIMEOUT(brightness.count(), int(document.looks().fitted().size()), test::kPatience);
    for (int i = 0; document.looks().holds(i); ++i)
        if (document.looks()[i].name == look.toStdString())
            document.chooseLook(i);
    if (options.contains("--show"))
        document.setVisible({{"bones"}});
    document.setDenoised(denoised);
    QTRY_VERIFY_WITH_TIMEOUT(!document.scene().maskAwaited, test::kPatience);
    document.setNextFilm({150, 120});
    document.resetView();

    const QString window = saved(trial);
    const QString line = folder_.filePath("line.png");
    const test::ProgramRun made = test::runProgram(
        "pdrender-cli", QStringList{"render", series_, "-o", line, "--size", "150x120", "--samples", "32", "--device",
                                    "cpu", "--exposure", "auto", "--annotations", "none"} +
                            options);
    QVERIFY2(made.code == 0, made.err.constData());
    compare(QImage(window), QImage(line));
    comparePlan(trial, {"--scan", series_}, denoised ? QStringList{"--denoised"} : QStringList());
}

/// The plan holds no voxel of a part: rules find theirs again, and the label map is named.
void TestSameImage::aPlanWithPartsIsRenderedTheSame() {
    const QString series = folder_.filePath("aorta"), labels = folder_.filePath("organ.seg.nrrd");
    const Volume scan = test::scanOf(test::aortaBesideSpine());
    const dicom::ExportFacts facts{"Phantom^Aorta", "AORTA", "Test", "Aorta", "Made from formulas."};
    QVERIFY(bool(dicom::writeSeries(scan, facts, ui::fromQt(series), noProgress)));
    LabelMap map;
    map.geometry = scan.geometry();
    map.labels.assign(map.geometry.voxelCount(), 0);
    std::fill(map.labels.begin() + map.labels.size() / 2, map.labels.end(), std::uint8_t(1));
    map.parts = {{"organ", {40, 200, 40}}};
    QVERIFY(bool(writeLabelFile(map, ui::fromQt(labels))));

    Trial trial;
    trial.openAndWait(series);
    Document& document = trial.desktop.document();
    auto& presenter = trial.desktop.presenter<PartsPresenter>();
    presenter.open(labels);
    QTRY_VERIFY_WITH_TIMEOUT(document.scanParts(), test::kPatience);
    emit presenter.panel().vesselsWanted();
    QTRY_COMPARE_WITH_TIMEOUT(document.scanParts()->facts.size(), std::size_t(2), test::kPatience);
    PartEdits edits(document);
    edits.setState({0}, PartState::ghost);
    edits.setColour({1}, vec3(0.1f, 0.6f, 0.2f));
    edits.setColour({2}, vec3(0.7f, 0.1f, 0.1f));
    QCOMPARE(document.scene().parts.curves.size(), std::size_t(2));
    document.setDenoised(false);
    document.setNextFilm({150, 120});
    document.resetView();
    saved(trial);
    comparePlan(trial, {"--scan", series}, {"--labels", labels});
    QVERIFY(QImage(folder_.filePath("planned.png")).text("pdrender/notShown").endsWith("Ghost: rest of the body."));
}

/// Renders an image of the document's scene into a file, and returns its name.
QString TestSameImage::saved(Trial& trial) const {
    const QString file = folder_.filePath("window.png");
    QSignalSpy saved(&trial.desktop.presenter<SavingPresenter>().job(), &ImageJob::saved);
    trial.desktop.presenter<SavingPresenter>().render(
        {file, QSize(150, 120), {.levels = kFinestStep, .samples = 32}, ui::Annotate::none});
    [&] { QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience); }();
    return file;
}

/// Compares the image that saved() has rendered with that of the document's plan by the command line.
void TestSameImage::comparePlan(Trial& trial, const QStringList& scan, const QStringList& options) const {
    const QString plan = folder_.filePath("look.plan.json"), planned = folder_.filePath("planned.png");
    auto& plans = trial.desktop.presenter<PlanPresenter>();
    QSignalSpy kept(&plans.job(), &PlanJob::saved);
    plans.save(plan);
    QTRY_COMPARE_WITH_TIMEOUT(kept.count(), 1, test::kPatience);
    const test::ProgramRun ofPlan =
        test::runProgram("pdrender-cli", QStringList{"plan", plan} + scan +
                                             QStringList{"--render", "-o", planned, "--size", "150x120", "--samples",
                                                         "32", "--device", "cpu", "--annotations", "none"} +
                                             options);
    QVERIFY2(ofPlan.code == 0, ofPlan.err.constData());
    compare(QImage(folder_.filePath("window.png")), QImage(planned));
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestSameImage)
#include "same_image_test.moc"
