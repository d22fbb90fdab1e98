/// Whether forecasts come true: from a picture of 64 samples, how many more it takes to errors of 0.6 and 0.35 of its
/// own, scene by scene over seeds. Few seeds here; PDR_COVERAGE_SEEDS=40 takes as many, from 256 samples as well, and
/// prints what came of them (with QTEST_FUNCTION_TIMEOUT=3600000: it takes longer than tests may). From 64 samples the
/// exponent of a scene is little known; of all scenes it is right.

#include <QTest>
#include <algorithm>
#include <cmath>

#include "render/accuracy/forecast.h"
#include "tests/support/coverage_scenes.h"

using namespace pdr;
using test::MakeScene;

namespace {

constexpr float kExposure = 0.5f;

/// A picture in the making, shown whenever its samples have grown by a twelfth.
class Growing {
  public:
    Growing(const Scene& scene, Device& device) : film_(*device.film(scene.film, scene.revision, {})) {}

    FilmStatus next() {
        const auto more = std::max<std::uint64_t>(done_ / 12, 8);
        (void)film_->accumulate(std::uint32_t(more), {});
        done_ += more;
        (void)film_->resolve({kExposure});
        return (*film_->readback()).status;
    }

  private:
    std::unique_ptr<Accumulator> film_;
    std::uint64_t done_ = 0;
};

struct Tally {
    std::vector<double> ratios;  ///< foretold over needed samples
    int within = 0, atLeast = 0, notLess = 0;
};

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Goes on until the error is `part` of what it is now, at most to twice the end of the interval.
void judge(Growing& picture, const ErrorHistory& history, const FilmStatus& early, double part, Tally& tally) {
    const Foretold foretold = history.samples(part * early.displayError);
    FilmStatus status = early;
    while (status.displayError > part * early.displayError && double(status.samplesPerPixel) < 2 * foretold.high)
        status = picture.next();
    const auto needed = double(status.samplesPerPixel);
    tally.atLeast += early.fewBrightSamples;
    tally.notLess += needed >= foretold.low;
    tally.within += needed >= foretold.low && needed <= foretold.high;
    tally.ratios.push_back(foretold.value / needed);
}

/// Over seeds, from pictures of so many samples.
Tally tallyOf(Scene scene, int seeds, std::uint64_t samples, double part, Device& device) {
    Tally tally;
    for (int seed = 1; seed <= seeds; ++seed) {
        scene.seed = std::uint64_t(seed);
        ++scene.revision;
        (void)device.upload(scene);
        Growing picture(scene, device);
        ErrorHistory history;
        FilmStatus status;
        while (status.samplesPerPixel < samples) {
            status = picture.next();
            history.add(double(status.samplesPerPixel), status);
        }
        judge(picture, history, status, part, tally);
    }
    return tally;
}

}  // namespace

class ForecastCoverageTest : public QObject {
    Q_OBJECT

  private slots:
    void forecastsComeTrue_data() {
        QTest::addColumn<MakeScene>("made");
        QTest::newRow("tissue") << MakeScene(test::tissueScene);
        QTest::newRow("lens") << MakeScene(test::tissueThroughALens);
        QTest::newRow("forward fog") << MakeScene(test::forwardFog);
        QTest::newRow("small bright lamp") << MakeScene(test::smallBrightLamp);
        QTest::newRow("many bounces") << MakeScene(test::manyBounces);
    }
    void forecastsComeTrue() {
        QFETCH(MakeScene, made);
        const int asked = qEnvironmentVariableIntValue("PDR_COVERAGE_SEEDS"), seeds = std::max(asked, 10);
        Scene scene = made();
        scene.film = {28, 22};
        for (const std::uint64_t samples : {64, 256})
            for (const double part : {0.6, 0.35}) {
                if (asked == 0 && samples > 64)
                    break;
                const Tally tally = tallyOf(scene, seeds, samples, part, *device_);
                const double median = medianOf(tally.ratios);
                qInfo(
                    "from %d samples to %.2f of the error: %d of %d inside, %d not before, %d said at least, "
                    "foretold / needed %.2f in the median",
                    int(samples), part, tally.within, seeds, tally.notLess, tally.atLeast, median);
                QVERIFY(tally.notLess >= 0.9 * seeds);
                if (tally.atLeast > seeds / 2)
                    continue;
                // Of 10 where it is 95 %: fails by chance once in 1,000 scenes. 256 samples are the worst place to
                // foretell from: there the points dip, and all seeds together.
                QVERIFY(tally.within >= (asked > 0 ? 0.8 : 0.7) * seeds);
                QVERIFY(median > 0.66 && median < 1.5);
                ratios_.insert(ratios_.end(), tally.ratios.begin(), tally.ratios.end());
            }
    }
    void ofAllScenesTheMedianIsRight() {
        const double median = medianOf(ratios_);
        QVERIFY2(std::fabs(median - 1) < 0.1, qPrintable(QString::number(median)));
    }

  private:
    std::unique_ptr<Device> device_ = makeCpuDevice();
    std::vector<double> ratios_;  ///< of all that did not say "at least"
};

QTEST_GUILESS_MAIN(ForecastCoverageTest)
#include "forecast_coverage_test.moc"
