/// Exposure Render's schedule gives the image that it should give: ours if only the order of work differs.

#include <QTest>

#include <random>

#include "render/device/baseline/kroes_accumulator.h"
#include "render/device/emulated/host_gpu.h"
#include "render/film/display/tone_map.h"
#include "tests/support/scenes/images.h"
#include "tests/support/scenes/random_scenes.h"

using namespace pdr;

namespace {

constexpr Schedule kOurs{};
/// Exposure Render's stages, without anything that changes the image.
constexpr Schedule kOrderOnly{Schedule::Kind::kroes, false, false, false};
constexpr Schedule kRunningMean{Schedule::Kind::kroes, false, false, true};
constexpr Schedule kFiltered{Schedule::Kind::kroes, false, true, true};

/// A tissue with surfaces and shadows in front of a visible environment.
Scene someScene(Estimator estimator) {
    Scene scene = test::anyScene(4);
    scene.model = Model::singleScattering;
    scene.gradientFactor = 2;
    scene.estimator = estimator;
    scene.film = {37, 26};
    return scene;
}

void accumulated(Accumulator& film, std::uint32_t n) {
    const Result<void> done = film.accumulate(n, {});
    QVERIFY2(bool(done), done ? "" : done.error().text().c_str());
}

Image shown(Accumulator& film, const Display& display = {}) {
    if (!film.resolve(display))
        return {};
    Result<Image> image = film.readback();
    return image ? *image : Image{};
}

vec3& radianceOf(DirectionalLight& light) {
    return light.irradiance;
}
vec3& radianceOf(auto& light) {
    return light.radiance;
}

/// A device, its film, and what was uploaded.
struct Made {
    std::unique_ptr<Device> device = makeCpuDevice();
    std::unique_ptr<Accumulator> film;

    Made(const Scene& scene, const Schedule& schedule) {
        (void)device->upload(scene);
        film = *device->film(scene.film, 9, schedule);
    }
};

/// Paints made-up frames: value(x, y, number, channel).
class Painter final : public FrameSampler {
  public:
    using Value = std::function<float(ivec2 pixel, std::uint64_t number, int channel)>;
    explicit Painter(Value value) : value_(std::move(value)) {}

    void restart(const Tile& area) override { size_ = {area.width, area.height}; }
    Result<void> sample(std::uint64_t number, SampledPixel* frame, std::stop_token) override {
        for (int i = 0; i < size_.x * size_.y; ++i) {
            frame[i] = {vec3(0), 1};
            for (int channel = 0; channel < 3; ++channel)
                frame[i].radiance[channel] = value_({i % size_.x, i / size_.x}, number, channel);
            if (!(frame[i].radiance.x >= 0))
                frame[i] = {vec3(0), 0};
        }
        return {};
    }
    Result<Health> takeHealth() override { return Health{}; }
    std::shared_ptr<const PreparedScene> scene() const override { return nullptr; }
    FlatScene sceneOnDevice() const override { return {}; }

  private:
    ivec2 size_{0};
    Value value_;
};

std::unique_ptr<Accumulator> painted(HostGpu& gpu, ivec2 size, const Schedule& schedule, Painter::Value value) {
    return *KroesAccumulator<HostGpu>::make(gpu, wholeImage(size), 1, schedule,
                                            std::make_unique<Painter>(std::move(value)));
}

vec3 mean(Accumulator& film, int x, int y) {
    return vec3((*film.film())->pixel(x, y).mean);
}

}  // namespace

class ScheduleTest : public QObject {
    Q_OBJECT

  private slots:
    void whereOnlyTheOrderDiffersTheImageIsOursBitByBit_data() {
        QTest::addColumn<Estimator>("estimator");
        QTest::addColumn<Model>("model");
        QTest::newRow("unbiased") << Estimator::unbiased << Model::singleScattering;
        QTest::newRow("kroesMarch") << Estimator::kroesMarch << Model::singleScattering;
        QTest::newRow("all orders") << Estimator::unbiased << Model::multipleScattering;
        QTest::newRow("no scattering") << Estimator::unbiased << Model::emissionAbsorption;
    }
    void whereOnlyTheOrderDiffersTheImageIsOursBitByBit() {
        QFETCH(Estimator, estimator);
        QFETCH(Model, model);
        Scene scene = someScene(estimator);
        scene.model = model;
        Made ours(scene, kOurs), theirs(scene, kOrderOnly);
        for (const std::uint32_t n : {1u, 5u, 57u, 1u, 70u}) {  // before, at and after 64, where a block is full
            accumulated(*ours.film, n);
            accumulated(*theirs.film, n);
            const auto a = *ours.film->film(), b = *theirs.film->film();
            QCOMPARE(b->samplesPerPixel(), a->samplesPerPixel());
            QCOMPARE(b->revision(), std::uint64_t(9));
            QVERIFY(test::sameBits(*a, *b));
            const Image left = shown(*ours.film, {0.5f}), right = shown(*theirs.film, {0.5f});
            QVERIFY(left.rgba.size() == 4 * 37 * 26 && left.rgba == right.rgba);
            QCOMPARE(right.status.meanLuminance, left.status.meanLuminance);
            QVERIFY(right.status.relativeError == left.status.relativeError);
            QVERIFY(right.status.displayError == left.status.displayError);
            QVERIFY(right.status.tissuePixels == left.status.tissuePixels && left.status.tissuePixels > 0);
            QVERIFY(sameBits(a->content(), b->content()));
            QVERIFY(left.status.meanLuminance > 0);
        }
    }

