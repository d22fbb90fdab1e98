#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <fstream>
#include <functional>
#include <random>

#include "dicom/import.h"
#include "dicom/segmentation/frame_grid.h"
#include "dicom/segmentation/segmentation.h"
#include "tests/support/places.h"

using namespace pdr;

namespace fs = std::filesystem;

namespace {

const fs::path kFiles(PDR_SOURCE_DIR "/tests/oracle/labels/files");

/// A frame of 4 x 3 pixels of 1 mm at a place.
dicom::SliceHeader frameAt(const dvec3& position) {
    dicom::SliceHeader frame;
    frame.columns = 4;
    frame.rows = 3;
    frame.position = position;
    frame.rowDirection = dvec3(1, 0, 0);
    frame.columnDirection = dvec3(0, 1, 0);
    frame.spacingMm = dvec2(1, 1);
    return frame;
}

/// A scan of 2 mm between slices whose gantry is tilted.
VolumeGeometry tilted() {
    VolumeGeometry scan = VolumeGeometry::aligned({4, 3, 20}, {1, 1, 2}, {0, 0, 0});
    scan.patientFromIndex[2].y = 0.7;
    return scan;
}

}  // namespace

/// Segmentations are taken for their own scan only, and nothing in a file makes them lie elsewhere. That what other
/// programs write is read as they mean it is shown in tests/oracle/labels.
class SegmentationTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    dicom::Series series_;

    fs::path changed(const char* name, const std::function<void(DcmDataset&)>& change) const {
        DcmFileFormat content;
        if (content.loadFile((kFiles / name).c_str()).bad())
            qFatal("a file of the test is missing");
        content.getDataset()->loadAllDataIntoMemory();
        change(*content.getDataset());
        const fs::path file = fs::path(folder_.path().toStdString()) / "changed.dcm";
        content.saveFile(file.c_str(), EXS_LittleEndianExplicit);
        return file;
    }
    Result<LabelMap> read(const fs::path& file) const {
        return dicom::readSegmentation({file}, series_, series_.geometry, noProgress);
    }
    std::string refusal(const std::function<void(DcmDataset&)>& change, const char* name = "binary.dcm") const {
        const auto map = read(changed(name, change));
        return map ? "it was read" : std::string(map.error().what);
    }

  private slots:
    void initTestCase() {
        const auto scan = dicom::scanFolder(kFiles / "ct", noProgress);
        QVERIFY(bool(scan));
        series_ = scan->series.front();
    }

    void theirOwnScanTakesThem() {
        const auto map = read(changed("binary.dcm", [](DcmDataset&) {}));
        QVERIFY2(bool(map), map ? "" : map.error().text().c_str());
        QCOMPARE(map->parts.size(), std::size_t(3));
        QVERIFY(map->notes.empty());
    }

    void anotherPatientsIsRefused() {
        QCOMPARE(refusal([](DcmDataset& data) { data.putAndInsertString(DCM_PatientID, "L2"); }),
                 std::string("the segmentation names another patient than the scan"));
        QCOMPARE(refusal([](DcmDataset& data) { data.putAndInsertString(DCM_FrameOfReferenceUID, "2.25.44"); }),
                 std::string("the segmentation has another frame of reference than the scan"));
    }

    /// De-identified scans may have a frame of reference for each slice: then the series must be named.
    void withoutACommonFrameOfReferenceTheSeriesCounts() {
        dicom::Series split = series_;
        split.slices.front().identity.frameOfReferenceUid = "2.25.99";
        const auto map = dicom::readSegmentation({kFiles / "binary.dcm"}, split, split.geometry, noProgress);
        QVERIFY(bool(map));
        split.series.uid = "2.25.66";
        const auto other = dicom::readSegmentation({kFiles / "binary.dcm"}, split, split.geometry, noProgress);
        QVERIFY(!other);
        QCOMPARE(std::string(other.error().what), std::string("the segmentation does not refer to the scan"));
    }

    void whatIsNoSegmentationIsRefused() {
        const auto slice = read(kFiles / "ct" / "0.dcm");
        QVERIFY(!slice);
        QCOMPARE(std::string(slice.error().what), std::string("this is no DICOM segmentation"));
        QCOMPARE(refusal([](DcmDataset& data) { data.putAndInsertUint16(DCM_BitsAllocated, 4); }),
                 std::string("its pixels are no segments (4 bits)"));
        QVERIFY(refusal([](DcmDataset& data) {
                    data.putAndInsertString(DCM_SegmentationType, "OTHER");
                }).starts_with("it states "));
    }

    void fewerFramesOrPixelsThanStatedAreRefused() {
        QVERIFY(refusal([](DcmDataset& data) { data.putAndInsertString(DCM_NumberOfFrames, "10"); }) != "it was read");
        QVERIFY(refusal([](DcmDataset& data) {
                    const Uint8 few[4] = {255, 255, 255, 255};
                    data.putAndInsertUint8Array(DCM_PixelData, few, 4);
                }) != "it was read");
        QVERIFY(refusal([](DcmDataset& data) { data.putAndInsertUint16(DCM_Rows, 60); }) != "it was read");
    }

    void aFrameWithoutAPlaceIsRefused() {
        QCOMPARE(refusal([](DcmDataset& data) {
                     DcmItem* frame = nullptr;
                     data.findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, 2);
                     frame->findAndDeleteElement(DCM_PlanePositionSequence);
                 }),
                 std::string("its frames do not say where they lie in the patient"));
    }

    void itsNameIsThatOfWhatItIsOf() {
        const auto map = read(changed("binary.dcm", [](DcmDataset& data) {
            DcmItem* segment = nullptr;
            data.findAndGetSequenceItem(DCM_SegmentSequence, segment, 1);
            segment->findAndDeleteElement(DCM_SegmentLabel);
        }));
        QVERIFY(bool(map));
        QCOMPARE(map->parts[1].name, std::string("Bone"));
    }

    /// Half of the largest fraction belongs to a segment, also where that is no even number.
    void aHalfBelongsToASegment() {
        for (const int most : {1, 2, 100, 255}) {
            const auto map = read(changed("fraction.dcm", [&](DcmDataset& data) {
                std::vector<Uint8> pixels;
                const Uint8* old = nullptr;
                unsigned long count = 0;
                data.findAndGetUint8Array(DCM_PixelData, old, &count);
                pixels.assign(count, 0);
                pixels[0] = Uint8((most + 1) / 2);
                pixels[1] = Uint8((most + 1) / 2 - 1);
                data.putAndInsertUint8Array(DCM_PixelData, pixels.data(), count);
                data.putAndInsertUint16(DCM_MaximumFractionalValue, Uint16(most));
            }));
            QVERIFY(bool(map));
            QCOMPARE(std::ranges::count(map->labels, 1), 1);
        }
    }

    /// Frames that are left out leave gaps, which are as many slices of the scan as they are wide.
    void sparseFramesLieOnTheSlicesOfTheScan() {
        const dvec3 step(0, 0.7, 2);
        const auto grid =
            dicom::gridOfFrames({frameAt(9.0 * step), frameAt(3.0 * step), frameAt(9.0 * step)}, tilted());
        QVERIFY(bool(grid));
        QCOMPARE(grid->slice, (std::vector{6, 0, 6}));
        QCOMPARE(grid->geometry.size.z, 7);
        QVERIFY(glm::length(dvec3(grid->geometry.patientFromIndex[3]) - 3.0 * step) < 1e-9);
        QVERIFY(glm::length(dvec3(grid->geometry.patientFromIndex[2]) - step) < 1e-9);
    }

    /// Frames of other places than the scan's have a grid of their own, for resampling; uneven ones have none.
    void framesBesideTheSlicesOfTheScan() {
        const auto own = dicom::gridOfFrames({frameAt({0, 0, 7.5}), frameAt({0, 0, 0}), frameAt({0, 0, 3})}, tilted());
        QVERIFY(!own);
        QCOMPARE(std::string(own.error().what), std::string("its frames are not evenly spaced"));
        const auto even = dicom::gridOfFrames({frameAt({0, 0, 9}), frameAt({0, 0, 0}), frameAt({0, 0, 3})}, tilted());
        QVERIFY(bool(even));
        QCOMPARE(even->slice, (std::vector{3, 0, 1}));
        auto turned = frameAt({0, 0, 3});
        turned.rowDirection = dvec3(0, 1, 0);
        turned.columnDirection = dvec3(1, 0, 0);
        QVERIFY(!dicom::gridOfFrames({frameAt({0, 0, 0}), turned}, tilted()));
    }

    /// Places far apart must not become a grid that fills the memory.
    void framesFarApartAreRefused() {
        const VolumeGeometry scan = VolumeGeometry::aligned({4, 3, 2}, {1, 1, 1}, {0, 0, 0});
        QVERIFY(!dicom::gridOfFrames({frameAt({0, 0, 0}), frameAt({0, 0, 1}), frameAt({0, 0, 2e9})}, scan));
    }

    /// 300 seeded mutants: bytes changed, cut out, doubled. They are read or refused.
    void mutantsAreReadOrRefused() {
        std::ifstream file(kFiles / "binary.dcm", std::ios::binary);
        const std::string whole((std::istreambuf_iterator<char>(file)), {});
        std::mt19937 random(20261127);
        for (int mutant = 0; mutant < 300; ++mutant) {
            std::string bytes = whole;
            for (int change = 0; change < 1 + mutant % 4; ++change) {
                const std::size_t where = random() % bytes.size();
                if (random() % 3 == 0)
                    bytes.erase(where, 1 + random() % 5);
                else
                    bytes[where] = char(random());
            }
            const auto memory = std::make_shared<const std::vector<std::uint8_t>>(bytes.begin(), bytes.end());
            const auto map = dicom::readSegmentation({"mutant", memory}, series_, series_.geometry, noProgress);
            QVERIFY(!map || map->labels.size() == map->geometry.voxelCount());
        }
    }

    void readingIsCancelled() {
        const auto map = dicom::readSegmentation({kFiles / "binary.dcm"}, series_, series_.geometry,
                                                 [](double, std::string_view) { return false; });
        QVERIFY(!map);
        QCOMPARE(map.error().kind, ErrorKind::cancelled);
    }
};

QTEST_APPLESS_MAIN(SegmentationTest)
#include "segmentation_test.moc"
