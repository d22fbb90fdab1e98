#include <QTest>
#include <array>
#include <set>

#include "render/kernel/random.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

constexpr double kAlarm = 1e-6;  ///< false-alarm rate of each comparison; seeds are fixed

}  // namespace

class RandomTest : public QObject {
    Q_OBJECT

  private slots:
    void numbersLieInTheOpenInterval() {
        // The extreme words that the generator can put out.
        for (const std::uint64_t word : {std::uint64_t(0), ~std::uint64_t(0)}) {
            const float high = (toFloat(highBits(word)) + 0.5f) * 0x1p-23f;
            const float low = (toFloat(lowBits(word)) + 0.5f) * 0x1p-23f;
            QVERIFY(high > 0 && high < 1 && low > 0 && low < 1);
        }
    }

    void numbersAreUniformForAnyKey() {
        for (const std::uint64_t seed : {0ull, 1ull, ~0ull, 1ull << 63}) {
            std::array<double, 256> first{}, second{};
            RandomStream stream = Random(seed, 0, 0).stream(Dimension::filter);
            for (int i = 0; i < 200000; ++i) {
                const vec2 u = stream.pair();
                ++first[int(u.x * 256)];
                ++second[int(u.y * 256)];
            }
            QVERIFY(test::uniformP(first) > kAlarm);
            QVERIFY(test::uniformP(second) > kAlarm);
        }
    }

    /// The first numbers of neighbouring pixels, samples and dimensions, in pairs on a 16 x 16 board.
    void neighbouringStreamsAreIndependent() {
        const auto board = [](auto&& stream) {
            std::array<double, 256> counts{};
            for (int i = 0; i < 200000; ++i) {
                const float a = stream(i).pair().x, b = stream(i + 1).pair().x;
                ++counts[int(a * 16) * 16 + int(b * 16)];
            }
            return test::uniformP(counts);
        };
        QVERIFY(board([](int i) { return Random(1, unsigned(i), 5).stream(Dimension::filter); }) > kAlarm);
        QVERIFY(board([](int i) { return Random(1, 7, std::uint64_t(i)).stream(Dimension::filter); }) > kAlarm);
        QVERIFY(board([](int i) { return Random(std::uint64_t(i), 7, 5).stream(Dimension::filter); }) > kAlarm);
        QVERIFY(board([](int i) { return Random(1, 7, 5).stream(i, BounceDimension::shadow); }) > kAlarm);
    }

    void twoNumbersOfAPairAreIndependent() {
        std::array<double, 256> counts{};
        RandomStream stream = Random(9, 9, 9).stream(Dimension::filter);
        for (int i = 0; i < 500000; ++i) {
            const vec2 u = stream.pair();
            ++counts[int(u.x * 16) * 16 + int(u.y * 16)];
        }
        QVERIFY(test::uniformP(counts) > kAlarm);
    }

    void streamsDoNotMeet() {
        std::set<std::pair<float, float>> seen;
        for (unsigned pixel = 0; pixel < 100; ++pixel)
            for (unsigned sample = 0; sample < 100; ++sample) {
                const vec2 u = Random(1, pixel, sample).stream(Dimension::filter).pair();
                seen.insert({u.x, u.y});
            }
        QCOMPARE(seen.size(), std::size_t(10000));
    }

    void lanesDrawTheNumbersOfOnePath() {
        RandomStreamOf<FloatLanes> lanes{};
        std::array<RandomStream, kLanes> single;
        for (int lane = 0; lane < kLanes; ++lane) {
            single[lane] = Random(1, unsigned(lane), 3).stream(Dimension::filter);
            lanes.counter[lane] = single[lane].counter;
            lanes.key[lane] = single[lane].key;
        }
        for (int i = 0; i < 100; ++i) {
            FloatLanes first, second;
            lanes.pair(IntLanes{} - 1, first, second);
            for (int lane = 0; lane < kLanes; ++lane) {
                const vec2 u = single[lane].pair();
                QCOMPARE(first[lane], u.x);
                QCOMPARE(second[lane], u.y);
            }
        }
    }

    void logarithmIsAccurate() {
        for (int k = 0; k < (1 << 23); k += 37) {
            const float u = (float(k) + 0.5f) * 0x1p-23f;
            const double truth = -std::log(double(u));
            QVERIFY(std::fabs(negativeLog(u) - truth) <= 3e-7 * truth);
        }
    }
};

QTEST_GUILESS_MAIN(RandomTest)
#include "random_test.moc"
