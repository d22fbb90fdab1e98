/// Tests denoising on features: what they show stays sharp however few the samples, and what they do not show is
/// denoised as without them.

#include <QTest>
#include <cmath>
#include <functional>
#include <limits>

#include "render/film/error/smoothing_judgement.h"
#include "tests/support/scenes/noisy_films.h"

using namespace pdr;
using denoise::Colours, denoise::Features, denoise::Guide, denoise::Plane;

namespace {

constexpr ivec2 kSize{96, 64};

using Values = std::function<double(int x, int y)>;

/// Returns grey guides of an image of `size`, seen straight on; `light` and `depth`: of the image's pixels.
Features::Guides guidesOf(ivec2 size, const Values& light, const Values& depth) {
    Guide made = denoise::guideOf(size, 1);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            for (Plane& plane : made.radiance)
                plane.row(y)[x] = float(light(x, y));
            made.normal[2].row(y)[x] = made.opacity.row(y)[x] = 1;
            made.depth.row(y)[x] = float(depth(x, y));
        }
    for (Plane* plane :
         {&made.radiance[0], &made.radiance[1], &made.radiance[2], &made.normal[2], &made.opacity, &made.depth})
        plane->mirror();
    const auto shared = std::make_shared<const Guide>(std::move(made));
    return {shared, shared};
}

double even(int, int) {
    return 1;
}
/// Texture of single pixels, which no denoiser finds by itself.
double textured(int x, int y) {
    return 0.6 + 0.8 * test::chance(7, std::size_t(y) * 1000 + std::size_t(x), 0);
}
/// Light that falls from one side to the other.
double fading(int x, int) {
    return 0.3 + 0.02 * x;
}

/// Returns the root mean square error of the denoised film; `features`: null for none.
double errorOf(const NoisyFilm& noisy, const Values& truth, const Features* features) {
    const Colours smooth = pdr::smoothRadiance(noisy, {}, features);
    double squares = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x)
            squares += std::pow(noisy.unit * double(smooth[0].row(y)[x]) - truth(x, y), 2);
    return std::sqrt(squares / (kSize.x * kSize.y));
}

bool areFinite(const Colours& colours) {
    for (const Plane& plane : colours)
        for (int y = 0; y < plane.size().y; ++y)
            for (int x = 0; x < plane.size().x; ++x)
                if (!std::isfinite(plane.row(y)[x]))
                    return false;
    return true;
}

}  // namespace

class RegressionTest : public QObject {
    Q_OBJECT

  private slots:
    /// The image is the texture times light that the features do not know.
    void textureThatTheFeaturesShowStays() {
        const auto truth = [](int x, int y) { return textured(x, y) * fading(x, y); };
        const NoisyFilm noisy = noisyFilm(test::noisyFilmOf(kSize, truth, 4));
        const Features features(guidesOf(kSize, textured, even));
        const double with = errorOf(noisy, truth, &features), without = errorOf(noisy, truth, nullptr);
        QVERIFY2(with < 0.75 * without, qPrintable(QString("%1 %2").arg(with).arg(without)));
    }

    /// Two surfaces of nearly the same light, one behind the other.
    void anEdgeInDepthStaysSharp() {
        const auto truth = [](int x, int) { return x < 48 ? 1.0 : 0.8; };
        const NoisyFilm noisy = noisyFilm(test::noisyFilmOf(kSize, truth, 4));
        const Features features(guidesOf(kSize, even, [](int x, int) { return x < 48 ? 100 : 160; }));
        const auto contrast = [&](const Features* on) {
            const Colours smooth = pdr::smoothRadiance(noisy, {}, on);
            double sum = 0;
            for (int y = 0; y < kSize.y; ++y)
                sum += noisy.unit * double(smooth[0].row(y)[47] - smooth[0].row(y)[48]);
            return sum / kSize.y / 0.2;
        };
        const double with = contrast(&features), without = contrast(nullptr);
        QVERIFY2(with > 0.7 && with < 1.3 && without < 0.6, qPrintable(QString("%1 %2").arg(with).arg(without)));
    }

    /// Depth counts by its differences, wherever the tissue lies.
    void depthHasNoOrigin() {
        const auto truth = [](int x, int y) { return 1 + 0.5 * std::sin(0.2 * x + 0.1 * y); };
        const NoisyFilm noisy = noisyFilm(test::noisyFilmOf(kSize, truth, 4));
        const auto depth = [&](double from) {
            return Features(guidesOf(kSize, even, [=](int x, int y) { return from + 20 * truth(x, y); }));
        };
        const Features near = depth(10), far = depth(20000);
        const double one = errorOf(noisy, truth, &near), other = errorOf(noisy, truth, &far);
        QVERIFY2(std::fabs(one - other) < 0.02 * one, qPrintable(QString("%1 %2").arg(one).arg(other)));
    }

