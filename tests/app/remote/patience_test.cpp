/// Who decides how long to wait: heartbeats, waits before dialling again, and the watch for those that drip. All are
/// told the time.

#include <QTest>
#include <random>

#include "app/remote/backoff.h"
#include "app/remote/drip_watch.h"
#include "app/remote/heartbeat.h"

using namespace pdr;
using namespace pdr::remote;
using namespace std::chrono_literals;
using std::chrono::milliseconds;
using Peer = Heartbeat::Peer;

class PatienceTest : public QObject {
    Q_OBJECT

  private slots:
    void silenceIsNoticed_data() {
        QTest::addColumn<QList<int>>("heard");  // at these milliseconds
        QTest::addColumn<int>("now");
        QTest::addColumn<int>("peer");
        const auto row = [](const char* name, const QList<int>& heard, int now, Peer peer) {
            QTest::addRow("%s", name) << heard << now << int(peer);
        };
        row("at once", {}, 0, Peer::fine);
        row("just not suspect", {}, 2900, Peer::fine);
        row("suspect", {}, 3000, Peer::suspect);
        row("just not dead", {}, 9900, Peer::suspect);
        row("dead", {}, 10000, Peer::dead);
        row("heard in time", {2000, 4000}, 6900, Peer::fine);
        row("heard once, then suspect", {2000}, 5000, Peer::suspect);
        row("suspect, then heard", {5000}, 5100, Peer::fine);
        row("suspect, heard, suspect again", {5000}, 8000, Peer::suspect);
        row("heard just before it was dead", {9900}, 10000, Peer::fine);
        row("heard after it was dead", {11000}, 11000, Peer::dead);
        row("dead 10 s after it was heard", {7000}, 17000, Peer::dead);
    }
    void silenceIsNoticed() {
        QFETCH(QList<int>, heard);
        QFETCH(int, now);
        QFETCH(int, peer);
        Heartbeat heartbeat(0ms);
        Peer last = Peer::fine;
        for (int time = 0; time <= now; time += 100) {
            last = heartbeat.at(milliseconds(time));
            if (heard.contains(time)) {
                heartbeat.heard(milliseconds(time));
                last = heartbeat.at(milliseconds(time));
            }
        }
        QCOMPARE(int(last), peer);
    }

    /// After a pause of this side, as when a laptop is opened again, what the other side has sent is not read yet.
    void standingStillIsNotSilence() {
        Heartbeat heartbeat(0ms);
        QVERIFY(heartbeat.at(1h) == Peer::fine);
        heartbeat.heard(1h);
        QVERIFY(heartbeat.at(1h + 100ms) == Peer::fine);
        for (int i = 1; i <= 100; ++i)
            heartbeat.at(1h + 100ms + i * 100ms);
        QVERIFY(heartbeat.at(1h + 10s + 100ms) == Peer::dead);
    }

    void pingsComeAtTheirInterval() {
        Heartbeat heartbeat(0ms, {.interval = 1000ms});
        std::vector<int> when;
        std::uint64_t number = 0;
        for (int time = 50; time <= 5000; time += 50)
            if (const auto ping = heartbeat.due(milliseconds(time))) {
                QCOMPARE(ping->number, ++number);
                when.push_back(time);
            }
        QVERIFY((when == std::vector{50, 1050, 2050, 3050, 4050}));
    }

    void latencyIsTheMedianOfTheLast() {
        Heartbeat heartbeat(0ms);
        QVERIFY(!heartbeat.latency());
        auto now = 0ms;
        const auto answerAfter = [&](milliseconds latency) {
            now += 1s;
            const auto ping = heartbeat.due(now);
            heartbeat.answered({ping->number}, now + latency);
            heartbeat.answered({ping->number}, now + 900ms);  // a second answer says nothing
        };
        answerAfter(20ms);
        QVERIFY(*heartbeat.latency() == 20ms);
        answerAfter(500ms);
        answerAfter(30ms);
        QVERIFY(*heartbeat.latency() == 30ms);
        for (int i = 0; i < 9; ++i)
            answerAfter(40ms);
        QVERIFY(*heartbeat.latency() == 40ms);
        heartbeat.answered({9999}, now);
        QVERIFY(*heartbeat.latency() == 40ms);
    }

