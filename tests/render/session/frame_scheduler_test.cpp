/// Frames get as many iterations as fit their time, coarse films come in time, and a region waits for the rest.

#include <QTest>
#include <algorithm>

#include "render/session/frame_scheduler.h"
#include "tests/support/devices/fake_clock.h"

using namespace pdr;

namespace {

constexpr ivec2 kLarge{4096, 4096}, kSmall{96, 64};
constexpr Tile kRegion{0, 0, 48, 64};  // half of kSmall

FrameScheduler::Demand demand(int iterations, std::optional<std::uint64_t> replaced = {}) {
    return {{.iterations = iterations}, replaced};
}

/// A film in progress.
struct Planned {
    std::shared_ptr<test::FakeClock> clock = std::make_shared<test::FakeClock>();
    FrameScheduler scheduler{test::readingOf(clock)};
    Tile whole;

    explicit Planned(ivec2 size, bool moving = false) {
        scheduler.chooseFirst(size, moving);
        whole = wholeImage(dividedFilm(size, scheduler.divider()));
        scheduler.reset(TileProgress(whole));
    }
    void begin(bool overlaps = false, bool fresh = false) { scheduler.beginFrame(whole, overlaps, fresh); }
    /// Takes the next samples in `seconds` and returns them.
    Sweep::Order take(const FrameScheduler::Demand& demand, double seconds, bool inPieces = false) {
        const Sweep::Order order = scheduler.next(demand, inPieces);
        scheduler.took(order, seconds);
        return order;
    }
    /// Makes one frame of that part, each launch in `seconds`, and shows it in no time.
    FrameScheduler::Iterations frame(const Tile& part, const FrameScheduler::Demand& demand, double seconds) {
        scheduler.beginFrame(part, false, false);
        while (!scheduler.isComplete(demand))
            take(demand, seconds);
        const FrameScheduler::Iterations taken = scheduler.endFrame();
        scheduler.addImage({taken});
        return taken;
    }
};

/// Returns the samples of the images of a shared film that gets so many samples a second, until it has `enough`.
std::vector<std::uint64_t> samplesOfSharedImages(double perSecond, std::uint64_t enough) {
    Planned planned(kSmall);
    FrameScheduler::Demand shared{{.automatic = true}, {}, true};
    shared.isShared = true;
    std::vector<std::uint64_t> shown;
    while (planned.scheduler.samples().least < enough) {
        planned.begin();
        while (!planned.scheduler.isComplete(shared)) {
            const Sweep::Order order = planned.scheduler.next(shared, true);
            planned.scheduler.took(order, order.n * order.tile.height / (kSmall.y * perSecond));
        }
        planned.scheduler.addImage({planned.scheduler.endFrame()});
        shown.push_back(planned.scheduler.samples().least);
    }
    return shown;
}

}  // namespace

class FrameSchedulerTest : public QObject {
    Q_OBJECT

  private slots:
    void aFrameEndsWithTheIterationsThatWereAskedFor() {
        Planned planned(kSmall);
        QVERIFY(!planned.scheduler.isCoarse() && planned.scheduler.isBetweenFrames());
        planned.begin();
        QCOMPARE(planned.take(demand(6), 0.02).n, 6U);
        QVERIFY(planned.scheduler.isComplete(demand(6)) && !planned.scheduler.isComplete(demand(7)));
        QVERIFY(planned.scheduler.hasIterations() && !planned.scheduler.isBetweenFrames());
        QCOMPARE(planned.scheduler.frameSeconds(), 0.02);
        const FrameScheduler::Iterations taken = planned.scheduler.endFrame();
        QCOMPARE(taken.n, 6U);
        QCOMPARE(taken.seconds, 0.02);
        QVERIFY(planned.scheduler.isBetweenFrames());
        QCOMPARE(planned.scheduler.samples(), (SampleCounts{6, 6, 6}));
    }

    void aLaunchIsShort() {
        Planned planned(kSmall);
        planned.begin();
        const std::uint32_t first = planned.take(demand(10000), 0.6).n;
        QVERIFY(first > 1 && first < 10000);
        QCOMPARE(planned.take(demand(10000), 1).n, std::max(first / 10, 1U));  // it was ten times too slow
    }

