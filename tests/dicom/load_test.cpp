#include <QTest>

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "dicom/import.h"
#include "tests/support/slice_folder.h"

using namespace pdr;
using namespace pdr::dicom;

/// From a scanned series to its voxels, where something goes wrong between.
class LoadTest : public QObject {
    Q_OBJECT

  private slots:
    /// What the system lends to nobody in particular is not what this program may take.
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
        const std::uint64_t left = 20'000'000;  // the volume takes 38 MB
        const rlimit tight{rlim_t(pages * std::uint64_t(::sysconf(_SC_PAGESIZE)) + left), before.rlim_max};
        ::setrlimit(RLIMIT_AS, &tight);
        const auto refused = loadSeries(scan.series[0], Padding::maskAsAir, noProgress);
        ::setrlimit(RLIMIT_AS, &before);
        QVERIFY(!refused);
        QCOMPARE(refused.error().kind, ErrorKind::memory);
        QVERIFY2(refused.error().what.find("needs 37.7 MB of memory, and 1") != std::string::npos ||
                     refused.error().what.find("needs 37.7 MB of memory, and 20.0") != std::string::npos,
                 refused.error().what.c_str());
        QVERIFY(bool(loadSeries(scan.series[0], Padding::maskAsAir, noProgress)));
    }
};

QTEST_APPLESS_MAIN(LoadTest)
#include "load_test.moc"
