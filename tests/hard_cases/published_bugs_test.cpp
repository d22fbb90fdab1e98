/// Bugs that respected renderers had or have, each in its naive form, which must fail, and ours, which must not. B1 to
/// B12 in README.md.

#include <QTest>

#include <random>

#include "render/kernel/transport/integrator.h"
#include "tests/support/scenes/images.h"
#include "tests/support/scenes/one_pixel.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

RandomStream stream(int path) {
    return Random(63, unsigned(path), 1).stream(0, BounceDimension::distance);
}

/// Tissue seen through a window: opaque in the middle of it, clear again above.
Scene windowed() {
    Scene scene = test::plainScene(test::bumpyVolume({33, 30, 28}, dvec3(1), 8), 2);
    scene.transferFunction.nodes = {
        {.hu = 0, .opacity = 0}, {.hu = 200, .opacity = 1}, {.hu = 500, .opacity = 1}, {.hu = 700, .opacity = 0}};
    return scene;
}

/// Returns how many of 2e5 random points have more extinction than bound(cell) says.
template <class Bound>
int violations(const PreparedScene& prepared, Bound&& bound) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> unit(0, 1);
    const ivec3 size = prepared.ranges->fineSize();
    int found = 0;
    for (int i = 0; i < 200'000; ++i) {
        const vec3 p = vec3(unit(random), unit(random), unit(random)) * vec3(prepared.volume->size()) - 0.5f;
        const ivec3 cell((p + 4.0f) / 4.0f);
        found += extinction(prepared.flat, p) > bound(std::size_t((cell.z * size.y + cell.y) * size.x + cell.x), cell);
    }
    return found;
}

/// The distance of a walker over cells of 4 voxels to its next border along one axis, as it is commonly written.
float naiveBorder(float origin, float direction) {
    const float cell = std::floor(origin / 4);
    return ((direction > 0 ? cell + 1 : cell) * 4 - origin) / direction;
}

}  // namespace

class PublishedBugsTest : public QObject {
    Q_OBJECT

