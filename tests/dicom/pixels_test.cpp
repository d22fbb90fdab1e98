#include "tests/support/dicom/slice_file.h"

#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <iterator>
#include <limits>

#include "dicom/import.h"

using namespace pdr;
using namespace pdr::dicom;
using test::SliceFile;

namespace {

using Values = std::vector<int>;

/// Writes the slice twice, one above the other, and loads the stack.
class Folder {
  public:
    explicit Folder(SliceFile slice) {
        test::writeSliceFile(path() / "a", slice);
        slice.position.z = 2;
        test::writeSliceFile(path() / "b", slice);
    }

    std::filesystem::path path() const { return folder_.path().toStdString(); }

    Result<Volume> load(Padding padding) const {
        const Result<ScanResult> scan = scanFolder(path(), noProgress);
        if (!scan)
            return scan.error();
        return loadSeries(scan->series.front(), padding, noProgress);
    }

    /// Returns the first `count` voxels; empty if the stack does not load.
    Values voxels(int count, Padding padding = Padding::maskAsAir) const {
        const Result<Volume> volume = load(padding);
        return volume ? Values(volume->voxels().begin(), volume->voxels().begin() + count) : Values{};
    }

    std::size_t paddingCount() const {
        const Result<Volume> volume = load(Padding::maskAsAir);
        return volume ? volume->paddingCount() : 0;
    }

  private:
    QTemporaryDir folder_;
};

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Writes a slice in GE's own transfer syntax: implicit little endian, and pixels with their high byte first.
void writeGeSlice(const std::filesystem::path& file, SliceFile slice) {
    for (std::uint16_t& word : slice.raw)
        word = std::uint16_t(word << 8 | word >> 8);
    test::writeSliceFile(file, slice);
    DcmFileFormat content;
    if (content.loadFile(file.c_str()).bad() || content.saveFile(file.c_str(), EXS_LittleEndianImplicit).bad())
        qFatal("the test cannot write its file");
    std::string bytes = bytesOf(file);
    const std::string implicit = UID_LittleEndianImplicitTransferSyntax + std::string(1, '\0');
    bytes.replace(bytes.find(implicit), implicit.size(), UID_PrivateGE_LEI_WithBigEndianPixelDataTransferSyntax);
    std::ofstream(file, std::ios::binary) << bytes;
}

std::uint16_t bits(int value) {
    return std::uint16_t(std::int16_t(value));
}

}  // namespace

class PixelsTest : public QObject {
    Q_OBJECT

  private slots:
    void signedAndUnsignedPixelsMeanWhatTheySay() {
        QVERIFY((Folder({.raw = {bits(-5), 7}}).voxels(2) == Values{-5, 7}));
        SliceFile slice{.raw = {4095, 0}, .isSigned = false, .bitsStored = 12};
        slice.change = [](DcmDataset& data) { data.putAndInsertString(DCM_RescaleIntercept, "-1024"); };
        QVERIFY((Folder(slice).voxels(2) == Values{3071, -1024}));
    }

    void bitsAboveTheStoredOnesAreIgnored() {
        QVERIFY((Folder({.raw = {0xF005, 0x3FFF}, .isSigned = false, .bitsStored = 12}).voxels(2) == Values{5, 4095}));
        QVERIFY((Folder({.raw = {0x0FFF, 0x0800, 0x07FF}, .bitsStored = 12}).voxels(3) == Values{-1, -2048, 2047}));
    }

    void highBitShiftsTheStoredBits() {
        SliceFile slice{.raw = {0x0050, 0xFFFF}, .isSigned = false, .bitsStored = 12};
        slice.change = [](DcmDataset& data) { data.putAndInsertUint16(DCM_HighBit, 15); };
        QVERIFY((Folder(slice).voxels(2) == Values{5, 4095}));
    }

    void eightBitPixelsLoad() {
        SliceFile slice{.isSigned = false, .bitsStored = 8};
        slice.change = [](DcmDataset& data) {
            const Uint8 bytes[12] = {255, 1, 2};
            data.putAndInsertUint16(DCM_BitsAllocated, 8);
            data.putAndInsertUint8Array(DCM_PixelData, bytes, 12);
        };
        QVERIFY((Folder(slice).voxels(3) == Values{255, 1, 2}));
    }

