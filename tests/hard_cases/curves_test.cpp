/// Hard cases 36 to 41: curves, the bounds made from them, interpolation and gradients. Each naive form is written out
/// and must fail.

#include <QTest>

#include <algorithm>
#include <random>

#include "render/film/display/tone_map.h"
#include "render/kernel/transport/event.h"
#include "tests/support/devices/screen.h"
#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

using Nodes = std::vector<TransferNode>;

std::shared_ptr<const Volume> bumps() {
    return test::bumpyVolume({40, 36, 32}, dvec3(1), 4);
}

/// Bumps under a curve, all tissue lit from all around.
Scene bumpyScene(Nodes nodes, float extinctionPerMm = 2) {
    Scene scene = test::plainScene(bumps(), extinctionPerMm);
    scene.transferFunction.nodes = std::move(nodes);
    scene.environment = {vec3(1), false};
    return scene;
}

/// Nothing but a band: 0 at both ends of nearly every cell's range.
const Nodes kBand{{.hu = 300, .opacity = 0}, {.hu = 340, .opacity = 1}, {.hu = 380, .opacity = 0}};

std::shared_ptr<PreparedScene> flattened(const Nodes& nodes) {
    Scene scene = test::plainScene(test::makeVolume({2, 2, 2}, dvec3(1), [](int, int, int) { return 0; }), 1);
    scene.transferFunction.nodes = nodes;
    return test::prepared(scene);
}

/// `scene` behind other bounds: bound(range) for each fine cell.
template <class Bound>
std::shared_ptr<const PreparedScene> withBounds(const Scene& scene, Bound&& bound) {
    const auto prepared = test::prepared(scene);
    auto majorants = std::make_shared<Majorants>(*prepared->majorants);
    const ivec3 size = prepared->ranges->fineSize(), above = size / 4;
    majorants->coarse.assign(majorants->coarse.size(), 0);
    for (int n = 0; n < size.x * size.y * size.z; ++n) {
        const ivec3 cell(n % size.x, n / size.x % size.y, n / size.x / size.y);
        const HuRange range = prepared->ranges->cells()[std::size_t(n)];
        const float value = range == kEmptyRange ? 0 : bound(range);
        float& coarse = majorants->coarse[std::size_t((cell.z / 4 * above.y + cell.y / 4) * above.x + cell.x / 4)];
        majorants->fine[std::size_t(n)] = value;
        coarse = std::max(coarse, value);
    }
    prepared->flat.majorants.fine = majorants->fine.data();
    prepared->flat.majorants.coarse = majorants->coarse.data();
    prepared->majorants = majorants;
    return prepared;
}

double zBetween(const Film& a, const Film& b) {
    const test::ImageMean x = test::imageMean(a), y = test::imageMean(b);
    return (x.mean - y.mean) / std::hypot(x.standardError, y.standardError);
}

/// Returns a fraction as a texture unit rounds it: 8 bits of it.
float textureFraction(float x) {
    return std::floor(x * 256 + 0.5f) / 256;
}

}  // namespace

class CurvesTest : public QObject {
    Q_OBJECT

  private slots:
    /// Case 36. Exposure Render's intervals are half open: exactly on the last node there is nothing.
    void valueOnTheLastNodeIsZero() {
        const Nodes nodes{{.hu = -100, .opacity = 0.25f},
                          {.hu = 50, .opacity = 0.5f},
                          {.hu = 50, .opacity = 0.1f},
                          {.hu = 50, .opacity = 0.75f},
                          {.hu = 200, .opacity = 1}};
        const auto naive = [&](float hu) {
            for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
                if (hu >= nodes[i].hu && hu < nodes[i + 1].hu)
                    return glm::mix(nodes[i].opacity, nodes[i + 1].opacity,
                                    (hu - nodes[i].hu) / (nodes[i + 1].hu - nodes[i].hu));
            return 0.0f;
        };
        QCOMPARE(naive(200), 0.0f);
        const auto prepared = flattened(nodes);
        const FlatTransferFunction& curve = prepared->flat.transferFunction;
        QCOMPARE(opacity(curve, 200), 1.0f);
        QCOMPARE(opacity(curve, 32767), 1.0f);
        QCOMPARE(opacity(curve, -100), 0.25f);
        QCOMPARE(opacity(curve, -32768), 0.25f);
        QCOMPARE(opacity(curve, 50), 0.75f);  // right-continuous; what lies between two nodes of a step is ignored
        QVERIFY(opacity(curve, std::nextafter(50.0f, 0.0f)) > 0.499f);
        QCOMPARE(opacity(flattened({{.hu = 7, .opacity = 0.3f}})->flat.transferFunction, -5), 0.3f);
    }

