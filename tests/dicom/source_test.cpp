#include <QTest>

#include "dicom/import.h"
#include "dicom/read/pixels.h"
#include "tests/support/dicom/damaged_streams.h"
#include "tests/support/dicom/memory_source.h"
#include "tests/support/dicom/shared_data.h"
#include "tests/support/dicom/slice_folder.h"

using namespace pdr;
using namespace pdr::dicom;

namespace fs = std::filesystem;

namespace {

/// Writes all that is known of a scan, with file names as seen from the root of its source.
std::string textOf(const ScanResult& scan, const fs::path& root) {
    std::string text = std::to_string(scan.filesSeen) + " seen, " + std::to_string(scan.notDicom) + " foreign\n";
    for (const Series& series : scan.series) {
        text += series.series.id() + " " + std::to_string(int(series.verdict.stack)) + " " + series.verdict.reason;
        for (const Note& note : series.verdict.notes)
            text += "\n  " + note.code + ": " + note.text;
        for (const SliceRef& slice : series.slices)
            text += "\n  " + slice.file.lexically_relative(root).string() + " " + slice.identity.sopInstanceUid;
        text += "\n";
    }
    for (const Problem& problem : scan.problems)
        text += problem.file.lexically_relative(root).string() + ": " + problem.reason + "\n";
    return text;
}

/// Returns whether both volumes are the same, or both failed: which of several damaged slices an error names is chance.
bool sameOutcome(const Result<Volume>& a, const Result<Volume>& b) {
    if (!a || !b)
        return !a && !b;
    return std::ranges::equal(a->voxels(), b->voxels()) && a->remarks() == b->remarks() &&
           a->paddingCount() == b->paddingCount() && a->geometry().patientFromIndex == b->geometry().patientFromIndex;
}

}  // namespace

/// The importer does not depend on the place of the bytes: what memory yields is what the same files yield.
class SourceTest : public QObject {
    Q_OBJECT

    /// Compares a folder with a copy of it in memory; `compared` counts the volumes.
    static void compare(const fs::path& folder, int& compared) {
        const auto fromFiles = scanFolder(folder, noProgress);
        const auto fromMemory = scanSource(test::inMemory(folder), noProgress);
        QCOMPARE(bool(fromMemory), bool(fromFiles));
        if (!fromFiles)
            return;
        QCOMPARE(textOf(*fromMemory, {}), textOf(*fromFiles, folder));
        for (std::size_t i = 0; i < fromFiles->series.size(); ++i) {
            const auto load = [&](const ScanResult& scan) {
                return loadSeries(scan.series[i], Padding::keep, noProgress);
            };
            const auto files = load(*fromFiles);
            const auto memory = load(*fromMemory);
            QVERIFY2(sameOutcome(memory, files), fromFiles->series[i].series.id().c_str());
            compared += bool(files);
        }
    }

  private slots:
    /// Slices beside a copy, a damaged one of an odd number of bytes, an empty one and a text.
    void aFolderWithDamageIsTheSameInMemory() {
        const test::SliceFolder folder;
        folder.addStack(5, {.size = {16, 16}});
        fs::copy_file(folder.path() / "s02", folder.path() / "s02 copy");
        const std::string whole = test::bytesOf(folder.path() / "s04");
        test::writeBytes(folder.path() / "s04", whole.substr(0, whole.size() - 101));
        folder.addText("s05", "");
        folder.addText("readme.txt", "a text");
        int compared = 0;
        compare(folder.path(), compared);
        QCOMPARE(compared, 1);
    }