    void anImageIsNeverNoisierThanTheOneItReplaces() {
        const Planned planned(kSmall);
        QCOMPARE(planned.scheduler.wanted(demand(2)), 2U);
        QCOMPARE(planned.scheduler.wanted(demand(2, 9)), 9U);
    }

    void aLargeFilmBeginsCoarseAndGetsFinerInSteps() {
        Planned planned(kLarge);
        int divider = planned.scheduler.divider();
        QVERIFY(divider > 1 && planned.scheduler.isCoarse());
        while (planned.scheduler.isCoarse()) {
            planned.scheduler.chooseFiner(kLarge, false);
            QVERIFY(planned.scheduler.divider() < divider);
            divider = planned.scheduler.divider();
        }
        QCOMPARE(divider, 1);
    }

    void aFilmBegunDuringADragIsReplacedByAnotherOfItsSize() {
        Planned planned(kSmall, true);
        QVERIFY(planned.scheduler.isCoarse() && planned.scheduler.divider() == 1);
        planned.scheduler.chooseFiner(kLarge, false);
        QVERIFY(!planned.scheduler.isCoarse() && planned.scheduler.divider() == 1);
    }

    void theFirstIterationOfACoarseFilmShowsHowManyAreInTime() {
        Planned planned(kLarge);
        planned.begin();
        QCOMPARE(planned.take(demand(1), 0.001).n, 1U);
        QVERIFY(!planned.scheduler.isComplete(demand(1)));
        QCOMPARE(planned.scheduler.next(demand(1), false).n, ResolutionLadder::kSamples - 1);
    }

    void aCoarseFilmThatIsLateIsShownUnlessACoarserOneIs() {
        Planned planned(kLarge);
        planned.begin();
        planned.take(demand(1), ResolutionLadder::kFrameSeconds);
        QVERIFY(planned.scheduler.isComplete(demand(1)));
        QVERIFY(!planned.scheduler.isComplete(demand(1, 4)));
    }

    /// Turns, which take longer to begin, and finer films after an edit do not make the next edit's film coarser.
    void anEditBeginsInATimeOfItsOwn() {
        Planned planned(kLarge);
        FrameScheduler& scheduler = planned.scheduler;
        const auto edit = [&] {
            scheduler.chooseEdited(scheduler.dividerForEdit({600, 600}, false), false);
            scheduler.addBeginning(0.01);
            return scheduler.divider();
        };
        edit();
        const int usual = edit();
        QVERIFY(usual > 1 && usual < ResolutionLadder::kCoarsest);
        for (int i = 0; i < 5; ++i) {
            scheduler.chooseFirst(kLarge, false);
            scheduler.addBeginning(0.2);
            QCOMPARE(edit(), usual);
            scheduler.chooseFiner(kLarge, false);
            scheduler.addBeginning(0.2);
        }
    }

    /// What is between two marks tells nothing of the change.
    void theCoarseFilmOfAnEditHasAllItsSamplesOrOne() {
        FrameScheduler::Demand first = demand(1);
        first.keepsFirst = true;
        const auto samplesAt = [&](double secondsOfOne) {
            Planned planned(kLarge);
            planned.scheduler.chooseEdited(8, true);
            planned.whole = wholeImage(dividedFilm(kLarge, 8));
            planned.scheduler.reset(TileProgress(planned.whole));
            planned.begin();
            while (!planned.scheduler.isComplete(first))
                planned.scheduler.took(planned.scheduler.next(first, false), secondsOfOne);
            return planned.scheduler.samples().least;
        };
        const double inTime = ResolutionLadder().secondsForEdit(true) / ResolutionLadder::kSamples;
        QCOMPARE(samplesAt(inTime), std::uint64_t(ResolutionLadder::kSamples));
        QCOMPARE(samplesAt(1.4 * inTime), std::uint64_t(ResolutionLadder::kSamples));
        QCOMPARE(samplesAt(1.6 * inTime), std::uint64_t(1));
    }

    void aSlowLaunchComesInPieces() {
        Planned planned(kSmall);
        planned.frame(planned.whole, demand(1), 1);  // 6144 samples a second
        planned.begin();
        QVERIFY(planned.take(demand(1), 0.3, true).tile.height < kSmall.y);
        QVERIFY(!planned.scheduler.isBetweenFrames() && !planned.scheduler.hasIterations());
        QVERIFY(!planned.scheduler.isComplete(demand(1)));
        while (planned.scheduler.sweep().isHalfMade())
            planned.take(demand(1), 0.3, true);
        QVERIFY(planned.scheduler.isComplete(demand(1)));
    }

