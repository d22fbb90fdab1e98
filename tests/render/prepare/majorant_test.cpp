/// A thousand edits of the transfer function, each checked at very many points: the bound of the cell that a point lies
/// in is never below the extinction there. Points per edit: PDR_POINTS, else a number that suits every day; the long
/// run is `ctest -C long -L long`.

#include <tbb/parallel_for.h>

#include <QTest>
#include <atomic>
#include <cstdlib>
#include <functional>
#include <random>
#include <utility>

#include "render/kernel/medium.h"
#include "render/kernel/random.h"
#include "render/prepare/bound_cells.h"
#include "tests/support/scenes/masks.h"
#include "tests/support/scenes/part_scenes.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

constexpr int kEdits = 1000;
constexpr int kLow = -32001, kHigh = 30001;  ///< values of one part of the volume

/// Returns the HU of a node: anywhere, on whole numbers, just beside them, at the ends of int16.
float anyHu(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0, 1);
    // Beside 0, where floats are finest, and where interpolation between kLow and kHigh rounds to.
    const float besideVoxels[] = {-1e-40f, 0, 1e-40f, std::nextafter(float(kHigh), 1e9f),
                                  std::nextafter(float(kLow), -1e9f)};
    const float wide = random() % 3 ? 4500 * unit(random) - 1200 : 65535 * unit(random) - 32768;
    switch (random() % 5) {
        case 0:
            return std::floor(wide);
        case 1:
            return std::nextafter(std::floor(wide), random() % 2 ? 1e9f : -1e9f);
        case 2:
            return std::floor(wide) + 0.01f * (unit(random) - 0.5f);
        case 3:
            return random() % 2 ? wide : besideVoxels[random() % std::size(besideVoxels)];
        default:
            return random() % 20 ? wide : (random() % 2 ? -32768.0f : 32767.0f);
    }
}

void addBand(std::vector<TransferNode>& nodes, std::mt19937& random) {
    const float widths[] = {0, 1e-3f, 0.3f, 1, 20};
    const float low = std::clamp(anyHu(random), -32768.0f, 32000.0f), width = widths[random() % 5];
    nodes.push_back({.hu = low, .opacity = 0});
    nodes.push_back({.hu = low, .opacity = 1});
    nodes.push_back({.hu = low + width, .opacity = 1});
    nodes.push_back({.hu = low + width, .opacity = 0});
}

/// Returns a transfer function of bands, steps, repeated positions, huge and tiny slopes.
TransferFunction edit(unsigned number) {
    std::mt19937 random(number);
    std::uniform_real_distribution<float> unit(0, 1);
    TransferFunction function;
    function.extinctionPerMm = std::pow(10.0f, 12 * unit(random) - 6);
    for (int i = int(random() % 10); i >= 0; --i) {
        const float opacities[] = {0, 1, unit(random), 1e-6f * unit(random), 1e-30f};
        const float hu = std::clamp(anyHu(random), -32768.0f, 32767.0f);
        function.nodes.push_back({.hu = hu, .opacity = opacities[random() % 5]});
        if (random() % 3 == 0)
            function.nodes.push_back({.hu = hu, .opacity = opacities[random() % 5]});
        if (random() % 4 == 0)
            addBand(function.nodes, random);
    }
    std::ranges::stable_sort(function.nodes, {}, &TransferNode::hu);
    return function;
}

/// Returns a volume of five parts, from foot to head: rough tissue, a checkerboard of the extremes, all of int16 at
/// random, a slope, two values. It is a single volume, since the table of a curve's maxima over all of int16 is what
/// takes time.
std::shared_ptr<const Volume> volume() {
    const int part = 18;
    const auto tissue = test::bumpyVolume({33, 21, part}, dvec3(1), 5);
    std::mt19937 random(9);
    return test::makeVolume({33, 21, 5 * part}, {0.7, 1.1, 2.3}, [&](int i, int j, int k) -> int {
        if (k < part)
            return tissue->voxels()[(k * 21 + j) * 33 + i];
        if (k < 2 * part)
            return (i + j + k) % 2 ? 32767 : -32768;
        if (k < 3 * part)
            return int(random() % 65536) - 32768;
        if (k < 4 * part)
            return 900 * i - 700 * j + 31 * k;
        return random() % 2 ? kHigh : kLow;
    });
}

/// Random numbers in [0, 1) per lane.
struct LaneNumbers {
    RandomStreamOf<FloatLanes> stream;

