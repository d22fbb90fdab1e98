/// Tests the bounds that are stated for single pixels.

#include "render/film/error/local_error.h"

#include <QTest>
#include <cmath>

#include "tests/support/scenes/noisy_films.h"

using namespace pdr;
using test::chance;

namespace {

constexpr ivec2 kSize(40, 30);
constexpr std::uint32_t kSeen = kSeenTissue | kSeenChance;

/// Returns light of mean radiance 1, carried by one sample in `rarity`.
Film litFilm(std::uint64_t samples, double rarity, std::size_t luckless = std::size_t(-1)) {
    Film film(kSize, 1);
    const auto value = [&](std::size_t pixel, std::uint64_t sample) {
        if (pixel == luckless)
            return 0.01;
        return chance(3, pixel, sample) * rarity < 1 ? rarity : 0.0;
    };
    test::grow(film, samples, value, [](std::size_t) { return kSeen; });
    return film;
}

}  // namespace

class LocalErrorTest : public QObject {
    Q_OBJECT

  private slots:
    void aPixelThatHasSeenNoLightYetIsOffByWhatItsNeighboursAre() {
        const std::size_t luckless = 15 * 40 + 20;
        const Film film = litFilm(32, 8, luckless);
        const denoise::Plane errors = localErrors(film)[1];
        const double own = film.pixel(20, 15).standardError.y, stated = double(errors.row(15)[20]);
        QVERIFY(own == 0);
        QVERIFY(std::fabs(stated / std::sqrt(7.0 / 32) - 1) < 0.25);  // a variance of 8 - 1 a sample
    }
    void noneIsLessThanThePixelsOwn() {
        const Film film = test::noisyFilmOf(
            kSize, [](int x, int) { return x < 20 ? 0.01 : 1.0; }, 16);
        const denoise::Colours errors = localErrors(film);
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x)
                for (int c = 0; c < 3; ++c)
                    QVERIFY(errors[c].row(y)[x] >= 0.99999f * float(film.pixel(x, y).standardError[c]));
    }
    void nothingIsStatedWhereTheLightAroundRestsOnLessThanTwoBrightSamples() {
        const auto stated = [](const Film& film) {
            const denoise::Plane errors = localErrors(film)[1];
            double count = 0;
            for (int y = 0; y < kSize.y; ++y)
                count += double(std::count_if(errors.row(y), errors.row(y) + kSize.x,
                                              [](float error) { return std::isfinite(error); }));
            return count / (kSize.x * kSize.y);
        };
        QVERIFY(stated(litFilm(4, 400)) < 0.4);  // a quarter of a bright sample in 5 x 5 pixels
        QVERIFY(stated(litFilm(64, 100)) > 0.99);
        QCOMPARE(stated(litFilm(1, 1)), 0.0);
    }
    void whereChanceHasNoPartTheErrorIsZero() {
        Film film(kSize, 1);
        test::grow(
            film, 4, [](auto...) { return 0.5; }, [](std::size_t) { return 0u; });
        QCOMPARE(localErrors(film)[0].row(7)[7], 0.0f);
    }
};

QTEST_GUILESS_MAIN(LocalErrorTest)
#include "local_error_test.moc"
