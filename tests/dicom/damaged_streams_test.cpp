#include "tests/support/dicom/damaged_streams.h"

#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/oflog/oflog.h>

#include <atomic>
#include <thread>

#include "dicom/read/decoder_warnings.h"
#include "dicom/read/jpeg_stream.h"

using namespace pdr;
using test::Outcome;

namespace fs = std::filesystem;

namespace {

const std::vector<std::pair<const char*, E_TransferSyntax>> kCodings{
    {"RLE", EXS_RLELossless},
    {"JPEG lossless", EXS_JPEGProcess14},
    {"JPEG lossless, first-order", EXS_JPEGProcess14SV1},
    {"JPEG extended", EXS_JPEGProcess2_4},
    {"JPEG spectral selection", EXS_JPEGProcess6_8},
    {"JPEG progressive", EXS_JPEGProcess10_12},
    {"JPEG-LS", EXS_JPEGLSLossless},
    {"JPEG-LS near-lossless", EXS_JPEGLSLossy},
};

}  // namespace

class DamagedStreamsTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    fs::path file_;

    static void allCodings() {
        QTest::addColumn<int>("coding");
        for (const auto& [name, coding] : kCodings)
            QTest::newRow(name) << int(coding);
    }

  private slots:
    void initTestCase() { file_ = fs::path(folder_.path().toStdString()) / "slice"; }

    void noZeroRunLoadsSilently_data() { allCodings(); }
    void noZeroRunLoadsSilently() {
        QFETCH(int, coding);
        std::mt19937 random(3);
        int silent = 0, refused = 0;
        for (unsigned slice = 0; slice < 4; ++slice) {
            QVERIFY(test::writeCompressedSlice(file_, test::tissueSlice({128, 128}, slice), E_TransferSyntax(coding)));
            const std::string whole = test::bytesOf(file_);
            const auto sound = dicom::decodeSlice({file_}, dicom::Padding::keep);
            QVERIFY2(bool(sound), sound ? "" : sound.error().text().c_str());
            for (int trial = 0; trial < 16; ++trial) {
                test::writeBytes(file_, test::withZeroRun(whole, test::streamRange(whole), 64, random));
                const Outcome outcome = test::outcomeOf(file_, sound->hu);
                silent += outcome == Outcome::silent;
                refused += outcome == Outcome::refused;
            }
        }
        QVERIFY2(silent == 0, qPrintable(QString("%1 of 64 silent, %2 refused").arg(silent).arg(refused)));
        QVERIFY(refused > 32);
    }

    void zerosInTheLastBitsOfMeansAreSeen() {
        // One bit a block, without any code: only that tissue is never so even gives the damage away.
        QVERIFY(test::writeCompressedSlice(file_, test::tissueSlice({256, 256}, 1), EXS_JPEGProcess10_12));
        std::string bytes = test::bytesOf(file_);
        const test::StreamRange range = test::streamRange(bytes);
        const auto* start = reinterpret_cast<const std::uint8_t*>(bytes.data()) + range.first;
        const dicom::JpegStream jpeg = dicom::readJpeg({start, range.last - range.first});
        const auto scan = std::find_if(jpeg.scans.begin(), jpeg.scans.end(),
                                       [](const dicom::JpegScan& s) { return s.first == 0 && s.high > 0; });
        QVERIFY(scan != jpeg.scans.end());
        const auto middle = std::size_t(scan->parts[0].data() - start) + scan->parts[0].size() / 2;
        bytes.replace(range.first + middle, 16, 16, '\0');
        test::writeBytes(file_, bytes);
        QVERIFY(!dicom::decodeSlice({file_}, dicom::Padding::keep));
    }

    void damageIsNamed() {
        QVERIFY(test::writeCompressedSlice(file_, test::tissueSlice({64, 64}, 1), EXS_JPEGProcess14SV1));
        std::string bytes = test::bytesOf(file_);
        const test::StreamRange range = test::streamRange(bytes);
        bytes.replace((range.first + range.last) / 2, 64, 64, '\0');
        test::writeBytes(file_, bytes);
        const auto slice = dicom::decodeSlice({file_}, dicom::Padding::keep);
        QVERIFY(!slice);
        QVERIFY2(slice.error().what.find("the compressed image is damaged: ") == 0, slice.error().what.c_str());
        QCOMPARE(slice.error().where, file_.string());
    }

    void runLengthSegmentsAreCounted() {
        QVERIFY(test::writeCompressedSlice(file_, test::tissueSlice({64, 64}, 1), EXS_RLELossless));
        std::string bytes = test::bytesOf(file_);
        const std::size_t header = test::streamRange(bytes).first;
        bytes[header] = 3;  // segments
        test::writeBytes(file_, bytes);
        const auto slice = dicom::decodeSlice({file_}, dicom::Padding::keep);
        QVERIFY(!slice);
        QVERIFY2(slice.error().what.find("3 segments instead of 2") != std::string::npos, slice.error().what.c_str());
    }

    void numbersThatTheirBitsCannotHoldAreRefused() {
        test::SliceFile slice{.size = {64, 64}, .isSigned = false, .bitsStored = 12};
        slice.raw.assign(64 * 64, 7);
        slice.raw[100] = 0x2007;
        QVERIFY(test::writeCompressedSlice(file_, slice, EXS_RLELossless));
        const auto refused = dicom::decodeSlice({file_}, dicom::Padding::keep);
        QVERIFY(!refused);
        QVERIFY2(refused.error().what.find("1 of its pixels hold numbers that 12 bits cannot") != std::string::npos,
                 refused.error().what.c_str());

        slice.isSigned = true;
        slice.raw[100] = std::uint16_t(-5);
        QVERIFY(test::writeCompressedSlice(file_, slice, EXS_RLELossless));
        const auto taken = dicom::decodeSlice({file_}, dicom::Padding::keep);
        QVERIFY(bool(taken));
        QCOMPARE(int(taken->hu[100]), -5);
    }

    void constantTissueIsNoDamage() {
        for (const auto& [name, coding] : kCodings) {
            test::SliceFile slice{.size = {256, 256}, .isSigned = false, .bitsStored = 12};
            slice.raw.assign(256 * 256, 0);
            for (int i = 0; i < 40; ++i)
                slice.raw[std::size_t(256 * (100 + i) + 90 + i)] = 1500;
            QVERIFY(test::writeCompressedSlice(file_, slice, coding));
            const auto taken = dicom::decodeSlice({file_}, dicom::Padding::keep);
            QVERIFY2(bool(taken), (name + (taken ? "" : ": " + taken.error().what)).c_str());
        }
    }

    void complaintsReachTheSliceOfTheirThread() {
        dicom::prepareToolkit();
        const OFLogger decoder = OFLog::getLogger("dcmtk.dcmjpeg");
        std::atomic<int> wrong = 0;
        const auto decode = [&](int complaints) {
            for (int round = 0; round < 500; ++round) {
                const dicom::DecoderWarnings warnings;
                for (int i = 0; i < complaints; ++i)
                    OFLOG_WARN(decoder, "complaint " << complaints);
                const std::string expected = complaints == 0 ? "" : "complaint " + std::to_string(complaints);
                wrong += warnings.count() != complaints || warnings.first() != expected;
            }
        };
        std::vector<std::jthread> threads;
        for (int i = 0; i < 8; ++i)
            threads.emplace_back(decode, i % 4);
        threads.clear();
        QCOMPARE(wrong.load(), 0);
    }
};

QTEST_APPLESS_MAIN(DamagedStreamsTest)
#include "damaged_streams_test.moc"