    void allCodingsAreTheSameInMemory_data() {
        QTest::addColumn<int>("coding");
        for (const E_TransferSyntax coding :
             {EXS_LittleEndianImplicit, EXS_BigEndianExplicit, EXS_DeflatedLittleEndianExplicit, EXS_RLELossless,
              EXS_JPEGProcess14SV1, EXS_JPEGLSLossless, EXS_JPEGProcess2_4})
            QTest::newRow(DcmXfer(coding).getXferName()) << int(coding);
    }
    void allCodingsAreTheSameInMemory() {
        QFETCH(int, coding);
        const test::SliceFolder folder;
        for (int k = 0; k < 2; ++k) {
            test::SliceFile slice = test::tissueSlice({40, 40}, unsigned(k));
            slice.position = {0, 0, 2.0 * k};
            const fs::path file = folder.path() / std::to_string(k);
            QVERIFY(test::writeCompressedSlice(file, slice, E_TransferSyntax(coding)));
        }
        int compared = 0;
        compare(folder.path(), compared);
        QCOMPARE(compared, 1);
    }

    /// Files of old archives begin with their data set.
    void dataSetsWithoutMetaHeaderAreTheSameInMemory() {
        const test::SliceFolder folder;
        folder.addStack(3);
        for (const char* name : {"s00", "s01", "s02"}) {
            DcmFileFormat content;
            QVERIFY(content.loadFile((folder.path() / name).c_str()).good());
            QVERIFY(content.getDataset()->saveFile((folder.path() / name).c_str(), EXS_LittleEndianImplicit).good());
        }
        int compared = 0;
        compare(folder.path(), compared);
        QCOMPARE(compared, 1);
    }

    void realSeriesAreTheSameInMemory() {
        PDR_NEEDS_SHARED_CT();
        int compared = 0;
        for (const auto& folder : fs::directory_iterator(test::sharedCt())) {
            compare(folder.path(), compared);
            if (QTest::currentTestFailed())
                return;
        }
        QVERIFY2(compared >= 35, std::to_string(compared).c_str());
    }

    void anObjectThatIsGoneIsNamed() {
        const test::SliceFolder folder;
        folder.addStack(3);
        const auto source = test::inMemory(folder.path());
        const auto scan = scanSource(source, noProgress);
        QVERIFY(bool(scan));
        source->remove("s01");
        const auto refused = loadSeries(scan->series.at(0), Padding::maskAsAir, noProgress);
        QVERIFY(!refused);
        QCOMPARE(refused.error().what, std::string("it is gone"));
        QCOMPARE(refused.error().where, std::string("s01"));
    }

    /// An archive may hold another image under the same name by the time its pixels are read.
    void anotherObjectUnderTheSameNameIsRefused() {
        const test::SliceFolder folder, others;
        folder.addStack(3);
        others.addStack(3);
        const auto source = test::inMemory(folder.path());
        const auto scan = scanSource(source, noProgress);
        QVERIFY(bool(scan));
        const std::string bytes = test::bytesOf(others.path() / "s01");
        source->add("s01", {bytes.begin(), bytes.end()});
        const auto refused = loadSeries(scan->series.at(0), Padding::maskAsAir, noProgress);
        QVERIFY(!refused);
        QCOMPARE(refused.error().kind, ErrorKind::refused);
        QCOMPARE(refused.error().where, std::string("s01"));
    }

    /// A scan of objects in memory never looks at files of the same names.
    void filesOfTheSameNameAreNotLookedAt() {
        const test::SliceFolder folder;
        folder.addStack(3);
        const auto source = std::make_shared<test::MemorySource>();
        for (const char* name : {"s00", "s01", "s02"}) {
            const std::string bytes = test::bytesOf(folder.path() / name);
            source->add(folder.path() / name, {bytes.begin(), bytes.end()});
            test::writeBytes(folder.path() / name, "something else");
        }
        const auto scan = scanSource(source, noProgress);
        QVERIFY(bool(scan));
        QVERIFY(bool(loadSeries(scan->series.at(0), Padding::maskAsAir, noProgress)));
    }

    void whatHoldsNoDicomIsRefused() {
        const auto source = std::make_shared<test::MemorySource>();
        source->add("readme.txt", {'a', 'b', 'c'});
        const auto refused = scanSource(source, noProgress);
        QVERIFY(!refused);
        QCOMPARE(refused.error().what, std::string("the only file is not a DICOM image"));
    }
};

QTEST_APPLESS_MAIN(SourceTest)
#include "source_test.moc"
