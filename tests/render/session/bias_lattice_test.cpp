/// A lattice of a few pixels finds the same bias of an image as all its pixels do after far more samples.

#include <QTest>

#include <cmath>
#include <future>

#include "render/device/emulated/emulated_gpu.h"
#include "render/film/tone_curve.h"
#include "render/session/bias_measurements.h"
#include "render/session/session.h"
#include "tests/support/devices/screen.h"
#include "tests/support/scenes/tissue_scene.h"

using namespace pdr;

namespace {

Scene image(ivec2 film) {
    Scene scene = test::tissueScene();
    scene.film = film;
    return scene;
}

Scene blurred(Scene scene) {
    scene.schedule = {Schedule::Kind::kroes, false, true, true};
    return scene;
}

Scene marched(Scene scene) {
    scene.estimator = Estimator::kroesMarch;
    scene.transferFunction.extinctionPerMm = 4;  // one step is many free paths: the march misses much
    return scene;
}

/// Whole films, rendered both ways.
struct Films {
    std::shared_ptr<const Film> biased, exact;

    Films(Scene scene, Scene other, std::uint32_t samples, Device& device)
        : biased(made(std::move(scene), samples, device)), exact(made(std::move(other), samples, device)) {}

    static std::shared_ptr<const Film> made(Scene scene, std::uint32_t samples, Device& device) {
        scene.schedule.runningMean = false;
        const auto growing = startFilm(device, scene);
        (void)(*growing)->accumulate(samples, {});
        return *(*growing)->film();
    }
    /// Calls look(pixel with the bias, pixel without) for the pixels with tissue.
    template <class Look>
    void each(const Look& look) const {
        for (int y = 0; y < biased->size().y; ++y)
            for (int x = 0; x < biased->size().x; ++x)
                if (const PixelEstimate pixel = biased->pixel(x, y); pixel.tissue)
                    look(pixel, exact->pixel(x, y));
    }
    MeasuredBias bias() const {
        std::vector<BiasTile> tiles;
        each([&](const PixelEstimate& one, const PixelEstimate& other) {
            tiles.push_back({{one.halves, other.halves}});
        });
        return *measuredBias(tiles, 1);
    }
    /// Returns twice the root mean square difference of green, noise included [levels].
    double differ() const {
        const auto level = [](double radiance) { return double(exactLevelOf(displayCurve(), float(radiance))); };
        double squares = 0, count = 0;
        each([&](const PixelEstimate& one, const PixelEstimate& other) {
            squares += std::pow(level(one.mean.y) - level(other.mean.y), 2);
            ++count;
        });
        return 2 * std::sqrt(squares / count);
    }
};

/// Returns the error of a running mean of n iterations over all pixels, with other samples: against the same samples in
/// double precision, without the first.
double roundingOf(Scene scene, std::uint32_t n, Device& device) {
    scene.seed += 7;
    Scene exact = exactly(scene);
    const auto film = [&](const Scene& of, std::uint32_t samples) {
        const auto growing = startFilm(device, of);
        (void)(*growing)->accumulate(samples, {});
        return *(*growing)->film();
    };
    const auto rounded = film(scene, n), all = film(exact, n), first = film(exact, 1);
    const auto level = [](double radiance) { return double(exactLevelOf(displayCurve(), float(radiance))); };
    dvec3 squares(0);
    double count = 0;
    for (int y = 0; y < scene.film.y; ++y)
        for (int x = 0; x < scene.film.x; ++x)
            if (const PixelEstimate pixel = all->pixel(x, y); pixel.tissue) {
                const dvec3 mean = (double(n) * pixel.mean - first->pixel(x, y).mean) / double(n - 1);
                for (int c = 0; c < 3; ++c)
                    squares[c] += std::pow(level(rounded->pixel(x, y).mean[c]) - level(mean[c]), 2);
                ++count;
            }
    return 2 * std::sqrt(glm::max(squares.x, glm::max(squares.y, squares.z)) / count);
}

bool within(double found, double truth, double factor) {
    return found <= factor * truth && found >= truth / factor;
}

}  // namespace

class BiasLatticeTest : public QObject {
    Q_OBJECT

  private slots:
    void theBiasIsFoundWithinAFactorOfOneAndAHalf_data() {
        QTest::addColumn<Scene>("scene");
        QTest::newRow("march") << marched(image({140, 100}));
        QTest::newRow("blur") << blurred(image({140, 100}));
        QTest::newRow("both") << blurred(marched(image({140, 100})));
    }
    void theBiasIsFoundWithinAFactorOfOneAndAHalf() {
        QFETCH(Scene, scene);
        const auto device = makeCpuDevice();
        Scene exact = exactly(scene);
        exact.seed += 7;
        const MeasuredBias truth = Films(scene, exact, 256, *device).bias();
        BiasLattice lattice(withoutShortcuts(scene));
        for (int round = 0; round < 4; ++round)
            QVERIFY(bool(lattice.addRound(*device, {})));
        const auto found = lattice.measured(1);
        QVERIFY(found);
        qInfo("%+.1f %% (%+.1f to %+.1f), truth %+.1f %%; %.1f levels (%.1f to %.1f), truth %.1f",
              100 * found->brightness.value, 100 * found->brightness.low, 100 * found->brightness.high,
              100 * truth.brightness.value, found->levels.value, found->levels.low, found->levels.high,
              truth.levels.value);
        QVERIFY(within(found->levels.value, truth.levels.value, 1.5) && found->levels.low > 0);
        const auto& [value, low, high] = found->brightness;
        const double off = truth.brightness.value - value;  // 3 standard errors are 1.53 half widths of 95 %
        QVERIFY(off > 1.53 * (low - value) && off < 1.53 * (high - value));
    }

