/// A scan that is denoised for images has less noise and the same edges.

#include <tbb/global_control.h>

#include <QTest>
#include <random>

#include "render/base/errors.h"
#include "render/smooth/noise_level.h"
#include "render/smooth/non_local_means.h"
#include "render/smooth/slice_means.h"
#include "render/volume/value_unit.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

constexpr double kNoise = 50;
constexpr ivec3 kSize{96, 96, 16};
constexpr int kVessel = 24, kBone = 72;  ///< columns: the first of a vessel 2 voxels wide; the first of bone

/// Returns what is scanned: lung with a vessel on the left, then soft tissue, then bone.
double truth(int i) {
    if (i < 48)
        return i == kVessel || i == kVessel + 1 ? 40 : -850;
    return i < kBone ? 40 : 1000;
}

std::shared_ptr<const Volume> phantom() {
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0, kNoise);
    return test::makeVolume(kSize, {0.7, 0.7, 2.5},
                            [&](int i, int, int) { return std::lround(truth(i) + noise(random)); });
}

/// Returns the mean and the deviation of the voxels in the columns [begin, end).
std::pair<double, double> spreadOf(const Volume& volume, int begin, int end) {
    double sum = 0, squares = 0, count = 0;
    const auto voxels = volume.voxels();
    for (std::size_t at = 0; at < voxels.size(); ++at)
        if (const int i = int(at) % volume.size().x; i >= begin && i < end) {
            sum += voxels[at];
            squares += double(voxels[at]) * voxels[at];
            ++count;
        }
    return {sum / count, std::sqrt(squares / count - sum / count * (sum / count))};
}

double meanOf(const Volume& volume, int begin, int end) {
    return spreadOf(volume, begin, end).first;
}

std::vector<std::int16_t> rough(ivec2 size) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> hu(-1024, 3071);
    std::vector<std::int16_t> slice(std::size_t(size.x) * std::size_t(size.y));
    for (std::int16_t& value : slice)
        value = std::int16_t(hu(random) / 20);
    return slice;
}

template <class Real>
std::vector<std::int16_t> meansOf(const std::vector<std::int16_t>& slice, ivec2 size, float noise) {
    std::vector<std::int16_t> out(slice.size());
    SliceMeans<Real>(size, noise).write(slice, out);
    return out;
}

}  // namespace

class NonLocalMeansTest : public QObject {
    Q_OBJECT

  private slots:
    void noiseIsTakenOff() {
        const auto denoised = ctDenoised(*phantom(), noProgress);
        QVERIFY(bool(denoised));
        for (const auto& [begin, end] : {std::pair(0, 20), {52, 68}, {76, 96}}) {
            const auto [mean, deviation] = spreadOf(*denoised, begin, end);
            QVERIFY2(deviation <= 18, qPrintable(QString::number(deviation)));
            QVERIFY2(std::abs(mean - truth(begin)) < 2, qPrintable(QString::number(mean)));
        }
    }

    void edgesKeepTheirContrast() {
        const auto denoised = ctDenoised(*phantom(), noProgress);
        QVERIFY(bool(denoised));
        const double vessel = meanOf(*denoised, kVessel, kVessel + 2) - meanOf(*denoised, 4, 18);
        QVERIFY2(vessel >= 0.95 * 890, qPrintable(QString::number(vessel / 890)));
        const double bone = meanOf(*denoised, kBone, kBone + 1) - meanOf(*denoised, kBone - 1, kBone);
        QVERIFY2(bone >= 0.98 * 960, qPrintable(QString::number(bone / 960)));
    }

    /// A pixel beside the edge of its slice has as many neighbours as any other.
    void theEdgesOfASliceAreDenoisedToo() {
        const auto denoised = ctDenoised(*phantom(), noProgress);
        QVERIFY(bool(denoised));
        QVERIFY(spreadOf(*denoised, 0, 1).second <= 18);
        QVERIFY(spreadOf(*denoised, 95, 96).second <= 18);
    }

    /// Left and right, above and below are alike.
    void aMirroredSliceHasMirroredMeans() {
        const ivec2 size{41, 23};
        std::vector<std::int16_t> slice = rough(size);
        std::vector<std::int16_t> means = meansOf<FloatLanes>(slice, size, 40);
        std::ranges::reverse(slice);
        std::vector<std::int16_t> turned = meansOf<FloatLanes>(slice, size, 40);
        std::ranges::reverse(turned);
        for (std::size_t i = 0; i < means.size(); ++i)  // sums are rounded in another order
            QVERIFY(std::abs(means[i] - turned[i]) <= 1);
    }