    explicit LaneNumbers(std::uint64_t seed) {
        for (int lane = 0; lane < kLanes; ++lane) {
            const RandomStream one = Random(seed, unsigned(lane), 0).stream(Dimension::filter);
            stream.counter[lane] = one.counter;
            stream.key[lane] = one.key;
        }
    }
    void pair(FloatLanes& first, FloatLanes& second) { stream.pair(IntLanes{} - 1, first, second); }
};

/// A coordinate anywhere in [-0.5, size - 0.5]; one in four on a voxel's centre, where it may count to the cell before,
/// one in four just above it.
struct Coordinate {
    FloatLanes place;
    IntLanes cell;

    Coordinate(FloatLanes where, FloatLanes how, int size) {
        place = where * float(size) - 0.5f;
        const IntLanes centred = how < 0.25f;
        const FloatLanes centre = toFloat(toInt(where * float(size)));
        place = centred ? centre : (how < 0.5f ? centre + (how - 0.25f) * 1e-5f : place);
        cell = toInt(place * 0.25f + 1.0f);
        const IntLanes onBorder = centred & (how < 0.125f) & ((toInt(place) & 3) == 0) & (cell > 0);
        cell = onBorder ? cell - 1 : cell;
    }
};

/// Extinctions above their bounds among about `points` points.
long violations(const FlatScene& scene, std::uint64_t seed, int points) {
    const FlatMajorants& grid = scene.majorants;
    LaneNumbers numbers(seed);
    long found = 0;
    for (int i = 0; i < points; i += kLanes) {
        FloatLanes u[6];
        for (int pair = 0; pair < 3; ++pair)
            numbers.pair(u[pair], u[3 + pair]);
        const Coordinate x(u[0], u[3], scene.volume.size.x), y(u[1], u[4], scene.volume.size.y);
        const Coordinate z(u[2], u[5], scene.volume.size.z);
        const Vec3<FloatLanes> place{x.place, y.place, z.place};
        const FloatLanes met = extinction(scene, place, hounsfield(scene.volume, place), ~IntLanes{});
        const FloatLanes fine = gather(grid.fine, (z.cell * grid.fineSize.y + y.cell) * grid.fineSize.x + x.cell);
        const IntLanes coarseCell =
            ((z.cell >> 2) * grid.coarseSize.y + (y.cell >> 2)) * grid.coarseSize.x + (x.cell >> 2);
        const FloatLanes coarse = gather(grid.coarse, coarseCell);
        // Not "above": what is not a number is a violation too.
        found += std::popcount(laneBits(!((met <= fine) & (fine <= coarse))));
    }
    return found;
}

int pointsPerEdit() {
    const char* named = std::getenv("PDR_POINTS");
    return named ? std::atoi(named) : 100000;
}

/// Changes the curve as a hand does: one node between its neighbours, or the highest, or all.
void moveNode(TransferFunction& function, std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<TransferNode>& nodes = function.nodes;
    const std::size_t i = 1 + random() % (nodes.size() - 2);
    nodes[i].opacity = random() % 3 ? 0.9f * unit(random) : 0;
    nodes[i].hu = nodes[i - 1].hu + (nodes[i + 1].hu - nodes[i - 1].hu) * unit(random);
    if (random() % 8 == 0)
        nodes.back().opacity = 0.9f + 0.1f * unit(random);
    if (random() % 16 == 0)
        function.extinctionPerMm *= 0.5f + unit(random);
}

/// Returns a curve with a band thinner than 1 HU between wider pieces.
TransferFunction curveToMove() {
    TransferFunction function;
    const float hu[] = {-1000, -200, 30.2f, 30.4f, 30.6f, 300, 1200, 1800},
                opacity[] = {0, 0, 0, 0.5f, 0, 0.2f, 0.9f, 1};
    for (int i = 0; i < 8; ++i)
        function.nodes.push_back({.hu = hu[i], .opacity = opacity[i]});
    return function;
}

}  // namespace

class MajorantTest : public QObject {
    Q_OBJECT

  private slots:
    void noEditLosesMatter() {
        const auto all = volume();
        const int points = pointsPerEdit();
        std::atomic<long> found = 0, wrongEdits = 0;
        tbb::parallel_for(0, kEdits, [&](int number) {
            Scene scene = test::plainScene(all, 1);
            scene.film = {1, 1};
            scene.transferFunction = edit(unsigned(number));
            const auto prepared = Flattener().prepare(scene);
            const long here = violations(prepared->flat, std::uint64_t(number), points);
            found += here;
            wrongEdits += here > 0;
        });
        qInfo("%d edits, %d points each: %ld violations in %ld edits", kEdits, points, found.load(), wrongEdits.load());
        QCOMPARE(found.load(), 0L);
    }