    /// Pixels and padding are those of little endian; bytes in swapped words are of no known order.
    void pixelsOfGeWithTheHighByteFirstLoad() {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString();
        SliceFile slice{.raw = {bits(-2000), bits(-5), 0x0100, 300, 0, 0, 0, 0, 0, 0, 0, 0}};
        slice.change = [](DcmDataset& data) { data.putAndInsertSint16(DCM_PixelPaddingValue, -2000); };
        writeGeSlice(path / "a", slice);
        slice.position.z = 2;
        writeGeSlice(path / "b", slice);
        const auto scan = scanFolder(path, noProgress);
        QVERIFY(scan && scan->series.front().verdict.loadable());
        QCOMPARE(std::string(scan->series.front().series.coding), std::string("uncompressed"));
        const auto volume = loadSeries(scan->series.front(), Padding::maskAsAir, noProgress);
        QVERIFY(volume && volume->paddingCount() == 2 && volume->isPadding(0));
        QVERIFY((Values(volume->voxels().begin() + 1, volume->voxels().begin() + 4) == Values{-5, 256, 300}));
        slice.change = [](DcmDataset& data) {
            data.putAndInsertUint16(DCM_BitsAllocated, 8);
            data.putAndInsertUint16(DCM_BitsStored, 8);
            data.putAndInsertUint16(DCM_HighBit, 7);
        };
        for (const char* name : {"a", "b"})
            writeGeSlice(path / name, slice);
        const auto bytes = scanFolder(path, noProgress);
        QVERIFY(bytes && !bytes->series.front().verdict.loadable());
    }

    void pixelsOfThirtyTwoBitsLoad() {
        SliceFile slice;
        slice.change = [](DcmDataset& data) {
            std::vector<Uint16> words;
            for (const int value : {-5, 7, 70'000, -100'000, 0, 0, 0, 0, 0, 0, 0, 0}) {
                words.push_back(Uint16(unsigned(value)));
                words.push_back(Uint16(unsigned(value) >> 16));
            }
            data.putAndInsertUint16(DCM_BitsAllocated, 32);
            data.putAndInsertUint16(DCM_BitsStored, 32);
            data.putAndInsertUint16(DCM_HighBit, 31);
            data.putAndInsertString(DCM_RescaleSlope, "0.01");
            data.putAndInsertUint16Array(DCM_PixelData, words.data(), 24);
        };
        QVERIFY((Folder(slice).voxels(4) == Values{0, 0, 700, -1000}));
        slice.isSigned = false;  // the same bits are large numbers, then
        QVERIFY((Folder(slice).voxels(4) == Values{32767, 0, 700, 32767}));
    }

    void floatingPointPixelsLoad() {
        SliceFile slice;
        slice.change = [](DcmDataset& data) {
            delete data.remove(DCM_PixelData);
            std::vector<Float32> values(12, 40.4f);
            values[1] = -0.6f;
            values[2] = std::numeric_limits<float>::quiet_NaN();
            values[3] = 9e9f;
            values[4] = -7;
            auto* pixels = new DcmFloatingPointSingle(DCM_FloatPixelData);
            pixels->putFloat32Array(values.data(), 12);
            data.insert(pixels);
            data.putAndInsertUint16(DCM_BitsAllocated, 32);
            data.putAndInsertFloat32(DCM_FloatPixelPaddingValue, -7);
            data.putAndInsertString(DCM_RescaleSlope, "10");
        };
        const Folder single(slice);
        QVERIFY((single.voxels(5) == Values{404, -6, -1024, 32767, -1024}));
        QVERIFY((single.voxels(5, Padding::keep) == Values{404, -6, -1024, 32767, -70}));
        QCOMPARE(single.paddingCount(), std::size_t(4));
        slice.change = [](DcmDataset& data) {
            delete data.remove(DCM_PixelData);
            const std::vector<Float64> values(12, 40.6);
            auto* pixels = new DcmFloatingPointDouble(DCM_DoubleFloatPixelData);
            pixels->putFloat64Array(values.data(), 12);
            data.insert(pixels);
            data.putAndInsertUint16(DCM_BitsAllocated, 64);
        };
        QVERIFY((Folder(slice).voxels(2) == Values{41, 41}));
        const SliceFile whole = slice;
        slice.change = [&whole](DcmDataset& data) {
            whole.change(data);
            data.putAndInsertUint16(DCM_Rows, 4);
        };
        QVERIFY(!Folder(slice).load(Padding::keep));
    }

    void huIsRoundedToTheNearest() {
        SliceFile slice{.raw = {1, 2, 3, bits(-3)}};
        slice.change = [](DcmDataset& data) {
            data.putAndInsertString(DCM_RescaleSlope, "0.5");
            data.putAndInsertString(DCM_RescaleIntercept, "-0.75");
        };
        QVERIFY((Folder(slice).voxels(4) == Values{0, 0, 1, -2}));
    }

