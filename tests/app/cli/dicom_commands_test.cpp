#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>
#include <QTest>

#include <cstdint>
#include <fstream>
#include <vector>

#include "dicom/import.h"
#include "tests/support/dicom/shared_data.h"
#include "tests/support/dicom/slice_file.h"
#include "tests/support/grid_files.h"
#include "tests/support/places.h"
#include "tests/support/program_run.h"

using namespace pdr;

namespace {

struct Run : test::ProgramRun {
    QJsonObject json() const { return QJsonDocument::fromJson(out).object(); }
    QJsonObject series(int index) const { return json()["series"].toArray().at(index).toObject(); }
    QJsonObject firstSeries() const { return series(0); }
};

Run run(const QStringList& arguments,
        const QProcessEnvironment& environment = QProcessEnvironment::systemEnvironment()) {
    return {test::runProgram("pdrender-cli", arguments,
                             [&](QProcess& process) { process.setProcessEnvironment(environment); })};
}

}  // namespace

class DicomCommandsTest : public QObject {
    Q_OBJECT

    QTemporaryDir root_;
    QString at(const char* name) const { return root_.filePath(name); }

    /// A file like InVesalius' matrix.dat: every voxel tells its row and its slice.
    QString craniumFile() const {
        Voxels voxels;
        for (int z = 0; z < 108; ++z)
            for (int y = 0; y < 256; ++y)
                voxels.insert(voxels.end(), 256, std::int16_t(y * 100 + z));
        std::ofstream(at("matrix.dat").toStdString(), std::ios::binary)
            .write(reinterpret_cast<const char*>(voxels.data()), std::streamsize(voxels.size() * 2));
        return at("matrix.dat");
    }

    /// Three axial and three coronal slices of one series, once compressed with loss; somebody wrote a name.
    void makeTwoParts() const {
        const std::filesystem::path folder = at("parts").toStdString();
        std::filesystem::create_directories(folder);
        for (int k = 0; k < 6; ++k) {
            test::SliceFile slice{.size = {16, 16}, .position = {0, 0, 2.0 * k}};
            slice.change = [k](DcmDataset& data) {
                data.putAndInsertString(DCM_SeriesDescription, "Mrs Secret");
                data.putAndInsertString(DCM_SeriesNumber, "7");
                data.putAndInsertString(DCM_LossyImageCompression, "01");
                data.putAndInsertString(DCM_LossyImageCompressionRatio, "10");
                if (k < 3)
                    return;
                data.putAndInsertString(DCM_ImageOrientationPatient, "1\\0\\0\\0\\0\\-1");
                data.putAndInsertString(DCM_ImagePositionPatient, ("0\\" + std::to_string(k) + "\\0").c_str());
            };
            test::writeSliceFile(folder / std::to_string(k), slice);
        }
    }

  private slots:
    void infoGivesTheChestInFigures() {
        PDR_NEEDS_SHARED_CT();
        const QString folder = QString::fromStdString((test::sharedCt() / "chest_contrast").string());
        const Run info = run({"info", folder, "--json"});
        QCOMPARE(info.code, 0);
        QCOMPARE(info.json()["filesSeen"].toInt(), 100);
        const QJsonObject series = info.firstSeries();
        QCOMPARE(series["size"].toArray(), (QJsonArray{512, 512, 100}));
        QVERIFY(std::abs(series["spacingMm"].toArray()[0].toDouble() - 0.898438) < 1e-9);
        QVERIFY(std::abs(series["spacingMm"].toArray()[2].toDouble() - 2.5) < 1e-9);
        QCOMPARE(series["hu"]["lowest"].toInt(), -3024);
        QCOMPARE(series["hu"]["highest"].toInt(), 3071);
        QVERIFY(std::abs(series["hu"]["mean"].toDouble() + 1138.338608742) < 1e-9);
        QVERIFY(std::abs(series["huWithoutPadding"]["mean"].toDouble() + 628.738919282) < 1e-9);
        QCOMPARE(series["sha256"].toString(), "946f8eff4f00ddee9198713a6dbe7822f6d69311d2c0ab09ab32376039bf2b66");
        QCOMPARE(series["verdict"].toString(), "even");
    }