    void slicesDoNotMix() {
        const auto volume = test::makeVolume({20, 20, 3}, dvec3(1), [](int, int, int k) { return 10 * k; });
        const auto denoised = nonLocalMeans(*volume, 100, noProgress);
        QVERIFY(bool(denoised));
        QVERIFY(std::ranges::equal(denoised->voxels(), volume->voxels()));
    }

    void threadsAndLanesDoNotChangeABit() {
        const auto volume = phantom();
        Voxels one;
        for (const std::size_t threads : {1, 2, 8}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            const auto denoised = nonLocalMeans(*volume, kNoise, noProgress);
            QVERIFY(bool(denoised));
            if (one.empty())
                one.assign(denoised->voxels().begin(), denoised->voxels().end());
            QVERIFY(std::ranges::equal(denoised->voxels(), one));
        }
        for (const ivec2 size : {ivec2(96, 96), ivec2(37, 5), ivec2(1, 40), ivec2(40, 1), ivec2(1, 1), ivec2(2, 3)}) {
            const std::vector<std::int16_t> slice = rough(size);
            QCOMPARE(meansOf<FloatLanes>(slice, size, 40), meansOf<float>(slice, size, 40));
        }
    }

    void constantsStay() {
        for (const int hu : {-32768, -1024, 0, 40, 32767}) {
            const auto flat = test::makeVolume({33, 9, 2}, dvec3(1), [hu](int, int, int) { return hu; });
            const auto denoised = ctDenoised(*flat, noProgress);
            QVERIFY(bool(denoised));
            QVERIFY(std::ranges::equal(denoised->voxels(), flat->voxels()));
        }
    }

    /// Far values have no weight, and the largest difference of two does not overflow.
    void extremesStayApart() {
        const auto halves =
            test::makeVolume({32, 32, 1}, dvec3(1), [](int i, int, int) { return i < 16 ? INT16_MIN : INT16_MAX; });
        const auto apart = nonLocalMeans(*halves, kNoise, noProgress);
        QVERIFY(bool(apart));
        QVERIFY(std::ranges::equal(apart->voxels(), halves->voxels()));
        const auto mixed = nonLocalMeans(*halves, 65535, noProgress);
        QVERIFY(bool(mixed));
        QVERIFY(mixed->storedRange().lowest >= INT16_MIN && mixed->voxels()[15] < mixed->voxels()[16]);
    }

    void paddingStays() {
        const auto whole = phantom();
        std::vector<bool> padding(whole->voxels().size());
        Voxels voxels(whole->voxels().begin(), whole->voxels().end());
        for (std::size_t i = 0; i < voxels.size(); i += 3)
            padding[i] = true;
        const Volume scan(whole->geometry(), std::move(voxels), padding);
        const auto denoised = nonLocalMeans(scan, kNoise, noProgress);
        QVERIFY(bool(denoised));
        QCOMPARE(denoised->paddingCount(), scan.paddingCount());
        for (std::size_t i = 0; i < padding.size(); i += 3)
            QCOMPARE(denoised->voxels()[i], scan.voxels()[i]);
    }

    void itSaysSoAndIsTheSameScanOtherwise() {
        const auto scan = phantom();
        const auto denoised = ctDenoised(*scan, noProgress);
        QVERIFY(bool(denoised));
        QCOMPARE(denoised->remarks(), std::string("CT denoised"));
        QVERIFY(isCtDenoised(*denoised) && !isCtDenoised(*scan));
        QVERIFY(denoised->geometry().patientFromIndex == scan->geometry().patientFromIndex);
    }

    void otherValuesAreRefused() {
        const auto scan = phantom();
        const Volume counts =
            Volume(scan->geometry(), Voxels(scan->voxels().begin(), scan->voxels().end()), {}, "no-hu:Bq/ml");
        const auto refused = ctDenoised(counts, noProgress);
        QVERIFY(!refused);
        QCOMPARE(refused.error().kind, ErrorKind::refused);
    }

    void itCanBeCancelled() {
        const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);  // which makes every slice
        int calls = 0;
        const auto cancelled = ctDenoised(*phantom(), [&](double, std::string_view) { return ++calls < 3; });
        QVERIFY(!cancelled);
        QCOMPARE(cancelled.error().kind, ErrorKind::cancelled);
    }
};

QTEST_APPLESS_MAIN(NonLocalMeansTest)
#include "non_local_means_test.moc"
