#include <QTest>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "render/accuracy/error_against_time.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

constexpr std::array<double, 3> kExposureRender{0.2945, 0.411, 0.2945};  ///< Exposure Render's filter, one direction
constexpr int kEdge = 64;                                                ///< pixels; the image repeats beyond

using Image = std::vector<double>;

Image filtered(const Image& image) {
    Image result(image.size(), 0);
    for (int y = 0; y < kEdge; ++y)
        for (int x = 0; x < kEdge; ++x)
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    result[y * kEdge + x] += kExposureRender[j + 1] * kExposureRender[i + 1] *
                                             image[(y + j + kEdge) % kEdge * kEdge + (x + i + kEdge) % kEdge];
    return result;
}

double meanSquare(const Image& image, const Image& truth) {
    double sum = 0;
    for (std::size_t i = 0; i < image.size(); ++i)
        sum += (image[i] - truth[i]) * (image[i] - truth[i]);
    return sum / double(image.size());
}

/// Returns fine stripes, which a filter removes.
Image stripes() {
    Image image;
    for (int y = 0; y < kEdge; ++y)
        for (int x = 0; x < kEdge; ++x)
            image.push_back(1 + 0.2 * std::cos(2 * std::numbers::pi * x / 8));
    return image;
}

/// Returns `truth` with the noise that n samples of standard deviation 1 leave.
Image rendered(const Image& truth, double samples, std::mt19937_64& random) {
    std::normal_distribution<double> noise(0, 1 / std::sqrt(samples));
    Image image = truth;
    for (double& pixel : image)
        pixel += noise(random);
    return image;
}

}  // namespace

class ErrorAgainstTimeTest : public QObject {
    Q_OBJECT

  private slots:
    void exposureRendersFilterLeavesAnEighthOfTheVariance() {
        QVERIFY(std::fabs(remainingVariance(kExposureRender) - 0.117) < 0.0005);
        QCOMPARE(remainingVariance(std::array{1.0}), 1.0);
    }

    /// With random seeds, a false alarm would come once in 1e4 runs.
    void errorsOfImagesAreThoseForetold() {
        const Image truth = stripes();
        const double bias = meanSquare(filtered(truth), truth), kappa = remainingVariance(kExposureRender);
        std::mt19937_64 random(11);
        const std::array samples{4.0, 16.0, 400.0};
        for (const double n : samples) {
            test::Sample plain, blurred;
            for (int picture = 0; picture < 40; ++picture) {
                const Image image = rendered(truth, n, random);
                plain.add(meanSquare(image, truth));
                blurred.add(meanSquare(filtered(image), truth));
            }
            const double allowed = test::allowedZ(2 * int(samples.size()));
            QVERIFY(std::fabs(plain.z(unbiasedError(1, n))) < allowed);
            QVERIFY(std::fabs(blurred.z(filteredError(bias, kappa, 1, n))) < allowed);
            // The crossing lies where the images say: the filter wins before it, and loses after it for good
            QCOMPARE(blurred.mean() < plain.mean(), n < crossingSamples(bias, kappa, 1));
        }
    }

    void errorsMeetAtTheCrossing() {
        const double n = crossingSamples(0.01, 0.117, 2);
        QVERIFY(std::fabs(unbiasedError(2, n) / filteredError(0.01, 0.117, 2, n) - 1) < 1e-12);
        QVERIFY(std::isinf(crossingSamples(0, 0.117, 2)));
    }

    void tenthOfTheErrorTakesHundredTimesTheSamplesInWholeFrames() {
        QCOMPARE(samplesForError(0.1, 4), 400.0);
        QCOMPARE(samplesForError(0.01, 4), 40000.0);
        QCOMPARE(secondsForSamples(400, 100, 0.5), 2.0);
        QCOMPARE(secondsForSamples(401, 100, 0.5), 2.5);
        QCOMPARE(secondsForSamples(0.3, 100, 0.5), 0.5);
    }
};

QTEST_GUILESS_MAIN(ErrorAgainstTimeTest)
#include "error_against_time_test.moc"
