/// Slices in JPEG 2000: the numbers that were coded, or a sentence that says why not.

#include "tests/support/dicom/enhanced_file.h"
#include "tests/support/dicom/j2k_slice.h"

#include <QTemporaryDir>
#include <QTest>

#include "dicom/import.h"
#include "dicom/read/j2k_decoder.h"
#include "render/base/progress.h"

using namespace pdr;
using namespace pdr::dicom;

namespace {

constexpr const char* kLossless = "1.2.840.10008.1.2.4.90";
constexpr const char* kEither = "1.2.840.10008.1.2.4.91";
constexpr const char* kHighThroughput = "1.2.840.10008.1.2.4.201";
constexpr ivec2 kSize{96, 80};

/// Returns the numbers of a slice of tissue less `shift`.
std::vector<int> tissue(int shift, unsigned seed = 1) {
    const test::SliceFile slice = test::tissueSlice(kSize, seed);
    std::vector<int> values(slice.raw.begin(), slice.raw.end());
    for (int& value : values)
        value -= shift;
    return values;
}

std::vector<int> asInts(const std::vector<std::int16_t>& hu) {
    return {hu.begin(), hu.end()};
}

/// Returns where the first tile part begins.
std::size_t tilePartOf(const std::vector<std::uint8_t>& stream) {
    for (std::size_t at = 0; at + 1 < stream.size(); ++at)
        if (stream[at] == 0xFF && stream[at + 1] == 0x90)
            return at;
    qFatal("the stream has no tile part");
}

/// Returns where the content of the segment of `marker` begins in the main header.
std::size_t segmentOf(const std::vector<std::uint8_t>& stream, std::uint8_t marker) {
    for (std::size_t at = 2; at + 4 < stream.size(); at += 2 + std::size_t(stream[at + 2] << 8 | stream[at + 3]))
        if (stream[at + 1] == marker)
            return at + 4;
    qFatal("the stream has no such segment");
}

}  // namespace

