/// The image after an edit from films of few pixels: as sharp as the one before, and no worse than the new film alone.

#include <QTest>

#include "render/denoise/resampled.h"
#include "render/edit/coarse_edit.h"
#include "render/edit/light_change.h"
#include "tests/support/scenes/growing_films.h"

using namespace pdr;
using namespace pdr::test;
using denoise::Colours, denoise::Plane;

namespace {

constexpr ivec2 kSize{160, 128};
constexpr int kDivider = 4;
constexpr std::uint64_t kSamples = 4;

/// Returns what a film of 1 / kDivider of the width sees: the mean over the pixels that each of its own covers.
Truth seenCoarse(const Truth& truth) {
    return [truth](int x, int y) {
        double sum = 0;
        for (int v = 0; v < kDivider; ++v)
            for (int u = 0; u < kDivider; ++u)
                sum += truth(kDivider * x + u, kDivider * y + v);
        return sum / (kDivider * kDivider);
    };
}

Growing coarse(const Truth& truth, double own = 0) {
    return {seenCoarse(truth), 4711, own, kSize / kDivider};
}

/// Returns the root mean square of the relative error of the parts of the image that `counts` names.
double errorOf(const Colours& image, const Truth& truth, const std::function<bool(int, int)>& counts = {}) {
    double squares = 0;
    int pixels = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x)
            if (!counts || counts(x, y)) {
                const double off = double(image[1].row(y)[x]) / truth(x, y) - 1;
                squares += off * off;
                ++pixels;
            }
    return std::sqrt(squares / pixels);
}

/// The old image of many samples, and the images of an edit from coarse films.
struct Edit {
    Growing then{discs, 11}, was = coarse(discs), is;
    CoarseEdit image;

    Edit(const Truth& before, const Truth& after, double own)
        : then{before, 11},
          was(coarse(before)),
          is(coarse(after, own)),
          image(kept(then.to(256)), kSize / kDivider, was.to(kSamples).first) {
        is.to(kSamples);
    }
    Colours radiance(std::uint64_t mark = kSamples) const { return image.radiance(is.first, mark); }
    /// Returns the coarse film alone, smoothed and enlarged.
    Colours alone() const {
        const HalfImages halves = smoothed(*is.first.at(kSamples), kSamples);
        Colours image = meanOf(halves.even, halves.odd);
        for (Plane& plane : image)
            plane = denoise::enlarged(plane, kSize);
        return image;
    }
};

}  // namespace

class CoarseEditTest : public QObject {
    Q_OBJECT

  private slots:
    /// Each sample of the film lies in one of sixteen pixels.
    void aCoarseChangeIsLaidOnTheSharpImage_data() {
        QTest::addColumn<int>("mark");
        QTest::newRow("1") << 1;
        QTest::newRow("4") << 4;
    }
    void aCoarseChangeIsLaidOnTheSharpImage() {
        QFETCH(int, mark);
        const Edit edit(discs, edited, 0.1);
        const Colours shown = edit.radiance(std::uint64_t(mark));
        QCOMPARE(shown[0].size(), kSize);
        const double off = errorOf(shown, edited), alone = errorOf(edit.alone(), edited);
        const double unchanged = errorOf(kept(edit.then)->all, edited);
        qInfo("mark %d: off by %.4f; alone %.4f, old image %.4f", mark, off, alone, unchanged);
        QVERIFY2(off < 0.2 * alone, qPrintable(QString::number(off / alone)));
        QVERIFY2(off < (mark == 1 ? 1.0 : 0.75) * unchanged, qPrintable(QString::number(off / unchanged)));
    }

    /// What guides show of both scenes is there although it is too narrow for the few samples to tell it.
    void whatGuidesForetellIsThere() {
        const auto brighter = [](int x, int y) { return discs(x, y) * (y % 16 < 8 ? 1 : 1.3); };
        const auto changeOff = [&](bool guided) {
            Growing then{discs, 11}, was = coarse(discs), is = coarse(brighter, 0.1);
            if (guided) {
                was.first.keepUnshadowed(guideOf(was.truth, was.size));
                is.first.keepUnshadowed(guideOf(is.truth, is.size));
            }
            const auto old = kept(then.to(256));
            const Colours shown =
                CoarseEdit(old, was.size, was.to(kSamples).first).radiance(is.to(kSamples).first, kSamples);
            return errorOf(shown,
                           [&](int x, int y) { return double(old->all[1].row(y)[x]) * brighter(x, y) / discs(x, y); });
        };
        const double guided = changeOff(true), alone = changeOff(false);
        qInfo("off by %.4f, without guides %.4f", guided, alone);
        QVERIFY2(guided < 0.6 * alone, qPrintable(QString::number(guided / alone)));
    }

