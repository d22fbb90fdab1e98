#include <QTemporaryDir>
#include <QTest>

#include <fstream>

#include "render/volume/file/label_file.h"
#include "render/volume/file/label_nrrd.h"
#include "render/volume/file/label_table.h"
#include "tests/support/deflated.h"
#include "tests/support/grid_files.h"

using namespace pdr;

namespace fs = std::filesystem;

namespace {

/// Returns an NRRD of `values` on a grid of 4 x 2 x 1 voxels of 8 bits, with these pairs.
std::string labelNrrd(std::vector<std::uint8_t> values, const std::string& pairs) {
    values.resize(8);
    return "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 4 2 1\n"
           "space directions: (1,0,0) (0,1,0) (0,0,2)\nspace origin: (0,0,0)\nencoding: raw\n" +
           pairs + "\n" + test::bytesOf(values);
}

/// A NIfTI file of 4 x 2 x 1 labels.
std::string labelNifti(const std::vector<std::int16_t>& values, const std::string& extension = "") {
    test::NiftiBytes file;
    file.size = {4, 2, 1};
    file.stateAll();
    const std::size_t padded = (extension.size() + 8 + 15) / 16 * 16;
    const std::size_t start = extension.empty() ? 352 : 352 + padded;
    file.set(108, float(start));
    file.bytes.resize(352);
    if (!extension.empty()) {
        file.bytes[348] = 1;
        file.bytes.resize(start, '\0');
        file.set(352, std::int32_t(padded));
        std::copy(extension.begin(), extension.end(), file.bytes.begin() + 360);
    }
    return file.bytes + test::bytesOf(values);
}

constexpr const char* kCaret =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?> <CaretExtension>  <Date><![CDATA[2013-07-14T05:45:09]]></Date>\n"
    "<VolumeInformation Index=\"0\">   <LabelTable>\n"
    "<Label Key=\"5\" Red=\"1.0\" Green=\"0.5\" Blue=\"0\" Alpha=\"1\"><![CDATA[liver]]></Label>\n"
    "<Label Key=\"9\" Red=\"0\" Green=\"0\" Blue=\"0.2\" Alpha=\"1\">bowel &amp; &lt;gas&gt;</Label>\n"
    "<Label Key=\"11\" Red=\"0\" Green=\"0\" Blue=\"0.2\" Alpha=\"1\"><![CDATA[spleen]]></Label>\n"
    "  </LabelTable> </VolumeInformation></CaretExtension>";

}  // namespace