    /// The distance between slices is that across them, not that along the table.
    void infoTellsGapAndDriftOfATiltedGantry() {
        PDR_NEEDS_SHARED_CT();
        const QString folder = QString::fromStdString((test::sharedCt() / "mixed_study_tilt").string());
        const QJsonObject series = run({"info", folder, "--json"}).firstSeries();
        QVERIFY(std::abs(series["spacingMm"].toArray()[2].toDouble() - 2.37081) < 1e-5);
        QVERIFY(std::abs(series["driftMm"].toArray()[0].toDouble()) < 1e-9);
        QVERIFY(std::abs(series["driftMm"].toArray()[1].toDouble() + 0.79326) < 1e-5);
        QVERIFY(series["notes"].toArray()[0].toString().contains("tilted by 18.5 degrees"));
        const Run words = run({"info", folder});
        QVERIFY2(words.out.contains("drift            0, -0.793262 mm a slice"), words.out.constData());
    }

    void infoTellsFiguresOfAStackItRefuses() {
        PDR_NEEDS_SHARED_CT();
        const QString folder = QString::fromStdString((test::sharedCt() / "missing_slice").string());
        const Run info = run({"info", folder, "--json"});
        QVERIFY(info.firstSeries()["resampled"].toBool() && info.firstSeries()["loadable"].toBool());
        const QJsonObject series = info.series(1);
        QVERIFY(!series["resampled"].toBool() && !series["loadable"].toBool());
        QCOMPARE(series["verdict"].toString(), "gap");
        QVERIFY(series["reason"].toString().contains("10 mm apart"));
        QVERIFY(series["sha256"].toString().startsWith("21db65407cd46cdf"));
    }

    /// What `info` tells of a volume file, and a slice of it: two of the commands that take a file for a folder.
    void aVolumeFileIsTakenForAFolder() {
        const QString file = at("scan.mha");
        test::written(file.toStdString(), test::metaImageBytes());
        const Run info = run({"info", file, "--json"});
        QCOMPARE(info.code, 0);
        const QJsonObject series = info.firstSeries();
        QCOMPARE(series["size"].toArray(), (QJsonArray{6, 5, 8}));
        QCOMPARE(series["hu"]["lowest"].toInt(), -1000);
        QCOMPARE(series["hu"]["highest"].toInt(), 1390);
        QVERIFY(series["notes"].toArray()[0].toString().contains("they run from -1000 to 1390"));
        const Run slice = run({"slice", file, "--plane", "axial", "-o", at("scan.png")});
        QVERIFY2(slice.code == 0, slice.err.constData());
        QVERIFY(slice.err.contains("does not say that its values are HU"));
    }

    void infoNeverNamesThePatient() {
        PDR_NEEDS_SHARED_CT();
        const QString folder = QString::fromStdString((test::sharedCt() / "charsets").string());
        for (const QStringList& arguments : {QStringList{"info", folder}, QStringList{"info", folder, "--json"}}) {
            const Run info = run(arguments);
            QCOMPARE(info.code, 0);
            QVERIFY(!info.out.contains("Yamada") && !info.out.contains("Hong") && !info.err.contains("Yamada"));
        }
    }