    /// Case 36. A step of 4e-5 of the range, in a table of 128 texels.
    void narrowStepIsSmearedByATable() {
        const Nodes nodes{{.hu = 158, .opacity = 0.02f}, {.hu = 158.16f, .opacity = 0.56f}, {.hu = 430, .opacity = 1}};
        const auto table = [&](float hu) {
            const auto texel = [&](int i) { return TransferFunction{1, nodes}.opacityAt(4095.0f * i / 128 - 1024); };
            const float x = (hu + 1024) / 4095 * 128;
            return glm::mix(texel(int(x)), texel(int(x) + 1), x - std::floor(x));
        };
        const auto prepared = flattened(nodes);
        double naiveWorst = 0, worst = 0;
        for (float hu = 100; hu < 220; hu += 0.01f) {
            const auto exact = double(TransferFunction{1, nodes}.opacityAt(hu));
            naiveWorst = std::max(naiveWorst, std::fabs(table(hu) - exact));
            worst = std::max(worst, std::fabs(opacity(prepared->flat.transferFunction, hu) - exact));
        }
        QVERIFY(naiveWorst > 0.2 && worst < 1e-5);
    }

    /// Case 36. Below a first node at 0 HU the share of the way from 0 to 0 was taken.
    void tissueBelowTheFirstNodeIsNotANumber() {
        QVERIFY(std::isnan(glm::mix(0.8f, 0.8f, -100.0f / 0.0f)));
        for (const float first : {0.0f, -0.0f, 1e-40f, 1e-3f, -5.0f, 700.0f, 32767.0f, -32768.0f}) {
            const auto prepared = flattened({{.hu = first, .opacity = 0.5f, .albedo = vec3(0.8f), .roughness = 0.3f}});
            for (const float hu : {-32768.0f, -1024.0f, -1e-40f, 0.0f, 3.0f, 32767.0f}) {
                const Material material = materialAt(prepared->flat.transferFunction, hu);
                QVERIFY(material.albedo == vec3(0.8f) && material.roughness == 0.3f);
                QCOMPARE(opacity(prepared->flat.transferFunction, hu), 0.5f);
            }
        }
        // Two nodes so near to each other that the slope between them is infinite: 0 times it is no number.
        QVERIFY(std::isnan(1.0f / 1e-40f * 0.0f));
        const auto steep = flattened({{.hu = 0, .opacity = 0.25f}, {.hu = 1e-40f, .opacity = 1}});
        QCOMPARE(opacity(steep->flat.transferFunction, 0), 0.25f);
        QCOMPARE(opacity(steep->flat.transferFunction, 1), 1.0f);
    }

    /// Case 36. What cannot be drawn is refused: a 16-bit place in a curve of 70000 pieces wraps and is sought for
    /// ever.
    void badCurvesAreTaken() {
        QVERIFY(std::uint16_t(70000) < 70000);
        const auto taken = [](Nodes nodes) { return bool(TransferFunction{1, std::move(nodes)}.check()); };
        QVERIFY(!taken({}));
        QVERIFY(!taken({{.hu = 10}, {.hu = 5}}));
        QVERIFY(!taken({{.hu = NAN}}) && !taken({{.hu = 40000}}) && !taken({{.hu = 0, .opacity = NAN}}));
        QVERIFY(!taken({{.hu = 0, .opacity = 1.5f}}));
        QVERIFY(taken(Nodes(4096)) && !taken(Nodes(70000)));
        QVERIFY(taken({{.hu = 5}}));
    }