  private slots:
    /// B1, volren: the opacity of a cell's highest density, taken for the highest opacity of its densities.
    void opacityOfTheHighestDensityIsNoBound() {
        const auto prepared = Flattener().prepare(windowed());
        const auto& cells = prepared->ranges->cells();
        const auto naive = [&](std::size_t cell, ivec3) {
            return cells[cell] == kEmptyRange
                       ? 0
                       : 2 * 1.00001f * opacity(prepared->flat.transferFunction, cells[cell].highest);
        };
        QVERIFY(violations(*prepared, naive) > 10'000);
        QCOMPARE(violations(*prepared, [&](std::size_t cell, ivec3) { return prepared->majorants->fine[cell]; }), 0);
    }

    /// B2, volren: an optical depth of 0 over a bound of 0.
    void noDepthOverNoBoundIsNotANumber() {
        QVERIFY(std::isnan(-std::log(1.0f - 0.0f) / 0.0f));  // u = 0 in an empty cell
        Scene scene = windowed();
        for (TransferNode& node : scene.transferFunction.nodes)
            node.opacity = 0;
        const auto prepared = Flattener().prepare(scene);
        for (int i = 0; i < 1000; ++i)
            QCOMPARE(track<RatioTracking>(prepared->flat, {{-0.5f, 14, 14}, {1, 0, 0}, 33}, stream(i)), 1.0f);
    }

    /// B3, VisRTX: a cell's range from 8 samples of it misses what lies between them.
    void rangeOfEightSamplesMissesAVoxel() {
        const auto volume = test::makeVolume({17, 17, 17}, dvec3(1), [](int i, int j, int k) {
            return i == 5 && j == 6 && k == 7 ? 1000 : 0;  // a clip of metal
        });
        int naive = 0;
        for (const int i : {0, 15})
            for (const int j : {0, 15})
                for (const int k : {0, 15})
                    naive = std::max(naive, int(volume->voxels()[std::size_t((k * 17 + j) * 17 + i)]));
        QCOMPARE(naive, 0);
        const CellRanges ranges(*volume);
        int cells = 0;
        for (const HuRange& range : ranges.cells())
            cells += range.highest == 1000;
        QCOMPARE(cells, 1);  // cell [4, 8] of each axis; the voxel lies on none of its borders
        QVERIFY(ranges.whole() == (HuRange{0, 1000}));
    }

    /// B4, VisRTX (PR 298): a phase function that scatters to the half space about the gradient only.
    void phaseFunctionIsAHemisphere() {
        const auto naive = [](vec3 towards) { return std::max(towards.z, 0.0f) / kPi; };  // gradient along z
        QCOMPARE(naive({0.6f, 0, -0.8f}), 0.0f);
        for (const float g : {-0.7f, 0.0f, 0.5f, 0.9f}) {
            const vec3 travel = glm::normalize(vec3(0.3f, -0.5f, 0.7f));
            double whole = 0, behind = 0;
            const int n = 400;
            for (int i = 0; i < n * n; ++i) {  // midpoints in cosine and azimuth
                const float z = -1 + 2 * (float(i % n) + 0.5f) / n, phi = 2 * kPi * (float(i / n) + 0.5f) / n;
                const float sine = std::sqrt(1 - z * z);
                const double fraction =
                    phaseEval(g, -travel, {sine * std::cos(phi), sine * std::sin(phi), z}) * 4 * M_PI / (n * n);
                whole += fraction;
                behind += z < 0 ? fraction : 0;
            }
            QVERIFY(std::fabs(whole - 1) < 1e-3 && behind > 0.02);
        }
    }

    /// B5, VisRTX (PR 298): shadows that multiply by the albedo of what they cross. The light that gets through tissue
    /// does not depend on its colour: twice the albedo is twice the image, sample by sample.
    void shadowsAreTinted() {
        const double tau = 1, through = std::exp(-tau), naive = through * 0.4;  // at an albedo of 0.4
        QVERIFY(std::fabs(naive / through - 1) > 0.5);
        const auto device = test::testedDevice();
        const Film dark = test::render(test::slab(tau, {0, 0, -1}, 0.4f), 64, *device);
        const Film bright = test::render(test::slab(tau, {0, 0, -1}, 0.8f), 64, *device);
        for (int i = 0; i < 16; ++i)
            QVERIFY(std::fabs(2 * dark.pixel(i % 4, i / 4).mean.x / bright.pixel(i % 4, i / 4).mean.x - 1) < 1e-6);
    }

    /// B6, VisRTX (PR 218): a unit distance of 0 made steps that never end.
    void noExtinctionNeverEnds() {
        float t = 0;
        int steps = 0;
        while (t < 1 && ++steps < 1000)  // steps of the unit distance
            t += 0.0f;
        QCOMPARE(steps, 1000);
        Scene scene = windowed();
        scene.transferFunction.extinctionPerMm = 0;
        scene.environment = {vec3(0.5f), true};
        const Film film = test::render(scene, 16);
        QVERIFY(film.status().meanLuminance == 0.5 && film.status().health.perfect());
    }

    /// B7, Mitsuba 3 (PR 1959): exp(-majorant t) underflows beyond an optical depth of 87 and is divided by itself.
    void transmittanceOverItselfIsNotANumber() {
        const float beyond = std::exp(-120.0f);
        QVERIFY(std::isnan(beyond / beyond) || beyond < 1e-37f);
        QVERIFY(std::isnan(std::exp(-200.0f) / std::exp(-200.0f)));
        for (const double tau : {120.0, 1e4}) {
            const Film film = test::render(test::slab(tau, {0, 0, -1}, 0.8f), 4096);
            QVERIFY(film.status().health.perfect());
            QVERIFY(std::fabs(test::z(film, 0.8 / (4 * M_PI) * 2 * 0.5)) < test::allowedZ(2));
        }
    }

    /// B8, Mitsuba 3 (issue 1387): a homogeneous medium and a grid of the same value disagreed. Here a constant volume
    /// in cells, behind one bound that is 7 times too high, and the closed form agree.
    void constantGridIsNotTheHomogeneousMedium() {
        const Scene scene = test::slab(1.5, {0, 0, -1}, 0.8f);
        const double truth = 0.8 / (4 * M_PI) * -std::expm1(-3.0);
        const auto device = test::testedDevice();
        const auto loose = test::prepared(scene);
        auto bounds = std::make_shared<Majorants>(*loose->majorants);
        for (auto* grid : {&bounds->fine, &bounds->coarse})
            for (float& bound : *grid)
                bound *= 7;
        loose->flat.majorants.fine = bounds->fine.data();
        loose->flat.majorants.coarse = bounds->coarse.data();
        const Film tight = test::render(scene, 8192, *device), far = test::sampled(loose, 8192);
        QVERIFY(std::fabs(test::z(tight, truth)) < test::allowedZ(2));
        QVERIFY(std::fabs(test::z(far, truth)) < test::allowedZ(2));
        QVERIFY(test::sameBits(tight, far));  // the first flight asks bounds only where nothing is
        QVERIFY(std::fabs(test::z(tight, 1.02 * truth)) > test::allowedZ(2));  // 2 % would be seen
    }

    /// B11, VPT: what is no number becomes 1, or black, and nobody knows.
    void wrongSamplesAreReplacedByOne() {
        const auto value = [](std::uint64_t i) { return i % 100 == 7 ? NAN : 0.01f; };
        double naive = 0;
        for (std::uint64_t i = 0; i < 1000; ++i)
            naive += (std::isnan(value(i)) ? 1 : value(i)) / 1000.0;
        QVERIFY(naive > 0.019);  // twice as bright, and silent
        const Film film = test::filmOf(1000, value);
        QVERIFY(std::fabs(film.pixel(0, 0).mean.x / 0.01f - 1) < 1e-12);
        QCOMPARE(film.status().health.of(Fault::notANumber).count, std::uint64_t(10));
    }

    /// B12, pbrt-v4: a ray that lies in a border between cells, its component across it 0: 0 / 0.
    void rayInABorderBetweenCellsIsNotANumber() {
        QVERIFY(std::isnan(naiveBorder(8, 0.0f)) && std::isnan(naiveBorder(8, -0.0f)));
        const auto prepared = Flattener().prepare(
            test::plainScene(test::makeVolume({24, 24, 24}, dvec3(1), [](int, int, int) { return 0; }), 1e-6f));
        for (const float zero : {0.0f, -0.0f})
            for (const vec3 direction : {vec3(1, zero, zero), vec3(zero, -1, zero), vec3(zero, 0.6f, 0.8f)})
                for (const vec3 origin : {vec3(8), vec3(4, 8, 12), vec3(0, 0, 16)}) {
                    MajorantTraversal<float, true> flight;
                    flight.start(prepared->flat.majorants, {origin.x, origin.y, origin.z},
                                 {direction.x, direction.y, direction.z}, 1e30f, stream(1));
                    int steps = 0;
                    for (; flight.isActive() && steps < 100; ++steps)
                        flight.step(prepared->flat);
                    const float chord =
                        clipped(origin, direction, vec3(-0.5f), vec3(23.5f), Interval<float>{0, 1e30f}).leave;
                    QVERIFY(steps <= 21 && std::fabs(flight.t - chord) < 1e-4f * chord);
                }
    }
};

QTEST_GUILESS_MAIN(PublishedBugsTest)
#include "published_bugs_test.moc"
