#include <QTest>

#include <dlfcn.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <fstream>

#include "dicom/import.h"
#include "tests/support/dicom/slice_folder.h"

using namespace pdr;
using namespace pdr::dicom;

namespace {

/// Puts another file in the place of `path` just before it is opened for the n-th time, whoever opens it.
struct Exchange {
    std::filesystem::path path, other;
    std::atomic<int> openings = 0;  ///< number of openings until the exchange

    void opening(const char* opened) {
        if (path == opened && --openings == 0)
            std::filesystem::rename(other, path);
    }
};
Exchange* underWay = nullptr;

FILE* openAs(const char* function, const char* path, const char* mode) {
    if (underWay)
        underWay->opening(path);
    using Open = FILE* (*)(const char*, const char*);
    return reinterpret_cast<Open>(::dlsym(RTLD_NEXT, function))(path, mode);
}

}  // namespace

// Every opening of a file by a library of this program goes through these.
extern "C" {
FILE* openedHere(const char* path, const char* mode) __asm__("fopen");
FILE* openedHere(const char* path, const char* mode) {
    return openAs("fopen", path, mode);
}
FILE* openedHere64(const char* path, const char* mode) __asm__("fopen64");
FILE* openedHere64(const char* path, const char* mode) {
    return openAs("fopen64", path, mode);
}
}

/// Loading of a scanned series where something goes wrong after the scan.
class LoadTest : public QObject {
    Q_OBJECT

    /// Returns the error of loading a stack whose slice s01 is written anew, changed by `change`, after the scan.
    static Error afterTheScan(const std::function<void(test::SliceFile&)>& change) {
        const test::SliceFolder folder;
        const auto named = [](DcmDataset& data) {
            data.putAndInsertString(DCM_SOPInstanceUID, "1.2.3.4");
            data.putAndInsertString(DCM_FrameOfReferenceUID, "1.2.3.8");
            data.putAndInsertString(DCM_PatientName, "First^Patient");
        };
        test::SliceFile slice{.change = named};
        folder.addStack(3, slice);
        const ScanResult scan = folder.scan();
        slice.position = {0, 0, 2};
        change(slice);
        test::writeSliceFile(folder.path() / "s01", slice);
        const auto volume = loadSeries(scan.series.at(0), Padding::maskAsAir, noProgress);
        return volume ? Error{} : volume.error();
    }
    static test::SliceFile& with(test::SliceFile& slice, const DcmTagKey& tag, const char* value) {
        slice.change = [before = slice.change, tag, value](DcmDataset& data) {
            before(data);
            data.putAndInsertString(tag, value);
        };
        return slice;
    }

  private slots:
    void fileThatStaysTheSameLoads() {
        QCOMPARE(afterTheScan([](test::SliceFile&) {}).what, std::string());
    }

    /// Minutes may pass between a scan and the choice of a series, and folders of exports are overwritten.
    void anotherImageUnderTheSameNameIsRefused_data() {
        QTest::addColumn<std::function<void(test::SliceFile&)>>("change");
        const auto row = [](const char* name, const std::function<void(test::SliceFile&)>& change) {
            QTest::newRow(name) << change;
        };
        row("image", [](auto& slice) { with(slice, DCM_SOPInstanceUID, "1.2.3.5"); });
        row("class", [](auto& slice) { with(slice, DCM_SOPClassUID, UID_SecondaryCaptureImageStorage); });
        row("frame of reference", [](auto& slice) { with(slice, DCM_FrameOfReferenceUID, "1.2.3.9"); });
        row("series", [](auto& slice) { slice.seriesUid = "1.2.3.2"; });
        row("study", [](auto& slice) { with(slice, DCM_StudyInstanceUID, "1.2.4"); });
        row("patient's name", [](auto& slice) { with(slice, DCM_PatientName, "Second^Patient"); });
        row("patient's id", [](auto& slice) { with(slice, DCM_PatientID, "2"); });
        row("position", [](auto& slice) { slice.position = {0, 0, 4}; });
        row("orientation", [](auto& slice) { with(slice, DCM_ImageOrientationPatient, "1\\0\\0\\0\\-1\\0"); });
        row("spacing", [](auto& slice) { with(slice, DCM_PixelSpacing, "2\\2"); });
        row("size", [](auto& slice) { slice.size = {3, 4}; });
    }
    void anotherImageUnderTheSameNameIsRefused() {
        QFETCH(std::function<void(test::SliceFile&)>, change);
        const Error error = afterTheScan(change);
        QCOMPARE(error.what, std::string("the file has changed since the folder was scanned"));
        QVERIFY2(error.where.ends_with("/s01"), error.where.c_str());
        QVERIFY(error.hint.starts_with("Open the folder again"));
        QCOMPARE(error.kind, ErrorKind::refused);
    }

