/// Who sends more than there is reason for: a bucket of tokens, which is told the time, and a channel that asks it.

#include <random>

#include "app/remote/token_bucket.h"
#include "tests/app/remote/channel_rig.h"

using namespace pdr;
using namespace pdr::remote;
using namespace pdr::test;
using namespace std::chrono_literals;

namespace {

/// Returns how many of `most` messages pass, one after the other.
int passing(TokenBucket& bucket, TokenBucket::Moment now, int most) {
    int passed = 0;
    while (passed < most && bucket.take(now))
        ++passed;
    return passed;
}

/// A type that no version knows yet, which may be passed over.
wire::Bytes unknownMessage() {
    const auto header = wire::bytesOf({.type = wire::kFirstCritical - 1});
    return {header.begin(), header.end()};
}

ChannelLimits narrow() {
    ChannelLimits limits = Meeting::patientLimits().channel;
    limits.messages = {.perSecond = 1, .burst = 20};
    return limits;
}

}  // namespace

class FloodTest : public QObject {
    Q_OBJECT

  private slots:
    void burstPassesAtOnceAndNoMore() {
        TokenBucket bucket({.perSecond = 10, .burst = 50});
        QCOMPARE(passing(bucket, 5s, 1000), 50);
        QCOMPARE(passing(bucket, 5s + 99ms, 1000), 0);
        QCOMPARE(passing(bucket, 5s + 100ms, 1000), 1);
        QCOMPARE(passing(bucket, 7s, 1000), 19);
    }

    void restFillsIt() {
        TokenBucket bucket({.perSecond = 10, .burst = 50});
        for (const auto now : {0h, 1h, 20000h})
            QCOMPARE(passing(bucket, now, 1000), 50);
        QCOMPARE(passing(bucket, 20000h + 4s, 1000), 40);
    }

    void itsRatePassesForEver() {
        TokenBucket bucket({.perSecond = 500, .burst = 1});
        for (int i = 0; i < 100000; ++i)
            QVERIFY(bucket.take(i * 2ms));
        QVERIFY(!bucket.take(99999 * 2ms + 1ms));
    }

    void severalPassTogetherOrNotAtAll() {
        TokenBucket bucket({.perSecond = 10, .burst = 50});
        QVERIFY(bucket.take(0s, 30));
        QVERIFY(!bucket.take(0s, 21));
        QVERIFY(bucket.take(0s, 20) && bucket.take(0s, 0));
        QVERIFY(!bucket.take(0s));
    }

    /// In any stretch of time no more messages pass than allowed, and a sender that keeps to the limit passes, however
    /// they arrive.
    void noStretchOfTimeHoldsMore() {
        std::mt19937 random(7);
        for (int round = 0; round < 20; ++round) {
            const RateLimit limit{.perSecond = 1 + int(random() % 100), .burst = 1 + int(random() % 30)};
            TokenBucket bucket(limit);
            std::vector<std::int64_t> passed;  // microseconds
            std::int64_t now = 0;
            for (int i = 0; i < 400; ++i) {
                now += random() % 3 ? random() % 5000 : random() % 400'000;
                if (bucket.take(TokenBucket::Moment(now)))
                    passed.push_back(now);
            }
            for (std::size_t first = 0; first < passed.size(); ++first)
                for (std::size_t last = first; last < passed.size(); ++last) {
                    const double seconds = double(passed[last] - passed[first]) * 1e-6;
                    QVERIFY(double(last - first + 1) <=
                            double(limit.burst) + seconds * double(limit.perSecond) * 1.001);
                }
        }
    }

    void floodEndsTheConnection_data() {
        QTest::addColumn<wire::Bytes>("drop");
        QTest::addColumn<bool>("isNarrow");
        const wire::Bytes pong = wire::inOnePiece(wire::encode(wire::Pong{3}));
        QTest::newRow("messages") << pong << true;
        QTest::newRow("messages, as many as a program bears") << pong << false;
        QTest::newRow("messages of an unknown type") << unknownMessage() << true;
    }
    void floodEndsTheConnection() {
        QFETCH(const wire::Bytes, drop);
        QFETCH(const bool, isNarrow);
        Rig rig(isNarrow ? narrow() : Meeting::patientLimits().channel);
        rig.channel->setAdmitted();
        for (int i = 0; i < (isNarrow ? 2000 : 100'000); ++i)
            rig.say(drop);
        rig.socket.disconnectFromHost();
        QTRY_COMPARE_WITH_TIMEOUT(rig.ends, 1, kPatience);
        QVERIFY2(rig.reason.contains("more messages"), qPrintable(rig.reason));
    }

    void burstIsTaken() {
        Rig rig;
        rig.channel->setAdmitted();
        for (std::uint64_t i = 0; i < 5000; ++i)
            rig.say(wire::Message(wire::Pong{i}));
        QTRY_COMPARE_WITH_TIMEOUT(rig.received.size(), std::size_t(5000), kPatience);
        QVERIFY(rig.channel->isOpen());
    }

    /// Leases and their answers come as fast as work is done.
    void workIsNoFlood() {
        Rig rig(narrow());
        rig.channel->setAdmitted();
        for (int i = 0; i < 2000; ++i)
            rig.say(wire::Message(wire::Abandoned{}));
        QTRY_COMPARE_WITH_TIMEOUT(rig.received.size(), std::size_t(2000), kPatience);
        QVERIFY(rig.channel->isOpen());
    }
};

QTEST_GUILESS_MAIN(FloodTest)
#include "flood_test.moc"
