#include <QTemporaryDir>
#include <QTest>

#include "render/volume/file/label_folder.h"
#include "tests/support/grid_files.h"

using namespace pdr;

namespace fs = std::filesystem;

/// A folder with a mask of each part is one label map.
class LabelFolderTest : public QObject {
    Q_OBJECT

    QTemporaryDir root_;
    fs::path folder_;

    /// Writes a mask of 4 x 2 x 1 voxels.
    void write(const std::string& name, const std::vector<std::int16_t>& values, double movedMm = 0) const {
        test::NiftiBytes file;
        file.size = {4, 2, 1};
        file.sform[3].x += movedMm;
        file.stateAll();
        test::written(folder_ / name, file.bytes.substr(0, 352) + test::bytesOf(values));
    }
    static std::vector<int> labelsOf(const LabelMap& map) { return {map.labels.begin(), map.labels.end()}; }
    std::string refusal() const {
        const auto map = readLabelFolder(folder_, noProgress);
        return map ? "it was read" : map.error().text();
    }

  private slots:
    void init() {
        static int count = 0;
        folder_ = fs::path(root_.path().toStdString()) / std::to_string(++count);
        fs::create_directory(folder_);
    }

    void eachMaskIsAPartInTheOrderOfTheNames() {
        write("spleen.nii", {0, 0, 0, 0, 1, 1, 0, 0});
        write("aorta.nii", {0, 1, 0, 0, 0, 0, 0, 0});
        write("liver.nii", {0, 0, 1, 1, 0, 0, 0, 0});
        test::written(folder_ / "statistics.json", "{}");
        fs::create_directory(folder_ / "more");
        const auto map = readLabelFolder(folder_, noProgress);
        QVERIFY2(bool(map), map ? "" : map.error().text().c_str());
        QCOMPARE(map->parts.size(), std::size_t(3));
        QCOMPARE(map->parts[0].name, std::string("aorta"));
        QCOMPARE(map->parts[2].name, std::string("spleen"));
        QCOMPARE(labelsOf(*map), (std::vector{0, 1, 2, 2, 3, 3, 0, 0}));
        QVERIFY(map->notes.empty());
    }

    /// A tumour lies in its liver, whatever their files are called.
    void aVoxelInSeveralPartsBelongsToTheSmallest() {
        for (const char* tumour : {"a.nii", "z.nii"}) {
            init();
            write("liver.nii", {1, 1, 1, 1, 1, 0, 0, 0});
            write("lobe.nii", {0, 1, 1, 1, 0, 0, 0, 0});
            write(tumour, {0, 0, 1, 0, 0, 1, 0, 0});
            const auto map = readLabelFolder(folder_, noProgress);
            QVERIFY2(bool(map), map ? "" : map.error().text().c_str());
            std::vector<std::string> names;
            for (const std::uint8_t label : map->labels)
                names.push_back(label == 0 ? "" : map->parts[label - 1].name);
            const std::string own = fs::path(tumour).stem().string();
            QCOMPARE(names, (std::vector<std::string>{"liver", "lobe", own, "lobe", "liver", own, "", ""}));
            QCOMPARE(map->notes.size(), std::size_t(1));
            QVERIFY2(std::string(map->notes[0]).ends_with("the smallest keeps them: 3"), map->notes[0].c_str());
        }
    }

    void emptyMasksAreNoParts() {
        write("brain.nii", {0, 0, 0, 0, 0, 0, 0, 0});
        write("liver.nii", {0, 0, 1, 1, 0, 0, 0, 0});
        const auto map = readLabelFolder(folder_, noProgress);
        QVERIFY2(bool(map), map ? "" : map.error().text().c_str());
        QCOMPARE(map->parts.size(), std::size_t(1));
        QCOMPARE(map->notes, std::vector<Text>{emptyPartsNote(1)});
        fs::remove(folder_ / "liver.nii");
        QVERIFY2(refusal().find("it marks no voxel") != std::string::npos, refusal().c_str());
    }

    void masksOfAnotherScanAreRefused() {
        write("a.nii", {1, 0, 0, 0, 0, 0, 0, 0});
        write("b.nii", {0, 1, 0, 0, 0, 0, 0, 0}, 0.5);
        QVERIFY2(refusal().find("b.nii: the mask has other voxels") != std::string::npos, refusal().c_str());
    }

    void aFolderWithoutMasksIsRefused() {
        test::written(folder_ / "a.dcm", "nothing");
        QVERIFY2(refusal().find("it holds no label map") != std::string::npos, refusal().c_str());
    }

    void moreThan255PartsAreRefused() {
        std::vector<std::int16_t> values(8);
        for (int file = 0; file < 32; ++file) {
            for (int i = 0; i < 8; ++i)
                values[std::size_t(i)] = std::int16_t(i + 1);
            write("mask" + std::to_string(10 + file) + ".nii", values);
        }
        QVERIFY2(refusal().find("mask41.nii: the masks have more than 255 labels") != std::string::npos,
                 refusal().c_str());
    }

    void readingIsCancelled() {
        write("a.nii", {1, 0, 0, 0, 0, 0, 0, 0});
        const auto map = readLabelFolder(folder_, [](double, std::string_view) { return false; });
        QVERIFY(!map);
        QCOMPARE(map.error().kind, ErrorKind::cancelled);
    }
};

QTEST_APPLESS_MAIN(LabelFolderTest)
#include "label_folder_test.moc"
