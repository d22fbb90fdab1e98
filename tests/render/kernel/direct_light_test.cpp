/// Direct light: what the single light path of an event stands for, and that sampling a light and meeting it agree. The
/// tests check directions, distances and sums that are known without an image.

#include <QTest>
#include <cstring>
#include <random>

#include "render/device/cpu/event_group.h"
#include "render/kernel/transport/integrator.h"
#include "tests/support/scenes/scenes.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

Scene cube() {
    return test::plainScene(test::makeVolume({8, 6, 4}, {1, 2, 3}, [](int, int, int) { return 0; }), 1);
}

FlatLight panel() {
    Scene scene = cube();
    scene.lights = {RectangleLight{{40, -60, 20}, {-0.5, 0.8, -0.1}, {0, 0, 1}, 50, 30, vec3(2)}};
    return test::prepared(scene)->lights.front();
}

FlatLight ball() {
    Scene scene = cube();
    scene.lights = {SphereLight{{40, -60, 20}, 25, vec3(2)}};
    return test::prepared(scene)->lights.front();
}

/// Returns where a straight line from `from` (relative to the ball's centre) first meets the ball, in double.
double firstMeeting(dvec3 from, dvec3 direction, double radius) {
    const double along = glm::dot(from, direction);
    return -along - std::sqrt(along * along - glm::dot(from, from) + radius * radius);
}

constexpr std::uint32_t kAll = kFeatureMasks - 1;

/// Panels, a ball and a parallel light under a gradient, sought both ways.
Scene litFromAllSides() {
    Scene scene = cube();
    scene.lights = {RectangleLight{{40, -60, 20}, {-0.5, 0.8, -0.1}, {0, 0, 1}, 50, 30, vec3(2)},
                    RectangleLight{{-70, 10, 40}, {0.8, -0.1, -0.4}, {0, 0, 1}, 90, 60, vec3(1, 2, 3)},
                    SphereLight{{30, 60, -20}, 15, vec3(4, 1, 2)}, DirectionalLight{{0, 0, -1}, vec3(0.5f)}};
    scene.environment = {vec3(0.3f), false, vec3(0.1f, 0.2f, 0.3f)};
    scene.clip.planes = {{{0, 0, 2}, {0.1, 0.2, 1}}};
    return scene;
}

/// Events of all kinds: in fog, on matt and on glossy surfaces, seen from anywhere.
Event anyEvent(std::mt19937& random) {
    std::uniform_real_distribution<float> u(0.001f, 0.999f);
    const auto direction = [&] { return glm::normalize(vec3(u(random), u(random), u(random)) - 0.5f); };
    Event event{vec3(7 * u(random), 5 * u(random), 3 * u(random)), direction(), {}, vec3(0)};
    event.material = {vec3(u(random), u(random), u(random)), vec3(0), vec3(u(random) < 0.5f ? 0 : u(random)),
                      u(random)};
    if (u(random) < 0.7f)
        event.normal = facing(event.wo, direction());
    return event;
}

template <class T>
bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

class DirectLightTest : public QObject {
    Q_OBJECT

  private slots:
    /// Checks that the chosen one of several lights of one colour always brings what all bring together: isotropic
    /// tissue scatters albedo / 4 pi of it.
    void oneOfSeveralLightsStandsForTheirSum() {
        Scene scene = cube();
        scene.lights = {DirectionalLight{{0, 0, -1}, vec3(3)}, DirectionalLight{{1, 0, 0}, vec3(1)},
                        DirectionalLight{{0, 1, 1}, vec3(0.5f)}};
        const auto prepared = test::prepared(scene);
        const Event event{vec3(3, 2, 1), vec3(0, 1, 0), {.albedo = vec3(0.8f)}, vec3(0)};
        int firstChosen = 0;
        for (std::uint64_t i = 0; i < 1000; ++i) {
            const LightPath path = directLight<0>(prepared->flat, event, Sampler(kSobolTable, 1, 0, i), 0);
            QVERIFY(std::fabs(path.radiance.x / (0.8 / (4 * M_PI) * 4.5) - 1) < 1e-5);
            firstChosen += path.ray.direction.z > 0;
        }
        QVERIFY(firstChosen > 600 && firstChosen < 950);  // the brightest, but not always
    }

