/// The scanner's table from the import to the image: hidden by itself, shown again with one click, in the command
/// line and in what images say of themselves.

#include <QImage>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "dicom/write/export.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/dicom/lying_patients.h"
#include "tests/support/program_run.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

test::Lying patientOnTable() {
    return test::lying([](dvec3 p) { return test::either(test::trunk(p), test::table(p, 45)); }, {96, 72, 40},
                       dvec3(2, 2, 2.5));
}

/// Opens that patient as the import does.
void openWithoutTable(Document& document, const Volume& scan, const segment::HiddenTable& table) {
    document.open(table.body, table, {},
                  std::make_shared<const HiddenVoxels>(*HiddenVoxels::of(scan, *table.body, noProgress)));
}

bool sameImage(const Film& a, const Film& b) {
    return sameBits(a.content(), b.content());
}

}  // namespace

class TestTable : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        series_ = folder_.filePath("series");
        const dicom::ExportFacts facts{"Phantom^Trunk", "TRUNK", "Test", "Trunk", "Made from formulas."};
        const auto written = dicom::writeSeries(*patientOnTable().volume, facts, ui::fromQt(series_), noProgress);
        QVERIFY2(written, written ? "" : written.error().text().c_str());
    }

    void theWindowHidesItSaysSoAndShowsItAgain() {
        Trial trial;
        trial.openAndWait(series_);
        Document& document = trial.desktop.document();
        ui::MainWindow& window = trial.desktop.window();
        const auto without = document.scene().volume;
        QVERIFY2(QString::fromStdString(without->hidden()).contains(" ml of "), without->hidden().c_str());
        QVERIFY(window.message().text().startsWith("Table and holder hidden: "));
        QVERIFY(window.message().text().contains("touched the skin: check the edge."));
        QVERIFY(document.hasTable() && !document.canUndo());

        window.message().findChild<QPushButton*>()->click();
        QVERIFY(window.message().isHidden());
        const auto with = document.scene().volume;
        QVERIFY(with != without && with->hidden().empty());
        QVERIFY(std::ranges::equal(with->voxels(), patientOnTable().volume->voxels()));
        trial.waitForNewest();

        document.undo();
        QVERIFY(document.scene().volume == without && !document.canUndo());
        document.redo();
        QVERIFY(document.scene().volume == with);
        QTest::keyClick(&window, Qt::Key_T);
        QVERIFY(document.scene().volume == without);
        QTest::keyClick(&window, Qt::Key_T);
        QVERIFY(document.scene().volume == with);
    }

    void whoShowsItByKeyIsNotOfferedItAnyMore() {
        Trial trial;
        trial.openAndWait(series_);
        ui::MessageBar& message = trial.desktop.window().message();
        QVERIFY(!message.isHidden());
        QTest::keyClick(&trial.desktop.window(), Qt::Key_T);
        QVERIFY(message.isHidden());
    }

    /// The tick is all that is remembered, and the image comes back to the bit.
    void undoBringsBackTheSameImage() {
        const auto patient = patientOnTable();
        const auto table = *segment::hideTable(*patient.volume, noProgress);
        std::vector<NamedLook> looks = *bundledLooks();
        Document document(looks);
        document.setViewSize({40, 30});
        openWithoutTable(document, *patient.volume, table);
        const Film before = test::render(document.scene(), 4);
        document.setTable(Table::shown);
        QVERIFY(!sameImage(before, test::render(document.scene(), 4)));
        document.undo();
        QVERIFY(sameImage(before, test::render(document.scene(), 4)));
        document.setTable(Table::hidden);  // it is
        QVERIFY(!document.canUndo());
    }

    void theViewIsFilledByWhatIsSeen() {
        const auto patient = patientOnTable();
        const auto table = *segment::hideTable(*patient.volume, noProgress);
        Document document(*bundledLooks());
        document.setViewSize({400, 300});
        openWithoutTable(document, *patient.volume, table);
        const Camera near = document.setup().camera;
        QVERIFY(glm::length(near.targetMm - table.bodyBox.centreMm()) < 1e-9);
        document.setTable(Table::shown);
        QVERIFY(document.setup().camera == near);  // the user's view is left alone
        document.resetView();
        const Camera far = document.setup().camera;
        QVERIFY(glm::length(far.targetMm - patient.volume->geometry().centreMm()) < 1e-9);
        QVERIFY(glm::length(far.eyeMm - far.targetMm) > glm::length(near.eyeMm - near.targetMm));
        document.setTable(Table::hidden);
        document.resetView();
        QVERIFY(document.setup().camera == near);
    }

    void theNextScanIsShownWithoutItsTable() {
        const auto patient = patientOnTable();
        const auto table = *segment::hideTable(*patient.volume, noProgress);
        Document document(*bundledLooks());
        document.setTable(Table::shown);  // of nothing
        openWithoutTable(document, *patient.volume, table);
        document.setTable(Table::shown);
        openWithoutTable(document, *patient.volume, table);
        QVERIFY(document.scene().volume == table.body);
        document.open(patient.volume);
        document.setTable(Table::shown);
        QVERIFY(!document.hasTable() && !document.canUndo() && document.scene().volume == patient.volume);
    }

    /// Both volumes are freed before the next is read.
    void closingFreesTheScanAndItsCopy() {
        const auto patient = patientOnTable();
        auto table = *segment::hideTable(*patient.volume, noProgress);
        const std::weak_ptr<const Volume> body = table.body;
        Document document(*bundledLooks());
        openWithoutTable(document, *patient.volume, table);
        table = {};
        document.setTable(Table::shown);
        const std::weak_ptr<const Volume> scan = document.scene().volume;
        QVERIFY(!body.expired() && !scan.expired());
        document.close();
        QVERIFY(body.expired() && scan.expired());
    }

    /// The scan lies in memory only while its table is shown, and is the one that was read.
    void theScanIsKeptPacked() {
        const auto patient = patientOnTable();
        const auto table = *segment::hideTable(*patient.volume, noProgress);
        const HiddenVoxels hidden = *HiddenVoxels::of(*patient.volume, *table.body, noProgress);
        const auto voxels = patient.volume->voxels();
        QVERIFY2(4 * hidden.bytes() < voxels.size_bytes(), qPrintable(QString::number(hidden.bytes())));
        const Volume again = hidden.scanOf(*table.body);
        QVERIFY(std::ranges::equal(again.voxels(), voxels));
        QVERIFY(again.hidden().empty() && again.highestHu() == patient.volume->highestHu());
        QVERIFY(!HiddenVoxels::of(*patient.volume, *table.body, [](double, std::string_view) { return false; }));

        Document document(*bundledLooks());
        openWithoutTable(document, *patient.volume, table);
        document.setTable(Table::shown);
        const std::weak_ptr<const Volume> scan = document.scene().volume;
        QVERIFY(!scan.expired());
        document.setTable(Table::hidden);
        QVERIFY(scan.expired());
    }

    void theCommandLineHidesItUnlessToldOtherwise() {
        for (const QString word : {"", "hidden", "shown"}) {
            const QString file = folder_.filePath("picture.png");
            QStringList arguments{"render", series_, "-o", file, "--samples", "1", "--size", "32x32"};
            if (!word.isEmpty())
                arguments << "--table" << word;
            const test::ProgramRun run = test::runProgram("pdrender-cli", arguments);
            QCOMPARE(run.code, 0);
            QCOMPARE(run.err.contains("Table and holder hidden: "), word != "shown");
            const QString fact = QImage(file).text("pdrender/hidden");
            QVERIFY2(word == "shown" ? fact.isEmpty() : fact.endsWith(", rule 2, -250 HU, 3 mm, 10 mm"),
                     qPrintable(fact));
        }
        QVERIFY(test::runProgram("pdrender-cli", {"render", series_, "-o", "x.png", "--table", "gone"})
                    .err.contains("must be hidden or shown"));
    }

    /// A scene file says itself what it shows; the voxels that it names are shown whole where it says nothing.
    void aSceneFileShowsItUnlessItSaysOtherwise() {
        const auto imageOf = [&](const QString& table, const QStringList& more) {
            QFile scene(folder_.filePath("scene.json"));
            if (!scene.open(QIODevice::WriteOnly))
                qFatal("the test cannot write its files");
            scene.write(QString(R"({ "format": "pdrender-scene", "version": 1, "volume": { "dicom": "series"%1 },
                "transferFunction": { "extinctionPerMm": 1, "nodes": [ { "hu": 0, "opacity": 0 }, { "hu": 100, "opacity": 1 } ] },
                "camera": { "eyeMm": [0, 600, 0], "targetMm": [0, 0, 0] }, "film": { "width": 16, "height": 16 } })")
                            .arg(table)
                            .toUtf8());
            scene.close();
            const QString file = folder_.filePath("scene.png");
            const test::ProgramRun run = test::runProgram(
                "pdrender-cli", QStringList{"render", scene.fileName(), "-o", file, "--samples", "1"} + more);
            return run.code == 0 ? QImage(file).text("pdrender/hidden") : QString("no picture: ") + run.err;
        };
        QCOMPARE(imageOf("", {}), QString());
        QVERIFY(imageOf(", \"table\": \"hidden\"", {}).contains("rule 2"));
        QVERIFY(imageOf("", {"--table", "hidden"}).contains("rule 2"));
        QCOMPARE(imageOf(", \"table\": \"hidden\"", {"--table", "shown"}), QString());
    }

    void theListOfSeriesTellsItsMillilitres() {
        const test::ProgramRun run = test::runProgram("pdrender-cli", {"info", series_});
        QVERIFY2(run.out.contains("touched the skin\n"), qPrintable(run.out));
    }

  private:
    QTemporaryDir folder_;
    QString series_;
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestTable)
#include "table_test.moc"
