/// Tests what is stated of a pixel's levels when the errors of its channels are known: against random errors of known
/// correlation, with both tone curves.

#include "render/film/error/channel_margin.h"

#include <QTest>
#include <cmath>
#include <random>

#include "render/film/error/error_classes.h"
#include "render/film/error/level_error_map.h"
#include "render/film/error/likely_error.h"
#include "tests/support/scenes/noisy_films.h"

using namespace pdr;
using namespace pdr::test;

namespace {

constexpr float kExposure = 2;
constexpr Tone kKeepsHue{kExposure, ToneCurve::keepsHue}, kPerChannel{kExposure, ToneCurve::perChannel};

/// Returns normal numbers of variance 1, of which two each have that correlation.
dvec3 correlated(double correlation, std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double common = normal(random);
    const dvec3 own(normal(random), normal(random), normal(random));
    return std::sqrt(correlation) * dvec3(common) + std::sqrt(1 - correlation) * own;
}

/// Returns the mean of pixel i.
dvec3 pixelNumber(int i) {
    const dvec3 tissue[] = {{1, 0.69, 0.36}, {1, 0.6, 0.41}, {1, 0.12, 0.08},
                            {1, 1, 1},       {0.2, 0.3, 1},  {1, 0.98, 0.97}};
    return double(kExposure) * std::exp2(i / 6 - 3.0) * tissue[i % 6];
}

/// Returns the part of random errors of the standard error `error` that leave each channel within `margin` levels: that
/// of the channel which leaves it most often.
double leastWithin(const Tone& tone, dvec3 mean, dvec3 error, double correlation, float margin) {
    constexpr int kDraws = 4'000;
    const DisplayTransform transform = displayTransform(tone);
    std::mt19937 random(3);
    std::array<int, 3> within{};
    for (int i = 0; i < kDraws; ++i) {
        const vec3 light(mean / double(kExposure)), draw(error * correlated(correlation, random) / double(kExposure));
        const vec3 off = channelsOff(transform, light, draw);
        for (int c = 0; c < 3; ++c)
            within[std::size_t(c)] += off[c] <= margin;
    }
    return *std::ranges::min_element(within) / double(kDraws);
}

/// A film of 100 samples whose pixels' channels are off by normal errors of `error`, of that correlation.
Film colouredFilm(ivec2 size, dvec3 mean, dvec3 error, double correlation, unsigned seed = 5) {
    constexpr std::uint32_t kSamples = 100;
    std::mt19937 random(seed);
    FilmContent content = Film(size, 1).content();
    content.progress.advance(content.progress.area(), kSamples);
    for (std::size_t i = 0; i < content.moments.size(); ++i) {
        const dvec3 draw = error * correlated(correlation, random), off = error * correlated(correlation, random);
        const dvec3 m2 = error * error * double(kSamples) * double(kSamples - 1);
        content.moments[i] = {mean + off, m2, kSamples, vec3(mean + off + draw), kSamples / 2};
        content.block[i].seen = kSeenTissue | kSeenChance;
    }
    return Film(1, std::move(content));
}

/// Returns the part of the pixels, whose mean without noise is `mean`, that the map of levels holds: of the channel
/// that leaves it most often.
double leastInMap(const Film& film, dvec3 mean, const Tone& tone) {
    const LevelErrorMap map = levelErrorMap(film, tone);
    const DisplayTransform transform = displayTransform(tone);
    std::array<double, 3> within{};
    for (int y = 0; y < map.size.y; ++y)
        for (int x = 0; x < map.size.x; ++x) {
            const vec3 off = glm::abs(transform.exactLevels(film.pixel(x, y).mean) - transform.exactLevels(mean));
            const double margin = levelsOfBin(map.bins[std::size_t(map.size.x * y + x)]);
            for (int c = 0; c < 3; ++c)
                within[std::size_t(c)] += double(off[c]) <= margin;
        }
    return *std::ranges::min_element(within) / double(map.bins.size());
}

}  // namespace

class ChannelMarginTest : public QObject {
    Q_OBJECT

