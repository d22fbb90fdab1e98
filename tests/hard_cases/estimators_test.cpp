/// Hard cases 52 to 60: ends of paths, errors, machines and merging. Each naive form is written out and must fail.

#include <QTest>

#include <algorithm>
#include <atomic>
#include <random>

#include "render/accuracy/forecast.h"
#include "render/device/cpu/replay.h"
#include "render/film/display/tone_map.h"
#include "tests/hard_cases/trusting_is_nan.h"
#include "tests/support/devices/screen.h"
#include "tests/support/scenes/images.h"
#include "tests/support/scenes/one_pixel.h"

using namespace pdr;

namespace {

/// A white slab in a white room, of optical depth 100 and g = 0.9: only the cap on a path's length can darken it.
test::ImageMean whiteRoom(int maxBounces, Health& health) {
    Scene scene = test::slab(100, {0, 0, -1}, 1);
    scene.model = Model::multipleScattering;
    scene.maxBounces = maxBounces;
    scene.phaseG = 0.9f;
    scene.lights.clear();
    scene.environment = {vec3(1), true};
    const Film film = test::render(scene, 192);
    health = film.status().health;
    return test::imageMean(film);
}

/// Returns whether light of optical depth `thickness` in steps of `step` gets through Kroes' march: jittered start, a
/// threshold, binary.
bool kroesMarchPasses(double thickness, double step, double u, double jitter) {
    const double threshold = -std::log(u);
    double sum = 0;
    for (double t = jitter * step; t < thickness; t += step)
        if ((sum += step) >= threshold)
            return false;
    return true;
}

/// A film of one pixel that is given whole blocks: `counts` samples of mean `means`, spread +-1.
PixelEstimate merged(std::span<const std::pair<std::uint32_t, double>> blocks) {
    Film film(ivec2(1, 1), 0);
    for (const auto& [count, mean] : blocks) {
        *film.sums(test::kOnePixel).pixels = {
            .sum = dvec3(count * mean), .sumOfSquares = dvec3(count * (mean * mean + 1)), .count = count};
        film.commit({film.samplesPerPixel(), 64});
    }
    return film.pixel(0, 0);
}

Scene litBumps() {
    Scene scene = test::plainScene(test::bumpyVolume({30, 28, 26}, dvec3(1), 3), 2);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 600, .opacity = 1}};
    scene.environment = {vec3(0.5f), true};
    scene.model = Model::multipleScattering;
    scene.gradientFactor = 1;
    scene.film = {23, 19};
    return scene;
}

}  // namespace

class EstimatorsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Case 52. Ended after some events a white room is grey; ended by roulette it stays white, and what a cap cuts is
    /// counted: the light that is missing is at most what the cut samples would still have brought, 1 each. Without a
    /// cap every path brings the room's light from where it leaves, so the room is white sample by sample.
    void cappedPathsDarkenAWhiteRoom() {
        Health health;
        const test::ImageMean free = whiteRoom(100'000, health);
        QCOMPARE(free.mean, 1.0);
        QCOMPARE(free.standardError, 0.0);
        QVERIFY(health.perfect());
        const test::ImageMean capped = whiteRoom(20, health);
        QVERIFY(capped.mean < 1 - 10 * capped.standardError);
        const double cutShare = double(health.of(Fault::cutPath).count) / (16 * 192);
        QVERIFY(cutShare > 0.1 && 1 - capped.mean < cutShare + 4 * capped.standardError);
    }

    /// Case 53. Naive roulette survives with probability q = throughput: 0 / 0, and at q > 1 light is thrown away.
    void rouletteDividesByZeroOrByMoreThanOne() {
        const auto naive = [](float throughput, float u) { return u <= throughput ? throughput / throughput : 0; };
        QVERIFY(std::isnan(naive(0, 0)) && naive(3, 0.5f) == 1);
        for (const float throughput : {1e-38f, 1e-6f, 0.1f, 0.2499f, 0.25f, 1.0f, 3.0f, 1e30f}) {
            double mean = 0;
            const int draws = throughput < 1e-3f ? 1 << 20 : 1 << 14;
            for (int i = 0; i < draws; ++i) {  // u evenly, as the generator can give it
                vec3 kept(throughput, 0.5f * throughput, 0);
                if (russianRoulette(kept, (float(i) + 0.5f) / float(draws))) {
                    QVERIFY(kept.x >= throughput && kept.y == 0.5f * kept.x && kept.x >= 0.2499f);
                    mean += kept.x / draws;
                }
            }
            QVERIFY(std::fabs(mean - throughput) <= 2e-3 * throughput + 0.25 / draws);
        }
        vec3 nothing(0), noNumber(NAN);
        QVERIFY(!russianRoulette(nothing, 0x1p-24f));
        QVERIFY(russianRoulette(noNumber, 0.9f));  // it is met again at the pixel, and counted there
    }

    /// Case 54, the negative control: the test that our tracker passes must fail for a marcher.
    void marchInStepsOfTwoMeanFreePathsIsBiased() {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> u(1e-12, 1);
        const auto prepared = Flattener().prepare(
            test::plainScene(test::makeVolume({50, 4, 4}, dvec3(0.1), [](int, int, int) { return 0; }), 1));
        for (const double step : {0.5, 1.0, 2.0}) {
            test::Sample march, ours;
            const double thickness = 2.5 * step, truth = std::exp(-thickness);
            for (int i = 0; i < 600'000; ++i) {  // the smallest bias, 3.1 %, is then 15 standard errors
                const double jitter = u(random), threshold = u(random);
                march.add(kroesMarchPasses(thickness, step, threshold, jitter));
                const RandomStream numbers = Random(54, unsigned(i), 0).stream(0, BounceDimension::shadow);
                ours.add(track<RatioTracking>(prepared->flat, {{-0.5f, 1, 1}, {10, 0, 0}, float(thickness)}, numbers));
            }
            qInfo("step %.1f: march %+.0f %%, ours %+.2f %%", step, 100 * (march.mean() / truth - 1),
                  100 * (ours.mean() / truth - 1));
            QVERIFY(march.z(truth) > 10);
            QVERIFY(std::fabs(ours.z(truth)) < test::allowedZ(3));
        }
    }

    /// Case 55. Pixels that have seen nothing yet are no pixels without noise: stopped one by one they stay black.
    void pixelsThatSawNothingAreStopped() {
        const auto value = [](int pixel, int sample) {
            return Random(55, unsigned(pixel), unsigned(sample)).stream(Dimension::filter).pair().x < 1e-3f ? 1000.0f
                                                                                                            : 0.0f;
        };
        const double target = 0.5;
        const int edge = 24;
        double naive = 0;
        for (int pixel = 0; pixel < edge * edge; ++pixel) {
            test::Sample sample;
            for (int n = 0; n < 20'000 && !(n >= 16 && sample.standardError() <= target * sample.mean()); ++n)
                sample.add(value(pixel, n));
            naive += sample.mean() / (edge * edge);
        }
        QVERIFY2(naive < 0.2, qPrintable(QString::number(naive)));

        Film film(ivec2(edge, edge), 0);  // all pixels go on until the error of the whole image is small
        do {
            const SampleRange range = film.nextSamples(64);
            for (int pixel = 0; pixel < edge * edge; ++pixel)
                for (std::uint32_t i = 0; i < range.count; ++i)
                    addSample(film.sums({0, 0, edge, edge}).pixels[pixel], vec3(value(pixel, int(range.first + i))),
                              range.first + i);
            film.commit(range);
        } while (film.status().relativeError > target);
        QVERIFY(film.samplesPerPixel() > 2000);  // (1000 - 1) / 0.5^2 = 4000 are expected
        QVERIFY(std::fabs(test::z(film, 1)) < test::allowedZ(1));
    }

    /// Case 56, the processor's side. Nothing is compiled with fast-math, denormals stay, and one path alone is the
    /// same as among sixteen in step.
    void fastMathRemovesTheTestsForNan() {
        volatile float noNumber = NAN, tiny = 1e-40f;
        QVERIFY(!test::trustingIsNan(noNumber));
        QVERIFY(noNumber != noNumber && !(noNumber >= 0) && tiny * 0.5f > 0);
        PixelSums sums;
        QVERIFY(!addSample(sums, vec3(noNumber), 0));
        const auto prepared = Flattener().prepare(litBumps());
        const auto device = makeCpuDevice(1);
        const Film film = test::sampled(prepared, 1);
        for (int y = 0; y < film.size().y; ++y)
            for (int x = 0; x < film.size().x; ++x)
                QVERIFY(film.pixel(x, y).mean == dvec3(replayed(*prepared, {x, y}, 0).radiance));
    }

    /// Case 57, the processor's side. A buffer that the next frame is written to while this one is shown tears; a frame
    /// here is a value. Scenes that are wholly white or wholly black, edited while they are rendered.
    void frameIsTornByTheNextOne() {
        std::vector<int> shared(8, 1), shown(8);
        std::copy_n(shared.begin(), 4, shown.begin());
        shared.assign(8, 2);  // the next frame comes in between
        std::copy_n(shared.begin() + 4, 4, shown.begin() + 4);
        QVERIFY(shown.front() != shown.back());

        std::atomic<int> frames = 0, torn = 0;
        const auto look = [&](std::shared_ptr<const Frame> frame) {
            const std::uint8_t level = frame->revision % 2 ? 255 : 0;
            for (std::size_t i = 0; i < frame->rgba.size(); i += 4)
                torn += frame->rgba[i] != level;
            ++frames;
        };
        Scene scene = test::plainScene(test::makeVolume({1, 1, 1}, dvec3(1), [](int, int, int) { return 0; }), 0);
        scene.film = {64, 48};
        Session session(test::testedDevice(), look);
        while (frames < 600) {
            ++scene.revision;
            scene.environment = {vec3(scene.revision % 2 ? 100.0f : 0.0f), true};
            session.submit(scene, scene.revision % 3 == 0);
            std::this_thread::sleep_for(std::chrono::microseconds(scene.revision % 7 * 100));
        }
        qInfo("%d frames of %llu scenes", frames.load(), static_cast<unsigned long long>(scene.revision));
        QCOMPARE(torn.load(), 0);
    }

    /// Case 58, the sums. Means of parts that hold none, one, or a billion samples.
    void mergingMeansOfUnequalParts() {
        const double naiveEqual = (2.0 + 5.0) / 2, nothing = 0;
        QVERIFY(std::fabs(naiveEqual - 2) > 1 && std::isnan(nothing / nothing));
        std::vector<std::pair<std::uint32_t, double>> parts{
            {1'000'000'000, 2}, {1, 5}, {0, 7}, {64, -3}, {3'000'000, 2.5}};
        double count = 0, sum = 0;
        for (const auto& [n, mean] : parts) {
            count += n;
            sum += n * mean;
        }
        std::sort(parts.begin(), parts.end());
        const PixelEstimate first = merged(parts);
        QVERIFY(std::fabs(first.mean.x / (sum / count) - 1) < 1e-14);
        double squares = 0;
        for (const auto& [n, mean] : parts)
            squares += n * (1 + (mean - sum / count) * (mean - sum / count));
        QVERIFY(std::fabs(first.standardError.x / std::sqrt(squares / count / (count - 1)) - 1) < 1e-9);
        do {
            const PixelEstimate other = merged(parts);
            QCOMPARE(other.count, std::uint64_t(count));
            QVERIFY(std::fabs(other.mean.x / first.mean.x - 1) < 1e-14);
            QVERIFY(std::fabs(other.standardError.x / first.standardError.x - 1) < 1e-9);
        } while (std::next_permutation(parts.begin(), parts.end()));
    }

    /// Case 59. A filter over three pixels, run on each tile alone, leaves a seam at its edge. There is none here.
    void tilesShowASeam() {
        const auto filtered = [](const std::vector<double>& row, int from, int to, int x) {
            const auto at = [&](int i) { return row[std::size_t(std::clamp(i, from, to - 1))]; };
            return 0.2945 * at(x - 1) + 0.411 * at(x) + 0.2945 * at(x + 1);
        };
        const std::vector<double> row{1, 5, 2, 8, 3, 9, 4, 7};
        QVERIFY(filtered(row, 0, 4, 3) != filtered(row, 0, 8, 3));
        const auto device = test::testedDevice();
        const Film whole = test::render(litBumps(), 66, *device);
        for (const int tile : {1, 5, 16}) {
            const Film tiled = test::render(litBumps(), 66, *device, 64, tile);
            QVERIFY(test::sameBits(whole, tiled) && toneMap(whole, {}) == toneMap(tiled, {}));
        }
    }

    /// Case 60. No time, no speed, no iterations, one pixel.
    void noTimeGivesNoSpeed() {
        QVERIFY(std::isnan(0.0 / 0.0) && std::isinf(1 / 0.0));  // efficiency and frames per second of no time
        for (const double seconds : {100.0, 99.0, double(NAN)}) {
            ErrorHistory history;
            history.add(100, {.samplesPerPixel = 500, .displayError = 16});
            history.add(seconds, {.samplesPerPixel = 1000, .displayError = 12});
            QVERIFY(history.steps().empty());
        }
        ErrorHistory history;
        history.add(0, {});
        history.add(100, {.samplesPerPixel = 1000, .displayError = 12});
        QVERIFY(history.steps()[2].levels == 8 && history.steps()[2].seconds.value > 150);
        QVERIFY(std::isinf(samplesToReach(0.01, INFINITY, 1)));

        test::Screen screen;
        Session session(test::testedDevice(), screen.sink());
        for (const int n : {0, -5}) {  // taken as 1
            session.setIterationsPerFrame(n);
            Scene scene = litBumps();
            scene.film = {1, 1};
            scene.revision = std::uint64_t(10 + n);
            session.submit(scene, false);
            const auto frame = screen.await([&](const Frame& shown) {
                return shown.revision == scene.revision && shown.status.samplesPerPixel >= 3;
            });
            QVERIFY(frame && std::isfinite(frame->iterationsPerSecond) && frame->iterationsPerSecond > 0);
        }
    }
};

QTEST_GUILESS_MAIN(EstimatorsTest)
#include "estimators_test.moc"
