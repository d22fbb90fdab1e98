/// Rendering without a window: what a stop request leaves, and how the image is cut into requests.

#include <QTest>
#include <functional>
#include <vector>

#include "render/device/host_accumulator.h"
#include "render/session/batch_render.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/scenes/images.h"

namespace pdr {

class TestBatchRender : public QObject {
    Q_OBJECT

  private slots:
    void aStopRequestKeepsTheSampleOnItsWayOrDiscardsIt_data();
    void aStopRequestKeepsTheSampleOnItsWayOrDiscardsIt();
    void whatIsToBeDiscardedEndsAsWellWhereNothingStopsIt();
    void ordersThatReachTheNextBlockEndWithOne();
    void aFilmThatCanBeStoppedIsOrderedAtOnce_data();
    void aFilmThatCanBeStoppedIsOrderedAtOnce();
    void tilesThatAStopLeftEmptyGetASample();
    void anOrderEndsWhenItsTimeIsOver();
    void whatIsFoundWrongIsTakenAgain();
    void aStopRequestIsObeyedWhereAllWasFoundWrong();
    void aTimeThatIsOverLeavesASampleWhereAllWasFoundWrong();
};

/// Takes samples without light, and records where each request ends.
class WrittenOrders final : public HostAccumulator {
  public:
    using HostAccumulator::accumulate;
    using HostAccumulator::HostAccumulator;

    Result<void> accumulate(const Tile& region, std::uint32_t n, std::stop_token) override {
        for (const std::uint64_t end = next_ + n; next_ < end;) {
            const SampleRange samples = samplesInBlock(next_, std::uint32_t(end - next_));
            film_.commit(region, samples);
            next_ = samples.end();
        }
        ends.push_back(next_);
        return {};
    }

    std::vector<std::uint64_t> ends;

  private:
    std::uint64_t next_ = 0;
};

/// Is extended tile by tile: a stop request leaves its left half with all samples. Its samples find no light although
/// they may, so that no error is known.
class FilmOfTiles final : public HostAccumulator {
  public:
    FilmOfTiles() : HostAccumulator({0, 0, 32, 32}, 0) { film_.sums(film_.area()).pixels->seen = kSeenChance; }

    OrderSize orderSize() const override { return {1, 128, 256}; }
    Result<void> accumulate(const Tile&, std::uint32_t, std::stop_token) override { return {}; }
    Result<std::uint64_t> extend(std::uint64_t had, std::uint32_t n, std::stop_token stop,
                                 const Extended& told) override {
        orders.push_back(n);
        for (const Tile& half : {Tile{0, 0, 16, 32}, Tile{16, 0, 16, 32}}) {
            const std::uint64_t end = film_.progress().evenTiles(half).front().next + n;
            for (std::uint64_t next = end - n; next < end;) {
                const SampleRange samples = samplesInBlock(next, std::uint32_t(end - next));
                film_.commit(half, samples);
                next = samples.end();
            }
            if (told)
                told(film_.samples());
            constexpr int kGivesUp = 20'000'000;  // after times that none of the limits here reaches
            for (int i = 0; i < kGivesUp && orders.size() == stuckWith && told && !stop.stop_requested(); ++i)
                told(film_.samples());
            if (stop.stop_requested())
                return film_.samplesPerPixel();
        }
        return had + n;
    }

    std::vector<std::uint64_t> orders;
    std::size_t stuckWith = 0;  ///< number of the order, from 1, that takes until it is stopped; 0: none
};

/// Finds samples wrong with one of the requests, counted from 1.
class FoundWrong final : public HostAccumulator {
  public:
    explicit FoundWrong(int order) : HostAccumulator({0, 0, 32, 32}, 0), wrongWith_(order) {}

    Result<void> accumulate(const Tile&, std::uint32_t, std::stop_token) override { return {}; }
    Result<std::uint64_t> extend(std::uint64_t had, std::uint32_t n, std::stop_token, const Extended&) override {
        if (++orders == wrongWith_) {
            film_.restart(film_.area(), film_.revision());
            found();
            return 0;
        }
        for (std::uint64_t next = had; next < had + n;) {
            const SampleRange samples = samplesInBlock(next, std::uint32_t(had + n - next));
            film_.commit(film_.area(), samples);
            next = samples.end();
        }
        return had + n;
    }

    int orders = 0;
    std::function<void()> found = [] {};

