/// Tests which lines are marked in films with lines drawn into their samples, and in films without any.

#include <tbb/global_control.h>
#include <QTest>
#include <numbers>

#include "render/film/error/smoothing_judgement.h"
#include "tests/support/scenes/noisy_films.h"
#include "tests/support/scenes/tissue_scene.h"

using namespace pdr;
using namespace pdr::test;
using denoise::LostLine;

namespace {

constexpr ivec2 kFilm(420, 300), kCell(70, 75);
constexpr int kLines = 24;

double shade(int x, int y) {
    return 0.5 + 0.1 * std::sin(0.05 * x) + 0.1 * std::cos(0.07 * y);
}

/// Spokes, brighter every other one: edges in all directions, as high as the noise of few samples.
double wheel(int x, int y) {
    const dvec2 from = dvec2(x, y) - dvec2(kFilm) / 2.0;
    if (glm::length(from) < 70)
        return 0.5;
    return int(std::floor(8 * (std::atan2(from.y, from.x) / std::numbers::pi + 1))) % 2 == 0 ? 1.0 : 0.7;
}

double discs(int x, int y) {
    return std::hypot(x % 60 - 30, y % 60 - 30) < 20 ? 1 : 0.2;
}

/// A straight line, 2 pixels wide.
struct Drawn {
    dvec2 middle;
    double angle, length;

    /// Returns a place in the frame of the line: along it from its middle, and across it.
    dvec2 seen(dvec2 place) const {
        const dvec2 from = place - middle, along(std::cos(angle), std::sin(angle));
        return {glm::dot(from, along), from.y * along.x - from.x * along.y};
    }
    /// Returns the share of a pixel that the line covers.
    double cover(int x, int y) const {
        constexpr int kParts = 4;
        int inside = 0;
        for (int i = 0; i < kParts * kParts; ++i) {
            const dvec2 place = glm::abs(seen({x + (i % kParts + 0.5) / kParts, y + (i / kParts + 0.5) / kParts}));
            inside += place.x <= length / 2 && place.y <= 1;
        }
        return double(inside) / (kParts * kParts);
    }
    /// Returns whether all of a mark lies on the line.
    bool has(const LostLine& mark) const {
        const dvec2 begin = seen(mark.begin), end = seen(mark.end);
        const double off = std::max(std::fabs(begin.y), std::fabs(end.y));
        return off < 4 && std::fabs(begin.x + end.x) < length;
    }
};

/// Returns the line of a cell, 60 pixels long; each cell has another direction.
Drawn lineIn(int cell) {
    const dvec2 corner(cell % 6 * kCell.x, cell / 6 * kCell.y);
    return {corner + dvec2(kCell) / 2.0, std::numbers::pi * 0.618 * cell, 60};
}

/// Returns `truth` with its values computed once for each pixel.
Truth drawn(const Truth& truth) {
    std::vector<double> values;
    for (int y = 0; y < kFilm.y; ++y)
        for (int x = 0; x < kFilm.x; ++x)
            values.push_back(truth(x, y));
    return [values = std::move(values)](int x, int y) { return values[std::size_t(y * kFilm.x + x)]; };
}

Truth withLines(double contrast) {
    return drawn([contrast](int x, int y) {
        const int cell = y / kCell.y * 6 + x / kCell.x;
        return shade(x, y) * (1 - contrast * lineIn(cell).cover(x, y));
    });
}

std::vector<LostLine> marksOf(const Film& film) {
    return SmoothingJudgement::of(film)->lostLines();
}

/// Returns the marks of a film whose denoised image shows nothing but what `plain` shows.
std::vector<LostLine> marksBeside(const Film& film, const Film& plain) {
    const NoisyFilm noisy = noisyFilm(film), calm = noisyFilm(plain);
    const auto scaled = [](const denoise::Plane& plane, double unit) {
        return denoise::combined([unit](float value) { return float(unit) * value; }, plane);
    };
    const auto square = float(noisy.unit * noisy.unit);
    const denoise::Plane variance = denoise::combined([square](float value) { return square * value; },
                                                      denoise::realVariance(noisy.all.variance, noisy.ratio));
    return denoise::lostLines(scaled(denoise::luminance(noisy.all.mean), noisy.unit),
                              scaled(denoise::luminance(pdr::smoothRadiance(calm)), calm.unit), variance);
}

/// Returns whether the denoised image keeps less than half of a line's contrast.
bool isLost(const Drawn& line, const std::vector<double>& without, const std::vector<double>& with, double contrast) {
    double light = 0, kept = 0;
    for (int y = 0; y < kFilm.y; ++y)
        for (int x = 0; x < kFilm.x; ++x)
            if (const double cover = line.cover(x, y); cover == 1) {
                const auto pixel = std::size_t(y * kFilm.x + x);
                light += contrast * without[pixel];
                kept += without[pixel] - with[pixel];
            }
    return kept < 0.5 * light;
}

}  // namespace

class LostLinesTest : public QObject {
    Q_OBJECT