    /// The memory of majorants is used again, but not while a scene needs them; and nothing of what it held stays.
    void majorantsAreThoseOfTheirOwnScene() {
        Scene scene = test::plainScene(volume(), 1);
        scene.film = {1, 1};
        Flattener flattener;
        std::vector<std::shared_ptr<const PreparedScene>> held;
        for (unsigned number = 0; number < 12; ++number) {
            scene.transferFunction = edit(number);
            auto prepared = flattener.prepare(scene);
            const auto alone = Flattener().prepare(scene);
            QVERIFY(prepared->majorants->fine == alone->majorants->fine);
            QVERIFY(prepared->majorants->coarse == alone->majorants->coarse);
            QCOMPARE(prepared->majorants->occupiedLow, alone->majorants->occupiedLow);
            if (number % 4 == 0)
                held.push_back(std::move(prepared));
        }
        for (unsigned i = 0; i < held.size(); ++i) {
            scene.transferFunction = edit(4 * i);
            QVERIFY(held[i]->majorants->fine == Flattener().prepare(scene)->majorants->fine);
        }
    }

    /// What is known of a mask is kept while the curve is edited, and not when another one comes.
    void boundsAreThoseOfTheirOwnMask() {
        Scene scene = test::plainScene(volume(), 1);
        scene.film = {1, 1};
        Flattener flattener;
        for (unsigned number = 0; number < 12; ++number) {
            const unsigned seed = number / 3;
            if (number % 3 == 0)
                scene.mask = seed % 4 == 3 ? nullptr : test::anyMask(*scene.volume, seed + 1);
            scene.transferFunction = edit(number);
            const auto prepared = flattener.prepare(scene), alone = Flattener().prepare(scene);
            QVERIFY(prepared->majorants->fine == alone->majorants->fine);
            QVERIFY(prepared->majorants->coarse == alone->majorants->coarse);
        }
    }

    /// A hand that moves nodes gets the bounds of the whole curve, under one mask after the other, with parts that have
    /// curves of their own and without.
    void boundsOfAnEditAreThoseOfTheWholeCurve() {
        const auto all = volume();
        Scene scene = test::plainScene(all, 1);
        scene.film = {1, 1};
        Flattener flattener;
        std::mt19937 random(11);
        scene.transferFunction = curveToMove();
        for (unsigned number = 0; number < 80; ++number) {
            if (number % 20 == 10)
                scene.mask = number % 40 == 10 ? test::anyMask(*all, number) : nullptr;
            if (number % 16 == 8)
                scene.parts.map = number % 32 == 8 ? test::anyParts(*all, 2, number) : nullptr;
            scene.parts.curves.clear();
            if (scene.parts.map) {
                scene.parts.curves = {{1, scene.transferFunction}, {2, scene.transferFunction}};
                moveNode(scene.parts.curves[number % 2].transferFunction, random);
            }
            moveNode(scene.transferFunction, random);
            const auto prepared = flattener.prepare(scene), alone = Flattener().prepare(scene);
            QVERIFY(prepared->majorants->fine == alone->majorants->fine);
            QVERIFY(prepared->majorants->coarse == alone->majorants->coarse);
            QCOMPARE(prepared->majorants->occupiedLow, alone->majorants->occupiedLow);
            QCOMPARE(prepared->majorants->occupiedHigh, alone->majorants->occupiedHigh);
        }
    }

    /// After edits of soft tissue alone, the dense half gets its bounds anew if anything else changes them.
    void anotherScaleMaskOrPartsBoundAllTissue() {
        const auto tissue =
            test::makeVolume({64, 32, 32}, dvec3(1), [](int i, int, int) { return i < 32 ? 100 : 900; });
        Scene scene = test::plainScene(tissue, 1);
        scene.film = {1, 1};
        scene.transferFunction.nodes = {
            {.hu = 0, .opacity = 0.1f}, {.hu = 500, .opacity = 0.5f}, {.hu = 1000, .opacity = 1}};
        TransferFunction denser = scene.transferFunction;
        denser.nodes[1].opacity = 0.9f;
        Flattener flattener;
        const auto follows = [&](const char* change) {
            for (int edit = 0; edit < 4; ++edit) {  // the memory of two scenes takes turns
                scene.transferFunction.nodes[0].opacity = 0.1f + 0.05f * float(edit);
                const auto edited = flattener.prepare(scene), alone = Flattener().prepare(scene);
                QVERIFY2(edited->majorants->fine == alone->majorants->fine, change);
                QVERIFY2(edited->majorants->coarse == alone->majorants->coarse, change);
            }
        };
        follows("soft tissue alone");
        scene.transferFunction.extinctionPerMm *= 2;
        follows("scale");
        scene.mask = test::anyMask(*tissue, 3);
        follows("mask");
        scene.mask = nullptr;
        follows("no mask");
        scene.parts.curves = {{1, scene.transferFunction}, {2, denser}};
        for (const unsigned map : {1, 2, 3, 4}) {
            scene.parts.map = test::anyParts(*tissue, 2, map);
            follows("parts");
        }
    }

