#include <tbb/global_control.h>
#include <QTest>

#include "render/film/display/tone_map.h"
#include "tests/support/scenes/noisy_films.h"

using namespace pdr;
using namespace pdr::test;

namespace {

const std::vector<ivec2> kSizes{{1, 1}, {2, 1}, {1, 7}, {5, 3}, {16, 16}, {17, 31}, {40, 33}};

double flat(int, int) {
    return 0.3;
}

/// A disc before a darker ground.
double disc(int x, int y) {
    return std::hypot(x - 48, y - 32) < 20 ? 0.8 : 0.1;
}

double rmsError(const std::vector<double>& radiance, ivec2 size, const Truth& truth) {
    double squares = 0;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        const double off = radiance[i] - truth(int(i) % size.x, int(i) / size.x);
        squares += off * off / double(radiance.size());
    }
    return std::sqrt(squares);
}

std::vector<double> rawRadiance(const Film& film) {
    std::vector<double> radiance;
    for (std::size_t i = 0; i < pixelsOf(film); ++i)
        radiance.push_back(film.pixel(int(i) % film.size().x, int(i) / film.size().x).mean.x);
    return radiance;
}

double meanOf(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        sum += value / double(values.size());
    return sum;
}

std::vector<double> onThreads(int threads, const Film& film) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    return smoothRadiance(film);
}

}  // namespace

class SmoothingTest : public QObject {
    Q_OBJECT

  private slots:
    /// Denoising that begins after a stop request makes nothing, so an image that comes whole was not denoised again.
    void anotherExposureOfTheSameSamplesIsNotDenoisedAgain() {
        const Film few = noisyFilmOf({60, 40}, disc, 4), more = noisyFilmOf({60, 40}, disc, 5);
        std::stop_source stop;
        stop.request_stop();
        Development development;
        QVERIFY(development.image(few, {1, true}).rgba == imageOf(few, {1, true}).rgba);
        for (const float exposure : {0.5f, 2.0f})
            QVERIFY(development.image(few, {exposure, true}, stop.get_token()).rgba ==
                    imageOf(few, {exposure, true}).rgba);
        QVERIFY(development.image(more, {2, true}, stop.get_token()).rgba.empty());
        QVERIFY(development.image(more, {2, true}).rgba == imageOf(more, {2, true}).rgba);
        QVERIFY(development.image(more, {2, false}).rgba == imageOf(more, {2, false}).rgba);
        const Film another(2, more.content());
        QVERIFY(development.image(another, {2, true}, stop.get_token()).rgba.empty());
    }

    void anotherExposureOfMoreSamplesShowsWhatIsThere() {
        const Film few = noisyFilmOf({60, 40}, disc, 4), more = noisyFilmOf({60, 40}, disc, 5);
        const Film larger = noisyFilmOf({61, 40}, disc, 5);
        std::stop_source stop;
        stop.request_stop();
        Development development;
        (void)development.image(few, {1, true});
        QVERIFY(development.image(more, {2, true}, stop.get_token()).rgba == imageOf(few, {2, true}).rgba);
        QVERIFY(development.image(more, {2, true}).rgba == imageOf(more, {2, true}).rgba);
        QVERIFY(development.image(larger, {1, true}).rgba == imageOf(larger, {1, true}).rgba);
    }

    void whatWasDenoisedLastOutlivesOneThatWasBrokenOff() {
        const Film few = noisyFilmOf({60, 40}, disc, 4), more = noisyFilmOf({60, 40}, disc, 5);
        std::stop_source stop;
        stop.request_stop();
        Development development;
        (void)development.image(few, {1, true});
        QVERIFY(development.image(more, {1, true}, stop.get_token()).rgba.empty());
        QVERIFY(development.image(more, {2, true}, stop.get_token()).rgba == imageOf(few, {2, true}).rgba);
    }

    void threadsChangeNoBit() {
        const Film film = noisyFilmOf({150, 130}, disc, 8);
        QVERIFY(onThreads(1, film) == onThreads(3, film));
    }

    void noiseGoesAndLightStays() {
        const ivec2 size(96, 64);
        for (const std::uint64_t samples : {4, 16, 64}) {
            const Film film = noisyFilmOf(size, flat, samples);
            const std::vector<double> raw = rawRadiance(film), smooth = smoothRadiance(film);
            QVERIFY(rmsError(smooth, size, flat) < 0.1 * rmsError(raw, size, flat));
            QVERIFY(std::fabs(meanOf(smooth) / meanOf(raw) - 1) < 0.01);
        }
    }

