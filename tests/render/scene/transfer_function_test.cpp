#include <QTest>
#include <random>

#include "render/kernel/medium.h"
#include "render/prepare/opacity_maximum.h"
#include "render/scene/transfer_function.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

TransferFunction randomFunction(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0, 1);
    TransferFunction function;
    function.extinctionPerMm = 5 * unit(random);
    const int nodes = 1 + int(random() % 9);
    for (int i = 0; i < nodes; ++i) {
        // Whole numbers, fractions and repeated positions: vertical steps included.
        const float hu = random() % 3 ? float(int(random() % 4500) - 1200) : 4500 * unit(random) - 1200;
        function.nodes.push_back({.hu = hu, .opacity = random() % 4 ? unit(random) : 0});
        if (random() % 4 == 0)
            function.nodes.push_back({.hu = hu, .opacity = unit(random)});
    }
    std::stable_sort(function.nodes.begin(), function.nodes.end(),
                     [](const TransferNode& a, const TransferNode& b) { return a.hu < b.hu; });
    return function;
}

}  // namespace

class TransferFunctionTest : public QObject {
    Q_OBJECT

  private slots:
    /// Below a first node at 0 HU its properties apply, like below any other.
    void propertiesHoldBeyondTheOutermostNodes() {
        for (const float hu : {-1000.0f, 0.0f, 250.0f}) {
            Scene scene = test::plainScene(test::makeVolume({2, 2, 2}, dvec3(1), [](int, int, int) { return 0; }), 1);
            scene.transferFunction.nodes = {{.hu = hu, .opacity = 0.25f, .albedo = vec3(0.75f), .emission = vec3(3)}};
            const auto prepared = test::prepared(scene);
            for (const float value : {-32768.0f, -1.0f, 0.0f, 1.0f, 32767.0f}) {
                const Material material = materialAt(prepared->flat.transferFunction, value);
                QVERIFY(material.albedo == vec3(0.75f) && material.emission == vec3(3));
                QCOMPARE(opacity(prepared->flat.transferFunction, value), 0.25f);
            }
        }
    }

    void valueIsLinearBetweenNodesAndHeldOutside() {
        const TransferFunction function{1, {{.hu = 0, .opacity = 0.2f}, {.hu = 100, .opacity = 1}}};
        QCOMPARE(function.at(-5).opacity, 0.2f);
        QCOMPARE(function.at(50).opacity, 0.6f);
        QCOMPARE(function.at(100).opacity, 1.0f);
        QCOMPARE(function.at(3000).opacity, 1.0f);
    }

    void stepTakesTheRightHandValue() {
        const TransferFunction function{
            1, {{.hu = 0, .opacity = 0}, {.hu = 10, .opacity = 0}, {.hu = 10, .opacity = 1}, {.hu = 20, .opacity = 1}}};
        QCOMPARE(function.at(std::nextafter(10.0f, 0.0f)).opacity, 0.0f);
        QCOMPARE(function.at(10).opacity, 1.0f);
    }

    void kernelTableAgreesWithTheCurve() {
        std::mt19937 random(3);
        for (int round = 0; round < 200; ++round) {
            Scene scene = test::plainScene(test::makeVolume({2, 2, 2}, dvec3(1), [](int i, int, int) { return i; }), 1);
            scene.transferFunction = randomFunction(random);
            const auto prepared = Flattener().prepare(scene);
            for (int i = 0; i < 500; ++i) {
                const float hu = std::uniform_real_distribution<float>(-3000, 5000)(random);
                QVERIFY(std::fabs(opacity(prepared->flat.transferFunction, hu) -
                                  scene.transferFunction.at(hu).opacity) < 2e-6f);
            }
            for (const TransferNode& node : scene.transferFunction.nodes)
                QCOMPARE(opacity(prepared->flat.transferFunction, node.hu), scene.transferFunction.at(node.hu).opacity);
        }
    }

