/// Tests whether the upper bounds stated for a denoised image hold, scene by scene: over seeds, against a far better
/// image. It takes few seeds; with PDR_COVERAGE_SEEDS=100 it takes that many, more samples too, and prints the results.
///   relative  how often the root mean square error lies within its bound
///   levels    how often 95 % of the tissue lie within the levels that are stated for 95 % of it
///   slack     the stated over the true error, as a median: of the one and of the other

#include <QTest>
#include <algorithm>
#include <cmath>

#include "render/film/error/smoothing_judgement.h"
#include "tests/support/scenes/coverage_scenes.h"
#include "tests/support/scenes/known_films.h"

using namespace pdr;
using test::MakeScene;

namespace {

constexpr ivec2 kFilm(96, 80);

/// Ratios of the stated to the true error of an image.
struct Statement {
    double relativeSlack, levelsSlack;  ///< stated over true error
};

/// Returns the ratios for the image that is shown. Nothing where no error is stated.
std::optional<Statement> statementOf(const Film& film, const Film& truth, double exposure) {
    const auto stated = SmoothingJudgement::of(film)->overAll(exposure);
    if (!stated)
        return std::nullopt;
    const NoisyFilm noisy = noisyFilm(film);
    const denoise::Colours smooth = smoothRadiance(noisy);
    double mean = 0, squares = 0, pixels = 0;
    std::vector<double> levels;
    for (int y = 0; y < kFilm.y; ++y)
        for (int x = 0; x < kFilm.x; ++x) {
            const PixelEstimate best = truth.pixel(x, y);
            if (!best.tissue)
                continue;
            dvec3 shown;
            double off = 0;
            for (int c = 0; c < 3; ++c) {
                shown[c] = noisy.unit * double(smooth[c].row(y)[x]);
                off = std::max(off, std::fabs(test::curve(shown[c], exposure) - test::curve(best.mean[c], exposure)));
            }
            levels.push_back(off);
            mean += luminance(best.mean), ++pixels;
            // Subtract the noise of the reference image
            squares += std::pow(luminance(shown - best.mean), 2) - std::pow(luminance(best.errorDraw), 2);
        }
    const auto at = levels.begin() + std::ptrdiff_t(0.95 * double(levels.size()));
    std::ranges::nth_element(levels, at);
    const double relative = std::sqrt(squares / pixels) / (mean / pixels);
    return Statement{stated->relativeAtMost / relative, stated->levelsAtMost / *at};
}

/// Returns the median of a list that is not empty.
double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

}  // namespace

class DenoisedCoverageTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsStatedHolds_data() {
        QTest::addColumn<MakeScene>("made");
        QTest::addColumn<double>("exposure");
        QTest::newRow("tissue") << MakeScene(test::tissueScene) << 0.5;
        QTest::newRow("dark tissue") << MakeScene(test::tissueScene) << 8.0;
        QTest::newRow("lens") << MakeScene(test::tissueThroughALens) << 0.5;
        QTest::newRow("forward fog") << MakeScene(test::forwardFog) << 0.5;
        QTest::newRow("small bright lamp") << MakeScene(test::smallBrightLamp) << 0.5;
        QTest::newRow("many bounces") << MakeScene(test::manyBounces) << 0.5;
    }
    void whatIsStatedHolds() {
        QFETCH(MakeScene, made);
        QFETCH(double, exposure);
        const int asked = qEnvironmentVariableIntValue("PDR_COVERAGE_SEEDS");
        const int seeds = std::max(asked, 5);
        Scene scene = made();
        scene.film = kFilm;
        scene.seed = 9'999;
        const Film truth = test::render(scene, asked > 0 ? 4096 : 512);
        for (const std::uint64_t samples : {4, 8, 16, 64}) {
            if (asked == 0 && samples > 16)
                break;
            std::vector<double> relative, levels;
            for (int seed = 1; seed <= seeds; ++seed) {
                scene.seed = std::uint64_t(seed);
                if (const auto one = statementOf(test::render(scene, samples), truth, exposure))
                    relative.push_back(one->relativeSlack), levels.push_back(one->levelsSlack);
            }
            if (relative.empty()) {
                qInfo("%3d samples, %d seeds: nothing is said", int(samples), seeds);
                continue;
            }
            const auto held = [](const std::vector<double>& slack) {
                return int(std::ranges::count_if(slack, [](double one) { return one >= 1; }));
            };
            const int films = int(relative.size());
            qInfo("%3d samples, %d films, %d with a bound: relative held in %d, slack %.2f; levels in %d, slack %.2f",
                  int(samples), seeds, films, held(relative), median(relative), held(levels), median(levels));
            QVERIFY(held(relative) >= 0.95 * films - 1 && held(levels) >= 0.95 * films - 1);
        }
    }
};

QTEST_GUILESS_MAIN(DenoisedCoverageTest)
#include "denoised_coverage_test.moc"