    /// What identifies the patient, the study and the slices: an image and what is printed beside it hold none of it.
    void imagesIdentifyNobody() {
        static const std::vector<std::pair<DcmTagKey, const char*>> kIdentity{
            {DCM_PatientName, "Canary^Wilma"},         {DCM_PatientID, "CANARY4711"},
            {DCM_PatientBirthDate, "19290401"},        {DCM_AccessionNumber, "ACC77821"},
            {DCM_StudyInstanceUID, "1.2.826.77821.1"}, {DCM_FrameOfReferenceUID, "1.2.826.77821.2"},
            {DCM_StudyDescription, "Canary study"},    {DCM_SeriesDescription, "Canary series"}};
        const QTemporaryDir folder;
        for (int k = 0; k < 4; ++k) {
            test::SliceFile slice{.size = {16, 16}, .position = {0, 0, 2.0 * k}, .seriesUid = "1.2.826.77821.3"};
            slice.change = [k](DcmDataset& data) {
                for (const auto& [tag, value] : kIdentity)
                    data.putAndInsertString(tag, value);
                data.putAndInsertString(DCM_SOPInstanceUID, ("1.2.826.77821.4." + std::to_string(k)).c_str());
            };
            test::writeSliceFile(folder.filePath(QString::number(k)).toStdString(), slice);
        }
        const QStringList render{"render", folder.path(), "--samples", "1", "--size", "64x64", "-o"};
        for (const QStringList& how : {QStringList{at("who.png"), "--annotations", "none"}, QStringList{at("who.png")},
                                       QStringList{at("who.exr")}, QStringList{at("who.png"), "--json"}}) {
            const Run made = run(render + how);
            QVERIFY2(made.code == 0, made.err.constData());
            QFile image(how.front());
            QVERIFY(image.open(QIODevice::ReadOnly));
            QByteArray said = image.readAll() + made.out + made.err;
            const QImage picture(how.front());
            for (const QString& key : picture.textKeys())  // which PNG may have compressed
                said += picture.text(key).toUtf8();
            for (const char* part : {"anary", "ANARY", "19290401", "ACC77821", "77821", "1.2.840.10008.5.1.4.1.1.2"})
                QVERIFY2(!said.contains(part), part);
        }
    }

    void infoTellsDescriptionsOnlyWhereAsked() {
        makeTwoParts();
        for (const QStringList& how : {QStringList{}, QStringList{"--json"}}) {
            QVERIFY(!run(QStringList{"info", at("parts")} + how).out.contains("Mrs Secret"));
            QVERIFY(run(QStringList{"info", at("parts"), "--descriptions"} + how).out.contains("Mrs Secret"));
        }
    }

    void infoSpeaksInWords() {
        makeTwoParts();
        const Run info = run({"info", at("parts")});
        QVERIFY2(info.out.contains("CT series 7, 3 images: can be loaded\n"), info.out.constData());
        QVERIFY2(info.out.contains("note             3 slices were compressed with loss"), info.out.constData());
        QVERIFY2(info.out.contains("id               1.2.3.1#2\n"), info.out.constData());
    }

    void renderReachesEachPartAndSaysWhatTheImportRemarked() {
        makeTwoParts();
        for (const char* id : {"1.2.3.1", "1.2.3.1#2"}) {
            const Run render =
                run({"render", at("parts"), "--series", id, "-o", at("part.png"), "--samples", "1", "--size", "8x8"});
            QVERIFY2(render.code == 0, render.err.constData());
            QVERIFY2(render.err.contains("note: 3 slices were compressed with loss (an earlier coding, 10:1)"),
                     render.err.constData());
            QCOMPARE(QImage(at("part.png")).text("pdrender/remarks"), QString("lossy parts"));
        }
        const Run none = run({"render", at("parts"), "--series", "1.2.3.1#3", "-o", at("part.png"), "--samples", "1"});
        QCOMPARE(none.code, 1);
    }

    /// Without its last slice a stack is as even as before: nothing but a word tells that the top of a skull is gone.
    void endSliceThatCannotBeReadIsTold_data() {
        QTest::addColumn<QByteArray>("left");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("100 bytes") << QByteArray(100, '\0');
        QTest::newRow("garbage") << QByteArray(10000, 'x');
        QTest::newRow("cut in its header") << QByteArray(128, '\0') + "DICM" + QByteArray(9, '\1');
    }
    void endSliceThatCannotBeReadIsTold() {
        QFETCH(QByteArray, left);
        const QTemporaryDir folder;
        for (int k = 0; k < 4; ++k)
            test::writeSliceFile(folder.filePath(QString("%1.dcm").arg(k)).toStdString(),
                                 {.size = {16, 16}, .position = {0, 0, 2.0 * k}});
        std::ofstream(folder.filePath("4.dcm").toStdString(), std::ios::binary)
            .write(left.constData(), std::streamsize(left.size()));
        const Run render = run({"render", folder.path(), "-o", at("end.png"), "--samples", "1", "--size", "8x8"});
        QCOMPARE(render.code, 0);
        QVERIFY2(render.err.contains("note: 1 file could not be read") && render.err.contains("4.dcm"),
                 render.err.constData());
        const QJsonObject info = run({"info", folder.path(), "--json"}).json();
        QCOMPARE(info["notDicom"].toInt(), 0);
        QCOMPARE(info["problems"].toArray().size(), 1);
    }

