#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <fstream>

#include "dicom/import.h"
#include "dicom/write/export.h"
#include "tests/support/patience.h"
#include "tests/support/test_tool.h"

using namespace pdr;
using namespace pdr::dicom;

namespace fs = std::filesystem;

namespace {

const ExportFacts kFacts{"Test^Grid", "T1", "Tests", "Ramp", "A ramp, made for a test."};

Volume ramp(const VolumeGeometry& geometry) {
    Voxels voxels(geometry.voxelCount());
    for (std::size_t i = 0; i < voxels.size(); ++i)
        voxels[i] = std::int16_t(int(i * 7919 % 4096) - 1024);
    return Volume(geometry, std::move(voxels));
}

VolumeGeometry upright() {
    return VolumeGeometry::aligned({40, 30, 6}, {0.9570312, 0.75, 1.5}, {-122.0214843, -80.125, 33.3});
}

VolumeGeometry oblique() {
    const dvec3 row = glm::normalize(dvec3(0.8, 0.5, -0.1));
    const dvec3 normal = glm::normalize(glm::cross(row, dvec3(0.1, 1, 0.4)));
    dmat4 map(1.0);
    map[0] = dvec4(row * 0.7, 0.0);
    map[1] = dvec4(glm::cross(normal, row) * 0.6, 0.0);
    map[2] = dvec4(normal * 1.25, 0.0);
    map[3] = dvec4(-12.3456789, 98.7654321, -456.789123, 1.0);
    return {{12, 17, 5}, map};
}

/// The gantry was tilted: the slices are those of upright(), turned, and the table moved along the patient.
VolumeGeometry tilted() {
    VolumeGeometry geometry = upright();
    geometry.patientFromIndex[1] = 0.75 * dvec4(0, std::cos(0.3), -std::sin(0.3), 0);
    return geometry;
}

double largestDifference(const dmat4& a, const dmat4& b) {
    double largest = 0;
    for (int column = 0; column < 4; ++column)
        largest = std::max(largest, glm::length(a[column] - b[column]));
    return largest;
}

/// Returns what the program prints.
QString outputOf(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    process.waitForFinished(test::kPatience);
    return QString::fromLocal8Bit(process.readAll());
}

}  // namespace

class ExportTest : public QObject {
    Q_OBJECT

    QTemporaryDir root_;

    fs::path place(const char* name) const { return fs::path(root_.path().toStdString()) / name; }

    /// Returns whether anything beside the places has a name that begins with `start`.
    bool isBeside(const std::string& start) const {
        const fs::directory_iterator all(root_.path().toStdString());
        return std::any_of(begin(all), end(all),
                           [&](const auto& entry) { return entry.path().filename().string().starts_with(start); });
    }

  private slots:
    void foreignFoldersBesideItStay() {
        QTemporaryDir folder;
        const fs::path place = fs::path(folder.path().toStdString()) / "scan";
        fs::create_directory(place.string() + ".partial");
        std::ofstream(place.string() + ".partial/precious") << "mine";
        QVERIFY(bool(writeSeries(ramp(upright()), kFacts, place, noProgress)));
        QVERIFY(fs::exists(place.string() + ".partial/precious"));
        // A series that cannot be put in its place takes only itself away.
        std::ofstream(place.string() + "/also precious") << "mine";
        QVERIFY(!writeSeries(ramp(upright()), kFacts, place, noProgress));
        QVERIFY(fs::exists(place.string() + "/also precious"));
        const fs::directory_iterator all(folder.path().toStdString());
        QCOMPARE(std::distance(begin(all), end(all)), 2);
    }

    void nothingIsSaidOfASide() {
        QTemporaryDir folder;
        const fs::path place = fs::path(folder.path().toStdString()) / "scan";
        QVERIFY(bool(writeSeries(ramp(upright()), kFacts, place, noProgress)));
        std::ifstream in(place / "slice00001.dcm", std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(in), {}};
        QVERIFY(bytes.size() > 1000);
        const std::string laterality("\x20\x00\x60\x00", 4);  // which has to be there, empty
        QVERIFY(bytes.find(laterality + std::string("CS\0\0", 4)) != std::string::npos);
    }

    void whatIsWrittenComesBack_data() {
        QTest::addColumn<QString>("grid");
        for (const char* grid : {"upright", "oblique", "tilted"})
            QTest::newRow(grid) << grid;
    }
    void whatIsWrittenComesBack() {
        QFETCH(QString, grid);
        const Volume volume = ramp(grid == "oblique" ? oblique() : grid == "tilted" ? tilted() : upright());
        const fs::path folder = place(qPrintable(grid));
        QVERIFY(bool(writeSeries(volume, kFacts, folder, noProgress)));
        const auto scan = scanFolder(folder, noProgress);
        QVERIFY(bool(scan));
        QCOMPARE(scan->series.size(), std::size_t(1));
        const Series& series = scan->series.front();
        QCOMPARE(QString::fromStdString(series.verdict.reason), QString());
        QCOMPARE(series.verdict.notes.size(), std::size_t(grid == "tilted"));  // the tilt
        QCOMPARE(series.patient.name, kFacts.patientName);
        QCOMPARE(series.series.description, kFacts.seriesDescription);
        const auto back = loadSeries(series, Padding::maskAsAir, noProgress);
        QVERIFY(bool(back));
        QVERIFY(back->size() == volume.size());
        QVERIFY(std::equal(volume.voxels().begin(), volume.voxels().end(), back->voxels().begin()));
        QVERIFY(largestDifference(back->geometry().patientFromIndex, volume.geometry().patientFromIndex) < 1e-9);
    }