    void answersThatNeverComeTakeNoMemory() {
        Heartbeat heartbeat(0ms);
        const auto first = heartbeat.due(1s);
        for (int i = 2; i < 1000; ++i)
            QVERIFY(heartbeat.due(i * 1s));
        heartbeat.answered({first->number}, 2000s);
        QVERIFY(!heartbeat.latency());
    }

    void waitsDoubleUpToTenSeconds() {
        Backoff backoff;
        auto now = 0ms;
        std::vector<int> waits;
        while (const auto wait = backoff.failed(now, 0.999999)) {
            waits.push_back(int(wait->count()) + 1);
            now += *wait;
        }
        QVERIFY((std::vector(waits.begin(), waits.begin() + 8) ==
                 std::vector{200, 400, 800, 1600, 3200, 6400, 10000, 10000}));
        QVERIFY(now > 110s && now <= 120s);
    }

    void waitsAreHalfToWhole() {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> uniform;
        for (int round = 0; round < 200; ++round) {
            Backoff backoff;
            milliseconds now = 5000s, whole = 200ms;
            while (const auto wait = backoff.failed(now, uniform(random))) {
                QVERIFY(*wait >= whole / 2 && *wait <= whole);
                now += *wait + 3ms;
                QVERIFY(now <= 5120s + 3ms);
                whole = std::min<milliseconds>(2 * whole, 10s);
            }
        }
        Backoff one, two;
        QVERIFY(*one.failed(0ms, 0.1) != *two.failed(0ms, 0.9));
    }

    void afterSuccessItBeginsAgain() {
        Backoff backoff({.giveUp = 1s});
        QVERIFY(backoff.failed(0ms, 0) && backoff.failed(500ms, 0));
        QVERIFY(!backoff.failed(999ms, 0));
        backoff.succeeded();
        QCOMPARE(backoff.failed(5s, 0)->count(), 100);
    }

    void drips_data() {
        QTest::addColumn<int>("bytesPerSecond");  // of one message
        QTest::addColumn<int>("messageBytes");
        QTest::addColumn<bool>("tooSlow");
        QTest::addRow("a byte a second") << 1 << 1000 << true;
        QTest::addRow("half as fast as it must be") << (32 << 10) << (4 << 20) << true;
        QTest::addRow("as fast as it must be") << (64 << 10) << (4 << 20) << false;
        QTest::addRow("small but whole in time") << 100 << 900 << false;
        QTest::addRow("small messages all the time") << 1000 << 5000 << false;
    }
    void drips() {
        QFETCH(int, bytesPerSecond);
        QFETCH(int, messageBytes);
        QFETCH(bool, tooSlow);
        DripWatch watch(DripLimits{});
        bool noticed = false;
        for (int time = 0; time <= 60000 && !noticed; time += 250) {
            const std::int64_t received = std::int64_t(bytesPerSecond) * time / 1000;
            noticed =
                watch.tooSlow(milliseconds(time), received, received / messageBytes, received % messageBytes != 0);
            QVERIFY(!noticed || time >= 10000);
        }
        QCOMPARE(noticed, tooSlow);
    }

    /// The data comes fast at first, then next to nothing.
    void aDripBehindAFastBeginIsNoticed() {
        DripWatch watch(DripLimits{});
        bool noticed = false;
        for (int time = 0; time <= 20250; time += 250)
            noticed = watch.tooSlow(milliseconds(time), time < 5000 ? 1000 * time : 5'000'000 + time, 0, true);
        QVERIFY(noticed);
    }

    void aMessageThatIsWholeIsNoDrip() {
        DripWatch watch(DripLimits{});
        QVERIFY(!watch.tooSlow(0ms, 10, 0, true));
        QVERIFY(!watch.tooSlow(9990ms, 20, 0, true));
        QVERIFY(!watch.tooSlow(10010ms, 40, 1, true));  // the next has begun
        QVERIFY(!watch.tooSlow(20000ms, 50, 1, true));
        QVERIFY(watch.tooSlow(20010ms, 60, 1, true));
    }

    void whoSaysNothingIsNoDrip() {
        DripWatch watch(DripLimits{});
        for (int time = 0; time <= 100000; time += 250)
            QVERIFY(!watch.tooSlow(milliseconds(time), 500, 5, false));
    }
};

QTEST_APPLESS_MAIN(PatienceTest)
#include "patience_test.moc"