    void huBeyondSixteenBitsIsHeldAtTheEnd() {
        SliceFile slice{.raw = {65535, 0}, .isSigned = false};
        QVERIFY((Folder(slice).voxels(2) == Values{32767, 0}));
    }

    void paddingBecomesAirAndIsCounted() {
        SliceFile slice{.raw = {bits(-2000), 100}};
        slice.change = [](DcmDataset& data) { data.putAndInsertSint16(DCM_PixelPaddingValue, -2000); };
        const Folder folder(slice);
        QVERIFY((folder.voxels(2) == Values{-1024, 100}));
        QVERIFY((folder.voxels(2, Padding::keep) == Values{-2000, 100}));
        QCOMPARE(folder.paddingCount(), std::size_t(2));
        QCOMPARE(int(folder.load(Padding::keep)->lowestHu()), 2);
    }

    /// They are found while the voxels are written; a volume that looks at all of them finds the same.
    void rangesAreThoseOfTheVoxels() {
        for (const char* padding : {"", "2", "-2000", "100"}) {
            SliceFile slice{.raw = {bits(-2000), bits(-3000), 100, 3000}};
            slice.change = [&](DcmDataset& data) {
                if (*padding)
                    data.putAndInsertSint16(DCM_PixelPaddingValue, Sint16(std::stoi(padding)));
            };
            for (const Padding kept : {Padding::maskAsAir, Padding::keep}) {
                const auto read = Folder(slice).load(kept);
                QVERIFY(bool(read));
                const auto voxels = read->voxels();
                std::vector<bool> flags(voxels.size());
                for (std::size_t i = 0; i < flags.size(); ++i)
                    flags[i] = read->isPadding(i);
                const Volume again(read->geometry(), Voxels(voxels.begin(), voxels.end()), flags);
                QCOMPARE(int(read->lowestHu()), int(again.lowestHu()));
                QCOMPARE(int(read->highestHu()), int(again.highestHu()));
                QVERIFY(read->storedRange() == again.storedRange());
                QCOMPARE(read->paddingCount(), again.paddingCount());
            }
        }
    }

    void paddingWrittenWithTheOtherSignIsUnderstood() {
        SliceFile slice{.raw = {bits(-2000), 100}};
        slice.change = [](DcmDataset& data) {
            data.insert(new DcmUnsignedShort(DcmTag(DCM_PixelPaddingValue, EVR_US)), true);
            data.putAndInsertUint16(DcmTag(DCM_PixelPaddingValue, EVR_US), 63536);
        };
        QCOMPARE(Folder(slice).paddingCount(), std::size_t(2));

        SliceFile unsignedSlice{.raw = {63536, 100}, .isSigned = false};
        unsignedSlice.change = [](DcmDataset& data) {
            data.insert(new DcmSignedShort(DcmTag(DCM_PixelPaddingValue, EVR_SS)), true);
            data.putAndInsertSint16(DcmTag(DCM_PixelPaddingValue, EVR_SS), -2000);
        };
        QCOMPARE(Folder(unsignedSlice).paddingCount(), std::size_t(2));

        SliceFile twelveBits{.raw = {0x0830, 100}, .bitsStored = 12};
        twelveBits.change = [](DcmDataset& data) {
            data.putAndInsertUint16(DcmTag(DCM_PixelPaddingValue, EVR_US), 0x0830);
        };
        QCOMPARE(Folder(twelveBits).paddingCount(), std::size_t(2));
    }

    void paddingMeetsPixelsOfFewerBits() {
        SliceFile slice{.raw = {0x0830, 0}, .bitsStored = 12};
        slice.change = [](DcmDataset& data) { data.putAndInsertSint16(DCM_PixelPaddingValue, -2000); };
        QVERIFY((Folder(slice).voxels(2) == Values{-1024, 0}));
        slice.change = [](DcmDataset& data) { data.putAndInsertSint16(DCM_PixelPaddingValue, -32768); };
        QVERIFY((Folder(slice).voxels(2) == Values{-2000, 0}));
    }

    void paddingRangeTakesBothEnds() {
        SliceFile slice{.raw = {bits(-2000), bits(-1990), bits(-1989), bits(-2001)}};
        slice.change = [](DcmDataset& data) {
            data.putAndInsertSint16(DCM_PixelPaddingValue, -1990);
            data.putAndInsertSint16(DCM_PixelPaddingRangeLimit, -2000);
        };
        const Folder folder(slice);
        QVERIFY((folder.voxels(4) == Values{-1024, -1024, -1989, -2001}));
        QCOMPARE(folder.paddingCount(), std::size_t(4));
    }