  private slots:
    /// All lines are marked where the denoised image shows none of them.
    void lostLinesAreMarkedAndNothingElse_data() {
        QTest::addColumn<int>("samples");
        QTest::addColumn<double>("contrast");
        QTest::addRow("40 %% at 16 samples") << 16 << 0.4;
        QTest::addRow("20 %% at 64 samples") << 64 << 0.2;
    }
    void lostLinesAreMarkedAndNothingElse() {
        QFETCH(int, samples);
        QFETCH(double, contrast);
        const Film plain = noisyFilmOf(kFilm, shade, std::uint64_t(samples));
        const Film drawn = noisyFilmOf(kFilm, withLines(contrast), std::uint64_t(samples));
        const std::vector<LostLine> marks = marksBeside(drawn, plain);
        int marked = 0, right = 0;
        for (int cell = 0; cell < kLines; ++cell) {
            const Drawn line = lineIn(cell);
            const auto on = std::ranges::count_if(marks, [&](const LostLine& mark) { return line.has(mark); });
            right += int(on);
            marked += on > 0;
        }
        QVERIFY2(marked >= 0.8 * kLines, qPrintable(QString("%1 of %2").arg(marked).arg(kLines)));
        QCOMPARE(right, int(marks.size()));
        QVERIFY(std::ranges::all_of(marks, &LostLine::darker));
    }

    /// Lines that are so clear that the denoised image loses few are not marked, and no mark stands where there is no
    /// line.
    void whatTheDenoisedImageKeepsIsNotMarked_data() {
        QTest::addColumn<int>("samples");
        QTest::addColumn<double>("contrast");
        QTest::addRow("40 %% at 16 samples") << 16 << 0.4;
        QTest::addRow("20 %% at 64 samples") << 64 << 0.2;
    }
    void whatTheDenoisedImageKeepsIsNotMarked() {
        QFETCH(int, samples);
        QFETCH(double, contrast);
        const Film plain = noisyFilmOf(kFilm, shade, std::uint64_t(samples));
        const Film drawn = noisyFilmOf(kFilm, withLines(contrast), std::uint64_t(samples));
        const std::vector<double> without = smoothRadiance(plain), with = smoothRadiance(drawn);
        const std::vector<LostLine> marks = marksOf(drawn);
        int lost = 0, right = 0;
        for (int cell = 0; cell < kLines; ++cell) {
            const Drawn line = lineIn(cell);
            right += int(std::ranges::count_if(marks, [&](const LostLine& mark) { return line.has(mark); }));
            lost += isLost(line, without, with, contrast);
        }
        QVERIFY2(lost <= kLines / 4, qPrintable(QString::number(lost)));
        QCOMPARE(right, int(marks.size()));
        QCOMPARE(marksOf(noisyFilmOf(kFilm, withLines(0.4), 64)).size(), 0u);
    }

    /// A false mark in one of 20 images is allowed; none of these 20 has one. Edges are no lines.
    void filmsWithoutLinesHaveNoMarks_data() {
        QTest::addColumn<Truth>("truth");
        QTest::addRow("shade") << Truth(shade);
        QTest::addRow("discs") << Truth(discs);
        QTest::addRow("wheel") << Truth(wheel);
    }
    void filmsWithoutLinesHaveNoMarks() {
        QFETCH(Truth, truth);
        const Truth once = drawn(truth);
        int marks = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed)
            marks += int(marksOf(noisyFilmOf(kFilm, once, seed % 2 == 0 ? 4 : 16, 1, seed)).size());
        QCOMPARE(marks, 0);
    }

    /// A grain is lost, but it is no line; nor are pixels that met the one bright sample in forty.
    void neitherGrainNorSparksAreMarked() {
        const auto grain = [](int x, int y) { return 0.25 + 0.5 * chance(5, std::size_t(y * 1000 + x), 0); };
        QCOMPARE(marksOf(noisyFilmOf(kFilm, grain, 16)).size(), 0u);
        Film sparks(kFilm, 1);
        grow(
            sparks, 16,
            [](std::size_t pixel, std::uint64_t sample) { return chance(7, pixel, sample) < 0.025 ? 20.0 : 0.01; },
            [](std::size_t) { return kSeenTissue | kSeenChance; });
        QCOMPARE(marksOf(sparks).size(), 0u);
    }

    /// A long line is marked from one end to the other, not piece by piece.
    void aLongLineIsOne_data() {
        QTest::addColumn<double>("angle");
        for (const double angle : {0.0, 0.5, 1.3, 2.2})
            QTest::addRow("%g radians", angle) << angle;
    }
    void aLongLineIsOne() {
        QFETCH(double, angle);
        const Drawn line{dvec2(kFilm) / 2.0, angle, 120};
        const Truth brighter = drawn([&](int x, int y) { return 0.5 * (1 + 0.3 * line.cover(x, y)); });
        const Film plain = noisyFilmOf(
            kFilm, [](int, int) { return 0.5; }, 32);
        const std::vector<LostLine> marks = marksBeside(noisyFilmOf(kFilm, brighter, 32), plain);
        QCOMPARE(marks.size(), 1u);
        QVERIFY(line.has(marks[0]) && !marks[0].darker);
        const float length = glm::length(marks[0].end - marks[0].begin);
        QVERIFY2(length > 90 && length < 170, qPrintable(QString::number(length)));
    }

    void noThreadChangesALine() {
        std::vector<std::vector<LostLine>> marks;
        const Film film = noisyFilmOf(kFilm, withLines(0.3), 16);
        for (const std::size_t threads : {1, 3}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            marks.push_back(marksOf(film));
        }
        QVERIFY(!marks[0].empty() && marks[0].size() == marks[1].size());
        for (std::size_t i = 0; i < marks[0].size(); ++i)
            QVERIFY(marks[0][i].begin == marks[1][i].begin && marks[0][i].end == marks[1][i].end);
    }

    void imageSmallerThanALineHasNone() {
        for (const ivec2 size : {ivec2(1, 1), ivec2(44, 3), ivec2(60, 1)})
            QCOMPARE(marksOf(noisyFilmOf(size, shade, 16)).size(), 0u);
    }
};

QTEST_GUILESS_MAIN(LostLinesTest)
#include "lost_lines_test.moc"