    void otherToolsAcceptTheFiles() {
        PDR_NEEDS_TOOL("dciodvfy", "dicom3tools");
        PDR_NEEDS_TOOL("dcmdump", "dcmtk");
        PDR_NEEDS_TOOL("dcm2niix", "dcm2niix");
        ExportFacts ofAHead = kFacts;
        ofAHead.bodyPart = "HEAD";
        const fs::path folder = place("tools");
        QVERIFY(bool(writeSeries(ramp(upright()), ofAHead, folder, noProgress)));
        QVERIFY(bool(writeSeries(ramp(upright()), kFacts, place("of an unknown part"), noProgress)));
        QVERIFY(bool(writeSeries(ramp(tilted()), ofAHead, place("of a tilted gantry"), noProgress)));
        const auto verify = [](const fs::path& series) {
            return outputOf("dciodvfy", {QString::fromStdString((series / "slice00001.dcm").string())});
        };
        const QString file = QString::fromStdString((folder / "slice00001.dcm").string());
        const QString verified = verify(folder);
        const auto dumped = outputOf("dcmdump", {file});
        const QString nifti = QString::fromStdString(place("nifti").string());
        QDir().mkpath(nifti);
        const auto converted =
            outputOf("dcm2niix", {"-b", "n", "-z", "n", "-o", nifti, QString::fromStdString(folder.string())});
        QCOMPARE(verified.trimmed(), QString("CTImage"));  // nothing else to say
        QCOMPARE(verify(place("of a tilted gantry")).trimmed(), QString("CTImage"));
        const QString unknown = verify(place("of an unknown part"));
        QVERIFY2(!unknown.contains("Error") && unknown.count("Warning") == unknown.count("attribute <Laterality>"),
                 qPrintable(unknown));
        QVERIFY(dumped.contains("=CTImageStorage") && dumped.contains("=LittleEndianExplicit"));
        QVERIFY2(converted.contains("(40x30x6x1)"), qPrintable(converted));
        // It knows no vendor by our name, and says so; nothing else may trouble it.
        QVERIFY2(converted.count("Warning") == converted.count("Unable to determine manufacturer"),
                 qPrintable(converted));
    }

    void uidsAreFreshAndWellFormed() {
        const fs::path first = place("uid1"), second = place("uid2");
        QVERIFY(bool(writeSeries(ramp(upright()), kFacts, first, noProgress)));
        QVERIFY(bool(writeSeries(ramp(upright()), kFacts, second, noProgress)));
        const auto a = scanFolder(first, noProgress), b = scanFolder(second, noProgress);
        const QString uid = QString::fromStdString(a->series[0].series.uid);
        QVERIFY(uid != QString::fromStdString(b->series[0].series.uid));
        QVERIFY(QRegularExpression("^2\\.25\\.[1-9][0-9]{1,38}$").match(uid).hasMatch());
    }

    void emptyFolderIsFilled() {
        fs::create_directories(place("waiting"));
        QVERIFY(bool(writeSeries(ramp(upright()), kFacts, place("waiting"), noProgress)));
        QCOMPARE(std::distance(fs::directory_iterator(place("waiting")), {}), std::ptrdiff_t(6));
    }

    void folderWithFilesIsLeftAlone() {
        fs::create_directories(place("used"));
        std::ofstream(place("used") / "mine") << "mine";
        const auto written = writeSeries(ramp(upright()), kFacts, place("used"), noProgress);
        QVERIFY(!written);
        QVERIFY(written.error().what.find("not empty") != std::string::npos);
        QCOMPARE(std::distance(fs::directory_iterator(place("used")), {}), std::ptrdiff_t(1));
    }

    void cancelLeavesNothingBehind() {
        const auto atHalf = [](double fraction, std::string_view) { return fraction < 0.5; };
        const auto written = writeSeries(ramp(upright()), kFacts, place("cancelled"), atHalf);
        QVERIFY(!written);
        QVERIFY(written.error().kind == ErrorKind::cancelled);
        QVERIFY(!fs::exists(place("cancelled")));
        QVERIFY(!isBeside("cancelled."));
    }

    void fullDiskLeavesNothingBehind() {
        // A limit on the size of files fails the same system call that a full disk fails.
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        rlimit small = before;
        small.rlim_cur = 2000;
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &small);
        const auto written = writeSeries(ramp(upright()), kFacts, place("full"), noProgress);
        setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, handler);
        QVERIFY(!written);
        QVERIFY(written.error().hint.find("disk full") != std::string::npos);
        QVERIFY(!fs::exists(place("full")));
        QVERIFY(!isBeside("full."));
    }

    /// Slices are planes of square corners; what else is askew, they can say.
    void aGridWhoseRowsAndColumnsAreAskewIsRefused() {
        VolumeGeometry askew = upright();
        askew.patientFromIndex[1] += dvec4(0.3, 0, 0, 0);
        const auto written = writeSeries(ramp(askew), kFacts, place("askew"), noProgress);
        QVERIFY(!written);
        QVERIFY(written.error().what.find("right angles") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(ExportTest)
#include "export_test.moc"