    void maximumBoundsEveryValueInAnInterval() {
        std::mt19937 random(7);
        for (int round = 0; round < 100; ++round) {
            const TransferFunction function = randomFunction(random);
            const TransferTables tables(function);
            const OpacityMaximum maximum(tables.flat(), {-1200, 3400});
            for (int i = 0; i < 100; ++i) {
                const int low = int(random() % 4600) - 1200;
                const int high = std::min(3400, low + int(random() % 300));
                const float bound = maximum.over({std::int16_t(low), std::int16_t(high)});
                float seen = 0;
                for (int step = 0; step <= 50; ++step)
                    seen = std::max(seen, opacity(tables.flat(), float(low) + float(high - low) * float(step) / 50));
                QVERIFY(bound >= seen);
                // In O(1) the very number that looking at the pieces gives.
                QCOMPARE(bound, highestOpacity(tables.flat(), {std::int16_t(low), std::int16_t(high)}));
            }
        }
    }

    void maximumKnowsWhereTheCurveBeginsAndEnds() {
        const TransferFunction function{
            1, {{.hu = 150, .opacity = 0}, {.hu = 160, .opacity = 1}, {.hu = 170, .opacity = 0}}};
        const TransferTables tables(function);
        const OpacityMaximum maximum(tables.flat(), {100, 200});
        for (int low = 100; low <= 200; ++low)
            for (int high = low; high <= 200; ++high) {
                const HuRange range{std::int16_t(low), std::int16_t(high)};
                QCOMPARE(maximum.over(range), highestOpacity(tables.flat(), range));
            }
    }

    void maximumOfOneValueIsThatValue() {
        const TransferFunction function{1, {{.hu = 150, .opacity = 0}, {.hu = 1500, .opacity = 1}}};
        const TransferTables tables(function);
        const OpacityMaximum maximum(tables.flat(), {150, 1500});
        QCOMPARE(maximum.over({150, 150}), 0.0f);
        QCOMPARE(maximum.over({1500, 1500}), 1.0f);
        QCOMPARE(maximum.over(kEmptyRange), 0.0f);
    }

    /// The classical failure is a band that lies wholly inside a cell's range, zero at both of its ends.
    void majorantIsNeverBelowTheExtinction() {
        std::mt19937 random(11);
        const ivec3 size(33, 21, 18);
        const auto volume = test::bumpyVolume(size, {0.7, 1.1, 2.3}, 5);
        std::uniform_real_distribution<float> unit(0, 1);
        Flattener flattener;
        for (int round = 0; round < 50; ++round) {
            Scene scene = test::plainScene(volume, 1);
            scene.transferFunction = randomFunction(random);
            const auto prepared = flattener.prepare(scene);
            const FlatMajorants& grid = prepared->flat.majorants;
            for (int i = 0; i < 20000; ++i) {
                const vec3 p = vec3(unit(random), unit(random), unit(random)) * vec3(size) - 0.5f;
                const ivec3 fine((p + 4.0f) / 4.0f);
                const ivec3 coarse = fine / 4;
                const float found = extinction(prepared->flat, p);
                const float fineBound = grid.fine[(fine.z * grid.fineSize.y + fine.y) * grid.fineSize.x + fine.x];
                const float coarseBound =
                    grid.coarse[(coarse.z * grid.coarseSize.y + coarse.y) * grid.coarseSize.x + coarse.x];
                QVERIFY2(found <= fineBound, qPrintable(QString("%1 > %2").arg(found).arg(fineBound)));
                QVERIFY(fineBound <= coarseBound);
            }
        }
    }

    void badNodesAreNamed() {
        TransferFunction function{1, {{.hu = 10}, {.hu = 5}}};
        QCOMPARE(function.check().error().where, std::string("transferFunction.nodes[1].hu"));
        function.nodes = {{.hu = 10, .opacity = std::nanf("")}};
        QCOMPARE(function.check().error().where, std::string("transferFunction.nodes[0].opacity"));
        function.nodes.clear();
        QVERIFY(!function.check());
    }
};

QTEST_GUILESS_MAIN(TransferFunctionTest)
#include "transfer_function_test.moc"