    /// What has nothing to do with the image is found to be so, except for some noise.
    void featuresOfAnotherImageDoLittleHarm() {
        const NoisyFilm noisy = noisyFilm(test::noisyFilmOf(kSize, fading, 16));
        const Features same(guidesOf(kSize, even, even)), other(guidesOf(kSize, textured, even));
        const double with = errorOf(noisy, fading, &other), without = errorOf(noisy, fading, &same);
        QVERIFY2(with < 1.15 * without, qPrintable(QString("%1 %2").arg(with).arg(without)));
    }

    void anImageWithoutNoiseOrDifferencesStaysToTheBit() {
        const NoisyFilm noisy = noisyFilm(test::noisyFilmOf(kSize, even, 4, 0));
        const Features features(guidesOf(kSize, textured, fading));
        const Colours smooth = pdr::smoothRadiance(noisy, {}, &features);
        for (int c = 0; c < 3; ++c)
            for (int y = 0; y < kSize.y; ++y)
                for (int x = 0; x < kSize.x; ++x)
                    QCOMPARE(smooth[std::size_t(c)].row(y)[x], noisy.all.mean[std::size_t(c)].row(y)[x]);
    }

    /// Pixels are fitted many at a time; those of narrow images, too, and beyond the last of a row.
    void eachPixelIsFittedByItself() {
        const auto truth = [](int x, int y) { return textured(x, y); };
        for (const ivec2 size : {ivec2(1, 1), ivec2(3, 40), ivec2(17, 5), ivec2(40, 33)}) {
            const NoisyFilm noisy = noisyFilm(test::noisyFilmOf(size, truth, 4));
            const Features features(guidesOf(size, textured, even));
            QCOMPARE(features.size(), size);
            const Colours smooth = pdr::smoothRadiance(noisy, {}, &features);
            QVERIFY(areFinite(smooth));
            // Upside down and mirrored, each pixel becomes the same but for the order of sums
            const auto turned = [&](const Values& value) {
                return [=](int x, int y) { return value(size.x - 1 - x, size.y - 1 - y); };
            };
            NoisyFilm back = noisy;
            const auto turn = [&](Plane& plane) {
                const Plane from = plane;
                for (int y = 0; y < size.y; ++y)
                    for (int x = 0; x < size.x; ++x)
                        plane.row(y)[x] = from.row(size.y - 1 - y)[size.x - 1 - x];
                plane.mirror();
            };
            for (Plane* plane :
                 {&back.all.mean[0], &back.all.mean[1], &back.all.mean[2], &back.all.variance, &back.ratio})
                turn(*plane);
            const Features backFeatures(guidesOf(size, turned(textured), even));
            const Colours other = pdr::smoothRadiance(back, {}, &backFeatures);
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    QVERIFY(std::fabs(smooth[0].row(y)[x] - other[0].row(size.y - 1 - y)[size.x - 1 - x]) < 1e-3f);
        }
    }

    void lightThatIsNoNumberIsDark() {
        const NoisyFilm noisy = noisyFilm(test::noisyFilmOf(kSize, fading, 4));
        for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
            const Features features(guidesOf(
                kSize, [bad](int x, int) { return x % 9 == 0 ? bad : 1.0; }, even));
            QVERIFY(areFinite(pdr::smoothRadiance(noisy, {}, &features)));
        }
    }

    /// The halves know nothing of each other, so that each can judge the other.
    void aHalfOnFeaturesKnowsItsOwnSamplesAlone() {
        NoisyFilm noisy = noisyFilm(test::noisyFilmOf(kSize, textured, 8));
        const auto features = std::make_shared<const Features>(guidesOf(kSize, textured, even));
        const SmoothHalves halves = smootherOn(features)(noisy, {});
        for (Plane& plane : noisy.odd.mean)
            plane = Plane(kSize);
        const SmoothHalves again = smootherOn(features)(noisy, {});
        const SmoothHalves plain = denoisedHalves(noisy, {});
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x)
                QCOMPARE(again.even[0].row(y)[x], halves.even[0].row(y)[x]);
        QVERIFY(again.odd[0].row(9)[9] != halves.odd[0].row(9)[9]);
        QVERIFY(plain.even[0].row(9)[9] != halves.even[0].row(9)[9]);
    }

    void aStopRequestEndsIt() {
        std::stop_source stop;
        stop.request_stop();
        const NoisyFilm noisy = noisyFilm(test::noisyFilmOf(kSize, textured, 4));
        const Features features(guidesOf(kSize, textured, even));
        QCOMPARE(pdr::smoothRadiance(noisy, stop.get_token(), &features)[0].size(), kSize);
    }
};

QTEST_GUILESS_MAIN(RegressionTest)
#include "regression_test.moc"