    void paddingIsASlicesOwnAffair() {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString();
        SliceFile slice{.raw = {5, 6}};
        slice.change = [](DcmDataset& data) { data.putAndInsertSint16(DCM_PixelPaddingValue, 5); };
        test::writeSliceFile(path / "a", slice);
        slice.position.z = 1;
        slice.change = [](DcmDataset& data) { data.putAndInsertSint16(DCM_PixelPaddingValue, 6); };
        test::writeSliceFile(path / "b", slice);
        const auto scan = scanFolder(path, noProgress);
        const auto volume = loadSeries(scan->series.front(), Padding::maskAsAir, noProgress);
        QVERIFY(bool(volume));
        // The slices count on from 2 after the two given values: 5 and 6 come again.
        QVERIFY(volume->isPadding(0) && !volume->isPadding(1) && !volume->isPadding(12) && volume->isPadding(13));
    }

    void undeclaredRoundFieldOfGeIsPadding() {
        SliceFile slice{.raw = {bits(-2000), bits(-1999)}};
        slice.change = [](DcmDataset& data) { data.putAndInsertString(DCM_RescaleIntercept, "-1024"); };
        QVERIFY((Folder(slice).voxels(2) == Values{-1024, -3023}));
        QVERIFY((Folder(slice).voxels(2, Padding::keep) == Values{-3024, -3023}));
        QVERIFY((Folder({.raw = {bits(-2000)}}).voxels(1) == Values{-2000}));
    }

    void missingRescaleIsSaid() {
        SliceFile slice{.raw = {42}};
        slice.change = [](DcmDataset& data) { data.findAndDeleteElement(DCM_RescaleSlope); };
        const Folder folder(slice);
        const auto scan = scanFolder(folder.path(), noProgress);
        QCOMPARE(scan->series.front().verdict.notes.size(), std::size_t(1));
        QVERIFY((folder.voxels(1) == Values{42}));
    }

    void unitsOtherThanHuAreSaid() {
        SliceFile slice;
        slice.change = [](DcmDataset& data) { data.putAndInsertString(DCM_RescaleType, "Z_EFF"); };
        const auto scan = scanFolder(Folder(slice).path(), noProgress);
        QVERIFY(scan->series.front().verdict.notes.front().text.find("Z_EFF") != std::string::npos);
    }

    void unusableRescaleIsRefused_data() {
        QTest::addColumn<QString>("slope");
        for (const char* slope : {"0", "nan", "1e999", "1,5", "x"})
            QTest::newRow(slope) << slope;
    }
    void unusableRescaleIsRefused() {
        QFETCH(QString, slope);
        SliceFile slice;
        slice.change = [&](DcmDataset& data) { data.putAndInsertString(DCM_RescaleSlope, qPrintable(slope)); };
        const Folder folder(slice);
        const auto scan = scanFolder(folder.path(), noProgress);
        QCOMPARE(scan->series.front().verdict.stack, Stack::unreadable);
        QVERIFY(!folder.load(Padding::keep));
    }

    void colourAndOddFormatsAreRefused_data() {
        QTest::addColumn<int>("samples");
        QTest::addColumn<int>("bits");
        QTest::addColumn<int>("stored");
        QTest::addColumn<int>("columns");
        QTest::newRow("colour") << 3 << 16 << 16 << 4;
        QTest::newRow("32 bits") << 1 << 32 << 32 << 4;
        QTest::newRow("more stored than allocated") << 1 << 16 << 17 << 4;
        QTest::newRow("nothing stored") << 1 << 16 << 0 << 4;
        QTest::newRow("more pixels than there are") << 1 << 16 << 16 << 5;
        QTest::newRow("too wide") << 1 << 16 << 16 << 65535;
        QTest::newRow("no width") << 1 << 16 << 16 << 0;
    }
    void colourAndOddFormatsAreRefused() {
        QFETCH(int, samples);
        QFETCH(int, bits);
        QFETCH(int, stored);
        QFETCH(int, columns);
        SliceFile slice;
        slice.change = [=](DcmDataset& data) {
            data.putAndInsertUint16(DCM_SamplesPerPixel, Uint16(samples));
            data.putAndInsertUint16(DCM_BitsAllocated, Uint16(bits));
            data.putAndInsertUint16(DCM_BitsStored, Uint16(stored));
            data.putAndInsertUint16(DCM_HighBit, Uint16(stored - 1));
            data.putAndInsertUint16(DCM_Columns, Uint16(columns));
        };
        const auto volume = Folder(slice).load(Padding::maskAsAir);
        QVERIFY(!volume);
        QVERIFY(!volume.error().what.empty());
    }
};

QTEST_APPLESS_MAIN(PixelsTest)
#include "pixels_test.moc"