    /// Cases 36 and 37. 0 violations in 1e6 points: steps just beyond a cell's range, and values that float hardly
    /// tells apart from their neighbours.
    void boundLiesBelowTheExtinction() {
        std::mt19937 random(11);
        std::uniform_real_distribution<float> unit(0, 1);
        for (const float top : {400.0f, 4095.0f, 20000.0f, 32766.0f}) {
            const int low = -int(top);
            const auto volume = test::makeVolume({21, 20, 19}, dvec3(1), [&](int, int, int) {
                return random() % 3 ? int(top) : low + int(random() % unsigned(2 * top));
            });
            for (int round = 0; round < 25; ++round) {
                const float step = round % 5 ? top - 20 + 20 * unit(random) : std::nextafter(top, 1e9f);
                Scene scene = test::plainScene(volume, 1e6f * unit(random));
                scene.transferFunction.nodes = {{.hu = -7.5f, .opacity = 0}, {.hu = -7, .opacity = 0.3f},
                                                {.hu = -6.9f, .opacity = 0}, {.hu = step, .opacity = 0},
                                                {.hu = step, .opacity = 1},  {.hu = step + 1e-3f, .opacity = 0.2f}};
                const auto prepared = Flattener().prepare(scene);
                const FlatMajorants& grid = prepared->flat.majorants;
                for (int i = 0; i < 10'000; ++i) {
                    vec3 p = vec3(unit(random), unit(random), unit(random)) * vec3(21, 20, 19) - 0.5f;
                    p.x = i % 2 ? p.x : std::nextafter(std::round(p.x), i % 4 ? 99.0f : -99.0f);
                    const ivec3 cell((p + 4.0f) / 4.0f);
                    const float bound = grid.fine[(cell.z * grid.fineSize.y + cell.y) * grid.fineSize.x + cell.x];
                    const float found = extinction(prepared->flat, p);
                    QVERIFY2(found <= bound, qPrintable(QString("%1 > %2 at %3").arg(found).arg(bound).arg(top)));
                }
            }
        }
    }

    /// Case 37. The bound from the ends of a cell's range: tissue in a band is missing from the image.
    void bandBetweenTheEndsOfARangeIsLost() {
        const Scene scene = bumpyScene(kBand);
        const auto device = test::testedDevice();
        const auto ends = [&](HuRange range) {
            const TransferFunction& curve = scene.transferFunction;
            return curve.extinctionPerMm * std::max(curve.opacityAt(range.lowest), curve.opacityAt(range.highest));
        };
        const Film right = test::sampled(test::withGlobalMajorant(scene), 256);
        const Film ours = test::render(scene, 256, *device);
        const Film naive = test::sampled(withBounds(scene, ends), 256);
        QVERIFY2(std::fabs(zBetween(ours, right)) < 4, qPrintable(QString::number(zBetween(ours, right))));
        QVERIFY2(zBetween(naive, right) < -20, qPrintable(QString::number(zBetween(naive, right))));
        QVERIFY(ours.status().health.perfect() && right.status().health.perfect());
        Scene tracked = scene;  // and our own counter sees it, where rays are tracked: behind the first event
        tracked.model = Model::multipleScattering;
        QVERIFY(test::sampled(withBounds(tracked, ends), 256).status().health.of(Fault::overMajorant).count > 0);
    }

    /// Case 38. An edit of the curve: the bounds of the one before would hide what the edit shows.
    void boundsOfTheCurveBeforeAnEditAreKept() {
        const Scene before = bumpyScene({{.hu = 900, .opacity = 0}, {.hu = 1000, .opacity = 1}});
        Scene after = bumpyScene({{.hu = 100, .opacity = 0}, {.hu = 200, .opacity = 1}});
        after.volume = before.volume;
        after.revision = 2;
        Flattener flattener;
        const auto old = flattener.prepare(before), edited = flattener.prepare(after);
        const auto fresh = Flattener().prepare(after);
        QVERIFY(edited->majorants->fine == fresh->majorants->fine &&
                edited->majorants->coarse == fresh->majorants->coarse);
        QVERIFY(old->majorants->fine != fresh->majorants->fine);

        const auto device = test::testedDevice();
        const auto stale = test::prepared(after);
        stale->flat.majorants = old->flat.majorants;
        const Film right = test::sampled(fresh, 32);
        const double difference = zBetween(test::sampled(stale, 32), right);
        QVERIFY2(difference < -6, qPrintable(QString::number(difference)));
        QVERIFY(test::sameBits(test::sampled(edited, 32), right));

        // And no sample of the scene before the edit gets into the image after it.
        test::Screen screen;
        Session session(test::testedDevice(), screen.sink());
        session.setIterationsPerFrame(32);
        session.submit(before, false);
        QVERIFY(screen.await([](const Frame& frame) { return frame.status.samplesPerPixel >= 64; }));
        session.setPaused(true);
        session.submit(after, false);
        const auto frame = screen.await([](const Frame& shown) { return shown.revision == 2 && !shown.coarse; });
        QVERIFY(frame && frame->rgba == toneMap(right, {}));
    }