    void edgesStay() {
        const ivec2 size(96, 64);
        const Film film = noisyFilmOf(size, disc, 16);
        const std::vector<double> raw = rawRadiance(film), smooth = smoothRadiance(film);
        QVERIFY2(rmsError(smooth, size, disc) < 0.4 * rmsError(raw, size, disc),
                 qPrintable(QString::number(rmsError(smooth, size, disc) / rmsError(raw, size, disc))));
        QVERIFY(std::fabs(meanOf(smooth) / meanOf(raw) - 1) < 0.01);
        for (int x = 44; x < 53; ++x) {
            QVERIFY(smooth[std::size_t(15 * 96 + x)] > 0.6);  // 17 pixels from the middle
            QVERIFY(smooth[std::size_t(5 * 96 + x)] < 0.2);   // 27
        }
    }

    /// The samples differ but their means are the same: there is noise to remove, and nothing to change.
    void aConstantImageStaysConstant() {
        for (const ivec2 size : kSizes) {
            Film film(size, 1);
            grow(
                film, 8, [](std::size_t, std::uint64_t sample) { return sample % 2 == 0 ? 0.25 : 0.75; },
                [](std::size_t) { return kSeenTissue; });
            for (const double radiance : smoothRadiance(film))
                QVERIFY(radiance == 0.5);
        }
    }

    void anImageWithoutNoiseIsLeftAlone() {
        const Film film = noisyFilmOf({96, 64}, disc, 8, 0);
        const std::vector<double> raw = rawRadiance(film), smooth = smoothRadiance(film);
        for (std::size_t i = 0; i < raw.size(); ++i)
            QVERIFY(float(smooth[i]) == float(raw[i]));
    }

    /// In tissue where one sample in 60 brings light most pixels are black by chance, with wide gaps between the
    /// others: no holes are left, and no light comes to the background beside it.
    void darkTissueHasNoHoles() {
        const ivec2 size(96, 64);
        const auto isTissue = [&](std::size_t pixel) { return int(pixel) % size.x < 64; };
        Film film(size, 1);
        grow(
            film, 4,
            [&](std::size_t pixel, std::uint64_t sample) {
                return isTissue(pixel) && chance(11, pixel, sample) < 1.0 / 60 ? 1.0 : 0.0;
            },
            [&](std::size_t pixel) { return isTissue(pixel) ? kSeenTissue | kSeenChance : kSeenChance; });
        const std::vector<double> smooth = smoothRadiance(film);
        int holes = 0, tissue = 0;
        double light = 0;
        for (std::size_t pixel = 0; pixel < smooth.size(); ++pixel)
            if (isTissue(pixel)) {
                ++tissue;
                light += smooth[pixel];
                holes += smooth[pixel] < 0.1 / 60;
            } else if (int(pixel) % size.x > 76) {
                QCOMPARE(smooth[pixel], 0.0);
            }
        QVERIFY2(holes < 0.01 * tissue, qPrintable(QString("%1 of %2").arg(holes).arg(tissue)));
        QVERIFY2(std::fabs(60 * light / tissue - 1) < 0.15, qPrintable(QString::number(60 * light / tissue)));
    }

    /// Short bent vessels of 2 pixels keep half of a contrast of 40 % at 16 samples, whose noise is a quarter of the
    /// light; on a background without vessels nothing is added.
    void smallVesselsStay() {
        const ivec2 size(320, 240);
        const auto shade = [](int x, int y) { return 0.5 + 0.1 * std::sin(0.05 * x) + 0.1 * std::cos(0.07 * y); };
        const auto isVessel = [](int x, int y) {  // an arc in each 40 x 40 pixels
            const dvec2 from(x % 40 - 19.5, y % 40 - 25.5);
            const double radius = 14 + (x / 40 * 7 + y / 40 * 3) % 5, angle = std::atan2(from.y, from.x);
            return std::fabs(glm::length(from) - radius) < 1 && angle < -0.6 && angle > -2.5;
        };
        const auto kept = [&](double contrast) {
            const auto drawn = [&](int x, int y) { return shade(x, y) * (isVessel(x, y) ? 1 + contrast : 1); };
            const std::vector<double> without = smoothRadiance(noisyFilmOf(size, shade, 16));
            const std::vector<double> with = smoothRadiance(noisyFilmOf(size, drawn, 16));
            double light = 0, left = 0;
            for (std::size_t i = 0; i < with.size(); ++i)
                if (const int x = int(i) % size.x, y = int(i) / size.x; isVessel(x, y)) {
                    light += contrast * shade(x, y);
                    left += with[i] - without[i];
                }
            return left / light;
        };
        const double dark = kept(-0.4), bright = kept(0.4);
        QVERIFY2(dark > 0.5 && bright > 0.33, qPrintable(QString("%1, %2").arg(dark).arg(bright)));
        const double calm = rmsError(smoothRadiance(noisyFilmOf(size, shade, 16)), size, shade);
        QVERIFY2(calm < 0.025 * 0.5, qPrintable(QString::number(calm)));
    }

