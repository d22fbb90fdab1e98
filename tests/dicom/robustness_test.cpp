#include <QTemporaryDir>
#include <QTest>

#include <zlib.h>

#include <cstring>
#include <fstream>
#include <random>

#include "dicom/import.h"
#include "dicom/read/file_structure.h"
#include "dicom/read/pixels.h"
#include "dicom/read/slice_header.h"
#include "tests/support/deflated.h"
#include "tests/support/dicom/shared_data.h"

using namespace pdr;
using namespace pdr::dicom;

namespace fs = std::filesystem;

namespace {

using Bytes = std::string;

void write(const fs::path& file, const Bytes& bytes) {
    std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

Bytes read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

Bytes little(std::uint32_t value, int count) {
    Bytes bytes;
    for (int i = 0; i < count; ++i)
        bytes += char(value >> 8 * i & 0xFF);
    return bytes;
}

Bytes tag(int group, int element) {
    return little(std::uint32_t(group), 2) + little(std::uint32_t(element), 2);
}

/// Preamble, and a meta header that names the transfer syntax.
Bytes headOf(Bytes transferSyntax) {
    if (transferSyntax.size() % 2)
        transferSyntax += '\0';
    Bytes head(128, '\0');
    for (const Bytes& part :
         {Bytes("DICM"), tag(2, 0x10), Bytes("UI"), little(std::uint32_t(transferSyntax.size()), 2), transferSyntax})
        head += part;
    return head;
}

const Bytes kImplicit = "1.2.840.10008.1.2", kExplicit = "1.2.840.10008.1.2.1", kDeflated = "1.2.840.10008.1.2.1.99";

/// Returns `depth` open-ended sequences within each other, followed by their ends.
Bytes nested(int depth, bool explicitVr) {
    Bytes open, close;
    for (int i = 0; i < depth; ++i) {
        open += tag(8, 0x1140) + (explicitVr ? Bytes("SQ\0\0", 4) : Bytes()) + little(0xFFFFFFFF, 4);
        open += tag(0xFFFE, 0xE000) + little(0xFFFFFFFF, 4);
        close += tag(0xFFFE, 0xE00D) + little(0, 4) + tag(0xFFFE, 0xE0DD) + little(0, 4);
    }
    return open + close;
}

/// Returns `depth` sequences within each other with stated lengths; the innermost is written first.
Bytes nestedWithLengths(int depth) {
    Bytes inner;
    for (int i = 0; i < depth; ++i) {
        inner = tag(0xFFFE, 0xE000) + little(std::uint32_t(inner.size()), 4) + inner;
        inner = tag(8, 0x1140) + little(std::uint32_t(inner.size()), 4) + inner;
    }
    return inner;
}

/// Returns the most address space or memory that this process has ever had [kB].
long peak(const char* field) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.rfind(field, 0) == 0)
            return std::atol(line.c_str() + std::strlen(field) + 1);
    }
    return 0;
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kAddressSpaceIsOurs = false;
#else
constexpr bool kAddressSpaceIsOurs = true;
#endif

/// Does everything that the import does with a file.
void use(const fs::path& file) {
    const HeaderRead header = readSliceHeader({file});
    if (header.kind == HeaderRead::Kind::damaged)
        QVERIFY(!header.damage.empty());
    const auto slice = decodeSlice({file}, Padding::maskAsAir);
    if (!slice)
        QVERIFY(!slice.error().what.empty());
}

}  // namespace

class RobustnessTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    fs::path file_;

    FileStructure structureOf(const Bytes& bytes) {
        write(file_, bytes);
        return checkStructure({file_});
    }

  private slots:
    void initTestCase() { file_ = fs::path(folder_.path().toStdString()) / "file"; }

    void nestingIsBounded_data() {
        QTest::addColumn<bool>("isExplicit");
        QTest::newRow("explicit") << true;
        QTest::newRow("implicit") << false;
    }
    void nestingIsBounded() {
        QFETCH(bool, isExplicit);
        const Bytes head = headOf(isExplicit ? kExplicit : kImplicit);
        QCOMPARE(structureOf(head + nested(64, isExplicit)).damage, Bytes());
        QVERIFY(structureOf(head + nested(65, isExplicit)).damage.find("nested") != Bytes::npos);
        QVERIFY(structureOf(head + nested(6000, isExplicit)).damage.find("nested") != Bytes::npos);
        use(file_);
    }

    void nestingWithStatedLengthsIsBounded() {
        QCOMPARE(structureOf(headOf(kImplicit) + nestedWithLengths(64)).damage, Bytes());
        QVERIFY(structureOf(headOf(kImplicit) + nestedWithLengths(6000)).damage.find("nested") != Bytes::npos);
        use(file_);
    }

    void nestingInsideUnknownElementsIsBounded() {
        const Bytes unknown = tag(9, 0x1010) + Bytes("UN\0\0", 4) + little(0xFFFFFFFF, 4) + tag(0xFFFE, 0xE000) +
                              little(0xFFFFFFFF, 4) + nested(6000, false);
        QVERIFY(structureOf(headOf(kExplicit) + unknown).damage.find("nested") != Bytes::npos);
        use(file_);
        const Bytes inner = nestedWithLengths(6000).substr(8);
        const Bytes known = tag(8, 0x1140) + Bytes("UN\0\0", 4) + little(std::uint32_t(inner.size()), 4) + inner;
        QVERIFY(structureOf(headOf(kExplicit) + known).damage.find("nested") != Bytes::npos);
        use(file_);
    }

    void nestingInsideDeflatedFilesIsBounded() {
        QCOMPARE(structureOf(headOf(kDeflated) + test::deflated(nested(64, true), test::kBareStream)).damage, Bytes());
        QVERIFY(structureOf(headOf(kDeflated) + test::deflated(nested(20000, true), test::kBareStream))
                    .damage.find("nested") != Bytes::npos);
        use(file_);
    }

    void deflateBombIsRefused() {
        const Bytes zeros(64 << 20, '\0');
        Bytes bomb;
        z_stream stream{};
        deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
        bomb.resize(4 << 20);
        stream.next_out = reinterpret_cast<Bytef*>(bomb.data());
        stream.avail_out = uInt(bomb.size());
        for (int i = 0; i < 5; ++i) {
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(zeros.data()));
            stream.avail_in = uInt(zeros.size());
            deflate(&stream, i < 4 ? Z_NO_FLUSH : Z_FINISH);
        }
        bomb.resize(stream.total_out);
        deflateEnd(&stream);
        QVERIFY(structureOf(headOf(kDeflated) + bomb).damage.find("deflated") != Bytes::npos);
    }

    void lengthsBeyondTheFileAreRefused() {
        const Bytes pixels = tag(0x7FE0, 0x10) + Bytes("OW\0\0", 4) + little(0xFFFFFFF0, 4) + Bytes(100, 'x');
        const FileStructure found = structureOf(headOf(kExplicit) + pixels);
        QVERIFY(found.damage.find("4294967280 bytes, but only 100") != Bytes::npos);
        QVERIFY(found.reachesPixels);
        use(file_);
        const Bytes name = tag(0x10, 0x10) + "PN" + little(60000, 2) + "short";
        QVERIFY(!structureOf(headOf(kExplicit) + name).damage.empty());
    }

    void compressedImageMustEnd() {
        const Bytes start =
            tag(0x7FE0, 0x10) + Bytes("OB\0\0", 4) + little(0xFFFFFFFF, 4) + tag(0xFFFE, 0xE000) + little(0, 4);
        const Bytes fragment = tag(0xFFFE, 0xE000) + little(4, 4) + "abcd";
        const Bytes end = tag(0xFFFE, 0xE0DD) + little(0, 4);
        const Bytes head = headOf("1.2.840.10008.1.2.4.70");
        QCOMPARE(structureOf(head + start + fragment + end).damage, Bytes());
        QVERIFY(structureOf(head + start + fragment).damage.find("ends inside") != Bytes::npos);
        QVERIFY(structureOf(head + start + "garbage in place of a fragment" + end).damage.find("fragments") !=
                Bytes::npos);
    }

    void imageThatClaimsToBeHugeIsNotDecoded_data() {
        QTest::addColumn<QString>("folder");
        for (const char* folder :
             {"JPEGProcess1", "JPEGProcess6_8", "JPEGProcess10_12", "JPEGProcess14SV1", "JPEGLSLossless"})
            QTest::newRow(folder) << folder;
    }
    void imageThatClaimsToBeHugeIsNotDecoded() {
        PDR_NEEDS_SHARED_CT();
        QFETCH(QString, folder);
        Bytes bytes = read(test::sharedCt() / "transfer_syntaxes" / folder.toStdString() / "CTImage.dcm");
        const Bytes size = Bytes("\x02\0\x02\0\x01", 5);  // 512 x 512, one component, as a frame header says it
        const std::size_t at = bytes.find(size);
        QVERIFY(at != Bytes::npos);
        bytes.replace(at, 4, "\xFF\xD0\xFF\xD0");
        write(file_, bytes);
        const auto slice = decodeSlice({file_}, Padding::keep);
        QVERIFY(!slice);
        QVERIFY2(slice.error().what.find("size") != Bytes::npos, slice.error().what.c_str());
    }

    void hostileNestingIsAProblemAndNothingDies() {
        PDR_NEEDS_SHARED_CT();
        const auto scan = scanFolder(test::sharedCt() / "hostile_nesting", noProgress);
        QVERIFY(bool(scan));
        QCOMPARE(scan->problems.size(), std::size_t(1));
        QVERIFY(scan->problems[0].reason.find("nested more than 64 deep") != Bytes::npos);
    }

    void malformedFilesNeitherCrashNorHang_data() {
        QTest::addColumn<QString>("folder");
        for (const char* folder : {"fuzz_pwnlab", "fuzz_zzuf", "broken_headers", "missing_tags", "truncated", "not_ct"})
            QTest::newRow(folder) << folder;
    }
    void malformedFilesNeitherCrashNorHang() {
        PDR_NEEDS_SHARED_CT();
        QFETCH(QString, folder);
        const fs::path place = test::sharedCt() / folder.toStdString();
        const auto scan = scanFolder(place, noProgress);
        QVERIFY(bool(scan));
        for (const Series& series : scan->series)
            QVERIFY(bool(loadSeries(series, Padding::keep, noProgress)) || !series.verdict.loadable());
        for (const Problem& problem : scan->problems)
            QVERIFY(!problem.file.empty() && !problem.reason.empty());
        for (const auto& entry : fs::recursive_directory_iterator(place)) {
            if (entry.is_regular_file())
                use(entry.path());
        }
    }

    void fileCutAnywhereIsNeverTakenForWhole() {
        PDR_NEEDS_SHARED_CT();
        const Bytes whole = read(test::sharedCt() / "tiny_ct" / "CT_small.dcm");
        write(file_, whole);
        QVERIFY(bool(decodeSlice({file_}, Padding::keep)));
        // The last 138 bytes are a padding element behind the pixels.
        for (std::size_t size = 0; size < whole.size() - 138; size += size < 6000 ? 13 : 1777) {
            write(file_, whole.substr(0, size));
            QVERIFY2(!decodeSlice({file_}, Padding::keep), std::to_string(size).c_str());
        }
    }

    void flippedBytesNeitherCrashNorHang_data() {
        QTest::addColumn<QString>("file");
        QTest::newRow("raw") << "tiny_ct/CT_small.dcm";
        QTest::newRow("deflated") << "transfer_syntaxes/DeflatedExplicitVRLittleEndian/CTImage.dcm";
        QTest::newRow("RLE") << "transfer_syntaxes/RLELossless/CTImage.dcm";
        QTest::newRow("JPEG lossless") << "transfer_syntaxes/JPEGProcess14SV1/CTImage.dcm";
        QTest::newRow("JPEG progressive") << "transfer_syntaxes/JPEGProcess10_12/CTImage.dcm";
        QTest::newRow("JPEG-LS") << "transfer_syntaxes/JPEGLSLossless/CTImage.dcm";
    }
    void flippedBytesNeitherCrashNorHang() {
        PDR_NEEDS_SHARED_CT();
        QFETCH(QString, file);
        const Bytes whole = read(test::sharedCt() / file.toStdString());
        std::mt19937 random(7);
        for (int trial = 0; trial < 150; ++trial) {
            Bytes altered = whole;
            for (int flip = 0; flip < 1 + trial % 8; ++flip) {
                // Half of them near the start, where the header and the tables of the codecs lie.
                const std::size_t range = trial % 2 ? whole.size() : std::min<std::size_t>(whole.size(), 5000);
                altered[random() % range] = char(random());
            }
            write(file_, altered);
            use(file_);
        }
    }

    void cleanupTestCase() {
        if (kAddressSpaceIsOurs)
            QVERIFY2(peak("VmPeak:") < 2L << 20, std::to_string(peak("VmPeak:")).c_str());
        QVERIFY(peak("VmHWM:") < 2L << 20);
    }
};

QTEST_APPLESS_MAIN(RobustnessTest)
#include "robustness_test.moc"
