/// Clamping a volume, and the memory that voxels lie in.

#include <unistd.h>
#include <QTest>

#include <algorithm>
#include <fstream>
#include <numeric>

#include "render/volume/clamp.h"

using namespace pdr;

namespace {

/// Returns the memory of this program that lies in the machine's memory.
std::size_t residentBytes() {
    std::size_t all = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> all >> resident;
    return resident * std::size_t(::sysconf(_SC_PAGESIZE));
}

}  // namespace

class ClampTest : public QObject {
    Q_OBJECT

  private slots:
    void clampsInTheSameMemory() {
        Voxels voxels(4 * 3 * 2);
        std::iota(voxels.begin(), voxels.end(), std::int16_t(-10));
        std::vector<bool> padding(voxels.size());
        padding[0] = true;
        Volume volume(VolumeGeometry::aligned({4, 3, 2}, dvec3(1), dvec3(0)), std::move(voxels), padding, "clipped");
        const std::int16_t* before = volume.voxels().data();
        const Volume result = clamped(std::move(volume), std::pair(-4, 7));
        QVERIFY(result.voxels().data() == before);
        for (std::size_t i = 0; i < 24; ++i)
            QCOMPARE(int(result.voxels()[i]), std::clamp(int(i) - 10, -4, 7));
        QCOMPARE(int(result.lowestHu()), -4);
        QCOMPARE(int(result.highestHu()), 7);
        QCOMPARE(int(result.storedRange().lowest), -4);
        QVERIFY(result.isPadding(0) && !result.isPadding(1));
        QCOMPARE(result.paddingCount(), std::size_t(1));
        QCOMPARE(result.remarks(), std::string("clipped"));
    }

    /// Arrays of any size, below and above that of a page, whole pages and not; which ones get large pages is left
    /// open.
    void largeArraysHoldTheirValues() {
        for (const std::size_t bytes : {0u, 1u, 4095u, (4u << 20) - 2, 4u << 20, (4u << 20) + 2, (9u << 20) + 6}) {
            Voxels voxels(bytes / 2);
            for (std::size_t i = 0; i < voxels.size(); ++i)
                voxels[i] = std::int16_t(i * 31);
            Voxels copy = voxels;
            copy.push_back(5);
            bool equal = true;
            for (std::size_t i = 0; i < voxels.size(); ++i)
                equal = equal && copy[i] == std::int16_t(i * 31) && voxels[i] == copy[i];
            QVERIFY(equal);
        }
    }

    /// Voxels get their values from those who make them; writing zeros first would give all pages to one thread.
    void pagesComeWhenTheyAreWritten() {
        constexpr std::size_t kBytes = 256 << 20;
        const std::size_t before = residentBytes();
        Voxels voxels(kBytes / 2);
        QVERIFY(residentBytes() < before + kBytes / 2);
        std::ranges::fill(voxels, std::int16_t(1));
        QVERIFY(residentBytes() > before + kBytes / 2);
        QVERIFY(std::ranges::all_of(Voxels(kBytes / 64, 0), [](std::int16_t hu) { return hu == 0; }));
    }
};

QTEST_GUILESS_MAIN(ClampTest)
#include "clamp_test.moc"
