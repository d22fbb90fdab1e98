/// What lanes read at once is what they read one by one.

#include <QTest>
#include <random>
#include <vector>

#include "render/base/lanes.h"

using namespace pdr;

class LanesTest : public QObject {
    Q_OBJECT

  private slots:
    /// Reads entries from the first to the last, with NaN among the floats, and pairs that straddle cache lines and
    /// pages.
    void bothWaysToGatherReadTheSame() {
        std::mt19937 random(7);
        std::vector<float> floats(100'000);
        std::vector<std::int16_t> pairs(floats.size() + 1);
        for (float& value : floats)
            value = std::bit_cast<float>(std::uint32_t(random()));
        for (std::int16_t& value : pairs)
            value = std::int16_t(random());
        for (int round = 0; round < 10'000; ++round) {
            IntLanes index{};
            for (int lane = 0; lane < kLanes; ++lane)
                index[lane] = int(random() % floats.size());
            if (round == 0)
                index[0] = 0, index[1] = int(floats.size() - 1);
            const IntLanes atOnce = bitsOf(gatherAtOnce(floats.data(), index));
            const IntLanes oneByOne = bitsOf(gatherOneByOne(floats.data(), index));
            QVERIFY(!any(atOnce != oneByOne));
            QVERIFY(!any(gatherPairsAtOnce(pairs.data(), index) != gatherPairsOneByOne(pairs.data(), index)));
            FloatLanes first, second;
            gatherPair(pairs.data(), index, first, second);
            for (int lane = 0; lane < kLanes; ++lane) {
                QCOMPARE(first[lane], float(pairs[std::size_t(index[lane])]));
                QCOMPARE(second[lane], float(pairs[std::size_t(index[lane]) + 1]));
            }
        }
    }

    /// A lane may take the 64 bits of any other, and keeps its own where it does not.
    void lanesTakeWordsOfOtherLanes() {
        std::mt19937_64 random(11);
        for (int round = 0; round < 1000; ++round) {
            BitsLanes mine{}, theirs{};
            IntLanes from{}, mask{};
            for (int lane = 0; lane < kLanes; ++lane) {
                mine[lane] = random(), theirs[lane] = random();
                from[lane] = int(random() % kLanes);
                mask[lane] = random() % 2 ? -1 : 0;
            }
            const BitsLanes taken = selected(mask, permuted(theirs, from), mine);
            for (int lane = 0; lane < kLanes; ++lane)
                QCOMPARE(taken[lane], mask[lane] ? theirs[from[lane]] : mine[lane]);
        }
    }
};

QTEST_GUILESS_MAIN(LanesTest)
#include "lanes_test.moc"