    /// An edit leaves the bounds of cells alone whose HU have the opacity that they had.
    void boundsOfUnchangedTissueStay() {
        const auto tissue =
            test::makeVolume({64, 16, 16}, dvec3(1), [](int i, int, int) { return i < 32 ? 100 : 900; });
        const CellRanges ranges(*tissue);
        const auto coarse = coarseRanges(ranges);
        HighestWeights weights;
        const auto bounded = [&](Majorants& majorants, float opacity, const CurveBound* before) {
            TransferFunction function;
            function.nodes = {{.hu = 0, .opacity = opacity}, {.hu = 500, .opacity = 0.5f}, {.hu = 1000, .opacity = 1}};
            const TransferTables tables(function);
            const auto curves = curveBounds(tables.flat(), {}, ranges.whole());
            const BoundedTissue all{ranges, tissue->size(), weights, {}, curves};
            if (before)
                boundChanged(majorants, all, coarse, curves[0].changedFrom(*before));
            else
                boundAll(majorants, all);
            return curves[0];
        };
        Majorants majorants;
        const CurveBound before = bounded(majorants, 0.1f, nullptr);
        const auto at = [&](int i) -> float& {
            return majorants.fine[std::size_t(cellIndex({i, 2, 2}, ranges.fineSize()))];
        };
        const float soft = at(2), dense = at(14);
        at(14) = 7;  // what is bounded anew has another value
        bounded(majorants, 0.2f, &before);
        QVERIFY(at(2) > soft);
        QCOMPARE(at(14), 7.0f);
        bounded(majorants, 0.2f, nullptr);
        QCOMPARE(at(14), dense);
    }

    /// A peak between two HU, which no whole number shows, counts as a change of both.
    void peaksBetweenTwoHuAreChanges() {
        const auto maximum = [](float opacity) {
            TransferFunction function;
            function.nodes = {
                {.hu = 30.2f, .opacity = 0}, {.hu = 30.4f, .opacity = opacity}, {.hu = 30.6f, .opacity = 0}};
            return OpacityMaximum(TransferTables(function).flat(), {-100, 200});
        };
        QVERIFY((maximum(0.5f).changedFrom(maximum(0.25f)) == HuRange{30, 31}));
        QVERIFY(maximum(0.5f).changedFrom(maximum(0.5f)).empty());
    }

    /// The depths of a view are kept only while the same cells hold tissue, the view stays and the same planes cut.
    void depthsAreThoseOfTheirOwnScene() {
        Scene scene = test::plainScene(test::bumpyVolume({33, 21, 18}, dvec3(1), 5), 1);
        scene.film = {96, 64};
        const Camera first = scene.camera;
        const std::vector<std::function<void()>> edits{
            [&] {
                scene.transferFunction.nodes = {{.hu = 1000, .opacity = 0}, {.hu = 1400, .opacity = 1}};
            },
            [&] { scene.transferFunction.nodes[0].hu = 600; },
            [&] { scene.transferFunction.nodes[1].opacity = 0.5f; },
            [&] { scene.transferFunction.nodes[0].hu = 800; },
            [&] { scene.camera.eyeMm.x += 4; },
            [&] { scene.camera.fovDegrees += 10; },
            [&] {
                scene.film = {64, 96};
            },
            [&] { scene.camera.apertureMm = 20; },
            [&] { scene.camera.apertureMm = 8; },
            [&] {
                scene.clip.planes = {{{1, 0, 0}, scene.volume->geometry().centreMm()}};
            },
            [&] { scene.clip.planes[0].pointMm.x += 5; },
            [&] {
                scene.clip.planes[0].normal = {0, 1, 0};
            },
            [&] { scene.clip = {}, scene.camera = first; }};
        Flattener flattener;
        std::vector<std::size_t> kept;
        std::vector<vec2> before;
        for (std::size_t i = 0; i < edits.size(); ++i) {
            edits[i]();
            const auto prepared = flattener.prepare(scene);
            QVERIFY(prepared->viewDepths == Flattener().prepare(scene)->viewDepths);
            if (std::exchange(before, prepared->viewDepths) == prepared->viewDepths)
                kept.push_back(i);
        }
        QCOMPARE(kept, std::vector<std::size_t>{2});  // all others change them
    }
};

QTEST_APPLESS_MAIN(MajorantTest)
#include "majorant_test.moc"
