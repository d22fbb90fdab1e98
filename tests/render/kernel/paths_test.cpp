/// Paths from event to event: how many events there may be, and that ending paths early changes no mean.

#include <QTest>

#include "render/kernel/transport/integrator.h"
#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

/// White fog without an end, in a uniform white environment.
Scene fog() {
    Scene scene = test::slab(1000, {0, 0, -1}, 1);
    scene.model = Model::multipleScattering;
    scene.lights.clear();
    scene.environment = {vec3(1), true};
    return scene;
}

/// Counts the events of a path.
struct Events {
    int count = 0;
    void segment(const Path&, int, const Collisions& met) { count += met.of[0] >= 0; }
    void light(const PathVertex&, const float*) {}
};

}  // namespace

class PathsTest : public QObject {
    Q_OBJECT

  private slots:
    void aPathHasAsManyEventsAsItMay() {
        for (const int most : {2, 3, 8}) {
            Scene scene = fog();
            scene.maxBounces = most;
            const auto prepared = test::prepared(scene);
            int longest = 0;
            for (std::uint64_t i = 0; i < 400; ++i) {
                Events events;
                const PathSample path =
                    tracePath<kBounces | kEnvironment>(prepared->flat, {1, 1}, i, vec2(0, 1e30f), events);
                QCOMPARE(path.cut, events.count == most);  // without absorption it ends at the cap or outside
                longest = std::max(longest, events.count);
            }
            QCOMPARE(longest, most);
        }
    }

    /// Checks the mean of free paths, 1 / extinction: the first flights of rays through uniform fog, to 0.05 %, so that
    /// an error of 0.3 % would be six standard errors.
    void freePathsAreAsLongAsTheExtinctionSays() {
        Scene scene = fog();
        scene.volume = test::makeVolume({5, 5, 300}, dvec3(1), [](int, int, int) { return 0; });
        scene.transferFunction.extinctionPerMm = 0.1f;
        const auto prepared = test::prepared(scene);
        const Ray ray{vec3(2, 2, -0.5f), vec3(0, 0, 1), 300};  // depth 30: one in 1e13 gets through
        test::Sample distance;
        for (std::uint64_t i = 0; i < 4'000'000; ++i)
            distance.add(
                track<DeltaTracking>(prepared->flat, ray, Random(1, 1, i).stream(0, BounceDimension::distance)));
        QVERIFY2(std::fabs(distance.z(10)) < test::allowedZ(1),
                 qPrintable(QString("%1 +- %2").arg(distance.mean()).arg(distance.standardError())));
    }

    /// Checks that a path keeps on average albedo times its throughput, however little that is, and continues in a
    /// direction of mean cosine g, as the phase function has it, whether or not other paths were ended.
    void endingPathsEarlyChangesNoMean() {
        constexpr float kG = 0.4f, kAlbedo = 0.7f;
        Scene scene = fog();
        scene.phaseG = kG;
        const auto prepared = test::prepared(scene);
        const Event event{vec3(200, 200, 2), vec3(0, 0, -1), {.albedo = vec3(kAlbedo)}, vec3(0)};
        for (const float before : {0.3f, 0.1f, 0.01f}) {
            test::Sample kept, forwards;
            for (std::uint64_t i = 0; i < 200'000; ++i) {
                Path path{Sampler(kSobolTable, 1, 2, i), {}, vec3(before)};
                const bool alive = sampleContinuation<kBounces>(prepared->flat, path, event, 3);
                const double after = alive ? path.throughput.x : 0;
                kept.add(after);
                forwards.add(after * -glm::dot(path.segment.direction, event.wo));
            }
            const double truth = double(before) * double(kAlbedo), allowed = test::allowedZ(6);
            QVERIFY2(std::fabs(kept.mean() - truth) <= allowed * kept.standardError() + 1e-6 * truth,
                     qPrintable(QString("%1, must be %2").arg(kept.mean()).arg(truth)));
            QVERIFY2(std::fabs(forwards.z(truth * double(kG))) < allowed,
                     qPrintable(QString("%1, must be %2").arg(forwards.mean()).arg(truth * double(kG))));
        }
    }
};

QTEST_GUILESS_MAIN(PathsTest)
#include "paths_test.moc"
