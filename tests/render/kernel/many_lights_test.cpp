/// More lights than an event can ask one by one: what is picked stands for all, and nothing on a ray is missed.

#include <QTest>
#include <random>
#include <set>

#include "render/kernel/transport/direct_light.h"
#include "tests/support/scenes/scenes.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

constexpr dvec3 kMiddle(4, 4, 6);

/// Panels, balls and parallel light from all over, none like another; one ball stands near.
Scene litBy(int count) {
    Scene scene = test::plainScene(test::makeVolume({8, 6, 4}, {1, 2, 3}, [](int, int, int) { return 0; }), 1);
    scene.lights = {SphereLight{kMiddle + dvec3(7, 0, 0), 0.5, vec3(9)}};
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    while (int(scene.lights.size()) < count) {
        const dvec3 to = glm::normalize(dvec3(normal(random), normal(random), normal(random)));
        const vec3 radiance(float(std::exp(normal(random))));
        const int kind = int(scene.lights.size() % 3);
        if (kind == 0)
            scene.lights.emplace_back(DirectionalLight{-to, radiance});
        else if (kind == 1)
            scene.lights.emplace_back(SphereLight{kMiddle + 40.0 * to, 3, 20.0f * radiance});
        else
            scene.lights.emplace_back(RectangleLight{kMiddle + 60.0 * to, -to, {0.1, 0, 1}, 12, 5, 20.0f * radiance});
    }
    return scene;
}

}  // namespace

class ManyLightsTest : public QObject {
    Q_OBJECT

  private slots:
    void fewLightsAreAllLookedAt() {
        const auto prepared = test::prepared(litBy(kMostLightsInTurn));
        QVERIFY(prepared->flat.lightSums == nullptr);
        int count = 0;
        forLightsLookedAt(prepared->flat, Sampler(kSobolTable, 1, 0, 0), 0, [&](const FlatLight& light, float weight) {
            QVERIFY(&light == &prepared->lights[std::size_t(count)] && weight == 1);
            ++count;
        });
        QCOMPARE(count, kMostLightsInTurn);
    }

    /// Each light counts once on average, at the first event and at later ones.
    void eachLightIsPickedForItself() {
        const auto prepared = test::prepared(litBy(200));
        const FlatScene& flat = prepared->flat;
        for (const int bounce : {0, 3}) {
            std::vector<test::Sample> weights(200);
            for (std::uint32_t pixel = 0; pixel < 20'000; ++pixel) {
                std::vector<double> of(200);
                int picks = 0;
                forLightsLookedAt(flat, Sampler(kSobolTable, 1, pixel, 0), bounce,
                                  [&](const FlatLight& light, float weight) {
                                      of[std::size_t(&light - flat.lights)] += weight;
                                      ++picks;
                                  });
                QCOMPARE(picks, kLightsPicked);
                for (std::size_t i = 0; i < of.size(); ++i)
                    weights[i].add(of[i]);
            }
            for (const test::Sample& weight : weights)
                QVERIFY2(std::fabs(weight.z(1)) < test::allowedZ(400), qPrintable(QString::number(weight.mean())));
        }
    }

    /// The lights that are looked at bring what all bring.
    void thePickedStandForAll() {
        const auto prepared = test::prepared(litBy(200));
        FlatScene all = prepared->flat;
        all.lightSums = nullptr;
        const Event event{vec3(3, 2, 1), vec3(0, 1, 0), {.albedo = vec3(0.8f)}, vec3(0)};
        test::Sample picked, asked;
        for (std::uint32_t pixel = 0; pixel < 20'000; ++pixel) {
            const Sampler sampler(kSobolTable, 1, pixel, 0);
            picked.add(directLight<kPlacedLights>(prepared->flat, event, sampler, 0).radiance.x);
            asked.add(directLight<kPlacedLights>(all, event, sampler, 0).radiance.x);
        }
        const double off = (picked.mean() - asked.mean()) / std::hypot(picked.standardError(), asked.standardError());
        QVERIFY2(std::fabs(off) < test::allowedZ(1), qPrintable(QString::number(off)));
    }

    void everyLightOnARayIsFound() {
        const auto prepared = test::prepared(litBy(500));
        const FlatScene& flat = prepared->flat;
        FlatScene all = flat;
        all.lightSums = nullptr;
        std::mt19937 random(8);
        std::normal_distribution<float> normal;
        long visited = 0, met = 0;
        for (int ray = 0; ray < 5000; ++ray) {
            const vec3 place(normal(random), normal(random), normal(random));
            const vec3 direction = glm::normalize(vec3(normal(random), normal(random), normal(random)));
            std::set<const FlatLight*> found, expected;
            forLightsMet<kPlacedLights>(flat, place, direction,
                                        [&](const FlatLight& light, const LightHit&) { found.insert(&light); });
            forLightsMet<kPlacedLights>(all, place, direction,
                                        [&](const FlatLight& light, const LightHit&) { expected.insert(&light); });
            QVERIFY(found == expected);
            met += long(expected.size());
            forLightsOnRay(flat, place, direction, [&](const FlatLight&) { ++visited; });
        }
        QVERIFY(met > 1000);
        QVERIFY2(visited < 10 * met, qPrintable(QString("%1 visited, %2 met").arg(visited).arg(met)));
    }

    /// A ray that misses them all looks at no node but the first.
    void whatIsBesideARayIsNotLookedAt() {
        const auto prepared = test::prepared(litBy(500));
        FlatScene flat = prepared->flat;
        std::vector<FlatLightNode> nodes(flat.lightNodes, flat.lightNodes + flat.lightNodeCount);
        const vec3 beside = nodes[0].centre + vec3(2 * nodes[0].radius, 0, 0);
        for (std::size_t i = 1; i < nodes.size(); ++i)
            nodes[i].centre = beside;  // so that looking at it is seen
        flat.lightNodes = nodes.data();
        int visited = 0;
        forLightsOnRay(flat, beside, vec3(0, 1, 0), [&](const FlatLight&) { ++visited; });
        QCOMPARE(visited, 0);
    }

    /// What does not shine is neither picked nor in the tree.
    void darkLightsCostNothing() {
        Scene scene = litBy(kMostLightsInTurn);
        for (int i = 0; i < 100; ++i)
            scene.lights.emplace_back(SphereLight{kMiddle + dvec3(50 + i, 0, 0), 1, vec3(0)});
        QVERIFY(test::prepared(scene)->flat.lightSums == nullptr);
        scene.lights.emplace_back(SphereLight{kMiddle + dvec3(0, 50, 0), 1, vec3(1)});
        const auto prepared = test::prepared(scene);
        QVERIFY(prepared->flat.lightSums != nullptr);
        for (const FlatLightNode& node : prepared->lightTables.nodes)
            QVERIFY(node.light < 0 || prepared->lights[std::size_t(node.light)].radiance != vec3(0));
        for (std::uint32_t pixel = 0; pixel < 1000; ++pixel)
            forLightsLookedAt(prepared->flat, Sampler(kSobolTable, 1, pixel, 0), 0,
                              [&](const FlatLight& light, float) { QVERIFY(light.radiance != vec3(0)); });
    }
};

QTEST_APPLESS_MAIN(ManyLightsTest)
#include "many_lights_test.moc"