    void emptyGroundFarFromNoiseStaysBlack() {
        const auto corner = [](int x, int y) { return x < 20 && y < 20 ? 0.5 : 0.0; };
        Film film(ivec2(96, 64), 1);
        grow(
            film, 4,
            [&](std::size_t pixel, std::uint64_t sample) {
                return corner(int(pixel % 96), int(pixel / 96)) * 2 * chance(1, pixel, sample);
            },
            [&](std::size_t pixel) {
                return corner(int(pixel % 96), int(pixel / 96)) > 0 ? kSeenTissue | kSeenChance : kSeenChance;
            });
        const std::vector<double> smooth = smoothRadiance(film);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 96; ++x)
                if (x >= 23 || y >= 23)
                    QVERIFY(smooth[std::size_t(y * 96 + x)] == 0);
    }

    /// A filter that measured in radiances would blur a dim scene and leave a bright one noisy.
    void brightnessChangesNoBit() {
        const auto scaled = [](double scale) {
            return smoothRadiance(noisyFilmOf(
                {60, 50}, [=](int x, int y) { return scale * disc(x, y); }, 8));
        };
        const std::vector<double> here = scaled(1), bright = scaled(0x1p40), dim = scaled(0x1p-40);
        for (std::size_t i = 0; i < here.size(); ++i) {
            QVERIFY(bright[i] == here[i] * 0x1p40);
            QVERIFY(dim[i] == here[i] * 0x1p-40);
        }
    }

    void nothingIsNegativeOrNoNumber() {
        const std::vector<Truth> truths{[](int, int) { return 0.0; }, disc,
                                        [](int x, int y) { return x == 3 && y == 2 ? 1e30 : 1e-6; },
                                        [](int x, int) { return x % 2 == 0 ? 1e-30 : 1e30; }};
        for (const ivec2 size : kSizes)
            for (const Truth& truth : truths)
                for (const std::uint64_t samples : {0, 1, 2, 3, 65})
                    for (const double radiance : smoothRadiance(noisyFilmOf(size, truth, samples)))
                        QVERIFY(radiance >= 0 && std::isfinite(radiance));
    }

    /// With one sample the noise is estimated from the neighbours.
    void oneSampleIsDenoisedToo() {
        const ivec2 size(96, 64);
        const Film film = noisyFilmOf(size, flat, 1);
        QVERIFY(rmsError(smoothRadiance(film), size, flat) < 0.25 * rmsError(rawRadiance(film), size, flat));
    }

    /// The samples fill each half evenly: their noise is a fifth of what independent samples of that spread would have.
    /// A filter that relied on the spread would blur the grating.
    void noiseThatIsLessThanItsSamplesSayIsMeasured() {
        const ivec2 size(96, 64);
        const auto grating = [](int x, int) { return 0.5 + 0.03 * (x / 4 % 2); };
        Film film(size, 1);
        const auto stratified = [&](std::size_t pixel, std::uint64_t sample) {
            const double place = double(sample / 2) + chance(9, pixel, sample);
            return grating(int(pixel) % size.x, 0) * (0.5 + std::fmod(place, 16) / 16);
        };
        grow(film, 32, stratified, [](std::size_t) { return kSeenTissue; });
        const std::vector<double> raw = rawRadiance(film), smooth = smoothRadiance(film);
        QVERIFY(rmsError(smooth, size, grating) < 0.7 * rmsError(raw, size, grating));
    }
};

QTEST_GUILESS_MAIN(SmoothingTest)
#include "smoothing_test.moc"