    /// What a light brings is its radiance times the solid angle that it fills, and it comes from the middle of it on
    /// average. A panel of half edges a, b straight ahead at distance d fills 4 asin(ab / sqrt((a^2 + d^2)(b^2 +
    /// d^2))).
    void aLightBringsItsSolidAngleEvenly() {
        const double d = 70, a = 25, b = 15;
        const auto fromAhead = [d](const FlatLight& light) { return light.position + light.normal * float(d); };
        const double filled = 4 * std::asin(a * b / std::sqrt((a * a + d * d) * (b * b + d * d)));
        const double cone = 1 - std::sqrt(1 - 25.0 * 25 / (d * d));  // 1 - cosine
        FlatLight round = ball();
        round.normal = vec3(0, 0, 1);
        for (const auto& [light, truth, square] :
             {std::tuple(panel(), 2 * filled, true), {round, 4 * M_PI * cone, false}}) {
            test::Sample brought, aside, up, forwards;
            vec3 s, t;
            orthonormalBasis(light.normal, s, t);
            for (std::uint64_t i = 0; i < 100'000; ++i) {
                const vec2 u = Random(5, 1, i).stream(Dimension::filter).pair();
                const LightSample sample = sampleLight<kPlacedLights>(light, fromAhead(light), u);
                brought.add(sample.radiance.x);
                aside.add(sample.radiance.x * glm::dot(sample.wi, s));
                up.add(sample.radiance.x * glm::dot(sample.wi, t));
                forwards.add(-glm::dot(sample.wi, light.normal));
            }
            const double allowed = test::allowedZ(8);
            QVERIFY2(std::fabs(brought.mean() - truth) < allowed * brought.standardError() + 1e-5 * truth,
                     qPrintable(QString("%1, must be %2").arg(brought.mean()).arg(truth)));
            QVERIFY(std::fabs(aside.z(0)) < allowed && std::fabs(up.z(0)) < allowed);
            QVERIFY(square || std::fabs(forwards.z(1 - cone / 2)) < allowed);  // even over the cone, so over its cosine
        }
    }

    void nothingShinesBehindAPanelOrInsideABall() {
        const FlatLight light = panel(), round = ball();
        for (const vec2 u : {vec2(0.1f, 0.2f), vec2(0.5f, 0.5f), vec2(0.9f, 0.3f)}) {
            QVERIFY(sampleLight<kPlacedLights>(light, light.position - light.normal * 30.0f, u).radiance == vec3(0));
            QVERIFY(sampleLight<kPlacedLights>(round, round.position + vec3(1, 2, 3), u).radiance == vec3(0));
        }
        QVERIFY(!intersectLight(light, -light.normal * 30.0f, light.normal).met);
    }

    /// The zenith lies towards the head.
    void aGradientRunsFromTheZenithToTheNadir() {
        Scene scene = cube();
        scene.environment = {vec3(3), false, vec3(1)};
        const auto prepared = test::prepared(scene);
        const FlatEnvironment& sky = prepared->flat.environment;
        QCOMPARE(environmentRadiance(sky, vec3(0, 0, 1)).x, 3.0f);
        QCOMPARE(environmentRadiance(sky, vec3(0, 1, 0)).x, 2.0f);
        QCOMPARE(environmentRadiance(sky, vec3(0, 0, -1)).x, 1.0f);
    }

    /// A hidden environment lights the tissue all the same.
    void hiddenSurroundingsAreNotSeen() {
        Scene scene = cube();
        scene.lights.clear();
        scene.camera.type = Camera::Type::orthographic;
        scene.camera.heightMm = 100;  // the volume lies in the middle of the film
        for (const bool visible : {false, true}) {
            scene.environment = {vec3(3), visible};
            const Film film = test::render(scene, 64);
            QCOMPARE(film.pixel(0, 0).mean.x, visible ? 3.0 : 0.0);
            QVERIFY(film.pixel(16, 16).mean.x > 0.1);
        }
    }

    void hiddenLightsAreNotSeen() {
        Scene scene = cube();
        scene.transferFunction.extinctionPerMm = 0;
        scene.camera.type = Camera::Type::orthographic;
        scene.camera.heightMm = 100;
        const dvec3 before = scene.volume->geometry().centreMm() - scene.camera.forward() * 18.0;
        for (const bool visible : {false, true}) {
            scene.lights = {SphereLight{before, 8, vec3(2), visible}, SphereLight{{900, 0, 0}, 10, vec3(2), true}};
            const Film film = test::render(scene, 16);
            QCOMPARE(film.pixel(16, 16).mean.x, visible ? 2.0 : 0.0);
            QCOMPARE(film.pixel(0, 0).mean.x, 0.0);
        }
    }

    /// A ray along a sampled direction meets the same light, where it was sampled and with the density it had.
    void whatIsSampledIsMetAlike() {
        std::mt19937 random(1);
        std::uniform_real_distribution<float> u(0.001f, 0.999f);
        for (const FlatLight& light : {panel(), ball()})
            for (int i = 0; i < 10'000; ++i) {
                const vec3 place(20 * u(random) - 10, 20 * u(random) - 10, 20 * u(random) - 10);
                const LightSample sample = sampleLight<kPlacedLights>(light, place, {u(random), u(random)});
                const LightHit hit = intersectLight(light, place - light.position, sample.wi);
                QVERIFY(hit.met);
                QVERIFY(std::fabs(hit.pdf / sample.pdf - 1) < 2e-3);
                QVERIFY(std::fabs(hit.distance - sample.distance) < 0.05);
                // Towards the other side it lies behind: there is no light in front.
                QVERIFY(!(intersectLight(light, place - light.position, -sample.wi).met &&
                          intersectLight(light, place - light.position, -sample.wi).distance > 0));
            }
    }

