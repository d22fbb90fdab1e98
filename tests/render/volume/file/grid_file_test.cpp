#include <QTemporaryDir>
#include <QTest>

#include <random>

#include "render/volume/file/grid_file.h"
#include "tests/support/deflated.h"
#include "tests/support/grid_files.h"

using namespace pdr;

namespace fs = std::filesystem;

static std::string packed(const std::string& bytes) {
    return test::deflated(bytes, test::kGzipFile);
}

/// Volume files are read as their headers say, and refused where they say too little. That the headers are understood
/// as other programs understand them is shown in tests/oracle/grids.
class GridFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    fs::path at(const std::string& name) const { return fs::path(folder_.path().toStdString()) / name; }

    Result<GridFile> read(const std::string& name, const std::string& bytes) const {
        return readGridFile(test::written(at(name), bytes));
    }
    static std::vector<double> valuesOf(const GridFile& grid) {
        std::vector<double> values(grid.geometry.voxelCount());
        return GridSamples(grid).read(values) ? values : std::vector<double>();
    }
    /// Returns what is said of a file that must be refused, with every trace of its path taken out.
    std::string refusal(const std::string& name, const std::string& bytes) const {
        const Result<GridFile> grid = read(name, bytes);
        return grid ? "it was read" : std::string(grid.error().what);
    }
    static std::vector<double> expectedValues() {
        const auto values = test::steppedValues({6, 5, 8});
        return {values.begin(), values.end()};
    }

  private slots:
    /// RAS becomes LPS: both first rows are negated, of the origin, too.
    void niftiIsTurnedIntoThePatientsAxes() {
        test::NiftiBytes file;
        file.sform[3] = dvec4(10, 20, 30, 1);
        file.stateAll();
        const auto grid = read("a.nii", file.bytes);
        QVERIFY(bool(grid));
        QVERIFY(glm::length(grid->geometry.patientFromIndex[3] - dvec4(-10, -20, 30, 1)) < 1e-6);
        QVERIFY(glm::length(grid->geometry.patientFromIndex[0] - dvec4(0.8, 0, 0, 0)) < 1e-6);
        QVERIFY(glm::length(grid->geometry.patientFromIndex[1] - dvec4(0, 0.9, 0, 0)) < 1e-6);
        QCOMPARE(valuesOf(*grid), expectedValues());
    }

    void niftiInMetresAndWithASlope() {
        test::NiftiBytes file;
        file.sform[2] = dvec4(0, 0, 0.0015, 0);
        file.stateAll();
        file.bytes[123] = 1;
        file.set(112, 2.5f);
        file.set(116, -7.0f);
        const auto grid = read("a.nii", file.bytes);
        QVERIFY(bool(grid));
        QVERIFY(std::abs(grid->geometry.spacingMm().z - 1.5) < 1e-6);
        QCOMPARE(grid->slope, 2.5);
        QCOMPARE(grid->intercept, -7.0);
        QCOMPARE(valuesOf(*grid), expectedValues());  // as stored: labels want nothing else
    }

    /// A qform that turns nothing, beside an sform: they may lie 0.1 mm apart at the furthest corner, not more.
    void twoPlacesMustBeOne() {
        test::NiftiBytes file;
        file.sform = glm::scale(dmat4(1.0), dvec3(0.8, 0.9, 1.5));
        file.stateAll();
        file.set(252, std::int16_t(1));
        for (const auto& [at, value] : {std::pair{80, 0.8f}, {84, 0.9f}, {88, 1.5f}})
            file.set(std::size_t(at), value);
        file.set(276, 0.09f);  // the origin's z
        QVERIFY(bool(read("a.nii", file.bytes)));
        file.set(276, 0.11f);
        QCOMPARE(refusal("a.nii", file.bytes),
                 std::string("it states two places in the patient (sform and qform) that differ by up to 0.11 mm"));
    }

    void whatStatesNoPlaceIsRefused() {
        const std::string unplaced = "it does not say how it lies in the patient";
        test::NiftiBytes nifti;
        nifti.set(254, std::int16_t(0));
        QCOMPARE(refusal("a.nii", nifti.bytes), unplaced);
        for (const char* field : {"space", "space directions", "space origin"})
            QCOMPARE(refusal("a.nrrd", test::nrrdBytes({{field, ""}})), unplaced);
        for (const char* key : {"TransformMatrix", "Offset", "ElementSpacing"})
            QCOMPARE(refusal("a.mha", test::metaImageBytes({{key, ""}})), unplaced);
    }

    void nrrdInTheThreeSpaces() {
        const auto originIn = [&](const std::string& space) {
            const auto grid = read("a.nrrd", test::nrrdBytes({{"space", space}}));
            return grid ? dvec3(grid->geometry.patientFromIndex[3]) : dvec3(0);
        };
        QCOMPARE(originIn("LPS"), dvec3(-10, -20, 30));
        QCOMPARE(originIn("right-anterior-superior"), dvec3(10, 20, 30));
        QCOMPARE(originIn("LAS"), dvec3(-10, 20, 30));
        QCOMPARE(originIn("scanner-xyz"), dvec3(0));
    }

    /// What label maps need: whole numbers without a rescale, and what is written beside them.
    void nrrdKeepsItsPairs() {
        const auto grid = read("a.nrrd", test::nrrdBytes({{"Segment0_Name:=liver", "left"}}));
        QVERIFY(bool(grid));
        QCOMPARE(grid->pairs.at("Segment0_Name"), std::string("liver: left"));
        QCOMPARE(valuesOf(*grid), expectedValues());
    }

    void bytesInTheOtherOrder() {
        std::string swapped = test::nrrdBytes({{"endian", "big"}});
        for (std::size_t i = swapped.size() - 6 * 5 * 8 * 2; i < swapped.size(); i += 2)
            std::swap(swapped[i], swapped[i + 1]);
        const auto grid = read("a.nrrd", swapped);
        QVERIFY(bool(grid));
        QCOMPARE(valuesOf(*grid), expectedValues());
        QCOMPARE(refusal("a.nrrd", test::nrrdBytes({{"endian", ""}})),
                 std::string("it does not say the order of its bytes"));
    }

    void samplesBesideTheHeader() {
        test::written(at("voxels.raw"), "skipped" + test::bytesOf(test::steppedValues({6, 5, 8})));
        const auto nrrd = read("a.nhdr", test::nrrdBytes({{"data file", "voxels.raw"}, {"byte skip", "7"}}));
        const auto meta = read("a.mhd", test::metaImageBytes({{"ElementDataFile", "voxels.raw"}, {"HeaderSize", "7"}}));
        QVERIFY(bool(nrrd) && bool(meta));
        QCOMPARE(valuesOf(*nrrd), expectedValues());
        QCOMPARE(valuesOf(*meta), expectedValues());
    }

    void samplesElsewhereAreRefused() {
        const std::string elsewhere = "its voxels lie in several files, or outside its folder";
        for (const char* name : {"/etc/passwd", "../voxels.raw", "LIST", "voxels%03d.raw"}) {
            QCOMPARE(refusal("a.nhdr", test::nrrdBytes({{"data file", name}})), elsewhere);
            QCOMPARE(refusal("a.mhd", test::metaImageBytes({{"ElementDataFile", name}})), elsewhere);
        }
        QVERIFY(refusal("a.mhd", test::metaImageBytes({{"ElementDataFile", "absent.raw"}}))
                    .starts_with("the file of its voxels cannot be read"));
    }

    void moreThanOneValueForEachPlaceIsRefused() {
        const std::string several = "it holds several values for each place";
        test::NiftiBytes nifti;
        nifti.set(40, std::int16_t(4));
        nifti.set(48, std::int16_t(2));
        QCOMPARE(refusal("a.nii", nifti.bytes), several);
        QCOMPARE(refusal("a.nrrd", test::nrrdBytes({{"dimension", "4"}})), several);
        QCOMPARE(refusal("a.mha", test::metaImageBytes({{"ElementNumberOfChannels", "3"}})), several);
    }

    /// A packed file that is cut off, in its checksum at the latest, is refused when its samples are read.
    void everyTruncationOfAPackedFileIsSeen() {
        const std::string whole = packed(test::NiftiBytes().bytes);
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const auto grid = read("a.nii.gz", whole.substr(0, length));
            QVERIFY2(!grid || valuesOf(*grid).empty(), std::to_string(length).c_str());
        }
        const auto twice = read(
            "a.nii.gz", packed(test::NiftiBytes().bytes.substr(0, 400)) + packed(test::NiftiBytes().bytes.substr(400)));
        QVERIFY(bool(twice));
        QCOMPARE(valuesOf(*twice), expectedValues());  // as `cat a.gz b.gz` writes it
    }

    void aWrongChecksumIsSeen() {
        std::string bytes = packed(test::NiftiBytes().bytes);
        bytes[bytes.size() - 6] ^= 1;
        const auto grid = read("a.nii.gz", bytes);
        QVERIFY(bool(grid));
        QVERIFY(valuesOf(*grid).empty());
    }

    /// Cut off anywhere, a file is refused by its header or by its samples.
    void everyTruncationIsRefused() {
        for (const auto& [name, whole] : {std::pair<std::string, std::string>{"a.nii", test::NiftiBytes().bytes},
                                          {"a.nrrd", test::nrrdBytes()},
                                          {"a.mha", test::metaImageBytes()}})
            for (std::size_t length = 0; length < whole.size(); length += 7)
                QVERIFY2(!read(name, whole.substr(0, length)), (name + std::to_string(length)).c_str());
    }

    /// A header alone takes no memory, whatever it claims.
    void samplesThatTheFileCannotHoldAreRefused() {
        QCOMPARE(refusal("a.nrrd", test::nrrdBytes({{"sizes", "65535 65535 65535"}})),
                 std::string("it is too short for its 65535 x 65535 x 65535 voxels"));
        QCOMPARE(refusal("a.nrrd", test::nrrdBytes({{"sizes", "65535 65535 60000"}, {"encoding", "gzip"}})),
                 std::string("it is too short for its 65535 x 65535 x 60000 voxels"));
        for (const char* size : {"0 5 8", "-1 5 8", "6.5 5 8", "70000 5 8", "nan 5 8", "6 5"})
            QCOMPARE(refusal("a.mha", test::metaImageBytes({{"DimSize", size}})), std::string("its header is damaged"));
    }

    void mutantsAreReadOrRefused_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"a.nii", "a.nii.gz", "a.nrrd", "a.mha"})
            QTest::newRow(name) << name;
    }
    /// 200 seeded mutants of each format: bytes changed, cut out, doubled. Neither a crash nor more memory than a
    /// piece.
    void mutantsAreReadOrRefused() {
        QFETCH(QString, name);
        const std::string whole = name == "a.nii"      ? test::NiftiBytes().bytes
                                  : name == "a.nii.gz" ? packed(test::NiftiBytes().bytes)
                                  : name == "a.nrrd"   ? test::nrrdBytes()
                                                       : test::metaImageBytes();
        std::mt19937 random(20261126);
        int refused = 0;
        for (int mutant = 0; mutant < 200; ++mutant) {
            std::string bytes = whole;
            for (int change = 0; change < 1 + mutant % 4; ++change) {
                const std::size_t where = random() % 370;
                if (random() % 3 == 0)
                    bytes.erase(where, 1 + random() % 5);
                else if (random() % 3 == 0)
                    bytes.insert(where, bytes.substr(where, 1 + random() % 9));
                else
                    bytes[where] = char(random());
            }
            const auto grid = read(name.toStdString(), bytes);
            refused += !grid;
            if (!grid)
                continue;
            std::vector<double> piece(std::min<std::size_t>(grid->geometry.voxelCount(), 10'000));
            (void)GridSamples(*grid).read(piece);
        }
        QVERIFY2(refused > 50 && refused < 200, std::to_string(refused).c_str());
    }

    void endingsSayWhatIsOpened() {
        for (const char* name : {"a.nii", "a.NII.GZ", "a.nrrd", "a.nhdr", "a.mha", "b.c.MHD"})
            QVERIFY(isGridFile(name));
        for (const char* name : {"nii", "a.gz", "a.dcm", "a.raw", "a.nii.zip", ""})
            QVERIFY(!isGridFile(name));
    }
};

QTEST_APPLESS_MAIN(GridFileTest)
#include "grid_file_test.moc"
