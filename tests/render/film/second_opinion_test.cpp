/// Compares the noise estimated from the halves of a film with other estimates of the same noise.
///   halves       the draws of the error (errorDrawOf), which the screen's numbers come from
///   blocks       images of 64 samples, each with random numbers of its own: how far their means lie apart
///   the samples  the standard errors that a film keeps beside the halves, as if its samples were independent
/// Blocks of one film are no independent estimate: they share their low-discrepancy points, and lie further apart than
/// their mean is off.

#include <QTest>
#include <cmath>

#include "tests/support/scenes/coverage_scenes.h"
#include "tests/support/statistics.h"

using namespace pdr;
using test::MakeScene;

namespace {

constexpr int kBlocks = 24;

/// Mean squares of the error of the green channel over the pixels of an image.
struct Noise {
    double halves = 0, samples = 0;  ///< mean over the blocks, each alone
    double blocks = 0;
};

Noise noiseOf(Scene scene) {
    std::vector<Film> blocks;
    for (scene.seed = 1; scene.seed <= kBlocks; ++scene.seed)
        blocks.push_back(test::render(scene, kSamplesPerBlock));
    Noise noise;
    for (int y = 0; y < scene.film.y; ++y)
        for (int x = 0; x < scene.film.x; ++x) {
            test::Sample means;
            for (const Film& block : blocks) {
                const PixelEstimate pixel = block.pixel(x, y);
                means.add(pixel.mean.y);
                noise.halves += pixel.errorDraw.y * pixel.errorDraw.y / kBlocks;
                noise.samples += pixel.standardError.y * pixel.standardError.y / kBlocks;
            }
            noise.blocks += kBlocks * means.standardError() * means.standardError();
        }
    return noise;
}

}  // namespace

class SecondOpinionTest : public QObject {
    Q_OBJECT

  private slots:
    void halvesAndBlocksAgreeWithinTenPercent_data() {
        QTest::addColumn<MakeScene>("made");
        QTest::newRow("tissue") << MakeScene(test::tissueScene);
        QTest::newRow("lens") << MakeScene(test::tissueThroughALens);
        QTest::newRow("small bright lamp") << MakeScene(test::smallBrightLamp);
        QTest::newRow("many bounces") << MakeScene(test::manyBounces);
    }
    void halvesAndBlocksAgreeWithinTenPercent() {
        QFETCH(MakeScene, made);
        Scene scene = made();
        scene.film = {28, 22};
        const Noise noise = noiseOf(scene);
        const double halves = std::sqrt(noise.halves / noise.blocks), samples = std::sqrt(noise.samples / noise.blocks);
        qInfo("root mean square error, over that by blocks: by the halves %.3f, by the samples %.2f", halves, samples);
        QVERIFY(std::fabs(halves - 1) < 0.1);
        QVERIFY(samples > 1);  // low-discrepancy points are better than independent samples, never worse
    }
};

QTEST_GUILESS_MAIN(SecondOpinionTest)
#include "second_opinion_test.moc"
