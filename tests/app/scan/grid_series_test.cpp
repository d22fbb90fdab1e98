#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <iterator>

#include "app/scan/grid_series.h"
#include "app/scan/scan_place.h"
#include "app/scan/series_choice.h"
#include "tests/support/deflated.h"
#include "tests/support/dicom/slice_folder.h"
#include "tests/support/dicom/zip_file.h"
#include "tests/support/grid_files.h"

using namespace pdr;
using namespace pdr::app;

namespace fs = std::filesystem;

/// A volume file becomes a series by the importer's own judgement.
class GridSeriesTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    fs::path at(const std::string& name) const { return fs::path(folder_.path().toStdString()) / name; }
    Result<dicom::Series> seriesOf(const std::string& nrrd) const {
        return gridSeries(test::written(at("a.nrrd"), nrrd), noProgress);
    }
    static std::string contentOf(const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    template <class Value>
    static std::string withValues(const std::vector<std::pair<std::string, std::string>>& header,
                                  const std::vector<Value>& values) {
        std::string bytes = test::nrrdBytes(header);
        return bytes.replace(bytes.size() - 480, 480, test::bytesOf(values));
    }

  private slots:
    void aVolumeFileIsOneEntry() {
        const auto scan = scanPlace(test::written(at("head.mha"), test::metaImageBytes()), noProgress);
        QVERIFY(bool(scan));
        QCOMPARE(scan->series.size(), std::size_t(1));
        const dicom::Series& series = scan->series[0];
        QVERIFY2(series.verdict.loadable(), series.verdict.reason.c_str());
        QCOMPARE(series.series.modality, std::string("MetaImage"));
        QCOMPARE(series.geometry.size, ivec3(6, 5, 8));
        QCOMPARE(series.patient, dicom::PatientFacts());
        const auto volume = loadVoxels(series, dicom::Padding::maskAsAir, noProgress);
        QVERIFY(bool(volume));
        QVERIFY(std::ranges::equal(volume->voxels(), test::steppedValues({6, 5, 8})));
        QCOMPARE(volume->geometry().spacingMm(), dvec3(0.8, 0.9, 1.5));
    }

    void aSliceOfItCanBeReadAlone() {
        const auto series = seriesOf(test::nrrdBytes({{"space directions", "(0.8,0,0) (0,0.9,0) (0,0,-1.5)"}}));
        const auto volume = loadVoxels(*series, dicom::Padding::maskAsAir, noProgress);
        for (const int k : {0, 3, 7}) {
            const auto slice = decodeSliceOf(*series, series->slices[std::size_t(k)], {});
            QVERIFY(slice && slice->size == ivec2(6, 5));
            QVERIFY(std::ranges::equal(slice->hu, std::span(volume->voxels()).subspan(std::size_t(k) * 30, 30)));
        }
    }

    /// The list, the report and images say that nothing in the file calls its values HU.
    void itIsSaidThatTheUnitIsNotStated() {
        const auto series = seriesOf(test::nrrdBytes());
        QVERIFY(bool(series));
        QCOMPARE(series->verdict.notes.size(), std::size_t(1));
        QCOMPARE(series->verdict.notes[0].text,
                 std::string("the file does not say that its values are HU; they run from "
                             "-1000 to 1390, and are taken as HU"));
        const auto volume = loadVoxels(*series, dicom::Padding::maskAsAir, noProgress);
        QVERIFY(bool(volume));
        QCOMPARE(volume->remarks(), std::string("no-unit:-1000..1390"));
    }

    void valuesFromFatToBoneMayBeHu() {
        QVERIFY(mayBeHu({-1024, 3071}));
        QVERIFY(mayBeHu({-100, 100}));
        for (const ValueRange& range : {ValueRange{0, 255},
                                        {0, 4095},
                                        {-50, 5},
                                        {-1000, 50},
                                        {-99, 3000},
                                        {-1e5, 3000},
                                        {-1000, 40'000},
                                        {-1000, std::numeric_limits<double>::infinity()}})
            QVERIFY2(!mayBeHu(range), std::to_string(range.lowest).c_str());
    }

    void otherValuesLoadExactlyAndNotAsHu_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<double>("slope");
        QTest::addColumn<double>("intercept");
        QTest::addColumn<double>("lowest");   // sample
        QTest::addColumn<double>("highest");  // sample
        QTest::addColumn<bool>("areWhole");
        QTest::addColumn<bool>("isPlain");
        QTest::newRow("MR") << int(SampleType::int16) << 1.0 << 0.0 << 0.0 << 4095.0 << true << true;
        QTest::newRow("grey levels") << int(SampleType::uint8) << 1.0 << 0.0 << 0.0 << 255.0 << true << true;
        QTest::newRow("wide") << int(SampleType::uint16) << 1.0 << 0.0 << 0.0 << 65535.0 << true << false;
        QTest::newRow("far") << int(SampleType::int32) << 1.0 << 0.0 << 1e6 << 1e6 + 65535 << true << false;
        QTest::newRow("scaled") << int(SampleType::int16) << 0.3 << 20000.0 << -32768.0 << 32767.0 << false << false;
        QTest::newRow("negative") << int(SampleType::uint16) << -0.3 << 7.0 << 0.0 << 65535.0 << false << false;
        QTest::newRow("whole floats") << int(SampleType::float32) << 1.0 << 0.0 << -5.0 << 800.0 << true << true;
    }
    void otherValuesLoadExactlyAndNotAsHu() {
        QFETCH(int, type);
        QFETCH(double, slope);
        QFETCH(double, intercept);
        QFETCH(double, lowest);
        QFETCH(double, highest);
        QFETCH(bool, areWhole);
        QFETCH(bool, isPlain);
        GridFile grid;
        grid.type = SampleType(type);
        grid.slope = slope;
        grid.intercept = intercept;
        const double a = lowest * slope + intercept, b = highest * slope + intercept;
        const ValueRange range{std::min(a, b), std::max(a, b), areWhole};
        const auto [unit, isExact] = gridUnit(grid, range);
        QVERIFY(!unit.isHu && isExact);
        QCOMPARE(unit.isPlain(), isPlain);
        for (const double sample : {lowest, lowest + 1, std::floor((lowest + highest) / 2), highest}) {
            const double value = sample * slope + intercept, voxel = std::nearbyint(unit.voxelOf(value));
            QVERIFY(voxel >= INT16_MIN && voxel <= INT16_MAX);
            QVERIFY2(std::abs(unit.valueOf(voxel) - value) < 1e-9, std::to_string(value).c_str());
        }
    }

    void fractionsAreRoundedToStepsAndItIsSaid() {
        std::vector<float> values(6 * 5 * 8, 0.25f);
        values[0] = 0;
        values[1] = 1;
        values[7] = std::numeric_limits<float>::quiet_NaN();
        const auto series = seriesOf(withValues({{"type", "float"}}, values));
        QVERIFY(bool(series) && series->verdict.loadable());
        QVERIFY(std::ranges::count(series->verdict.notes, "rounded", &dicom::Note::code) == 1);
        const auto volume = loadVoxels(*series, dicom::Padding::maskAsAir, noProgress);
        QVERIFY(bool(volume));
        const ValueUnit unit = unitOf(*volume);
        QCOMPARE(unit, series->unit);
        QVERIFY(volume->isPadding(7));
        QCOMPARE(volume->voxels()[7], volume->voxels()[0]);
        for (const auto& [i, value] : {std::pair(0, 0.0), {1, 1.0}, {2, 0.25}})
            QVERIFY(std::abs(unit.valueOf(volume->voxels()[std::size_t(i)]) - value) <= 1.0 / 65535 / 2 * 1.001);
    }

    void infiniteValuesAreRefused() {
        std::vector<float> values(6 * 5 * 8, std::numeric_limits<float>::infinity());
        QCOMPARE(seriesOf(withValues({{"type", "float"}}, values))->verdict.stack, dicom::Stack::unreadable);
    }

    /// A grid that is mirrored is turned by the order of its slices: no voxel changes its place in the patient.
    void aMirroredGridIsTurned() {
        const std::string bytes = test::nrrdBytes({{"space directions", "(0.8,0,0) (0,0.9,0) (0,0,-1.5)"}});
        const auto series = seriesOf(bytes);
        QVERIFY(bool(series) && series->verdict.loadable());
        const auto volume = loadVoxels(*series, dicom::Padding::maskAsAir, noProgress);
        QVERIFY(bool(volume));
        const dmat4& map = volume->geometry().patientFromIndex;
        QVERIFY(glm::determinant(dmat3(map)) > 0);
        const auto stored = test::steppedValues({6, 5, 8});
        for (int k = 0; k < 8; ++k) {
            const dvec3 there = dvec3(map * dvec4(2, 3, k, 1)), fromFile = {-10 + 2 * 0.8, -20 + 3 * 0.9, there.z};
            QVERIFY(glm::distance(there, fromFile) < 1e-9);
            const int inFile = int(std::lround((30 - there.z) / 1.5));
            QCOMPARE(volume->voxels()[std::size_t((k * 5 + 3) * 6 + 2)], stored[std::size_t((inFile * 5 + 3) * 6 + 2)]);
        }
    }

    /// Slices may drift as those of a tilted gantry do: the grid stays that of the file.
    void aGridThatIsShearedAsByATiltedGantryLoads() {
        const auto series = seriesOf(test::nrrdBytes({{"space directions", "(0.8,0,0) (0,0.9,0) (0,0.5,1.5)"}}));
        QVERIFY(bool(series));
        QVERIFY2(series->verdict.loadable(), series->verdict.reason.c_str());
        QVERIFY(std::ranges::any_of(series->verdict.notes, [](const auto& note) { return note.code == "tilt"; }));
        const dmat4& map = series->geometry.patientFromIndex;
        QVERIFY(glm::distance(map[2], dvec4(0, 0.5, 1.5, 0)) < 1e-9);
        QVERIFY(glm::distance(map[3], dvec4(-10, -20, 30, 1)) < 1e-9);
        QVERIFY(bool(loadVoxels(*series, dicom::Padding::maskAsAir, noProgress)));
    }

    void aGridThatIsShearedOtherwiseIsRefused() {
        const auto steep = seriesOf(test::nrrdBytes({{"space directions", "(0.8,0,0) (0,0.9,0) (0,2,1.5)"}}));
        QVERIFY(bool(steep));
        QCOMPARE(steep->verdict.stack, dicom::Stack::tilted);
        QVERIFY(!loadVoxels(*steep, dicom::Padding::maskAsAir, noProgress));
        const auto rows = seriesOf(test::nrrdBytes({{"space directions", "(0.8,0,0) (0.1,0.9,0) (0,0,1.5)"}}));
        QVERIFY(bool(rows));
        QCOMPARE(rows->verdict.stack, dicom::Stack::noGeometry);
    }

    /// Folders of Slicer or of a training set hold volumes, labels and what else there is.
    void aFolderListsItsVolumeFiles() {
        const fs::path folder = at("folder");
        fs::create_directories(folder / "below");
        test::written(folder / "labels.nrrd", test::nrrdBytes({{"type", "ushort"}}));
        test::written(folder / "below/scan.nii", test::NiftiBytes().bytes);
        test::written(folder / "damaged.mha", "ObjectType = Image");
        test::written(folder / "._damaged.mha", "a text");
        const auto scan = scanPlace(folder, noProgress);
        QVERIFY(bool(scan));
        QCOMPARE(scan->filesSeen, 4);
        QCOMPARE(scan->notDicom, 1);
        QCOMPARE(scan->series.size(), std::size_t(2));
        QVERIFY(scan->series[0].verdict.loadable());
        QCOMPARE(scan->series[0].series.description, std::string("scan.nii"));
        QVERIFY(scan->series[0].unit.isHu && !scan->series[1].unit.isHu);
        QCOMPARE(scan->problems.size(), std::size_t(1));
        QCOMPARE(scan->problems[0].file, folder / "damaged.mha");
    }

    /// Files of one name in two folders are told apart; one that is opened by itself has its own name.
    void oneOfSeveralFilesIsChosenByItsPath() {
        const fs::path folder = at("both");
        for (const char* side : {"left", "right"}) {
            fs::create_directories(folder / side);
            test::written(folder / side / "scan.nrrd", test::nrrdBytes());
        }
        const auto scan = scanPlace(folder, noProgress);
        QVERIFY(scan && scan->series.size() == 2);
        for (const char* path : {"left/scan.nrrd", "right/scan.nrrd"}) {
            const auto chosen = chosenSeries(*scan, path);
            QVERIFY2(bool(chosen), path);
            QCOMPARE(chosen->slices.front().file, folder / path);
        }
        QVERIFY(!chosenSeries(*scan, "scan.nrrd"));
        const auto alone = scanPlace(folder / "left/scan.nrrd", noProgress);
        QVERIFY(alone && chosenSeries(*alone, "scan.nrrd"));
    }

    /// Raw, packed, and with the voxels beside the header; what is in a file is in the archive as well.
    void anArchiveHoldsVolumeFiles() {
        const std::string inOne = test::metaImageBytes();
        const std::size_t header = inOne.size() - 480;
        const std::string local = "ElementDataFile = LOCAL";
        std::string apart = inOne.substr(0, header);
        apart.replace(apart.find(local), local.size(), "ElementDataFile = head.raw");
        const fs::path archive = test::writeZip(
            at("scans.zip"), {{"a/head.mha", inOne},
                              {"a/._head.mha", "a text"},
                              {"b/head.mhd", apart},
                              {"b/head.raw", inOne.substr(header)},
                              {"c/head.nii", test::NiftiBytes().bytes},
                              {"c/head.nii.gz", test::deflated(test::NiftiBytes().bytes, test::kGzipFile)},
                              {"d/absent.mhd", apart},
                              {"e/inner.zip", "PK"}});
        const auto scan = scanPlace(archive, noProgress);
        QVERIFY2(bool(scan), scan ? "" : scan.error().text().c_str());
        QCOMPARE(scan->series.size(), std::size_t(4));
        QCOMPARE(scan->problems.size(), std::size_t(2));
        QVERIFY(scan->problems[1].reason.find("cannot be read (it is gone)") != std::string::npos);
        const auto alone = loadVoxels(*gridSeries(test::written(at("head.mha"), inOne), noProgress),
                                      dicom::Padding::maskAsAir, noProgress);
        for (const char* name : {"a/head.mha", "b/head.mhd", "c/head.nii", "c/head.nii.gz"}) {
            const auto series = chosenSeries(*scan, name);
            QVERIFY2(series && series->verdict.loadable(), name);
            const auto volume = loadVoxels(*series, dicom::Padding::maskAsAir, noProgress);
            QVERIFY2(bool(volume), volume ? "" : volume.error().text().c_str());
            if (name[0] != 'c')
                QVERIFY2(std::ranges::equal(volume->voxels(), alone->voxels()), name);
            const auto slice = decodeSliceOf(*series, series->slices[3], {});
            QVERIFY(slice && std::ranges::equal(slice->hu, std::span(volume->voxels()).subspan(90, 30)));
        }
    }

    void dicomAndVolumeFilesOfAnArchiveAreListedTogether() {
        const test::SliceFolder slices;
        slices.addStack(3);
        std::vector<test::ZipMember> members{{"head.nrrd", test::nrrdBytes()}};
        for (const char* name : {"s00", "s01", "s02"})
            members.push_back({name, contentOf(slices.path() / name)});
        const auto scan = scanPlace(test::writeZip(at("both.zip"), members), noProgress);
        QVERIFY(scan && scan->series.size() == 2);
        QCOMPARE(scan->notDicom, 0);
        for (const dicom::Series& series : scan->series)
            QVERIFY(bool(loadVoxels(series, dicom::Padding::maskAsAir, noProgress)));
    }

    void whatIsNoNumberIsPadding() {
        std::vector<float> values(6 * 5 * 8, 40.5f);
        values[0] = -1000;
        values[1] = 900;
        values[7] = std::numeric_limits<float>::quiet_NaN();
        const auto series = seriesOf(withValues({{"type", "float"}}, values));
        QVERIFY(bool(series) && series->verdict.loadable());
        const auto volume = loadVoxels(*series, dicom::Padding::maskAsAir, noProgress);
        QVERIFY(bool(volume));
        QCOMPARE(volume->paddingCount(), std::size_t(1));
        QVERIFY(volume->isPadding(7));
        QCOMPARE(volume->voxels()[7], Volume::kAirHu);
        QCOMPARE(volume->voxels()[8], std::int16_t(40));  // halves go to the even neighbour
    }

    void anotherFileUnderItsNameIsRefused() {
        const auto series = seriesOf(test::nrrdBytes());
        QVERIFY(bool(series));
        test::written(at("a.nrrd"), test::nrrdBytes({{"space origin", "(0,0,0)"}}));
        const auto refused = loadVoxels(*series, dicom::Padding::maskAsAir, noProgress);
        QVERIFY(!refused);
        QCOMPARE(refused.error().where, at("a.nrrd").string());
    }

    void cancelledWhereAsked() {
        const auto stop = [](double, std::string_view) { return false; };
        const auto cancelled = gridSeries(test::written(at("a.nrrd"), test::nrrdBytes()), stop);
        QVERIFY(!cancelled);
        QCOMPARE(cancelled.error().kind, ErrorKind::cancelled);
    }
};

QTEST_APPLESS_MAIN(GridSeriesTest)
#include "grid_series_test.moc"