  private slots:
    /// 24 pixels; the chance of 4000 draws to miss 95 % by 1.5 % is one in 100,000.
    void ninetyFiveOfAHundredAreWithinTheMargin_data() {
        QTest::addColumn<double>("correlation");
        for (const double correlation : {0.0, 0.3, 0.7, 1.0})
            QTest::addRow("%.1f", correlation) << correlation;
    }
    void ninetyFiveOfAHundredAreWithinTheMargin() {
        QFETCH(double, correlation);
        for (int i = 0; i < 36; ++i) {
            const dvec3 mean = pixelNumber(i), error = 0.03 * mean;
            const float margin = levelsWithin(mean, error, kKeepsHue, float(correlation));
            const double within = leastWithin(kKeepsHue, mean, error, correlation, margin);
            const bool isGrey = i % 6 == 3 || i % 6 == 5;  // any channel may be the largest: the curve has a kink there
            QVERIFY2(within > (isGrey ? 0.91 : 0.935), qPrintable(QString("%1: %2").arg(i).arg(within)));
            QVERIFY2(within < (isGrey ? 0.985 : 0.968), qPrintable(QString("%1: %2").arg(i).arg(within)));
        }
    }

    void theOtherCurveAsksForNoCorrelation() {
        for (int i = 0; i < 36; ++i)
            QCOMPARE(levelsWithin(pixelNumber(i), 0.1 * pixelNumber(i), kPerChannel, 0),
                     levelsWithin(pixelNumber(i), 0.1 * pixelNumber(i), kPerChannel, 1));
    }

    /// Greys whose channels go together are as well known as with the other curve.
    void greysAreKnownAsWellAsBefore() {
        for (const double grey : {0.01, 0.3, 2.0, 9.0})
            QCOMPARE(levelsWithin(dvec3(grey), dvec3(0.1 * grey), kKeepsHue, 1),
                     levelsWithin(dvec3(grey), dvec3(0.1 * grey), kPerChannel, 1));
    }

    /// A channel without noise moves with the largest one.
    void theLargestChannelCountsForAll() {
        const DisplayTransform transform = displayTransform(kKeepsHue);
        const vec3 mean(1, 0.5f, 0.3f), off(0.2f, 0, 0);
        for (const float correlation : {0.0f, 0.5f, 1.0f}) {
            const vec3 truth = channelsOff(transform, mean, off);
            QVERIFY(truth.y > 1 && truth.z > 1);
            const float said = levelsApart(transform, mean, off, correlation);
            QVERIFY(std::fabs(said - std::max({truth.x, truth.y, truth.z})) < 1e-3f);
        }
    }

    void theFilmTellsHowItsChannelsGoTogether() {
        for (const double correlation : {0.0, 0.5, 1.0}) {
            const Film film = colouredFilm({40, 40}, {1, 0.6, 0.3}, {0.03, 0.02, 0.04}, correlation);
            const denoise::Plane told = likelyErrorsAndCorrelation(film, wholeImage(film.size())).correlation;
            double sum = 0;
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < 40; ++x)
                    sum += double(told.row(y)[x]) / 1600;
            QVERIFY2(std::fabs(sum - correlation) < 0.06, qPrintable(QString::number(sum)));
        }
    }

    /// The whole way: a film, its map, and what the pixels would show without noise. With both curves less holds where
    /// the channels' errors are independent, since the noise of the luminance is taken for that of each channel.
    void theMapHolds_data() { ninetyFiveOfAHundredAreWithinTheMargin_data(); }
    void theMapHolds() {
        QFETCH(double, correlation);
        for (const double light : {0.3, 2.0, 6.0}) {
            const dvec3 mean = light * dvec3(1, 0.65, 0.35);
            const Film film = colouredFilm({60, 60}, mean, 0.04 * mean, correlation);
            const double keeps = leastInMap(film, mean, kKeepsHue), each = leastInMap(film, mean, kPerChannel);
            QVERIFY2(keeps > each - 0.03, qPrintable(QString("%1 %2").arg(keeps).arg(each)));
            QVERIFY(keeps < 0.98 && (correlation < 0.7 || keeps > 0.92));
        }
    }

    void classesTellHowChannelsGoTogether() {
        const LookBin bin = LookBin::of(1, 1, 1);
        for (const double correlation : {0.0, 0.6, 1.0}) {
            std::mt19937 random(9);
            ErrorSums sums;
            for (int i = 0; i < 20'000; ++i) {
                const dvec3 error = dvec3(0.1, 0.2, 0.05) * correlated(correlation, random);
                const double sum = error.x + error.y + error.z;
                sums.add(bin, vec3(error * error), float(sum * sum));
            }
            QVERIFY(std::fabs(double(ErrorClasses(sums).correlation(bin)) - correlation) < 0.03);
        }
        QCOMPARE(ErrorClasses().correlation(bin), 1.0f);
    }
};

QTEST_GUILESS_MAIN(ChannelMarginTest)
#include "channel_margin_test.moc"