    /// Case 39, the processor's side. A texture unit has 8 bits of a fraction: 8 HU of 4095 between neighbours.
    void textureFractionsMoveTheSurface() {
        const auto board =
            test::makeVolume({8, 8, 8}, dvec3(1), [](int i, int j, int k) { return (i + j + k) % 2 ? 4095 : 0; });
        const auto prepared = Flattener().prepare(test::plainScene(board, 1));
        double worst = 0, naiveWorst = 0;
        for (float x = 0; x < 1; x += 1 / 3000.0f) {
            const float exact = 4095 * x;
            worst = std::max(worst, std::fabs(double(hounsfield(prepared->flat.volume, vec3(2 + x, 2, 2))) - exact));
            naiveWorst = std::max(naiveWorst, std::fabs(double(4095 * textureFraction(x)) - exact));
        }
        QVERIFY(worst < 1e-3 && naiveWorst > 7);
        const auto surface = [](auto&& density) {  // where 1250 HU are reached, by bisection
            float low = 0, high = 1;
            while (high - low > 1e-6f)
                (density((low + high) / 2) < 1250 ? low : high) = (low + high) / 2;
            return double(high);
        };
        const double truth = 1250 / 4095.0;
        QVERIFY(std::fabs(surface([&](float x) { return hounsfield(prepared->flat.volume, vec3(2 + x, 2, 2)); }) -
                          truth) < 1e-5);
        QVERIFY(std::fabs(surface([](float x) { return 4095 * textureFraction(x); }) - truth) > 5e-4);
    }

    /// Case 40. No gradient, one whose square underflows, and one measured over 0.004 voxels with 8-bit fractions.
    void normalOfNoGradientIsNotANumber() {
        QVERIFY(std::isnan(glm::normalize(vec3(0)).x));
        const auto ramp = test::prepared(
            test::plainScene(test::makeVolume({9, 9, 9}, dvec3(1), [](int i, int, int) { return 100 * i; }), 1));
        FlatScene scene = ramp->flat;
        scene.transferFunction.surfaceFactor = INFINITY;
        QVERIFY(surfaceNormal(scene, scene.transferFunction, {4, 4, 4}, {-1, 0, 0}, 400, 0) == vec3(-1, 0, 0));
        scene.volume.indexFromLocal = mat3(1e-25f);
        const vec3 gradient = hounsfieldGradient(scene.volume, {4, 4, 4});
        QVERIFY(gradient.x > 0 && glm::length(gradient) == 0);
        QVERIFY(surfaceNormal(scene, scene.transferFunction, {4, 4, 4}, {-1, 0, 0}, 400, 0) == vec3(0));

        const auto texture = [](float x) { return 100 * (std::floor(x) + textureFraction(x - std::floor(x))); };
        double naiveWorst = 0, worst = 0;
        for (float x = 2; x < 6; x += 0.01f) {
            naiveWorst = std::max(naiveWorst, std::fabs((texture(x + 0.004f) - texture(x - 0.004f)) / 0.8 - 1));
            worst = std::max(worst, std::fabs(hounsfieldGradient(ramp->flat.volume, {x, 4, 4}).x / 100.0 - 1));
        }
        QVERIFY(naiveWorst > 0.4 && worst < 1e-4);
    }

    /// Case 41. Every event a surface, or none: the image is that of surfaces, or of the phase function, bit by bit.
    void saturatedSurfaceProbabilityLeavesItsRange() {
        QVERIFY(std::isnan(1e6f * 1e38f * 0.0f));  // a factor that has become infinite, times no gradient
        const auto device = test::testedDevice();
        const auto image = [&](float gradientFactor) {
            Scene scene = bumpyScene({{.hu = 0, .opacity = 0}, {.hu = 0, .opacity = 1}});
            scene.gradientFactor = gradientFactor;
            scene.phaseG = 0.5f;
            return test::render(scene, 8, *device);
        };
        const Film phase = image(0), surface = image(1e6f);
        QVERIFY(test::sameBits(image(1e-14f), phase));  // compiled in, and never happens
        QVERIFY(test::sameBits(image(1e5f), surface));
        QVERIFY(!test::sameBits(phase, surface));
        QVERIFY(surface.status().health.perfect() && surface.status().meanLuminance > 0);
    }
};

QTEST_GUILESS_MAIN(CurvesTest)
#include "curves_test.moc"
