/// A picture without a window: what a stop request leaves of it.

#include <QTest>

#include "render/session/batch_render.h"
#include "tests/support/failing_device.h"
#include "tests/support/pictures.h"

namespace pdr {

class TestBatchRender : public QObject {
    Q_OBJECT

  private slots:
    void aStopRequestKeepsTheSampleOnItsWayOrDiscardsIt_data();
    void aStopRequestKeepsTheSampleOnItsWayOrDiscardsIt();
    void whatIsToBeDiscardedEndsAsWellWhereNothingStopsIt();
};

static Scene smallSlab() {
    Scene scene = test::slab(1, {0, 1, 0}, 0.5f);
    scene.film = {24, 16};
    return scene;
}

void TestBatchRender::aStopRequestKeepsTheSampleOnItsWayOrDiscardsIt_data() {
    QTest::addColumn<bool>("keeps");
    QTest::newRow("kept") << true;
    QTest::newRow("discarded") << false;
}

void TestBatchRender::aStopRequestKeepsTheSampleOnItsWayOrDiscardsIt() {
    QFETCH(bool, keeps);
    std::stop_source stop;
    int launches = 0;
    const auto mishaps = std::make_shared<test::Mishaps>();
    mishaps->before = [&](const std::string& verb) {
        if (verb == "accumulate" && ++launches == 2)
            stop.request_stop();
    };
    const auto device = test::failing(mishaps);
    const Scene scene = smallSlab();
    QVERIFY(device->upload(scene));
    const auto film = *device->film(scene.film, scene.revision, scene.schedule);
    BatchRender batch(*film, {.samples = 40}, {}, keeps ? WhenStopped::keep : WhenStopped::discard);
    const auto ended = batch.run(stop.get_token(), [](const BatchState&) {});
    QVERIFY(ended && ended->reason == StopReason::interrupted);
    QCOMPARE(launches, 2);
    QCOMPARE(mishaps->brokenOff.load(), !keeps);
    QCOMPARE(ended->film.samplesPerPixel > 1, keeps);
}

void TestBatchRender::whatIsToBeDiscardedEndsAsWellWhereNothingStopsIt() {
    const auto device = test::failing(std::make_shared<test::Mishaps>());
    const Scene scene = smallSlab();
    QVERIFY(device->upload(scene));
    const auto film = *device->film(scene.film, scene.revision, scene.schedule);
    const auto ended = BatchRender(*film, {.samples = 40}, {}, WhenStopped::discard).run({}, [](const BatchState&) {});
    QVERIFY(ended && ended->reason == StopReason::samples);
    QCOMPARE(ended->film.samplesPerPixel, std::uint64_t(40));
}

}  // namespace pdr

QTEST_GUILESS_MAIN(pdr::TestBatchRender)
#include "batch_render_test.moc"
