/// Hard cases 11 to 17: random numbers. Each naive form is written out and must fail. Thresholds: 1e-6 for each
/// comparison, fixed seeds.

#include <QTest>

#include <array>
#include <random>

#include "render/kernel/transport/integrator.h"
#include "tests/support/devices/fake_clock.h"
#include "tests/support/devices/screen.h"
#include "tests/support/scenes/images.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

constexpr double kAlarm = 1e-6;

RandomStream stream(int path) {
    return Random(17, unsigned(path), 1).stream(0, BounceDimension::distance);
}

/// Marsaglia's multiply-with-carry as Exposure Render uses it: 23 bits of two 16-bit generators.
float multiplyWithCarry(std::uint32_t& z, std::uint32_t& w) {
    z = 36969 * (z & 65535) + (z >> 16);
    w = 18000 * (w & 65535) + (w >> 16);
    return float(((z << 16) + w) & 0x7FFFFF) * 0x1p-23f;
}

/// A stream whose next word is `word`: the generator run backwards.
RandomStream streamOfWord(std::uint64_t word) {
    const std::uint64_t factor = 0x94D049BB133111EBull;
    std::uint64_t inverse = factor;  // modulo 2^64, by Newton's method
    for (int i = 0; i < 6; ++i)
        inverse *= 2 - factor * inverse;
    const std::uint64_t mixed = (word ^ (word >> 31) ^ (word >> 62)) * inverse;
    std::uint64_t x = 0x9E3779B97F4A7C15ull;  // the counter's first step, from 0
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
    return {{0, x ^ (x >> 27) ^ mixed}};
}

int distinct(std::vector<float> values) {
    std::sort(values.begin(), values.end());
    return int(std::unique(values.begin(), values.end()) - values.begin());
}

/// Correlation of x[i] with x[i + lag], in units of its standard error.
double correlation(const std::vector<float>& x, int lag) {
    double sum = 0;
    const int n = int(x.size()) - lag;
    for (int i = 0; i < n; ++i)
        sum += (x[std::size_t(i)] - 0.5) * (x[std::size_t(i + lag)] - 0.5);
    return 12 * sum / std::sqrt(double(n));
}

/// Kolmogorov-Smirnov distance of numbers from the uniform distribution.
double distanceFromUniform(std::vector<float> values) {
    std::sort(values.begin(), values.end());
    double worst = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        worst = std::max({worst, std::fabs(double(i) / double(values.size()) - values[i]),
                          std::fabs(double(i + 1) / double(values.size()) - values[i])});
    return worst;
}

Scene smallScene() {
    Scene scene = test::plainScene(test::bumpyVolume({20, 20, 20}, dvec3(1), 3), 2);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0, .albedo = vec3(0.1f)},
                                    {.hu = 600, .opacity = 1, .albedo = vec3(0.5f)},
                                    {.hu = 2000, .opacity = 1, .albedo = vec3(1)}};
    scene.environment = {vec3(1), false};
    scene.film = {19, 13};
    return scene;
}

}  // namespace

class RandomNumbersTest : public QObject {
    Q_OBJECT

  private slots:
    /// Case 11. The two ends of what the generator gives, forced into all that draws numbers.
    void extremeNumbersGiveInfinityOrAnIndexTooFar() {
        QVERIFY(std::isinf(-std::log(0.0f * 0x1p-23f)));
        const int lights = 10;
        QCOMPARE(int(float(~0u) * 0x1p-32f * lights), lights);  // float(2^32 - 1) is 2^32

        const vec2 lowest = streamOfWord(0).pair(), highest = streamOfWord(~0ull).pair();
        const float low = lowest.x, high = highest.x;
        QVERIFY(low == 0x1p-24f && lowest.y == low && high == 1 - 0x1p-24f && highest.y == high);
        QVERIFY(negativeLog(low) < 17.33f && negativeLog(low) > 16.6f && negativeLog(high) > 0);
        FlatLight panel{.type = LightType::rectangle, .radiance = vec3(1)};
        panel.normal = vec3(0, 0, -1), panel.halfU = vec3(2, 0, 0), panel.halfV = vec3(0, 3, 0), panel.area = 24;
        const Material shiny{vec3(0.5f), vec3(0), vec3(0.04f), 0.1f};
        for (const vec2 u : {vec2(low, low), vec2(low, high), vec2(high, low), vec2(high, high)}) {
            for (const float g : {0.0f, 0.9999f, -0.9999f})
                QVERIFY(std::fabs(glm::length(phaseSample(g, vec3(0, 0, 1), u)) - 1) < 1e-6f);
            for (const float choice : {low, high})
                QVERIFY(std::fabs(glm::length(surfaceSample(shiny, {0, 0, 1}, {0, 0.6f, 0.8f}, choice, u)) - 1) <
                        1e-5f);
            const LightSample light = sampleRectangle(panel, vec3(0, 0, -5), u);
            QVERIFY(std::isfinite(light.radiance.x) && light.radiance.x > 0 && light.distance >= 5);
            LightReservoir choice(u.x);
            for (int i = 0; i < lights; ++i)
                choice.offer(true, vec3(float(i)), 1, vec3(i < 9 ? 1.0f : 0.0f));
            QVERIFY(choice.radianceOfAll().x > 0 && choice.wi.x < 9);  // never the dark one
        }
    }