    void effectsAndReplaySayWhatTheImportRemarked() {
        makeTwoParts();
        const Run effects = run({"effects", at("parts"), "--size", "4x4"});
        QVERIFY2(effects.code == 0 && effects.err.contains("note: 3 slices were"), effects.err.constData());
        const Run replay = run({"replay", at("parts"), "--size", "4x4", "--pixel", "1,1"});
        QVERIFY2(replay.code == 0 && replay.err.contains("note: 3 slices were"), replay.err.constData());
    }

    void wrongUseIsTwoAndErrorsAreOne() {
        QCOMPARE(run({"info"}).code, 2);
        QCOMPARE(run({"info", "--nonsense"}).code, 2);
        QCOMPARE(run({"info", "--help"}).code, 0);
        QCOMPARE(run({"example"}).code, 2);
        QCOMPARE(run({"example", at("x"), "--cranium"}).code, 2);
        QCOMPARE(run({"example", "--help"}).code, 0);
        const Run missing = run({"info", at("missing")});
        QCOMPARE(missing.code, 1);
        QVERIFY(missing.err.contains("no such folder"));
    }

    void missingDictionaryIsSaid() {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("DCMDICTPATH", at("missing.dic"));
        const Run info = run({"info", root_.path()}, environment);
        QCOMPARE(info.code, 1);
        QVERIFY2(info.err.contains("dictionary"), info.err.constData());
    }

    void craniumIsNeitherMirroredNorTurned() {
        const Run example = run({"example", at("cranium"), "--cranium", craniumFile()});
        QVERIFY2(example.code == 0, example.err.constData());
        const auto scan = dicom::scanFolder(at("cranium").toStdString(), noProgress);
        QVERIFY(bool(scan));
        const dicom::Series& series = scan->series.front();
        QVERIFY(series.verdict.loadable());
        QVERIFY(series.geometry.size == ivec3(256, 256, 108));
        QVERIFY(glm::distance(series.geometry.spacingMm(), dvec3(0.9570312, 0.9570312, 1.5)) < 1e-9);
        const auto volume = dicom::loadSeries(series, dicom::Padding::maskAsAir, noProgress);
        QVERIFY(bool(volume));
        // The file's last row is the face; in the patient, low y is the front.
        const auto hu = [&](std::size_t y, std::size_t z) { return int(volume->voxels()[(z * 256 + y) * 256]); };
        QCOMPARE(hu(0, 0), 25500);
        QCOMPARE(hu(255, 0), 0);
        QCOMPARE(hu(255, 107), 107);
        QVERIFY(series.geometry.patientFromIndex[1].y > 0 && series.geometry.patientFromIndex[2].z > 0);
    }

    void wrongMatrixLeavesNothing() {
        std::ofstream(at("short.dat").toStdString()) << "short";
        const Run example = run({"example", at("none"), "--cranium", at("short.dat")});
        QCOMPARE(example.code, 1);
        QVERIFY(example.err.contains("256 x 256 x 108"));
        QVERIFY(!QFileInfo::exists(at("none")));
    }

    void phantomStandsInAndSaysSo() {
        const Run example = run({"example", at("phantom")});
        QCOMPARE(example.code, 0);
        QVERIFY(example.err.contains("phantom"));
        const Run info = run({"info", at("phantom"), "--json"});
        QCOMPARE(info.firstSeries()["size"].toArray(), (QJsonArray{256, 230, 256}));
        QCOMPARE(info.firstSeries()["loadable"].toBool(), true);
    }
};

QTEST_GUILESS_MAIN(DicomCommandsTest)
#include "dicom_commands_test.moc"
