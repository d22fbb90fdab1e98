#include <QTest>

#include <dlfcn.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <mutex>
#include <thread>

#include "dicom/import.h"
#include "tests/support/dicom/memory_source.h"
#include "tests/support/dicom/slice_folder.h"
#include "tests/support/patience.h"

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

/// Objects in memory that calls a function whenever one is opened.
class WatchedSource : public test::MemorySource {
  public:
    mutable std::function<void(const std::string&)> opening = [](const std::string&) {};

    Result<NamedBytes> open(const std::filesystem::path& name) const override {
        opening(name.string());
        return MemorySource::open(name);
    }
};

/// A scanned stack of `count` slices in memory; slice k holds the value k.
struct WatchedStack {
    explicit WatchedStack(int count, const std::function<void(test::SliceFile&)>& change = {}) {
        const test::SliceFolder folder;
        folder.addStack(count, {.size = {8, 8}}, "s", [&](int k, test::SliceFile& slice) {
            slice.raw.assign(64, std::uint16_t(k));
            if (change)
                change(slice);
        });
        const auto written = test::inMemory(folder.path());
        const auto listing = written->list(noProgress);
        for (const std::filesystem::path& name : listing->names)
            source->add(name, *written->open(name)->memory);
        series = scanSource(source, noProgress)->series.at(0);
    }

    std::shared_ptr<WatchedSource> source = std::make_shared<WatchedSource>();
    Series series;
};

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

    /// The last slice is held back until all others have arrived.
    void slicesCanBeLookedAtWhileOthersAreRead() {
        const WatchedStack stack(30);
        std::shared_ptr<const ArrivingVolume> arriving;
        std::vector<ArrivedSlices> seen;
        std::vector<std::int16_t> values;
        const std::int16_t* begin = nullptr;
        stack.source->opening = [&](const std::string& name) {
            if (name != "s00")
                return;
            for (int ms = 0; arriving->arrived() < 29 && ms < test::kPatience; ++ms)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            arriving->look([&](std::span<const ArrivedSlices> parts) {
                seen.assign(parts.begin(), parts.end());
                values.assign(parts[0].voxels.begin(), parts[0].voxels.end());
                begin = parts[0].voxels.data();
            });
        };
        const auto volume = loadSeries(stack.series, Padding::maskAsAir, noProgress, nullptr,
                                       [&](std::shared_ptr<const ArrivingVolume> taken) { arriving = taken; });
        QVERIFY(bool(volume));
        QCOMPARE(seen.size(), std::size_t(1));
        QCOMPARE(seen[0].first, 1);
        QCOMPARE(seen[0].geometry.size, ivec3(8, 8, 29));
        QCOMPARE(seen[0].geometry.patientFromIndex[3].z, 2.0);
        QVERIFY(std::ranges::equal(values, volume->voxels().subspan(64)));
        QCOMPARE(begin, &volume->voxels()[64]);  // they stay where they are
        QVERIFY(!arriving->look([](std::span<const ArrivedSlices>) {}));
    }

    /// Views begin with the middle slice.
    void theMiddleSliceIsReadFirst() {
        const WatchedStack stack(41);
        std::vector<std::string> order;
        std::mutex mutex;
        stack.source->opening = [&](const std::string& name) {
            const std::lock_guard lock(mutex);
            if (std::ranges::find(order, name) == order.end())
                order.push_back(name);
        };
        QVERIFY(bool(loadSeries(stack.series, Padding::maskAsAir, noProgress)));
        QCOMPARE(order.size(), std::size_t(41));
        // Several threads begin at once, in no order
        const std::size_t threads = std::max(1u, std::thread::hardware_concurrency());
        for (std::size_t i = 0; i < order.size(); ++i) {
            const int fromMiddle = std::abs(std::stoi(order[i].substr(1)) - 20);
            QVERIFY2(std::size_t(2 * fromMiddle) <= i + 2 * threads, order[i].c_str());
        }
    }

    void whatArrivedOfAFailureIsGone_data() {
        QTest::addColumn<bool>("cancels");
        QTest::newRow("a file is gone") << false;
        QTest::newRow("cancelled") << true;
    }
    void whatArrivedOfAFailureIsGone() {
        QFETCH(bool, cancels);
        const WatchedStack stack(30);
        if (!cancels)
            stack.source->remove("s07");
        std::shared_ptr<const ArrivingVolume> arriving;
        const auto volume = loadSeries(
            stack.series, Padding::maskAsAir, [&](double, std::string_view) { return !cancels; }, nullptr,
            [&](std::shared_ptr<const ArrivingVolume> taken) { arriving = taken; });
        QVERIFY(!volume);
        QVERIFY(arriving);
        QVERIFY(!arriving->look([](std::span<const ArrivedSlices>) {}));
    }

    /// Padding of values that are no HU gets the lowest of all values in the end: a slice with it would change.
    void slicesThatWillChangeDoNotArrive() {
        const WatchedStack stack(6, [](test::SliceFile& slice) {
            slice.raw[5] = 63536;
            slice.change = [](DcmDataset& data) {
                data.putAndInsertString(DCM_Modality, "MR");
                data.putAndInsertUint16(DCM_PixelPaddingValue, 63536);
            };
        });
        QVERIFY(!stack.series.unit.isHu);
        std::shared_ptr<const ArrivingVolume> arriving;
        const auto volume = loadSeries(stack.series, Padding::maskAsAir, noProgress, nullptr,
                                       [&](std::shared_ptr<const ArrivingVolume> taken) { arriving = taken; });
        QVERIFY2(volume, volume ? "" : volume.error().text().c_str());
        QCOMPARE(volume->paddingCount(), std::size_t(6));
        QCOMPARE(arriving->arrived(), 0);
    }
};

QTEST_APPLESS_MAIN(LoadTest)
#include "load_test.moc"