    /// Compares rays to a visible tolerance with the same rays to a hundredth of it, on all pixels.
    void whatAToleranceDoesIsFoundWithinAFactorOfOneAndAHalf() {
        Scene scene = image({140, 100});
        scene.model = Model::emissionAbsorption;
        scene.toleranceLevels = 4;
        const auto device = makeCpuDevice();
        Scene exact = exactly(scene);
        exact.toleranceLevels = 0.04f;
        const MeasuredBias truth = Films(scene, exact, 64, *device).bias();
        BiasLattice lattice(withoutTolerance(scene));
        for (int round = 0; round < 4; ++round)
            QVERIFY(bool(lattice.addRound(*device, {})));
        const auto found = lattice.measured(1);
        QVERIFY(found);
        qInfo("%.4f levels (%.4f to %.4f), truth %.4f", found->levels.value, found->levels.low, found->levels.high,
              truth.levels.value);
        QVERIFY(within(found->levels.value, truth.levels.value, 1.5) && truth.levels.value > 0);
        QVERIFY(found->levels.high <= 4);  // the bound holds
    }

    /// Rounding is the only bias left: the lost first sample is none.
    void whatARunningMeanDoesIsFoundWithinAFactorOfOneAndAHalf() {
        Scene scene = image({70, 50});
        scene.schedule = {Schedule::Kind::kroes, false, false, true};
        const auto device = makeCpuDevice();
        BiasLattice lattice(withoutRounding(scene));
        for (int round = 0; round < 4; ++round)
            QVERIFY(bool(lattice.addRound(*device, {})));
        QCOMPARE(lattice.samples(), std::uint64_t(512));
        const auto found = lattice.measured(1);
        QVERIFY(found);
        const double truth = roundingOf(scene, 512, *device);
        qInfo("%.3g levels (%.3g to %.3g), truth %.3g", found->levels.value, found->levels.low, found->levels.high,
              truth);
        QVERIFY(within(found->levels.value, truth, 1.5));
    }

    /// Both filters use the same random numbers, so nearly all that differs is the filter.
    void whatTextureUnitsDoLiesBelowTheBound() {
        const auto device = makeEmulatedGpu();
        Scene fast = image({40, 30});
        fast.filtering = Filtering::fast;
        const double truth = Films(fast, exactly(fast), 64, *device).differ();
        const auto found = measureBias(fast, 1, *device, 0, {});
        QVERIFY(bool(found) && found->shortcuts);
        QVERIFY2(truth > 0 && truth < found->shortcuts->levels.high,
                 qPrintable(QString("%1, %2").arg(truth).arg(found->shortcuts->levels.high)));
    }

    void aStoppedRoundCountsForNothing() {
        const auto device = makeCpuDevice();
        std::stop_source source;
        source.request_stop();
        BiasLattice lattice(withoutShortcuts(marched(image({64, 64}))));
        QVERIFY(bool(lattice.addRound(*device, source.get_token())));
        QCOMPARE(lattice.samples(), std::uint64_t(0));
        QVERIFY(bool(lattice.addRound(*device, {})));
        QCOMPARE(lattice.samples(), std::uint64_t(64));
    }

    /// The session measures between two frames and does not change the image.
    void aSessionMeasuresItBesideTheImage() {
        Scene scene = marched(image({64, 48}));
        scene.revision = 5;
        const auto device = makeCpuDevice();
        test::Screen screen;
        std::shared_ptr<const Film> film;
        {
            Session session(makeCpuDevice(2), screen.sink());
            session.setIterationsPerFrame(32);
            session.submit(scene, false);
            QVERIFY(screen.await([](const Frame& frame) { return frame.bias.measured.shortcuts.has_value(); }));
            std::promise<void> taken;
            session.requestSnapshot(5, [&](const Result<FilmView>& view) {
                film = std::make_shared<Film>(view->film.revision(), view->film.content());
                taken.set_value();
            });
            taken.get_future().wait();
        }
        const Film other = test::render(scene, film->samplesPerPixel(), *device);
        QVERIFY(sameBits(film->content(), other.content()));

        scene.estimator = Estimator::unbiased;
        test::Screen exact;
        Session session(makeCpuDevice(2), exact.sink());
        session.submit(scene, false);
        const auto frame = exact.await([](const Frame& frame) { return frame.status.samplesPerPixel > 256; });
        QVERIFY(frame && !frame->bias.measured.shortcuts);
    }
};

QTEST_GUILESS_MAIN(BiasLatticeTest)
#include "bias_lattice_test.moc"