    /// A slice is opened several times: its header and its pixels must not be of two files.
    void fileExchangedWhileItIsReadIsRefused_data() {
        QTest::addColumn<int>("opening");
        for (int opening = 1; opening <= 6; ++opening)
            QTest::addRow("before opening %d", opening) << opening;
    }
    void fileExchangedWhileItIsReadIsRefused() {
        QFETCH(int, opening);
        const test::SliceFolder folder, others;
        const auto withPixels = [](int first) {
            test::SliceFile slice{.size = {64, 64}};
            slice.raw.assign(64 * 64, std::uint16_t(first));
            return slice;
        };
        folder.addStack(3, withPixels(100));
        others.addStack(3, withPixels(900));
        const ScanResult scan = folder.scan();
        Exchange exchange{folder.path() / "s01", others.path() / "s01", opening};
        underWay = &exchange;
        const auto volume = loadSeries(scan.series.at(0), Padding::maskAsAir, noProgress);
        underWay = nullptr;
        QVERIFY2(opening > 1 || exchange.openings <= 0, "no opening was seen");
        if (exchange.openings > 0) {
            QVERIFY(bool(volume));
        } else {
            QVERIFY2(!volume, "another file's pixels, or header, passed");
            QCOMPARE(volume.error().what, std::string("the file has changed since the folder was scanned"));
        }
    }

    void exchangedSlicesAreRefused() {
        const test::SliceFolder folder;
        folder.addStack(3);
        const ScanResult scan = folder.scan();
        std::filesystem::rename(folder.path() / "s01", folder.path() / "other");
        std::filesystem::rename(folder.path() / "s02", folder.path() / "s01");
        std::filesystem::rename(folder.path() / "other", folder.path() / "s02");
        QVERIFY(!loadSeries(scan.series.at(0), Padding::maskAsAir, noProgress));
    }

    void whatIsNoFileAnyMoreIsNotWaitedFor() {
        const test::SliceFolder folder;
        folder.addStack(3);
        const ScanResult scan = folder.scan();
        std::filesystem::remove(folder.path() / "s01");
        QCOMPARE(::mkfifo((folder.path() / "s01").c_str(), 0600), 0);
        const auto refused = loadSeries(scan.series.at(0), Padding::maskAsAir, noProgress);
        QVERIFY(!refused);
        QCOMPARE(refused.error().what, std::string("this is no plain file"));
    }

    /// A slice that the system does not let the program read is not damaged.
    void theSystemsReasonIsGiven() {
        const test::SliceFolder folder;
        folder.addStack(3);
        const ScanResult scan = folder.scan();
        rlimit before{};
        ::getrlimit(RLIMIT_NOFILE, &before);
        const rlimit none{3, before.rlim_max};
        ::setrlimit(RLIMIT_NOFILE, &none);
        const auto refused = loadSeries(scan.series.at(0), Padding::maskAsAir, noProgress);
        ::setrlimit(RLIMIT_NOFILE, &before);
        QVERIFY(!refused);
        QVERIFY2(refused.error().what == "the file cannot be read (Too many open files)",
                 refused.error().text().c_str());
        QVERIFY(refused.error().hint.find("ulimit") != std::string::npos);
    }

    /// The memory limit of this program counts, however much memory the system has left.
    void limitOfTheProgramCountsForAVolume() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("sanitizers take the address space");
#endif
        const test::SliceFolder folder;
        folder.addStack(12, {.size = {1024, 1024}});
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(1));
        rlimit before{};
        ::getrlimit(RLIMIT_AS, &before);
        std::uint64_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const std::uint64_t left = 20'000'000;  // the volume takes 27 MB
        const rlimit tight{rlim_t(pages * std::uint64_t(::sysconf(_SC_PAGESIZE)) + left), before.rlim_max};
        ::setrlimit(RLIMIT_AS, &tight);
        const auto refused = loadSeries(scan.series[0], Padding::maskAsAir, noProgress);
        ::setrlimit(RLIMIT_AS, &before);
        QVERIFY(!refused);
        QCOMPARE(refused.error().kind, ErrorKind::memory);
        QVERIFY2(refused.error().what.find("needs 26.7 MB of memory, and 1") != std::string::npos ||
                     refused.error().what.find("needs 26.7 MB of memory, and 20.0") != std::string::npos,
                 refused.error().what.c_str());
        QVERIFY(bool(loadSeries(scan.series[0], Padding::maskAsAir, noProgress)));
    }
};

QTEST_APPLESS_MAIN(LoadTest)
#include "load_test.moc"
