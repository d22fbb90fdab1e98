/// Multi-frame CT: each frame in its place, with its own rescale, in every coding; or a sentence that says why not.

#include <QTemporaryDir>
#include <QTest>

#include "dicom/import.h"
#include "dicom/read/pixels.h"
#include "dicom/read/slice_header.h"
#include "render/base/progress.h"
#include "tests/support/dicom/enhanced_file.h"
#include "tests/support/dicom/memory_source.h"

using namespace pdr;
using namespace pdr::dicom;

namespace {

constexpr ivec2 kSize{64, 48};

/// Returns a file of frames 2 mm apart, from the top down, each with an intercept of its own.
test::EnhancedFile thorax(int count) {
    test::EnhancedFile file{.size = kSize};
    for (int k = 0; k < count; ++k) {
        test::EnhancedFrame frame{.position = {0, 0, 2.0 * (count - 1 - k)}, .intercept = -1024.0 - 10 * k};
        frame.raw = test::tissueSlice(kSize, unsigned(k) + 1).raw;
        file.frames.push_back(frame);
    }
    return file;
}

/// Returns the HU of a frame, as they must be.
std::vector<int> huOf(const test::EnhancedFrame& frame) {
    std::vector<int> hu;
    for (const std::uint16_t raw : frame.raw)
        hu.push_back(int(std::lround(raw * frame.slope + frame.intercept)));
    return hu;
}

std::vector<int> sliceOf(const Volume& volume, int k) {
    const std::size_t voxels = std::size_t(kSize.x) * std::size_t(kSize.y);
    const auto first = volume.voxels().begin() + std::ptrdiff_t(std::size_t(k) * voxels);
    return {first, first + std::ptrdiff_t(voxels)};
}

std::string reasonOf(const ScanResult& scan) {
    if (!scan.problems.empty())
        return scan.problems.front().reason;
    return scan.series.empty() ? std::string() : std::string(scan.series.front().verdict.reason);
}

}  // namespace

class MultiFrameTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_, scratch_;

    std::filesystem::path folder() const { return folder_.path().toStdString(); }
    std::filesystem::path file() const { return folder() / "thorax"; }
    std::filesystem::path scratch() const { return std::filesystem::path(scratch_.path().toStdString()) / "one frame"; }
    ScanResult scanned() const {
        Result<ScanResult> scan = scanFolder(folder(), noProgress);
        return scan ? *std::move(scan) : ScanResult{};
    }

    /// Fails unless the folder holds one series whose slices are the frames of `like`, from the last to the first.
    void verifyIsRead(const test::EnhancedFile& like) const {
        const ScanResult scan = scanned();
        QVERIFY2(scan.series.size() == 1 && scan.series[0].verdict.loadable(), reasonOf(scan).c_str());
        const Series& series = scan.series.front();
        const auto volume = loadSeries(series, Padding::keep, noProgress);
        QVERIFY2(bool(volume), volume ? "" : volume.error().text().c_str());
        const int count = int(like.frames.size());
        QVERIFY(volume->geometry().size == ivec3(kSize, count));
        QVERIFY(glm::distance(dvec3(volume->geometry().patientFromIndex[2]), dvec3(0, 0, 2)) < 1e-9);
        for (int k = 0; k < count; ++k)
            QCOMPARE(sliceOf(*volume, k), huOf(like.frames[std::size_t(count - 1 - k)]));
    }

  private slots:
    void cleanup() {
        for (const auto& entry : std::filesystem::directory_iterator(folder()))
            std::filesystem::remove_all(entry.path());
    }

    void framesLieWhereTheySay() {
        test::EnhancedFile file = thorax(5);
        file.frames[1].slope = 0.5;
        test::writeEnhancedFile(this->file(), file);
        verifyIsRead(file);
        const Series series = scanned().series.at(0);
        QCOMPARE(series.slices.front().frame, 4);
        QCOMPARE(series.slices.back().frame, 0);
    }

    /// The toolkit parses the groups of a thousand frames for a third of a second; who cancels does not wait for that.
    void parsingTheGroupsEndsOnRequest() {
        test::writeEnhancedFile(file(), thorax(50));
        int asked = 0;
        const auto count = [&] { return ++asked > 0; };
        QVERIFY(readSliceHeader({file()}, count).kind == HeaderRead::Kind::object);
        const int all = asked;
        QVERIFY2(all > 10 * 50, qPrintable(QString::number(all)));
        for (int last = all / 4; last < all; last += all / 4) {
            asked = 0;
            const HeaderRead read = readSliceHeader({file()}, [&] { return ++asked < last; });
            QVERIFY(read.kind == HeaderRead::Kind::damaged && read.frames.empty());
            QCOMPARE(asked, last);
        }
    }

    void theHighByteMayComeFirst() {
        const test::EnhancedFile file = thorax(3);
        test::writeEnhancedFile(this->file(), file, EXS_BigEndianExplicit);
        verifyIsRead(file);
    }

    void everyCodingIsRead_data() {
        QTest::addColumn<int>("coding");
        QTest::addColumn<int>("fragments");
        QTest::addColumn<bool>("hasTable");
        QTest::addColumn<int>("besides");
        const auto add = [](const char* name, E_TransferSyntax coding, int fragments, bool hasTable, int besides = 0) {
            QTest::newRow(name) << int(coding) << fragments << hasTable << besides;
        };
        add("RLE", EXS_RLELossless, 1, false);
        add("RLE with a table", EXS_RLELossless, 1, true);
        add("RLE in pieces", EXS_RLELossless, 3, true);
        add("RLE with a wrong table", EXS_RLELossless, 1, true, 2);
        add("JPEG lossless", EXS_JPEGProcess14SV1, 1, false);
        add("JPEG lossless in pieces", EXS_JPEGProcess14SV1, 4, false);
        add("JPEG lossless, any predictor", EXS_JPEGProcess14, 2, true);
        add("JPEG-LS", EXS_JPEGLSLossless, 1, true);
        add("JPEG-LS in pieces", EXS_JPEGLSLossless, 2, false);
        add("JPEG-LS in pieces, with a wrong table", EXS_JPEGLSLossless, 2, true, 2);
    }
    void everyCodingIsRead() {
        QFETCH(int, coding);
        QFETCH(int, fragments);
        QFETCH(bool, hasTable);
        QFETCH(int, besides);
        const test::EnhancedFile file = thorax(4);
        std::vector<std::string> streams;
        for (const test::EnhancedFrame& frame : file.frames)
            streams.push_back(test::streamOf(scratch(), kSize, frame.raw, E_TransferSyntax(coding)));
        test::writeCodedEnhancedFile(this->file(), file, streams, E_TransferSyntax(coding),
                                     {fragments, hasTable, std::size_t(besides)});
        verifyIsRead(file);
    }

    /// The basic table stays empty then (PS3.5, A.4), and each frame is one fragment.
    void extendedOffsetTablesAreRead() {
        const test::EnhancedFile file = thorax(4);
        for (const E_TransferSyntax coding : {EXS_RLELossless, EXS_JPEGProcess14SV1}) {
            std::vector<std::string> streams;
            for (const test::EnhancedFrame& frame : file.frames)
                streams.push_back(test::streamOf(scratch(), kSize, frame.raw, coding));
            test::writeCodedEnhancedFile(this->file(), file, streams, coding, {.hasExtendedTable = true});
            verifyIsRead(file);
        }
    }

    void whatCodingLosesIsThatOfEachFrameAlone_data() {
        QTest::addColumn<int>("coding");
        QTest::addColumn<int>("bits");
        QTest::addColumn<int>("most");
        QTest::newRow("JPEG baseline") << int(EXS_JPEGProcess1) << 8 << 20;
        QTest::newRow("JPEG extended, 8 bits") << int(EXS_JPEGProcess2_4) << 8 << 20;
        QTest::newRow("JPEG extended, 12 bits") << int(EXS_JPEGProcess2_4) << 12 << 60;
        QTest::newRow("JPEG-LS near-lossless") << int(EXS_JPEGLSLossy) << 12 << 2;
    }
    void whatCodingLosesIsThatOfEachFrameAlone() {
        QFETCH(int, coding);
        QFETCH(int, bits);
        QFETCH(int, most);
        test::EnhancedFile file = thorax(3);
        std::vector<std::string> streams;
        std::vector<std::vector<int>> alone;
        for (test::EnhancedFrame& frame : file.frames) {
            for (std::uint16_t& raw : frame.raw)
                raw = std::uint16_t(raw >> (12 - bits));
            streams.push_back(test::streamOf(scratch(), kSize, frame.raw, E_TransferSyntax(coding), bits));
            const auto decoded = decodeSlice(NamedBytes{scratch()}, Padding::keep);
            QVERIFY2(bool(decoded), decoded ? "" : decoded.error().text().c_str());
            alone.emplace_back(decoded->hu.begin(), decoded->hu.end());
        }
        if (bits == 8)
            file.change = [](DcmDataset& data) { test::putEightBits(data, {}); };
        test::writeCodedEnhancedFile(this->file(), file, streams, E_TransferSyntax(coding), {2, true});
        const Series series = scanned().series.at(0);
        QVERIFY(std::ranges::count(series.verdict.notes, "lossy", &Note::code) == 1);
        const auto volume = loadSeries(series, Padding::keep, noProgress);
        QVERIFY2(bool(volume), volume ? "" : volume.error().text().c_str());
        int largest = 0;
        for (int k = 0; k < 3; ++k) {
            const test::EnhancedFrame& frame = file.frames[std::size_t(2 - k)];
            const std::vector<int> seen = sliceOf(*volume, k), truth = huOf(frame);
            for (std::size_t i = 0; i < seen.size(); ++i) {
                QCOMPARE(seen[i], alone[std::size_t(2 - k)][i] + int(frame.intercept));
                largest = std::max(largest, std::abs(seen[i] - truth[i]));
            }
        }
        QVERIFY2(largest > 0 && largest <= most, qPrintable(QString::number(largest)));
    }

    /// RLE has no marker: without a table, nobody knows which fragment belongs to which frame.
    void fragmentsThatNothingAssignsAreRefused() {
        const test::EnhancedFile file = thorax(3);
        std::vector<std::string> streams;
        for (const test::EnhancedFrame& frame : file.frames)
            streams.push_back(test::streamOf(scratch(), kSize, frame.raw, EXS_RLELossless));
        test::writeCodedEnhancedFile(this->file(), file, streams, EXS_RLELossless, {2, false});
        const ScanResult scan = scanned();
        QVERIFY(scan.series.front().verdict.loadable());
        const auto volume = loadSeries(scan.series.front(), Padding::keep, noProgress);
        QVERIFY(!volume &&
                volume.error().text().find("where each of its 3 compressed frames begins") != std::string::npos);
    }

    /// A frame of one file is no copy of another, although both lie in files with the same bytes.
    void framesAreComparedNotFiles() {
        test::EnhancedFile file = thorax(3);
        file.frames[2].position = file.frames[1].position;
        test::writeEnhancedFile(this->file(), file);
        QCOMPARE(int(scanned().series.at(0).verdict.stack), int(Stack::doubled));
        QVERIFY(scanned().series[0].verdict.reason.find("thorax #") != std::string::npos);
        file.frames[2] = file.frames[1];
        test::writeEnhancedFile(this->file(), file);
        const Series copied = scanned().series.at(0);
        QCOMPARE(copied.verdict.notes.at(0).code, std::string("copies"));
        QCOMPARE(copied.slices.size(), std::size_t(2));
    }

    void aCopyOfTheFileIsLeftOut() {
        const test::EnhancedFile file = thorax(4);
        test::writeEnhancedFile(this->file(), file);
        std::filesystem::copy_file(this->file(), folder() / "copy");
        QVERIFY(scanned().series.at(0).verdict.notes.at(0).text.find("4 copies") != std::string::npos);
        verifyIsRead(file);
    }

    void anImageInSeveralFilesIsWholeOrNamesWhatIsMissing() {
        const test::EnhancedFile whole = thorax(6);
        const auto write = [&](int part) {
            test::EnhancedFile piece{.size = kSize};
            piece.frames.assign(whole.frames.begin() + 2 * (part - 1), whole.frames.begin() + 2 * part);
            piece.change = [part](DcmDataset& data) {
                data.putAndInsertString(DCM_ConcatenationUID, "1.2.3.4");
                data.putAndInsertUint16(DCM_InConcatenationNumber, Uint16(part));
                data.putAndInsertUint16(DCM_InConcatenationTotalNumber, 3);
            };
            test::writeEnhancedFile(folder() / ("z" + std::to_string(9 - part)), piece);
        };
        write(1);
        write(3);
        QVERIFY2(reasonOf(scanned()).find("part 2 of 3 is missing") != std::string::npos, reasonOf(scanned()).c_str());
        QVERIFY(!scanned().series.at(0).verdict.loadable());
        write(2);
        verifyIsRead(whole);
    }

    void whatCannotBeReadSaysWhy() {
        test::EnhancedFile file = thorax(3);
        file.change = [](DcmDataset& data) { data.putAndInsertString(DCM_NumberOfFrames, "2"); };
        test::writeEnhancedFile(this->file(), file);
        QCOMPARE(reasonOf(scanned()), std::string("it states 2 frames, and describes another number of them"));
        file.change = [](DcmDataset& data) { data.findAndDeleteElement(DCM_PerFrameFunctionalGroupsSequence); };
        test::writeEnhancedFile(this->file(), file);
        QCOMPARE(reasonOf(scanned()),
                 std::string("thorax: it holds 3 frames in one file, and does not say where they lie"));
        file.change = {};
        file.frames[1].change = [](DcmItem& own) { own.findAndDeleteElement(DCM_PlanePositionSequence); };
        test::writeEnhancedFile(this->file(), file);
        const std::string apart = scanned().series.at(1).verdict.reason;
        QVERIFY2(apart.find("thorax #2 does not say its position") != std::string::npos, apart.c_str());
    }

    void aFileThatChangedMeanwhileIsRefused() {
        test::EnhancedFile file = thorax(3);
        test::writeEnhancedFile(this->file(), file);
        const Series series = scanned().series.at(0);
        std::ranges::swap(file.frames[0].position, file.frames[2].position);
        test::writeEnhancedFile(this->file(), file);
        const auto volume = loadSeries(series, Padding::keep, noProgress);
        QVERIFY(!volume && volume.error().kind == ErrorKind::refused);
    }

    /// Any byte may be wrong: what is read has the size that the file states, or there is a reason.
    void damageHarmsNothing() {
        const test::EnhancedFile file = thorax(4);
        std::vector<std::string> streams;
        for (const test::EnhancedFrame& frame : file.frames)
            streams.push_back(test::streamOf(scratch(), kSize, frame.raw, EXS_JPEGProcess14SV1));
        test::writeCodedEnhancedFile(this->file(), file, streams, EXS_JPEGProcess14SV1, {2, true});
        const std::string sound = test::bytesOf(this->file());
        const std::size_t groups = sound.find(std::string("\x00\x52\x29\x92", 4));
        const test::StreamRange range = test::streamRange(sound);
        std::mt19937 random(7);
        int refused = 0;
        for (int trial = 0; trial < 250; ++trial) {
            std::string bytes = sound;
            // half of the damage in the groups, a half in the offset table and the heads of the fragments
            const std::size_t first = trial % 2 ? groups : range.first - 24;
            const std::size_t last = trial % 2 ? range.first : range.first + 16;
            for (unsigned n = 0; n < 1 + random() % 3; ++n)
                bytes[first + random() % (last - first)] = char(random());
            if (trial % 10 == 0)
                bytes.resize(groups + random() % (bytes.size() - groups));
            const auto source = std::make_shared<test::MemorySource>();
            source->add("thorax", {bytes.begin(), bytes.end()});
            const auto scan = scanSource(source, noProgress);
            bool isWhole = scan && !scan->series.empty() && scan->series[0].verdict.loadable();
            if (isWhole) {
                const auto volume = loadSeries(scan->series[0], Padding::keep, noProgress);
                isWhole = volume && volume->geometry().size == scan->series[0].geometry.size;
            }
            refused += !isWhole;
        }
        QVERIFY2(refused > 60 && refused < 240, qPrintable(QString::number(refused)));
    }
};

QTEST_APPLESS_MAIN(MultiFrameTest)
#include "multi_frame_test.moc"
