#include <zlib.h>

#include <QTest>

#include <random>

#include "dicom/import.h"
#include "tests/support/dicom/damaged_streams.h"
#include "tests/support/dicom/shared_data.h"
#include "tests/support/dicom/slice_folder.h"
#include "tests/support/dicom/zip_file.h"

using namespace pdr;
using namespace pdr::dicom;

namespace fs = std::filesystem;

namespace {

/// Returns the files of `folder` as members below `prefix`.
std::vector<test::ZipMember> membersOf(const fs::path& folder, const std::string& prefix = "study/") {
    std::vector<test::ZipMember> members;
    for (const auto& file : fs::directory_iterator(folder))
        members.push_back({prefix + file.path().filename().string(), test::bytesOf(file.path())});
    return members;
}

Result<ScanResult> scanArchive(const fs::path& archive, const Progress& progress) {
    const auto source = openArchive(archive);
    return source ? scanSource(*source, progress) : source.error();
}

Result<Volume> loaded(const Result<ScanResult>& scan) {
    return loadSeries(scan->series.at(0), Padding::maskAsAir, noProgress);
}

}  // namespace

/// What lies in a ZIP archive or is packed by gzip is what lies in the folder.
class ZipTest : public QObject {
    Q_OBJECT

    test::SliceFolder slices_, archives_;

    fs::path at(const std::string& name) const { return archives_.path() / name; }
    Result<ScanResult> scanOf(const std::vector<test::ZipMember>& members) const {
        return scanArchive(test::writeZip(at("a.zip"), members), noProgress);
    }
    /// Returns the reason why the only problem of a scan was left out.
    std::string leftOut(test::ZipMember member) const {
        auto members = membersOf(slices_.path());
        members.push_back(std::move(member));
        const auto scan = scanOf(members);
        return scan && scan->problems.size() == 1 && scan->series.size() == 1 ? std::string(scan->problems[0].reason)
                                                                              : "something else";
    }

  private slots:
    void initTestCase() { slices_.addStack(5, test::tissueSlice({24, 20}, 1)); }

    void anArchiveHoldsWhatItsFolderHolds() {
        const auto folder = scanFolder(slices_.path(), noProgress);
        const auto archive = scanOf(membersOf(slices_.path()));
        QVERIFY(bool(folder) && bool(archive));
        QCOMPARE(archive->series.size(), std::size_t(1));
        QCOMPARE(archive->filesSeen, 5);
        const auto a = loaded(folder), b = loaded(archive);
        QVERIFY(bool(a) && bool(b));
        QVERIFY(std::ranges::equal(a->voxels(), b->voxels()));
        QCOMPARE(a->geometry().patientFromIndex, b->geometry().patientFromIndex);
        for (const auto& slice : archive->series[0].slices)
            QVERIFY(slice.file.string().starts_with(at("a.zip/study/s0").string()));
    }

    /// The folders of a CD, with a directory of its files.
    void aCdIsReadAsItsFolders() {
        PDR_NEEDS_SHARED_CT();
        const fs::path cd = test::sharedCt() / "dicomdir_tree";
        std::vector<test::ZipMember> members;
        for (const auto& file : fs::recursive_directory_iterator(cd))
            if (file.is_regular_file())
                members.push_back({file.path().lexically_relative(cd).string(), test::bytesOf(file.path())});
        const auto folder = scanFolder(cd, noProgress), archive = scanOf(members);
        QVERIFY(bool(folder) && bool(archive));
        QCOMPARE(archive->filesSeen, folder->filesSeen);
        QCOMPARE(archive->series.size(), folder->series.size());
        for (std::size_t i = 0; i < folder->series.size(); ++i) {
            QCOMPARE(archive->series[i].series.id(), folder->series[i].series.id());
            QCOMPARE(archive->series[i].verdict.stack, folder->series[i].verdict.stack);
            QCOMPARE(archive->series[i].slices.size(), folder->series[i].slices.size());
        }
    }

    /// Nothing is written beside the archive, or elsewhere below its folder.
    void nothingIsUnpackedToTheDisk() {
        const test::SliceFolder alone;
        const auto scan = scanArchive(test::writeZip(alone.path() / "a.zip", membersOf(slices_.path())), noProgress);
        QVERIFY(bool(scan) && bool(loaded(scan)));
        QCOMPARE(std::distance(fs::recursive_directory_iterator(alone.path()), {}), std::ptrdiff_t(1));
    }

    void whatIsNoPlainFileIsLeftOutByName() {
        QCOMPARE(leftOut({"study/link", "/etc/passwd", true}), std::string("it is a link"));
        QCOMPARE(leftOut({"../outside", "x"}), std::string("its name leads out of the archive"));
        QCOMPARE(leftOut({"a\\..\\..\\outside", "x"}), std::string("its name leads out of the archive"));
        QCOMPARE(leftOut({"/etc/outside", "x"}), std::string("its name leads out of the archive"));
        QCOMPARE(leftOut({"more.zip", "PK"}), std::string("it is an archive within the archive"));
        QCOMPARE(leftOut({"more.tar.gz", "PK"}), std::string("it is an archive within the archive"));
    }