    void whatIsSentAgainChangesNothing() {
        const Scene scene = someScene(Estimator::kroesMarch);
        Schedule redundant = kFiltered;
        redundant.redundant = true;
        Made k0(scene, redundant), k1(scene, kFiltered);
        accumulated(*k0.film, 5);
        accumulated(*k1.film, 5);
        QVERIFY(shown(*k0.film).rgba == shown(*k1.film).rgba);
        const auto a = *k0.film->film(), b = *k1.film->film();
        for (int i = 0; i < scene.film.x * scene.film.y; ++i)
            QVERIFY(a->pixel(i % scene.film.x, i / scene.film.x).mean ==
                    b->pixel(i % scene.film.x, i / scene.film.x).mean);
        const Schedule resent{Schedule::Kind::kroes, true, false, false};
        Made all(scene, resent), ours(scene, kOurs);
        accumulated(*all.film, 66);
        accumulated(*ours.film, 66);
        QVERIFY(test::sameBits(**all.film->film(), **ours.film->film()));
    }

    /// Kroes' A += (x - A) / max(N, 1), in single precision, written out.
    void theRunningMeanThrowsTheFirstIterationAway() {
        HostGpu gpu;
        const auto value = [](ivec2 pixel, std::uint64_t number, int channel) {
            return 0.1f * float(pixel.x + 1) * float((number + 1) * (number + 1)) + float(channel);
        };
        const auto film = painted(gpu, {3, 1}, kRunningMean, value);
        const std::uint64_t effective[] = {1, 1, 2, 3, 4};
        for (std::uint64_t done = 0; done < 5; ++done) {
            accumulated(*film, 1);
            for (int x = 0; x < 3; ++x)
                for (int channel = 0; channel < 3; ++channel) {
                    float a = 0;
                    for (std::uint64_t i = 0; i <= done; ++i)
                        a += (value({x, 0}, i, channel) - a) / std::max(float(i), 1.0f);
                    QVERIFY(mean(*film, x, 0)[channel] == a);
                }
            QCOMPARE((*film->film())->pixel(0, 0).count, effective[done]);
        }
        QCOMPARE(mean(*film, 0, 0).x, 0.1f * (4 + 9 + 16 + 25) / 4);  // mean of the second to the fifth
        const FilmStatus status = shown(*film).status;
        QCOMPARE(status.samplesPerPixel, std::uint64_t(5));
        QVERIFY(std::isinf(status.relativeError) && std::isinf((*film->film())->status().relativeError));
    }

    void aSampleThatIsNoRadianceLeavesTheMeanAsItIs() {
        HostGpu gpu;
        for (const Schedule& schedule : {kRunningMean, kOrderOnly, kFiltered}) {
            const auto film = painted(gpu, {5, 4}, schedule, [](ivec2 pixel, std::uint64_t number, int) {
                return pixel == ivec2(2, 1) && number == 2 ? -1.0f : 3.0f;
            });
            accumulated(*film, 4);
            for (int i = 0; i < 20; ++i)
                QVERIFY(std::fabs(mean(*film, i % 5, i / 5).x - 3) < 1e-5f);
        }
    }

