/// Faults that are put into a scene are counted by cause, and each can be replayed.

#include <QTest>

#include "render/device/cpu/replay.h"
#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

Scene glowing() {
    Scene scene = test::plainScene(test::bumpyVolume({30, 30, 30}, dvec3(1), 3), 0.5f);
    scene.transferFunction.nodes = {{.hu = -200, .opacity = 0}, {.hu = 500, .opacity = 1}};
    scene.film = {24, 20};
    return scene;
}

Health healthOf(std::shared_ptr<const PreparedScene> prepared, int threads = 2, int tile = 4096) {
    return test::sampled(prepared, 40, 7, tile, threads).status().health;
}

/// `prepared` with one light of that radiance.
std::shared_ptr<PreparedScene> litBy(vec3 radiance) {
    const auto prepared = test::prepared(glowing());
    prepared->lights[0].radiance = radiance;
    return prepared;
}

void verifyReplayShows(const PreparedScene& prepared, Fault fault, const FaultCount& first) {
    const ivec2 film = prepared.flat.camera.film;
    const Replay replay = replayed(prepared, {int(first.pixel) % film.x, int(first.pixel) / film.x}, first.sample);
    QVERIFY2(replay.faults.of(fault).count > 0,
             qPrintable(QString("pixel %1 sample %2 of %3, radiance %4, segments %5, collision %6 light %7 T %8")
                            .arg(first.pixel)
                            .arg(first.sample)
                            .arg(first.count)
                            .arg(replay.radiance.x)
                            .arg(replay.segments.size())
                            .arg(replay.segments[0].events[0].collision)
                            .arg(replay.segments[0].events[0].light.radiance.x)
                            .arg(replay.segments[0].events[0].light.transmittance)));
    QVERIFY(!replay.segments.empty());
}

}  // namespace

class HealthTest : public QObject {
    Q_OBJECT

  private slots:
    void aRightSceneIsPerfect() { QVERIFY(healthOf(test::prepared(glowing())).perfect()); }

    void lightThatIsNoneIsCountedByCause_data() {
        QTest::addColumn<float>("light");
        QTest::addColumn<int>("fault");
        QTest::newRow("NaN") << NAN << int(Fault::notANumber);
        QTest::newRow("infinite") << INFINITY << int(Fault::infinite);
        QTest::newRow("too bright for float") << 3.4e38f << int(Fault::infinite);
        QTest::newRow("negative") << -1.0f << int(Fault::negative);
    }
    void lightThatIsNoneIsCountedByCause() {
        QFETCH(float, light);
        QFETCH(int, fault);
        // Bright enough that after scattering it is still beyond float.
        Scene scene = glowing();
        const auto prepared = litBy(vec3(light));
        if (std::isfinite(light) && light > 1)
            prepared->lights.assign(40, prepared->lights[0]);
        prepared->flat.lights = prepared->lights.data();
        prepared->flat.lightCount = int(prepared->lights.size());
        const Health health = healthOf(prepared);
        QVERIFY(health.rejected() > 0);
        QCOMPARE(health.of(Fault(fault)).count, health.rejected());
        verifyReplayShows(*prepared, Fault(fault), health.of(Fault(fault)));
    }

    void extinctionAboveItsBoundIsCounted() {
        Scene scene = glowing();
        scene.model = Model::multipleScattering;  // behind the first event rays are tracked
        const auto prepared = test::prepared(scene);
        auto majorants = std::make_shared<Majorants>(*prepared->majorants);
        for (float& bound : majorants->fine)
            bound *= 0.5f;
        for (float& bound : majorants->coarse)
            bound *= 0.5f;
        prepared->flat.majorants.fine = majorants->fine.data();
        prepared->flat.majorants.coarse = majorants->coarse.data();
        prepared->majorants = majorants;
        const FaultCount found = healthOf(prepared).of(Fault::overMajorant);
        QVERIFY(found.count > 100);
        verifyReplayShows(*prepared, Fault::overMajorant, found);
    }

    void cutPathsAreCounted() {
        Scene scene = glowing();
        scene.model = Model::multipleScattering;
        for (TransferNode& node : scene.transferFunction.nodes)
            node.albedo = vec3(1);
        QVERIFY(healthOf(test::prepared(scene)).perfect());
        scene.maxBounces = 2;
        const auto prepared = test::prepared(scene);
        const Health health = healthOf(prepared);
        QVERIFY(health.of(Fault::cutPath).count > 100);
        QCOMPARE(health.rejected(), std::uint64_t(0));
        verifyReplayShows(*prepared, Fault::cutPath, health.of(Fault::cutPath));
        scene.model = Model::singleScattering;  // has one event by its nature: nothing is cut
        QVERIFY(healthOf(test::prepared(scene)).perfect());
    }

    void countsDoNotDependOnThreadsOrTiles() {
        Scene scene = glowing();
        scene.model = Model::multipleScattering;
        scene.maxBounces = 2;
        const FaultCount one = healthOf(test::prepared(scene), 1).of(Fault::cutPath);
        const FaultCount other = healthOf(test::prepared(scene), 4, 7).of(Fault::cutPath);
        QVERIFY(one.count == other.count && one.sample == other.sample && one.pixel == other.pixel);
    }

    /// A replayed sample is the sample: the mean of a pixel's replays is the pixel, bit by bit.
    void aReplayIsTheSample() {
        Scene scene = glowing();
        scene.model = Model::multipleScattering;
        scene.gradientFactor = 1;
        scene.environment = {vec3(0.1f, 0.2f, 0.3f), true};
        const auto prepared = test::prepared(scene);
        const Film film = test::sampled(prepared, 32);
        for (const ivec2 pixel : {ivec2(12, 10), ivec2(3, 17), ivec2(0, 0)}) {
            dvec3 sum(0);
            for (std::uint64_t sample = 0; sample < 32; ++sample)
                sum += dvec3(replayed(*prepared, pixel, sample).radiance);
            QCOMPARE(sum.x / 32, film.pixel(pixel.x, pixel.y).mean.x);
        }
    }
};

QTEST_GUILESS_MAIN(HealthTest)
#include "health_test.moc"