  private:
    int wrongWith_;
};

static Scene smallSlab() {
    Scene scene = test::slab(1, {0, 1, 0}, 0.5f);
    scene.film = {24, 16};
    return scene;
}

void TestBatchRender::aStopRequestKeepsTheSampleOnItsWayOrDiscardsIt_data() {
    QTest::addColumn<bool>("keeps");
    QTest::newRow("kept") << true;
    QTest::newRow("discarded") << false;
}

void TestBatchRender::aStopRequestKeepsTheSampleOnItsWayOrDiscardsIt() {
    QFETCH(bool, keeps);
    std::stop_source stop;
    int launches = 0;
    const auto mishaps = std::make_shared<test::Mishaps>();
    mishaps->before = [&](const std::string& verb) {
        if (verb == "accumulate" && ++launches == 2)
            stop.request_stop();
    };
    const auto device = test::failing(mishaps);
    const Scene scene = smallSlab();
    QVERIFY(device->upload(scene));
    const auto film = *device->film(scene.film, scene.revision, scene.schedule);
    BatchRender batch(*film, {.samples = 40}, {}, keeps ? WhenStopped::keep : WhenStopped::discard);
    const auto ended = batch.run(stop.get_token(), [](const BatchState&) {});
    QVERIFY(ended && ended->reason == StopReason::interrupted);
    QCOMPARE(launches, 2);
    QCOMPARE(mishaps->brokenOff.load(), !keeps);
    QCOMPARE(ended->film.samplesPerPixel > 1, keeps);
}

void TestBatchRender::whatIsToBeDiscardedEndsAsWellWhereNothingStopsIt() {
    const auto device = test::failing(std::make_shared<test::Mishaps>());
    const Scene scene = smallSlab();
    QVERIFY(device->upload(scene));
    const auto film = *device->film(scene.film, scene.revision, scene.schedule);
    const auto ended = BatchRender(*film, {.samples = 40}, {}, WhenStopped::discard).run({}, [](const BatchState&) {});
    QVERIFY(ended && ended->reason == StopReason::samples);
    QCOMPARE(ended->film.samplesPerPixel, std::uint64_t(40));
}

void TestBatchRender::ordersThatReachTheNextBlockEndWithOne() {
    constexpr std::uint64_t kSamples = 5 * kSamplesPerBlock + 7;
    WrittenOrders film({0, 0, 32, 32}, 0);
    const auto ended = BatchRender(film, {.samples = kSamples}, {}).run({}, [](const BatchState&) {});
    QVERIFY(ended && ended->reason == StopReason::samples);
    QCOMPARE(film.ends.back(), kSamples);
    for (std::uint64_t first = 0; const std::uint64_t end : film.ends) {
        const bool isWithinABlock = first / kSamplesPerBlock == (end - 1) / kSamplesPerBlock;
        QVERIFY(isWithinABlock || end % kSamplesPerBlock == 0 || end == kSamples);
        first = end;
    }
}

void TestBatchRender::aFilmThatCanBeStoppedIsOrderedAtOnce_data() {
    QTest::addColumn<Stops>("stops");
    QTest::addColumn<std::vector<std::uint64_t>>("orders");
    QTest::newRow("few samples") << Stops{.samples = 100} << std::vector<std::uint64_t>{100};
    QTest::newRow("many samples") << Stops{.samples = 2000} << std::vector<std::uint64_t>{256, 768, 976};
    QTest::newRow("more time than it takes")
        << Stops{.samples = 500, .seconds = 1e9} << std::vector<std::uint64_t>{1, 255, 244};
    QTest::newRow("an error") << Stops{.samples = 2000, .relativeError = 1e-9}
                              << std::vector<std::uint64_t>{64, 192, 768, 976};
}

void TestBatchRender::aFilmThatCanBeStoppedIsOrderedAtOnce() {
    QFETCH(const Stops, stops);
    QFETCH(const std::vector<std::uint64_t>, orders);
    FilmOfTiles film;
    QList<double> means;
    const auto ended =
        BatchRender(film, stops, {}).run({}, [&](const BatchState& s) { means << s.film.meanSamplesPerPixel; });
    QVERIFY(ended && ended->reason == StopReason::samples);
    QCOMPARE(ended->film.samplesPerPixel, *stops.samples);
    QCOMPARE(film.orders, orders);
    QCOMPARE(means.first(), double(orders.front()) / 2);  // told before the order ended
    QCOMPARE(means.last(), double(*stops.samples));
}

void TestBatchRender::tilesThatAStopLeftEmptyGetASample() {
    std::stop_source stop;
    FilmOfTiles film;
    const auto ended =
        BatchRender(film, {.samples = 100}, {}).run(stop.get_token(), [&](const BatchState&) { stop.request_stop(); });
    QVERIFY(ended && ended->reason == StopReason::interrupted);
    QCOMPARE(film.orders, (std::vector<std::uint64_t>{100, 1}));
    QCOMPARE(ended->film.samplesPerPixel, std::uint64_t(1));
    QCOMPARE(ended->film.mostSamplesPerPixel, std::uint64_t(101));
}

/// All nodes may have gone.
void TestBatchRender::anOrderEndsWhenItsTimeIsOver() {
    FilmOfTiles film;
    film.stuckWith = 2;
    const auto ended = BatchRender(film, {.seconds = 0.3}, {}).run({}, [](const BatchState&) {});
    QVERIFY(ended && ended->reason == StopReason::seconds);
    QCOMPARE(ended->film.samplesPerPixel, std::uint64_t(1));
    QCOMPARE(film.orders.size(), std::size_t(2));
}

void TestBatchRender::whatIsFoundWrongIsTakenAgain() {
    FoundWrong film(3);
    const auto ended = BatchRender(film, {.samples = 100}, {}).run({}, [](const BatchState&) {});
    QVERIFY(ended && ended->reason == StopReason::samples);
    QCOMPARE(ended->film.samplesPerPixel, std::uint64_t(100));
    QVERIFY(film.orders > 3);
}

void TestBatchRender::aStopRequestIsObeyedWhereAllWasFoundWrong() {
    std::stop_source stop;
    FoundWrong film(3);
    film.found = [&] { stop.request_stop(); };
    const auto ended = BatchRender(film, {.samples = 1'000'000}, {}).run(stop.get_token(), [](const BatchState&) {});
    QVERIFY(ended && ended->reason == StopReason::interrupted);
    QCOMPARE(film.orders, 3);
    QCOMPARE(ended->film.samplesPerPixel, std::uint64_t(0));
}

void TestBatchRender::aTimeThatIsOverLeavesASampleWhereAllWasFoundWrong() {
    FoundWrong film(1);
    const auto ended = BatchRender(film, {.seconds = 1e-9}, {}).run({}, [](const BatchState&) {});
    QVERIFY(ended && ended->reason == StopReason::seconds);
    QCOMPARE(ended->film.samplesPerPixel, std::uint64_t(1));
}

}  // namespace pdr

QTEST_GUILESS_MAIN(pdr::TestBatchRender)
#include "batch_render_test.moc"
