#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "render/volume/file/label_file.h"
#include "tests/support/grid_files.h"
#include "tests/support/program_run.h"

using namespace pdr;

/// `pdrender-cli parts` lists what a label map marks in a scan, or says why the map does not belong to it.
class PartsCommandTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString at(const char* name) const { return folder_.filePath(name); }
    QString scan() const {
        test::written(at("scan.nii").toStdString(), test::NiftiBytes().bytes);
        return at("scan.nii");
    }
    /// A label map on the grid of the scan, moved along x [mm], with two labels.
    QString labels(double movedMm) const {
        test::NiftiBytes file;
        file.sform[3].x += movedMm;
        file.stateAll();
        std::vector<std::int16_t> values(6 * 5 * 8, 0);
        for (std::size_t i = 0; i < 60; ++i)
            values[i] = std::int16_t(i < 20 ? 4 : 2);
        test::written(at("labels.nii").toStdString(), file.bytes.substr(0, 352) + test::bytesOf(values));
        return at("labels.nii");
    }

  private slots:
    void partsAreListedWithTheirVolumes() {
        const auto run = test::runProgram("pdrender-cli",
                                          {"parts", scan(), "--labels", labels(0), "--json", "-o", at("out.seg.nrrd")});
        QVERIFY2(run.code == 0, run.err.constData());
        const QJsonObject report = QJsonDocument::fromJson(run.out).object();
        QCOMPARE(report["source"].toString(), QString("a label map (NIfTI)"));
        const QJsonArray parts = report["parts"].toArray();
        QCOMPARE(parts.size(), 2);
        QCOMPARE(parts[0].toObject()["name"].toString(), QString("part 2"));
        QVERIFY(std::abs(parts[0].toObject()["ml"].toDouble() - 40 * 0.8 * 0.9 * 1.5 / 1000) < 1e-6);
        QVERIFY(std::abs(parts[1].toObject()["ml"].toDouble() - 20 * 0.8 * 0.9 * 1.5 / 1000) < 1e-6);
        const auto written = readLabelFile(at("out.seg.nrrd").toStdString(), noProgress);
        QVERIFY(bool(written));
        QCOMPARE(written->parts.size(), std::size_t(2));
    }

    void aMapBesideTheScanIsRefused() {
        const auto run = test::runProgram("pdrender-cli", {"parts", scan(), "--labels", labels(0.4)});
        QCOMPARE(run.code, 1);
        QVERIFY(run.out.isEmpty());
        QVERIFY2(run.err.contains("labels.nii: the label map is shifted: its voxels lie 0.4 mm (0.5 voxels) beside"),
                 run.err.constData());
    }

    void usageIsExplained() {
        QCOMPARE(test::runProgram("pdrender-cli", {"parts", "--help"}).code, 0);
        const auto run = test::runProgram("pdrender-cli", {"parts", scan()});
        QCOMPARE(run.code, 2);
        QVERIFY(run.err.contains("parts: needs --labels or --find"));
        const auto elsewhere =
            test::runProgram("pdrender-cli", {"parts", scan(), "--labels", labels(0), "-o", at("out.nii")});
        QCOMPARE(elsewhere.code, 2);
        QVERIFY2(elsewhere.err.contains("--output: must end in .seg.nrrd"), elsewhere.err.constData());
    }
};

QTEST_GUILESS_MAIN(PartsCommandTest)
#include "parts_command_test.moc"
