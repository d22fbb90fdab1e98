/// Whether users who share a device get equal shares of it.

#include <QTest>

#include <atomic>
#include <cmath>
#include <map>
#include <thread>

#include "render/tiles/fair_turns.h"

using namespace pdr;

namespace {

/// Users, each with a thread of its own, at a device whose time passes by what turns cost.
class Users {
  public:
    /// Lets these users take one turn after the other until `seconds` have passed. `costs`: how long each turn of a
    /// user takes. All wait whenever one is chosen: between two turns an usher, who has had the least, holds the device
    /// until they do.
    void work(const std::map<int, double>& costs, double seconds) {
        std::atomic<bool> isOver = false;
        std::atomic<int> begun = 0;
        const double end = now_ + seconds;
        const auto waitFor = [&](std::size_t waiting) {
            while (!isOver && turns_.waiting() < waiting)
                std::this_thread::yield();
        };
        const std::size_t all = costs.size() > 1 ? costs.size() : 0;
        std::vector<std::jthread> threads;
        for (const auto& [user, cost] : costs)
            threads.emplace_back([&, &share = shares_[user], cost = cost] {
                const auto turn = [&] {
                    ++begun;
                    waitFor(all);  // the others and the usher
                    if (isOver)
                        return;
                    now_ += cost;
                    isOver = now_ >= end;
                };
                while (!isOver)
                    turns_.take(share, {}, turn);
            });
        FairTurns::Share usher;
        for (int seen = 0; all > 0 && !isOver;) {
            while (!isOver && begun == seen)
                std::this_thread::yield();
            seen = begun;
            turns_.take(usher, {}, [&] { waitFor(all); });
        }
    }
    double had(int user) { return turns_.had(shares_[user]); }
    FairTurns& turns() { return turns_; }

  private:
    double now_ = 0;
    FairTurns turns_{[this] { return now_; }};
    std::map<int, FairTurns::Share> shares_{{0, {}}, {1, {}}, {2, {}}};
};

}  // namespace

class FairTurnsTest : public QObject {
    Q_OBJECT

  private slots:
    void sharesAreEqualHoweverLongTheTurns() {
        Users users;
        const double lead = FairTurns::kMostLead, longest = 0.3 * lead, share = 100 * lead;
        users.work({{0, 0.1 * lead}, {1, longest}, {2, 0.03 * lead}}, 3 * share);
        for (int user = 0; user < 3; ++user)
            QVERIFY2(std::fabs(users.had(user) - share) < 1.01 * longest, qPrintable(QString::number(users.had(user))));
    }

    void whoWantsNothingCostsNothing() {
        Users users;
        users.work({{0, 1}}, 100);
        QCOMPARE(users.had(0), 100.0);
        QCOMPARE(users.had(1), 0.0);
    }

    /// Else a user would have the device alone for as long as others had used it before.
    void anIdleHourIsNoClaim() {
        Users users;
        users.work({{0, 1}}, 3600);
        users.work({{0, 1}, {1, 1}}, 100);
        QVERIFY2(users.had(1) >= 49 && users.had(1) <= 52, qPrintable(QString::number(users.had(1))));
    }

    /// A lease that comes a moment later than it could is not lost.
    void aShortGapIsMadeUpFor() {
        Users users;
        const double gap = 0.75 * FairTurns::kMostLead, cost = 0.05 * FairTurns::kMostLead;
        users.work({{0, cost}, {1, cost}}, 10 * gap);
        users.work({{0, cost}}, gap);
        users.work({{0, cost}, {1, cost}}, 3 * gap);
        QVERIFY(std::fabs(users.had(0) - users.had(1)) < 3 * cost);
    }

    void oneWorksAtATime() {
        FairTurns turns;
        std::atomic<int> working = 0, most = 0, done = 0;
        {
            std::vector<std::jthread> threads;
            for (int user = 0; user < 4; ++user)
                threads.emplace_back([&] {
                    FairTurns::Share share;
                    for (int turn = 0; turn < 50; ++turn)
                        turns.take(share, {}, [&] {
                            most = std::max<int>(most, ++working);
                            std::this_thread::yield();
                            --working;
                            ++done;
                        });
                });
        }
        QCOMPARE(most, 1);
        QCOMPARE(done, 200);
    }

    void aStopEndsTheWait() {
        FairTurns turns;
        std::atomic<bool> holds = false, go = false;
        FairTurns::Share first, second, third;
        std::jthread holder([&] {
            turns.take(first, {}, [&] {
                holds = true;
                while (!go)
                    std::this_thread::yield();
            });
        });
        while (!holds)
            std::this_thread::yield();
        std::stop_source stop;
        bool came = true, called = false;
        std::jthread waiter([&] { came = turns.take(second, stop.get_token(), [&] { called = true; }); });
        while (turns.waiting() < 1)
            std::this_thread::yield();
        stop.request_stop();
        waiter.join();  // before the holder ends
        QVERIFY(!came && !called);
        QCOMPARE(turns.waiting(), std::size_t(0));
        go = true;
        QVERIFY(turns.take(third, {}, [] {}));  // and nobody stands in the way
    }
};

QTEST_APPLESS_MAIN(FairTurnsTest)
#include "fair_turns_test.moc"