    /// No plane of the change is made in full size, but its bits are those of the enlarged one.
    void aChangeIsEnlargedRowByRow() {
        const auto valued = [](ivec2 size, const Truth& value) {
            Colours colours = denoise::coloursOf(size);
            for (std::size_t c = 0; c < 3; ++c) {
                for (int y = 0; y < size.y; ++y)
                    for (int x = 0; x < size.x; ++x)
                        colours[c].row(y)[x] = float(value(x + int(c), y));
                colours[c].mirror();
            }
            return colours;
        };
        const Colours old = valued(kSize, discs);
        const LightChange change{valued({37, 29}, [](int x, int y) { return 0.5 + (x * 7 + y) % 5; }),
                                 valued({37, 29}, [](int x, int y) { return (x + 3 * y) % 4 - 2.5; })};
        const Colours laid = laidOn(old, change);
        for (std::size_t c = 0; c < 3; ++c) {
            const Plane gain = denoise::enlarged(change.gain[c], kSize);
            const Plane offset = denoise::enlarged(change.offset[c], kSize);
            for (int y = -1; y <= kSize.y; ++y)  // with the mirror image
                for (int x = -1; x <= kSize.x; ++x)
                    QCOMPARE(laid[c].row(y)[x], std::max(gain.row(y)[x] * old[c].row(y)[x] + offset.row(y)[x], 0.0f));
        }
    }

    void noChangeLeavesTheImageAsItIs() {
        const Edit edit(discs, discs, 0);
        const Colours shown = edit.radiance(), old = kept(edit.then)->all;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x)
                QCOMPARE(shown[2].row(y)[x], old[2].row(y)[x]);
    }

    /// Light where the old image was dark is that of the new film, as when a cut uncovers what was hidden.
    void whatWasDarkIsShownByTheNewFilm() {
        const auto dark = [](int x, int) { return x < 80 ? 1e-4 : 1.0; };
        const auto uncovered = [](int x, int) { return x < 80 ? 0.5 : 1.0; };
        const Colours shown = Edit(dark, uncovered, 0.3).radiance();
        QVERIFY(errorOf(shown, uncovered, [](int x, int) { return x < 60; }) < 0.2);
    }

    /// What differs by chance alone is not shown as a change.
    void chanceChangesLittle() {
        const Edit edit(discs, discs, 0.3);
        const double off = errorOf(edit.radiance(), discs), unchanged = errorOf(kept(edit.then)->all, discs);
        qInfo("off by %.4f, old image %.4f", off, unchanged);
        QVERIFY2(off < 1.35 * unchanged, qPrintable(QString::number(off / unchanged)));
    }

    /// One sample of each pixel makes no light of its own, however little noise it shares with that of the scene
    /// before.
    void oneSampleMakesNoLight() {
        const Edit edit(discs, edited, 1);
        const double off = errorOf(edit.radiance(1), edited), unchanged = errorOf(kept(edit.then)->all, edited);
        qInfo("off by %.4f, old image %.4f", off, unchanged);
        QVERIFY2(off < 1.04 * unchanged, qPrintable(QString::number(off / unchanged)));
    }

    /// A scene that has nothing in common with the old one is shown no worse than without the old image.
    void aForeignImageDoesNoHarm() {
        const auto foreign = [](int x, int y) { return discs(y + 9, x + 21) * (x % 50 < 25 ? 3 : 0.3); };
        const Edit edit(foreign, discs, 1);
        const double off = errorOf(edit.radiance(), discs), alone = errorOf(edit.alone(), discs);
        qInfo("off by %.4f; alone %.4f", off, alone);
        QVERIFY2(off < 1.05 * alone, qPrintable(QString::number(off / alone)));
    }
};

QTEST_GUILESS_MAIN(CoarseEditTest)
#include "coarse_edit_test.moc"
