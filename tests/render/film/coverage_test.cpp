/// Whether what is stated of a picture's error holds, scene by scene: over seeds, against a far better picture. Few
/// seeds here; PDR_COVERAGE_SEEDS=200 takes as many, more samples too, and prints what came of them.
///   levels   the fraction of the tissue that lies within the levels stated for 95 % of it
///   mean     how often the 95 % interval of the picture's mean, from the draws of its pixels' errors, holds the truth
///   pixels   the fraction of pixels whose mean lies within two of the standard errors that are stated (localErrors) of
///            the truth, and of how many one is stated
///   map      the fraction of these that are shown within the levels stated of each of them (likelyErrors)

#include <QTest>
#include <cmath>

#include "render/film/level_error_map.h"
#include "render/film/likely_error.h"
#include "render/film/local_error.h"
#include "tests/support/coverage_scenes.h"
#include "tests/support/known_films.h"

using namespace pdr;
using test::MakeScene;

namespace {

constexpr float kExposure = 0.5f;
constexpr ivec2 kFilm(28, 22);

struct Coverage {
    double levels = 0, mean = 0, pixels = 0, stated = 0, map = 0;
    double fewBright = 0;  ///< pictures that say that they rest on few bright samples
};

/// Of one picture.
Coverage covered(const Film& film, const Film& truth) {
    const FilmStatus status = test::shownStatus(film, kExposure);
    const denoise::Plane errors = localErrors(film)[1];
    const denoise::Colours likely = likelyErrors(film, wholeImage(kFilm));
    double tissue = 0, within = 0, own = 0, stated = 0, mapped = 0, off = 0, squares = 0;
    for (int y = 0; y < kFilm.y; ++y)
        for (int x = 0; x < kFilm.x; ++x) {
            const PixelEstimate pixel = film.pixel(x, y), best = truth.pixel(x, y);
            off += pixel.mean.y - best.mean.y;
            squares += pixel.errorDraw.y * pixel.errorDraw.y;
            if (!pixel.tissue)
                continue;
            double levels = 0;
            for (int channel = 0; channel < 3; ++channel)
                levels = std::max(levels, std::fabs(test::curve(pixel.mean[channel], kExposure) -
                                                    test::curve(best.mean[channel], kExposure)));
            ++tissue;
            within += levels <= status.displayError;
            const double error = double(errors.row(y)[x]);
            stated += std::isfinite(error);
            own += std::isfinite(error) && std::fabs(pixel.mean.y - best.mean.y) <= 2 * error;
            const dvec3 likelyError(likely[0].row(y)[x], likely[1].row(y)[x], likely[2].row(y)[x]);
            mapped += std::isfinite(error) && levels <= double(levelsWithin(pixel.mean, likelyError, kExposure));
        }
    return {within / tissue, double(std::fabs(off) <= 1.96 * std::sqrt(squares)),
            own / stated,    stated / tissue,
            mapped / stated, double(status.fewBrightSamples)};
}

}  // namespace

class CoverageTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsStatedHolds_data() {
        QTest::addColumn<MakeScene>("made");
        QTest::addColumn<bool>("rareLight");  // most of a pixel's light comes by paths that few samples find
        QTest::newRow("tissue") << MakeScene(test::tissueScene) << false;
        QTest::newRow("lens") << MakeScene(test::tissueThroughALens) << false;
        QTest::newRow("forward fog") << MakeScene(test::forwardFog) << true;
        QTest::newRow("small bright lamp") << MakeScene(test::smallBrightLamp) << false;
        QTest::newRow("many bounces") << MakeScene(test::manyBounces) << false;
    }
    void whatIsStatedHolds() {
        QFETCH(MakeScene, made);
        QFETCH(bool, rareLight);
        const int asked = qEnvironmentVariableIntValue("PDR_COVERAGE_SEEDS");
        const int seeds = std::max(asked, 12);
        Scene scene = made();
        scene.film = kFilm;
        scene.seed = 9'999;
        const Film truth = test::render(scene, asked > 0 ? 65'536 : 8'192);
        for (const std::uint64_t samples : {64, 256, 1024}) {
            if (asked == 0 && samples > 256)
                break;
            Coverage sum;
            for (int seed = 1; seed <= seeds; ++seed) {
                scene.seed = std::uint64_t(seed);
                const Coverage one = covered(test::render(scene, samples), truth);
                sum.levels += one.levels / seeds, sum.mean += one.mean / seeds, sum.pixels += one.pixels / seeds;
                sum.stated += one.stated / seeds, sum.map += one.map / seeds;
                sum.fewBright += one.fewBright / seeds;
            }
            qInfo(
                "%4d samples, %d seeds: levels %.1f %%, mean %.1f %%, pixels %.1f %% of the %.1f %% that are stated, "
                "map "
                "%.1f %%; %.0f %% rest on few samples",
                int(samples), seeds, 100 * sum.levels, 100 * sum.mean, 100 * sum.pixels, 100 * sum.stated,
                100 * sum.map, 100 * sum.fewBright);
            // Where light is rare the picture thinks a little too well of itself, unless it says that it rests on few
            // samples.
            QVERIFY(sum.levels > (rareLight ? 0.9 : 0.93) && (sum.levels < 0.97 || sum.fewBright > 0));
            QVERIFY(sum.pixels > 0.95 && sum.stated > 0.9);
            QVERIFY(sum.map > 0.93 && (sum.map < 0.99 || rareLight));
            QVERIFY(sum.mean > 0.6);  // of 12 seeds: fails by chance once in 300,000 where it is 95 %
        }
    }
};

QTEST_GUILESS_MAIN(CoverageTest)
#include "coverage_test.moc"