    /// The near side of a ball is the one that shines, and what stands inside it hides nothing.
    void aBallIsMetAtItsNearSide() {
        const FlatLight light = ball();
        std::mt19937 random(2);
        std::uniform_real_distribution<float> u(0, 1);
        for (int i = 0; i < 10'000; ++i) {
            const vec3 from(60 * u(random) + 30, 60 * u(random) - 30, 60 * u(random) - 30);
            const LightSample sample =
                sampleLight<kPlacedLights>(light, from + light.position, {u(random) * 0.99f, u(random)});
            const double truth = firstMeeting(dvec3(from), dvec3(sample.wi), 25);
            QVERIFY(std::fabs(intersectLight(light, from, sample.wi).distance - truth) < 0.02);
            QVERIFY(std::fabs(sample.distance - truth) < 0.02);
        }
    }

    /// Local space is patient space, shifted by the volume's centre, whatever the voxels are like.
    void placesInTheKernelAreThoseInThePatient() {
        dmat4 map(0);
        map[0] = {0.6, 0.8, 0, 0};
        map[1] = {-1.6, 1.2, 0, 0};
        map[2] = {0, 0, 3, 0};
        map[3] = {10, -20, 30, 1};
        Scene scene = cube();
        scene.volume = std::make_shared<Volume>(VolumeGeometry{{8, 6, 4}, map}, Voxels(192, 0));
        const auto prepared = test::prepared(scene);
        for (const dvec3 index : {dvec3(0), dvec3(7, 5, 3), dvec3(-0.5, 5.5, 1.25), dvec3(3.5, 2.5, 1.5)}) {
            const dvec3 truth = dvec3(map * dvec4(index, 1)) - scene.volume->geometry().centreMm();
            QVERIFY(glm::length(dvec3(localPosition(prepared->flat.volume, vec3(index))) - truth) < 1e-5);
        }
        QVERIFY(glm::length(scene.volume->geometry().centreMm() - dvec3(map * dvec4(3.5, 2.5, 1.5, 1))) < 1e-12);
    }

    /// A lane finds bit by bit what its event finds alone, whatever is in the other lanes: the light path, the
    /// continuation and the light on a segment.
    void lanesFindWhatEachEventFinds() {
        Scene scene = litFromAllSides();
        scene.maxBounces = 3;
        const auto prepared = test::prepared(scene);
        FlatScene flat = prepared->flat;
        flat.sampleDirections = flat.lightAlongPath = true;
        std::mt19937 random(7);
        for (int round = 0; round < 400; ++round) {
            flat.raysStartOutside = round % 2 == 0;
            LaneColumns<EventOf> events;
            LaneColumns<LightNumbersOf> numbers;
            LaneColumns<LitSegmentOf> segments;
            LaneColumns<Vec3> onward;
            for (int lane = 0; lane < kLanes; ++lane) {
                const Sampler sampler(kSobolTable, 1, std::uint32_t(lane), std::uint64_t(round));
                const Event event = anyEvent(random);
                events.set(lane, event);
                numbers.set(lane, lightNumbers<kAll>(flat, sampler, lane % 3));
                onward.set(lane, sampler.triple(lane % 3, BounceDimension::continuation));
                segments.set(lane, {event.position, event.wo, lane % 3 + 0.5f, lane % 4 < 2 ? -1.0f : 60.0f});
            }
            const LaneColumns<LightPathOf> paths(directLight<kAll>(flat, events.all(), numbers.all()));
            const LaneColumns<ContinuationOf> ways(continuationFrom<kAll>(flat, events.all(), onward.all(), true));
            const LaneColumns<Vec3> collected(lightOnSegment<kAll>(flat, segments.all()));
            for (int lane = 0; lane < kLanes; ++lane) {
                const Sampler sampler(kSobolTable, 1, std::uint32_t(lane), std::uint64_t(round));
                const Event event = events.at(lane);
                QVERIFY(sameBits(paths.at(lane), directLight<kAll>(flat, event, sampler, lane % 3)));
                QVERIFY(sameBits(ways.at(lane), continuationFrom<kAll>(flat, event, onward.at(lane), true)));
                QVERIFY(sameBits(collected.at(lane), lightOnSegment<kAll>(flat, segments.at(lane))));
            }
        }
    }
};

QTEST_GUILESS_MAIN(DirectLightTest)
#include "direct_light_test.moc"