/// Label maps that other programs write come with their names and colours, and what is no label map is refused.
class LabelFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    fs::path at(const std::string& name) const { return fs::path(folder_.path().toStdString()) / name; }
    Result<LabelMap> read(const std::string& name, const std::string& bytes) const {
        return readLabelFile(test::written(at(name), bytes), noProgress);
    }
    std::string refusal(const std::string& name, const std::string& bytes) const {
        const auto map = read(name, bytes);
        return map ? "it was read" : std::string(map.error().what);
    }
    static std::vector<int> labelsOf(const LabelMap& map) { return {map.labels.begin(), map.labels.end()}; }

  private slots:
    /// The order of the labels is that of their numbers, not that in which they occur.
    void numbersBecomeLabelsInTheirOrder() {
        const auto map = read("a.nii", labelNifti({0, 900, 7, 7, 0, 3, 900, 900}));
        QVERIFY2(bool(map), map ? "" : map.error().text().c_str());
        QCOMPARE(labelsOf(*map), (std::vector{0, 3, 2, 2, 0, 1, 3, 3}));
        QCOMPARE(map->parts.size(), std::size_t(3));
        QCOMPARE(map->parts[2].name, std::string("part 900"));
        QCOMPARE(map->parts[2].colour, standardColour(900));
    }

    void slicersNamesAndColours() {
        const auto map = read("a.seg.nrrd", labelNrrd({0, 2, 2, 1},
                                                      "Segment0_ID:=Segment_1\nSegment0_Name:=left: ventricle\n"
                                                      "Segment0_LabelValue:=2\nSegment0_Color:=1 0.5 0\n"
                                                      "Segment1_ID:=Segment_2\nSegment1_Name:=aorta\n"
                                                      "Segment1_LabelValue:=1\n"));
        QVERIFY2(bool(map), map ? "" : map.error().text().c_str());
        QCOMPARE(map->parts[0], (MappedPart{"aorta", standardColour(1)}));
        QCOMPARE(map->parts[1], (MappedPart{"left: ventricle", {255, 128, 0}}));
        QCOMPARE(labelsOf(*map), (std::vector{0, 2, 2, 1, 0, 0, 0, 0}));
    }

    void totalSegmentatorsNamesAndColours() {
        for (const bool isPacked : {false, true}) {
            const std::string bytes = labelNifti({0, 5, 9, 9, 0, 0, 0, 0}, kCaret);
            const auto map = isPacked ? read("a.nii.gz", test::deflated(bytes, test::kGzipFile)) : read("a.nii", bytes);
            QVERIFY2(bool(map), map ? "" : map.error().text().c_str());
            QCOMPARE(map->parts.size(), std::size_t(2));
            QCOMPARE(map->parts[0], (MappedPart{"liver", {255, 128, 0}}));
            QCOMPARE(map->parts[1], (MappedPart{"bowel & <gas>", {0, 0, 51}}));
            QCOMPARE(map->notes.size(), std::size_t(1));  // the spleen has no voxels
        }
    }

    void brokenTablesAreNone() {
        const std::string whole = kCaret;
        for (std::size_t length = 0; length < whole.size(); ++length)
            for (const auto& [key, part] : caretLabels(whole.substr(0, length)))
                QVERIFY(key == 5 || key == 9 || key == 11);
        QVERIFY(caretLabels("<LabelTable><Label Key=\"x\">a</Label><Label Key=\"1\"</Label></LabelTable>").empty());
    }

    /// A file may be called by the patient, and images say the names of parts.
    void aMaskAloneDoesNotHaveTheNameOfItsFile() {
        const auto map =
            read("kidney_left.nii.gz", test::deflated(labelNifti({0, 1, 1, 0, 0, 0, 0, 0}), test::kGzipFile));
        QVERIFY(bool(map));
        QCOMPARE(map->parts[0].name, std::string("part 1"));
        const auto slicer = read("tumour.seg.nrrd", labelNrrd({0, 1}, ""));
        QCOMPARE(slicer->parts[0].name, std::string("part 1"));
    }

    void whatIsNoLabelMapIsRefused() {
        QCOMPARE(refusal("a.nii", labelNifti({0, -1000, 7, 7, 0, 3, 0, 0})),
                 std::string("its value -1000 is no label"));
        QCOMPARE(refusal("a.nii", labelNifti({0, 0, 0, 0, 0, 0, 0, 0})), std::string("it marks no voxel"));
        test::NiftiBytes halves;
        halves.set(112, 0.5f);
        halves.set(116, 1000.25f);
        QVERIFY(refusal("a.nii", halves.bytes).ends_with("is no label"));
        QVERIFY(refusal("a.nii", labelNifti({1, 2})).starts_with("it is too short"));
    }

    void moreThan255LabelsAreRefused() {
        const auto numbered = [](int count) {
            std::vector<std::int16_t> values(256, 0);
            for (int i = 0; i < count; ++i)
                values[std::size_t(255 - i)] = std::int16_t(3 * i + 3);
            test::NiftiBytes file;
            file.size = {16, 16, 1};
            file.stateAll();
            return file.bytes.substr(0, 352) + test::bytesOf(values);
        };
        const auto all = read("a.nii", numbered(255));
        QVERIFY2(bool(all), all ? "" : all.error().text().c_str());
        QCOMPARE(all->parts.size(), std::size_t(255));
        for (int i = 0; i < 255; ++i)
            QCOMPARE(int(all->labels[std::size_t(255 - i)]), i + 1);
        QCOMPARE(refusal("a.nii", numbered(256)), std::string("it has more than 255 labels"));
    }

    void whatIsWrittenComesBack() {
        LabelMap map;
        map.geometry = VolumeGeometry::aligned({7, 5, 3}, {0.7, 0.9, 2.5}, {-31.1, 12.25, 140.3});
        map.geometry.patientFromIndex[2] = dvec4(0.1, -0.3, 2.4, 0);  // a tilted gantry
        for (std::size_t i = 0; i < map.geometry.voxelCount(); ++i)
            map.labels.push_back(std::uint8_t(i % 4));
        map.parts = {{"liver", {255, 0, 7}}, {"liver", {1, 2, 3}}, {"two\nlines", {200, 100, 50}}};
        QVERIFY(!writeLabelFile(map, at("out.nrrd")));
        QVERIFY(bool(writeLabelFile(map, at("out.seg.nrrd"))));
        const auto back = readLabelFile(at("out.seg.nrrd"), noProgress);
        QVERIFY2(bool(back), back ? "" : back.error().text().c_str());
        QCOMPARE(labelsOf(*back), labelsOf(map));
        QVERIFY(back->geometry.patientFromIndex == map.geometry.patientFromIndex);
        map.parts[2].name = "two lines";
        QVERIFY(back->parts == map.parts);
    }

    void readingIsCancelled() {
        test::written(at("a.nii"), labelNifti({0, 1, 0, 0, 0, 0, 0, 0}));
        const auto map = readLabelFile(at("a.nii"), [](double, std::string_view) { return false; });
        QVERIFY(!map);
        QCOMPARE(map.error().kind, ErrorKind::cancelled);
    }
};

QTEST_APPLESS_MAIN(LabelFileTest)
#include "label_file_test.moc"