    /// Case 12. One word of the state is 0: 128 values, 0.8 % of them zero.
    void zeroKeyLeaves128Values() {
        std::vector<float> naive, ours;
        std::uint32_t z = 123456789, w = 0;
        for (int i = 0; i < 100'000; ++i)
            naive.push_back(multiplyWithCarry(z, w));
        QCOMPARE(distinct(naive), 128);
        QVERIFY(std::count(naive.begin(), naive.end(), 0.0f) > 500);
        for (const std::uint64_t seed : {0ull, ~0ull, 0ull - 0x9E3779B97F4A7C15ull}) {  // the last: mixBits(0)
            RandomStream random = Random(seed, 0, 0).stream(Dimension::filter);
            std::array<double, 256> bins{};
            ours.clear();
            for (int i = 0; i < 100'000; ++i) {
                ours.push_back(random.pair().x);
                ++bins[std::size_t(ours.back() * 256)];
            }
            QVERIFY(test::uniformP(bins) > kAlarm);
            QVERIFY(distinct(ours) > 99'000);  // 99406 of 2^23 are expected
            QCOMPARE(std::count(ours.begin(), ours.end(), 0.0f), 0);
        }
    }

    /// Case 13. A generator that is drawn from pixel after pixel gives another image when tiles change.
    void consumedNumbersMakeTheImageDependOnTiles() {
        const auto naive = [](int tile) {
            std::mt19937 generator(1);
            std::array<unsigned, 64> image{};
            for (int first = 0; first < 8; first += tile)  // columns in tiles, rows inside
                for (int y = 0; y < 8; ++y)
                    for (int x = first; x < std::min(first + tile, 8); ++x)
                        image[std::size_t(8 * y + x)] = unsigned(generator());
            return image;
        };
        QVERIFY(naive(8) != naive(3));
        const auto one = makeCpuDevice(1), two = makeCpuDevice(2);
        const Film whole = test::render(smallScene(), 70, *one);
        for (const int tile : {1, 2, 3, 7})
            for (const std::uint32_t n : {1u, 9u, 64u})
                QVERIFY(test::sameBits(whole, test::render(smallScene(), 70, tile % 2 ? *one : *two, n, tile)));
    }

    /// Case 14. The first numbers of neighbouring pixels and of successive samples, over 64 lags.
    void neighbouringPixelsAreCorrelated() {
        const auto worst = [](auto&& number) {
            std::vector<float> x;
            for (int i = 0; i < 100'000; ++i)
                x.push_back(number(i));
            double result = 0;
            for (int lag = 1; lag <= 64; ++lag)
                result = std::max(result, std::fabs(correlation(x, lag)));
            return result;
        };
        const double bound = test::allowedZ(64, kAlarm);
        // A linear congruential generator seeded with the pixel's number: the first number hardly depends on it.
        QVERIFY(worst([](int i) { return float((1664525u * unsigned(i) + 1013904223u) >> 8) * 0x1p-24f; }) > bound);
        QVERIFY(worst([](int i) { return Random(1, unsigned(i), 5).stream(Dimension::filter).pair().x; }) < bound);
        QVERIFY(worst([](int i) { return Random(1, 7, unsigned(i)).stream(Dimension::filter).pair().x; }) < bound);
        QVERIFY(worst([](int i) { return Random(unsigned(i), 7, 5).stream(Dimension::filter).pair().x; }) < bound);
    }

    /// Case 14, two machines given the same seed: their images are equal bit by bit, which no two seeds' are.
    void twoMachinesWithTheSameSeedAddNothing() {
        const auto device = test::testedDevice();
        Scene scene = smallScene();
        const Film first = test::render(scene, 8, *device), same = test::render(scene, 8, *device);
        scene.seed = 2;
        const Film other = test::render(scene, 8, *device);
        int equal = 0, noisy = 0;
        for (int y = 0; y < 13; ++y)
            for (int x = 0; x < 19; ++x) {
                if (first.pixel(x, y).standardError.x == 0)
                    continue;
                ++noisy;
                equal += first.pixel(x, y).mean == other.pixel(x, y).mean;
                QVERIFY(first.pixel(x, y).mean == same.pixel(x, y).mean);
            }
        QVERIFY2(noisy > 50 && equal == 0, qPrintable(QString("%1 of %2").arg(equal).arg(noisy)));
    }

    /// Case 15. The same numbers in every frame of a drag: the grain stays on the screen while the image moves
    /// beneath.
    void grainSticksToTheScreenWhileTheCameraMoves() {
        const auto device = test::testedDevice();
        QVERIFY(test::sameBits(test::render(smallScene(), 4, *device), test::render(smallScene(), 4, *device)));
        test::Screen screen;
        // No time passes on its clock: how coarse a moving image is must not depend on how busy the machine is.
        Session session(test::testedDevice(), screen.sink(), DeviceOpener(),
                        test::readingOf(std::make_shared<test::FakeClock>()));
        session.setPaused(true);  // each scene is shown once
        const auto frame = [&](std::uint64_t revision, bool moving) {
            Scene scene = smallScene();
            scene.film = {96, 64};
            scene.revision = revision;
            session.submit(scene, moving);
            return screen.await([&](const Frame& shown) { return shown.revision == revision; })->rgba;
        };
        const auto a = frame(1, true), b = frame(2, true), c = frame(3, true), d = frame(4, true);
        QVERIFY(a.size() == b.size() && b.size() == c.size() && c.size() == d.size());
        double product = 0, first = 0, second = 0;
        for (std::size_t i = 0; i < a.size(); i += 4) {
            product += (a[i] - b[i]) * (c[i] - d[i]);
            first += (a[i] - b[i]) * (a[i] - b[i]);
            second += (c[i] - d[i]) * (c[i] - d[i]);
        }
        QVERIFY(first > 0 && second > 0);
        // At least 1000 noisy pixels: 5 standard errors of the correlation of independent noise.
        QVERIFY(std::fabs(product) / std::sqrt(first * second) < 5 / std::sqrt(1000.0));
        QVERIFY(frame(5, false) == frame(6, false));  // and at rest the image is the same every time
    }

    /// Case 16. One number, rescaled in single precision from cell to cell, has few values left deep inside; ours
    /// carries the optical depth instead. 64 cells of total depth up to 17: all free paths together stay exponential.
    void rescaledNumberRunsOutOfBitsInDepth() {
        std::mt19937 generator(5);
        std::vector<float> naive;
        for (int i = 0; i < 20'000; ++i) {
            const double survivor = std::exp(-15.0) * (double(generator()) + 0.5) * 0x1p-32;
            float u = float(1 - survivor);  // of those that get to a depth of 15
            for (int cell = 0; cell < 60; ++cell)
                u = 1 - (1 - u) * std::exp(0.25f);
            naive.push_back(glm::clamp(u, 0.0f, 1.0f));
        }
        QVERIFY(distinct(naive) < 50 && distanceFromUniform(naive) > 0.1);

        for (const double tau : {1.0, 4.0, 9.0, 17.0}) {
            const auto prepared = test::prepared(test::plainScene(
                test::makeVolume({252, 4, 4}, dvec3(1), [](int, int, int) { return 0; }), float(tau / 252)));
            auto bounds = std::make_shared<Majorants>(*prepared->majorants);
            bounds->coarse.assign(bounds->coarse.size(), 1e6f);  // every coarse cell is to be walked cell by cell
            prepared->flat.majorants.coarse = bounds->coarse.data();
            std::array<double, 64> bins{};
            const double through = std::exp(-tau);
            double passed = 0;
            for (int i = 0; i < 100'000; ++i) {
                const float t = track<DeltaTracking>(prepared->flat, {{-0.5f, 1.5f, 1.5f}, {1, 0, 0}, 252}, stream(i));
                passed += t < 0;
                if (t >= 0)
                    ++bins[std::min(std::size_t(64 * std::expm1(-tau * t / 252) / (through - 1)), std::size_t(63))];
            }
            QVERIFY(test::uniformP(bins) > kAlarm);
            QVERIFY(std::fabs(passed - 1e5 * through) < 5 * std::sqrt(1e5 * through * (1 - through)) + 1);
        }
    }

    /// Case 17. Streams that begin 4096 numbers apart meet when a path draws more; ours of neighbouring samples, pixels
    /// and bounces share no word however long they run.
    void longPathRunsIntoItsNeighboursNumbers() {
        const auto shared = [](auto&& numbers) {
            std::vector<std::uint64_t> seen;
            for (int path = 0; path < 8; ++path)
                numbers(path, seen);
            std::sort(seen.begin(), seen.end());
            return int(seen.end() - std::unique(seen.begin(), seen.end()));
        };
        const int draws = 100'000;
        QVERIFY(shared([](int path, std::vector<std::uint64_t>& seen) {
                    for (int i = 0; i < draws; ++i)
                        seen.push_back(mixBits(std::uint64_t(path) * 4096 + unsigned(i)));
                }) > draws);
        QCOMPARE(shared([](int path, std::vector<std::uint64_t>& seen) {
                     const Random random(1, path & 1, std::uint64_t((path >> 1) & 1));
                     RandomStream numbers = random.stream(path >> 2, BounceDimension::distance);
                     for (int i = 0; i < draws; ++i) {
                         const vec2 u = numbers.pair();  // 46 of 64 bits: 0.005 chance meetings are expected
                         seen.push_back(std::uint64_t(u.x * 0x1p24f) << 32 | std::uint64_t(u.y * 0x1p24f));
                     }
                 }),
                 0);
    }
};

QTEST_GUILESS_MAIN(RandomNumbersTest)
#include "random_numbers_test.moc"