    void timeSpentOnARegionAloneCountsUntilTheRestHasCaughtUp() {
        Planned planned(kSmall);
        planned.frame(planned.whole, demand(2), 0.1);
        QCOMPARE(planned.scheduler.secondsAhead(), 0.0);
        const FrameScheduler::Iterations taken = planned.frame(kRegion, demand(2), 0.1);
        QCOMPARE(taken.n, 4U);  // it is half of the image
        QCOMPARE(planned.scheduler.secondsAhead(), taken.seconds);
        planned.frame(planned.whole, demand(2), 0.1);
        QCOMPARE(planned.scheduler.secondsAhead(), taken.seconds / 2);
        planned.frame(planned.whole, demand(2), 0.1);
        QCOMPARE(planned.scheduler.secondsAhead(), 0.0);
    }

    void overlappingFramesAreTimedAloneNowAndThen() {
        Planned planned(kSmall);
        planned.begin(false, true);
        QVERIFY(!planned.scheduler.isTimed());
        for (int i = 0; !planned.scheduler.timer().settled(); ++i) {
            QVERIFY(i < 100);
            planned.begin(true);
            QVERIFY(planned.scheduler.isTimed());
            planned.scheduler.addTimedFrame(1, 0.3, 0.1);
            QVERIFY(!planned.scheduler.isTimed());
        }
        QCOMPARE(planned.scheduler.timer().efficiency(), 0.2 / 0.3);
        planned.begin(true);
        QVERIFY(!planned.scheduler.isTimed());
        planned.begin(true, true);
        QVERIFY(planned.scheduler.isTimed());
        planned.clock->advanceTo(planned.clock->seconds() + 2.1);
        planned.begin(true);
        QVERIFY(planned.scheduler.isTimed());
        planned.scheduler.reset(TileProgress(planned.whole));
        QVERIFY(!planned.scheduler.isTimed() && !planned.scheduler.timer().settled());
    }

    void imagesOfASharedFilmComeWhenItsErrorHasHalved() {
        QCOMPARE(samplesOfSharedImages(10, 16), (std::vector<std::uint64_t>{1, 4, 16}));
    }

    void imagesOfAFastSharedFilmComeNoSoonerThanTheyAreSeen() {
        QCOMPARE(samplesOfSharedImages(145, 256), (std::vector<std::uint64_t>{1, 64, 256}));
        QCOMPARE(samplesOfSharedImages(1e6, 4096), (std::vector<std::uint64_t>{1, 64, 4096}));
    }

    void imagesOfASlowSharedFilmComeEveryTwoSeconds() {
        QCOMPARE(samplesOfSharedImages(2, 32), (std::vector<std::uint64_t>{1, 4, 8, 12, 16, 20, 24, 28, 32}));
        QCOMPARE(samplesOfSharedImages(40, 256), (std::vector<std::uint64_t>{1, 16, 64, 128, 192, 256}));
    }

    void aSharedFilmIsSampledInPieces() {
        Planned planned(kSmall);
        FrameScheduler::Demand shared{{.automatic = true}, {}, true};
        shared.isShared = true;
        planned.frame(planned.whole, shared, 0.2);
        planned.begin();
        const Sweep::Order order = planned.take(shared, 0.1);
        QVERIFY(order.n == 3 && order.tile.height == kFilmCell);
    }

    void noImageHasMoreSamplesThanAreAskedFor() {
        Planned planned(kSmall);
        FrameScheduler::Demand limited = demand(10);
        limited.stopsAt = 25;
        std::vector<std::uint32_t> taken;
        while (planned.scheduler.samples().least < limited.stopsAt)
            taken.push_back(planned.frame(planned.whole, limited, 0.02).n);
        QCOMPARE(taken, (std::vector<std::uint32_t>{10, 10, 5}));
        QCOMPARE(planned.frame(planned.whole, limited, 0.02).n, 10U);  // more was requested
    }

    void aRegionIsNotTimed() {
        Planned planned(kSmall);
        planned.scheduler.beginFrame(kRegion, true, true);
        QVERIFY(!planned.scheduler.isTimed());
    }
};

QTEST_GUILESS_MAIN(FrameSchedulerTest)
#include "frame_scheduler_test.moc"
