/// The film of the CPU device, extended piece by piece: what it holds, whenever it is stopped.

#include <QTest>

#include "render/device/device.h"
#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

constexpr std::uint32_t kFirst = 3, kMore = 125;  // samples, over the end of a block

/// Tissue in the middle of an image that several pieces cover.
Scene scattered() {
    Scene scene = test::plainScene(test::bumpyVolume({24, 20, 16}, dvec3(1), 3), 1);
    scene.film = {112, 80};
    scene.camera.eyeMm = scene.camera.targetMm + (scene.camera.eyeMm - scene.camera.targetMm) * 3.0;
    return scene;
}

/// A film of the scene on a device of its own.
struct LiveFilm {
    LiveFilm() : scene(scattered()), device(makeCpuDevice(1)) {
        if (device->upload(scene))
            live = *device->film(scene.film, scene.revision, scene.schedule);
    }
    std::uint64_t extend(std::uint64_t had, std::uint32_t n, std::stop_token stop = {}, const Extended& told = {}) {
        return *live->extend(had, n, std::move(stop), told);
    }
    Film film() const { return **live->film(); }

    Scene scene;
    std::unique_ptr<Device> device;
    std::unique_ptr<Accumulator> live;
};

bool samePixel(const PixelEstimate& a, const PixelEstimate& b) {
    return a.mean == b.mean && a.standardError == b.standardError;
}

}  // namespace

class CpuFilmTest : public QObject {
    Q_OBJECT

  private slots:
    void piecesMakeTheImageOfWholePasses() {
        LiveFilm pieces, passes;
        int told = 0;
        QCOMPARE(pieces.extend(0, kFirst), std::uint64_t(kFirst));
        QCOMPARE(pieces.extend(kFirst, kMore, {}, [&](const SampleCounts&) { ++told; }), std::uint64_t(kFirst + kMore));
        QVERIFY2(told > 2, qPrintable(QString::number(told)));
        for (std::uint32_t i = 0; i < kFirst + kMore; ++i)
            QVERIFY(passes.live->accumulate(1, {}));
        const Film film = pieces.film();
        QVERIFY(film.status().meanLuminance > 0);
        QCOMPARE(film.samples(), passes.film().samples());
        QVERIFY(test::sameBits(film, passes.film()));
    }

    /// Each pixel has the samples of the image before or of that after the order, or those of a block in between.
    void aStopLeavesWholePieces() {
        LiveFilm stopped, before, after;
        std::stop_source stop;
        stopped.extend(0, kFirst);
        const std::uint64_t least =
            stopped.extend(kFirst, kMore, stop.get_token(), [&](const SampleCounts&) { stop.request_stop(); });
        QCOMPARE(least, std::uint64_t(kFirst));
        const Film film = stopped.film();
        QCOMPARE(film.samples().least, std::uint64_t(kFirst));
        QCOMPARE(film.samples().most, std::uint64_t(kFirst + kMore));
        before.extend(0, kFirst);
        after.extend(0, kFirst + kMore);
        const Film few = before.film(), many = after.film();
        for (int y = 0; y < film.size().y; ++y)
            for (int x = 0; x < film.size().x; ++x)
                QVERIFY(samePixel(film.pixel(x, y), few.pixel(x, y)) || samePixel(film.pixel(x, y), many.pixel(x, y)));
        stopped.extend(kFirst, kMore);  // cells that are ahead stay so
        QCOMPARE(stopped.film().samples().least, std::uint64_t(kFirst + kMore));
    }

    void aStopOfTheFirstSamplesLeavesNone() {
        LiveFilm stopped, whole;
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(stopped.extend(0, kFirst, stop.get_token()), std::uint64_t(0));
        QCOMPARE(stopped.film().samples().most, std::uint64_t(0));
        stopped.extend(0, kFirst);
        whole.extend(0, kFirst);
        QVERIFY(test::sameBits(stopped.film(), whole.film()));
    }
};

QTEST_GUILESS_MAIN(CpuFilmTest)
#include "cpu_film_test.moc"