    void anEncryptedArchiveIsRefused() {
        auto members = membersOf(slices_.path());
        members[3].password = "secret";
        const auto refused = scanOf(members);
        QVERIFY(!refused);
        QCOMPARE(refused.error().what, std::string("the archive is encrypted"));
    }

    /// 300 MB of zeros are packed to a thousandth.
    void aBombIsRefusedBeforeItIsUnpacked() {
        const auto refused = scanOf({{"zeros", std::string(300'000'000, '\0')}});
        QVERIFY(!refused);
        QCOMPARE(refused.error().what,
                 std::string("the archive would unpack to 0.3 GB, which is more than 64 GB or 200 "
                             "times its size"));
    }

    void archivesThatAreNone() {
        test::writeBytes(at("text.zip"), "this is a text");
        test::writeBytes(at("empty.zip"), "");
        for (const char* name : {"text.zip", "empty.zip", "absent.zip"})
            QVERIFY(!scanArchive(at(name), noProgress));
        const auto none = scanOf({{"readme.txt", "a text"}});
        QVERIFY(!none);
        QCOMPARE(none.error().what, std::string("the only file is not a DICOM image"));
    }

    /// A wrong byte inside a packed slice is found by the checksum, and the slice is left out by name.
    void aDamagedEntryIsNamed() {
        const fs::path archive = test::writeZip(at("a.zip"), membersOf(slices_.path()));
        std::string bytes = test::bytesOf(archive);
        bytes[bytes.size() / 2] ^= 0x10;
        test::writeBytes(archive, bytes);
        const auto scan = scanArchive(archive, noProgress);
        QVERIFY(bool(scan));
        QCOMPARE(scan->problems.size(), std::size_t(1));
        QVERIFY(scan->problems[0].reason.starts_with("it cannot be unpacked"));
    }

    /// 200 seeded mutants and 60 truncations: read or refused, and never a volume of other voxels.
    void mutantsNeverGiveOtherVoxels() {
        const std::string whole = test::bytesOf(test::writeZip(at("a.zip"), membersOf(slices_.path())));
        const auto right = loaded(scanFolder(slices_.path(), noProgress));
        QVERIFY(bool(right));
        std::mt19937 random(20261126);
        for (int mutant = 0; mutant < 260; ++mutant) {
            std::string bytes = whole;
            if (mutant >= 200)
                bytes.resize(random() % bytes.size());
            else
                for (int change = 0; change <= mutant % 3; ++change)
                    bytes[mutant % 2 ? bytes.size() - 1 - random() % 500 : random() % bytes.size()] = char(random());
            test::writeBytes(at("mutant.zip"), bytes);
            const auto scan = scanArchive(at("mutant.zip"), noProgress);
            if (!scan || scan->series.empty() || !scan->series[0].verdict.loadable())
                continue;
            const auto volume = loaded(scan);
            if (volume && volume->size() == right->size())
                QVERIFY(std::ranges::equal(volume->voxels(), right->voxels()));
        }
    }

    /// Folders may hold files that gzip has packed one by one.
    void filesPackedByGzipAreRead() {
        const test::SliceFolder packed;
        for (const auto& file : fs::directory_iterator(slices_.path())) {
            const std::string bytes = test::bytesOf(file.path());
            const fs::path name = packed.path() / (file.path().filename().string() + ".dcm.gz");
            gzFile out = gzopen(name.c_str(), "wb");
            gzwrite(out, bytes.data(), unsigned(bytes.size()));
            gzclose(out);
        }
        const auto folder = scanFolder(slices_.path(), noProgress), gzip = scanFolder(packed.path(), noProgress);
        QVERIFY(bool(gzip));
        const auto a = loaded(folder), b = loaded(gzip);
        QVERIFY(bool(a) && bool(b));
        QVERIFY(std::ranges::equal(a->voxels(), b->voxels()));
        // Cut off, one is damaged; what is no DICOM is passed over
        const fs::path first = packed.path() / "s00.dcm.gz";
        fs::resize_file(first, fs::file_size(first) - 20);
        fs::create_directory(packed.path() / "beside");
        packed.addText("beside/notes.gz", "no gzip stream");
        const auto damaged = scanFolder(packed.path(), noProgress);
        QVERIFY(bool(damaged));
        QCOMPARE(damaged->problems.size(), std::size_t(1));
        QCOMPARE(damaged->problems[0].reason, std::string("the file ends too early"));
        QCOMPARE(damaged->notDicom, 1);
    }
};

QTEST_APPLESS_MAIN(ZipTest)
#include "zip_test.moc"