class Jpeg2000Test : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::filesystem::path file_;

    test::SliceFile header() const { return {.size = kSize, .isSigned = true, .bitsStored = 16}; }
    Result<DecodedSlice> decoded(const std::vector<std::uint8_t>& stream, const test::SliceFile& slice,
                                 const char* uid = kLossless) const {
        test::writeJ2kSlice(file_, slice, stream, uid);
        return decodeSlice({file_}, Padding::keep);
    }
    QString refusal(const std::vector<std::uint8_t>& stream) const {
        const auto slice = decoded(stream, header());
        return slice ? QString("it loads") : QString::fromStdString(slice.error().text());
    }

  private slots:
    void initTestCase() { file_ = std::filesystem::path(folder_.path().toStdString()) / "slice"; }

    void losslessIsExact() {
        const std::vector<int> values = tissue(1024), unsignedValues = tissue(0);
        const auto signedSlice = decoded(test::j2kStream(kSize, values, {}), header());
        QVERIFY2(bool(signedSlice), signedSlice ? "" : signedSlice.error().text().c_str());
        QCOMPARE(asInts(signedSlice->hu), values);
        QVERIFY(!signedSlice->hasLost && !signedSlice->isMended);
        test::SliceFile twelve = header();
        twelve.isSigned = false;
        twelve.bitsStored = 12;
        for (const int precision : {12, 16}) {  // many writers code all that is allocated
            const auto slice = decoded(test::j2kStream(kSize, unsignedValues, {precision, false}), twelve);
            QVERIFY2(bool(slice), slice ? "" : slice.error().text().c_str());
            QCOMPARE(asInts(slice->hu), unsignedValues);
        }
    }

    /// The bits of signed numbers may be coded as unsigned ones; samples that say that they are signed are.
    void theSignIsTheOneThatFits() {
        const std::vector<int> values = tissue(1024);
        std::vector<int> bits = values;
        for (int& value : bits)
            value &= 0xFFFF;
        const auto coded = decoded(test::j2kStream(kSize, bits, {16, false}), header());
        QVERIFY(coded);
        QCOMPARE(asInts(coded->hu), values);
        test::SliceFile wrong = header();
        wrong.isSigned = false;
        wrong.bitsStored = 12;
        const auto stated = decoded(test::j2kStream(kSize, values, {}), wrong);
        QVERIFY(stated);
        QCOMPARE(asInts(stated->hu), values);
    }

    void highThroughputIsRead() {
        // An even image has no coded blocks: what is left are the headers, which say how they would be coded.
        std::vector<std::uint8_t> stream = test::j2kStream(kSize, std::vector<int>(std::size_t(kSize.x * kSize.y)), {});
        stream[segmentOf(stream, 0x52) + 8] |= 0x40;
        stream[segmentOf(stream, 0x51)] |= 0x40;
        const std::vector<std::uint8_t> capabilities{0xFF, 0x50, 0, 8, 0, 2, 0, 0, 0, 0};
        stream.insert(stream.begin() + std::ptrdiff_t(segmentOf(stream, 0x52) - 4), capabilities.begin(),
                      capabilities.end());
        const auto slice = decoded(stream, header(), kHighThroughput);
        QVERIFY2(bool(slice), slice ? "" : slice.error().text().c_str());
        QVERIFY(std::ranges::all_of(slice->hu, [](int hu) { return hu == 0; }));
    }

    void lossIsSaid() {
        const std::vector<int> values = tissue(1024);
        const auto lossy = decoded(test::j2kStream(kSize, values, {16, true, 8}), header(), kEither);
        QVERIFY2(bool(lossy), lossy ? "" : lossy.error().text().c_str());
        QVERIFY(lossy->hasLost && asInts(lossy->hu) != values);
        double squares = 0;
        for (std::size_t n = 0; n < values.size(); ++n)
            squares += std::pow(lossy->hu[n] - values[n], 2);
        QVERIFY(std::sqrt(squares / double(values.size())) < 40);
        test::SliceFile honest = header();
        honest.change = [](DcmDataset& data) { data.putAndInsertString(DCM_LossyImageCompression, "01"); };
        QVERIFY(!decoded(test::j2kStream(kSize, values, {16, true, 8}), honest, kEither)->hasLost);  // noted already
    }

    /// Frames of a multi-frame image, in fragments that only their markers assign.
    void framesAreRead() {
        test::EnhancedFile image{.size = kSize};
        std::vector<std::string> streams;
        for (int k = 0; k < 3; ++k) {
            test::EnhancedFrame frame{.position = {0, 0, 2.0 * k}};
            frame.raw = test::tissueSlice(kSize, unsigned(k) + 1).raw;
            image.frames.push_back(frame);
            const std::vector<std::uint8_t> stream = test::j2kStream(kSize, tissue(0, unsigned(k) + 1), {12, false});
            streams.emplace_back(stream.begin(), stream.end());
        }
        const auto folder = file_.parent_path() / "frames";
        std::filesystem::create_directory(folder);
        test::writeCodedEnhancedFile(folder / "all", image, streams, EXS_JPEG2000LosslessOnly, {2, false});
        const auto scan = scanFolder(folder, noProgress);
        QVERIFY(scan && scan->series.size() == 1 && scan->series[0].verdict.loadable());
        const auto volume = loadSeries(scan->series[0], Padding::keep, noProgress);
        QVERIFY2(bool(volume), volume ? "" : volume.error().text().c_str());
        for (int k = 0; k < 3; ++k) {
            const std::vector<int> expected = tissue(1024, unsigned(k) + 1);
            const auto first = volume->voxels().begin() + std::ptrdiff_t(std::size_t(k) * expected.size());
            QCOMPARE(std::vector<int>(first, first + std::ptrdiff_t(expected.size())), expected);
        }
    }

    void notesSayWhatIsKnown() {
        const auto folder = file_.parent_path() / "series";
        std::filesystem::create_directory(folder);
        for (int k = 0; k < 3; ++k) {
            test::SliceFile slice = header();
            slice.position = {0, 0, 2.0 * k};
            if (k == 0)
                slice.change = [](DcmDataset& data) { data.putAndInsertString(DCM_LossyImageCompression, "00"); };
            std::vector<std::uint8_t> stream =
                test::j2kStream(kSize, tissue(1024, unsigned(k)), {16, true, k == 2 ? 8.0 : 0});
            if (k == 0)
                stream[tilePartOf(stream) + 8] ^= 0x20;  // 8,192 bytes too many
            test::writeJ2kSlice(folder / std::to_string(k), slice, stream, kEither);
        }
        const auto scan = scanFolder(folder, noProgress);
        QVERIFY(scan && scan->series.size() == 1 && scan->series[0].verdict.loadable());
        std::vector<Note> notes = scan->series[0].verdict.notes;
        const auto volume = loadSeries(scan->series[0], Padding::keep, noProgress, &notes);
        QVERIFY2(bool(volume), volume ? "" : volume.error().text().c_str());
        const auto says = [&](const char* text) {
            return std::ranges::any_of(notes, [&](const Note& note) { return std::string(note.text) == text; });
        };
        QVERIFY(
            says("2 slices may have been compressed with loss: their coding allows that, and their files do not "
                 "say"));
        QVERIFY(
            says("1 slice was compressed with loss, which its file does not say: the values are not those that were "
                 "measured"));
        QVERIFY(says("1 slice states a wrong length in its coding; it is complete, and was read to its end"));
        QCOMPARE(volume->remarks(), std::string("lossy maybe-lossy mended"));
    }

    /// Complete, but for a length beyond its end and padding behind it.
    void aLengthBeyondTheEndIsMended() {
        const std::vector<int> values = tissue(1024);
        std::vector<std::uint8_t> stream = test::j2kStream(kSize, values, {});
        stream[tilePartOf(stream) + 8] ^= 0x20;
        for (int zeros = 0; zeros < 3; ++zeros) {
            const auto slice = decoded(stream, header());
            QVERIFY2(bool(slice), slice ? "" : slice.error().text().c_str());
            QCOMPARE(asInts(slice->hu), values);
            QVERIFY(slice->isMended);
            stream.push_back(0);
        }
    }

    /// Some writers leave the boxes of a .jp2 file around the codestream.
    void boxesAroundItAreLeftOut() {
        std::vector<std::uint8_t> stream = test::j2kStream(kSize, tissue(1024), {});
        const std::vector<std::uint8_t> boxes{0, 0, 0, 12, 'j', 'P', ' ', ' ', 13, 10, 135, 10, 0, 0, 0, 0};
        stream.insert(stream.begin(), boxes.begin(), boxes.end());
        QCOMPARE(asInts(decoded(stream, header())->hu), tissue(1024));
    }

    void whatIsCutOffIsRefused() {
        const std::vector<std::uint8_t> whole = test::j2kStream(kSize, tissue(1024), {});
        for (std::size_t n = 0; n < 60; ++n) {
            std::vector<std::uint8_t> cut(whole.begin(), whole.begin() + std::ptrdiff_t(whole.size() * n / 60));
            if (cut.empty())
                cut.push_back(0xFF);
            QVERIFY2(!decodeJ2k(cut, kSize).stream.damage.empty(), qPrintable(QString::number(n)));
        }
    }

    void whatNoSliceIsIsRefusedUndecoded() {
        const std::vector<std::uint8_t> sound = test::j2kStream(kSize, tissue(1024), {});
        const auto changed = [&](std::size_t at, std::initializer_list<std::uint8_t> bytes) {
            std::vector<std::uint8_t> stream = sound;
            std::copy(bytes.begin(), bytes.end(), stream.begin() + std::ptrdiff_t(at));
            return stream;
        };
        const std::size_t size = segmentOf(sound, 0x51), coding = segmentOf(sound, 0x52);
        QVERIFY(refusal(changed(size + 2, {0, 0, 0, 97})).contains("not of the size"));
        QVERIFY(refusal(changed(size + 2, {0x7F, 0xFF, 0xFF, 0xFF})).contains("header is broken"));
        QVERIFY(refusal(changed(size + 18, {0, 0, 0, 1, 0, 0, 0, 1})).contains("more than 4096 blocks"));
        QVERIFY(refusal(changed(size + 18, {0, 0, 0, 0})).contains("header is broken"));
        QVERIFY(refusal(changed(size + 34, {0, 3})).contains("no grey image"));
        QVERIFY(refusal(changed(size + 36, {31})).contains("no grey image"));
        QVERIFY(refusal(changed(coding + 5, {33})).contains("header is broken"));
        QVERIFY(refusal(changed(coding + 6, {9})).contains("header is broken"));
        QVERIFY(refusal(changed(0, {0xFF, 0xD8})).contains("no JPEG 2000 codestream"));
    }

    /// A pixel for each precinct of 8192 x 8192 takes 20 GB.
    void precinctsAreCounted() {
        std::vector<std::uint8_t> stream = test::j2kStream(kSize, tissue(1024), {});
        const std::size_t size = segmentOf(stream, 0x51);
        for (const std::size_t axis : {2, 6, 18, 22})
            stream[size + axis + 2] = 0x20;
        QVERIFY(readJ2k(stream).damage.empty());
        QCOMPARE(readJ2k(stream).size.x, 0x2000 + kSize.x);
        const std::size_t coding = segmentOf(stream, 0x52);
        const auto levels = std::size_t(stream[coding + 5]);
        stream[coding] |= 1;
        stream[coding - 1] += std::uint8_t(levels + 1);
        stream.insert(stream.begin() + std::ptrdiff_t(coding) + 10, levels + 1, std::uint8_t(0));
        QCOMPARE(std::string(readJ2k(stream).damage), std::string("it is divided into more than 1048576 blocks"));
    }

    /// Any byte of the headers may be wrong: no crash, and no more memory than the slice takes.
    void damagedHeadersHarmNothing() {
        const std::vector<std::uint8_t> sound = test::j2kStream(kSize, tissue(1024), {});
        const std::size_t headers = tilePartOf(sound) + 14;
        std::mt19937 random(5);
        int refused = 0;
        for (int trial = 0; trial < 600; ++trial) {
            std::vector<std::uint8_t> stream = sound;
            for (unsigned n = 0; n < 1 + random() % 3; ++n)
                stream[random() % headers] = std::uint8_t(random());
            const J2kImage image = decodeJ2k(stream, kSize);
            QVERIFY(image.words.empty() != image.stream.damage.empty());
            refused += image.words.empty();
        }
        QVERIFY2(refused > 300, qPrintable(QString::number(refused)));
    }
};

QTEST_APPLESS_MAIN(Jpeg2000Test)
#include "jpeg2000_test.moc"