    /// There are too many iterations for any noise, and the edge is as soft as after the first one: the limit is the
    /// blurred truth.
    void theFilterNeverAveragesOut() {
        HostGpu gpu;
        const auto checker = [](ivec2 pixel, std::uint64_t, int) {
            return (pixel.x / 4 + pixel.y / 4) % 2 == 0 ? 1.0f : 0.0f;
        };
        const ivec2 size(16, 16);
        const auto film = painted(gpu, size, kFiltered, checker), sharp = painted(gpu, size, kRunningMean, checker);
        accumulated(*film, 300);
        accumulated(*sharp, 300);
        const auto weight = [&](ivec2 at, ivec2 offset) {
            const auto axis = [](int place, int step, int end) {
                const auto there = [&](int o) { return place + o >= 0 && place + o < end; };
                const auto w = [](int o) { return o == 0 ? 0.4110 : 0.2945; };
                double sum = 0;
                for (int o = -1; o <= 1; ++o)
                    sum += there(o) ? w(o) : 0;
                return there(step) ? w(step) / sum : 0;
            };
            return axis(at.x, offset.x, size.x) * axis(at.y, offset.y, size.y);
        };
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                double limit = 0;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        if (const double w = weight({x, y}, {dx, dy}); w > 0)
                            limit += w * double(checker({x + dx, y + dy}, 0, 0));
                QVERIFY(std::fabs(mean(*film, x, y).x - limit) < 1e-6);
                QCOMPARE(mean(*sharp, x, y).x, checker({x, y}, 0, 0));
            }
        QVERIFY(mean(*film, 3, 2).x < 0.75f && mean(*film, 4, 2).x > 0.25f);
    }

    /// kappa, the share of the variance that the filter leaves; 10 seeds. False alarms: 1 in 10,000 at most.
    void theFilterLeavesTheKnownShareOfWhiteNoise() {
        HostGpu gpu;
        const ivec2 size(200, 200);
        test::Sample squares;
        for (unsigned seed = 0; seed < 10; ++seed) {
            std::mt19937 random(seed);
            std::uniform_real_distribution<float> unit(0, 1);
            const auto film = painted(gpu, size, kFiltered, [&](ivec2, std::uint64_t, int) { return unit(random); });
            accumulated(*film, 1);
            const auto known = *film->film();
            test::Sample pixels;
            for (int y = 1; y < size.y - 1; y += 3)  // three apart they share no noise
                for (int x = 1; x < size.x - 1; x += 3)
                    pixels.add(known->pixel(x, y).mean.y);
            squares.add(pixels.variance() * 12);
        }
        qInfo("kappa %.4f +- %.4f", squares.mean(), squares.standardError());
        QVERIFY(squares.standardError() < 0.002);
        QVERIFY(std::fabs(squares.mean() - 0.1172) < 8 * squares.standardError());  // t of 9 degrees of freedom
    }

    void aResumedFilmGoesOnAsIfItHadNeverStopped() {
        const Scene scene = someScene(Estimator::unbiased);
        for (const Schedule& schedule : {kOrderOnly, kRunningMean, kFiltered}) {
            Made whole(scene, schedule), first(scene, schedule), second(scene, schedule);
            accumulated(*whole.film, 70);
            accumulated(*first.film, 33);
            accumulated(*second.film, 2);
            QVERIFY(bool(second.film->resume(**first.film->film())));
            QVERIFY(shown(*second.film).rgba == shown(*first.film).rgba);
            accumulated(*second.film, 37);
            QVERIFY(shown(*second.film).rgba == shown(*whole.film).rgba);
            const auto a = *whole.film->film(), b = *second.film->film();
            QCOMPARE(b->samplesPerPixel(), std::uint64_t(70));
            for (int i = 0; i < scene.film.x * scene.film.y; ++i) {
                const ivec2 pixel(i % scene.film.x, i / scene.film.x);
                QVERIFY(a->pixel(pixel.x, pixel.y).mean == b->pixel(pixel.x, pixel.y).mean);
                QVERIFY(a->pixel(pixel.x, pixel.y).count == b->pixel(pixel.x, pixel.y).count);
            }
        }
    }

    void displayChangesWithoutAnIteration() {
        Made made(someScene(Estimator::unbiased), kRunningMean);
        accumulated(*made.film, 3);
        const Image bright = shown(*made.film, {0.1f}), dark = shown(*made.film, {10});
        QVERIFY(bright.rgba != dark.rgba);
        QVERIFY(dark.rgba == toneMap(**made.film->film(), {10}));
        QVERIFY(bright.rgba == toneMap(**made.film->film(), {0.1f}));
        QCOMPARE(dark.status.samplesPerPixel, std::uint64_t(3));
        accumulated(*made.film, 1);
        QVERIFY(shown(*made.film, {10}).rgba == toneMap(**made.film->film(), {10}));
    }

    void faultsAreCountedAsOursAre() {
        Scene scene = someScene(Estimator::unbiased);
        Made ours(scene, kOurs), theirs(scene, kOrderOnly);
        for (Made* made : {&ours, &theirs}) {
            Scene wrong = scene;  // this scene would not pass Scene::check()
            for (Light& light : wrong.lights)
                std::visit([](auto& one) { radianceOf(one) = vec3(-1, 1, 1); }, light);
            (void)made->device->upload(wrong);
            accumulated(*made->film, 3);
        }
        const Health a = shown(*ours.film).status.health, b = shown(*theirs.film).status.health;
        QVERIFY(a.rejected() > 0);
        for (int i = 0; i < kFaults; ++i) {
            QCOMPARE(b.faults[i].count, a.faults[i].count);
            QCOMPARE(b.faults[i].sample, a.faults[i].sample);
            QCOMPARE(b.faults[i].pixel, a.faults[i].pixel);
        }
        QVERIFY(test::sameBits(**ours.film->film(), **theirs.film->film()));
    }

    void aCancelledIterateReturnsWithinOneIteration() {
        HostGpu gpu;
        std::stop_source stop;
        std::uint64_t last = 0;
        const auto film = painted(gpu, {2, 2}, kFiltered, [&](ivec2, std::uint64_t number, int) {
            last = number;
            if (number == 3)
                stop.request_stop();
            return 1.0f;
        });
        QVERIFY(bool(film->accumulate(1000000000, stop.get_token())));
        QCOMPARE(last, std::uint64_t(3));
        QVERIFY(bool(film->accumulate(1000000000, stop.get_token())));
        QCOMPARE(last, std::uint64_t(3));
        QCOMPARE(shown(*film).status.samplesPerPixel, std::uint64_t(3));
    }
};

QTEST_GUILESS_MAIN(ScheduleTest)
#include "schedule_test.moc"
