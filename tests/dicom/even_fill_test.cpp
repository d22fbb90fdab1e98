/// Even slices between uneven ones, by formula.

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "dicom/stack/even_fill.h"

using namespace pdr::dicom;

namespace {

constexpr double kSameMm = 0.15;

/// Returns the height of a new slice by what it was blended from.
double heightOf(const SliceBlend& slice, const std::vector<double>& heights) {
    return std::lerp(heights[std::size_t(slice.below)], heights[std::size_t(slice.above)], slice.weight);
}

int measuredIn(const EvenFill& fill) {
    return int(std::ranges::count(fill.slices, 0.0, &SliceBlend::weight));
}

}  // namespace

class EvenFillTest : public QObject {
    Q_OBJECT

  private slots:
    void aMissingSliceIsTheMeanOfItsNeighbours() {
        const auto fill = evenFill({10, 12.5, 15, 20, 22.5}, kSameMm);
        QVERIFY(fill && fill->slices.size() == 6 && std::abs(fill->gapMm - 2.5) < 1e-12);
        QVERIFY(fill->slices[3] == (SliceBlend{2, 3, 0.5}));
        for (const auto& [k, measured] : {std::pair(0, 0), {1, 1}, {2, 2}, {4, 3}, {5, 4}})
            QVERIFY(fill->slices[std::size_t(k)] == (SliceBlend{measured, measured, 0}));
        QVERIFY(std::abs(fill->furthestMm - 2.5) < 1e-12 && std::abs(fill->widestMm - 5) < 1e-12);
    }

    void zonesTakeTheCloserDistance() {
        const auto fill = evenFill({0, 1.5, 3, 4.5, 9.5, 14.5}, kSameMm);
        QVERIFY(fill && fill->slices.size() == 11 && std::abs(fill->gapMm - 1.45) < 1e-12);
        QVERIFY(fill->furthestMm < 2.5 + 1e-12);
    }

    /// Holes go from slice to slice; in a zone whose slices find no place among the new ones, they are one.
    void holesLieWhereMeasuredSlicesAreFarApart() {
        using Holes = std::vector<pdr::HoleHeights>;
        const auto holesOf = [](const std::vector<double>& heights) { return evenFill(heights, kSameMm)->holes; };
        QVERIFY(holesOf({10, 12.5, 15, 20, 22.5}) == (Holes{{5, 10}}));
        QVERIFY(holesOf({0, 2, 4, 8, 10, 16, 18}) == (Holes{{4, 8}, {10, 16}}));
        QVERIFY(holesOf({0, 2, 4, 8, 12, 14}) == (Holes{{4, 8}, {8, 12}}));
        const Holes zone = holesOf({0, 1.5, 3, 4.5, 9.5, 14.5});
        QVERIFY(zone.size() == 1 && std::abs(zone[0].fromMm - 4.35) < 1e-9 && std::abs(zone[0].toMm - 14.5) < 1e-9);
        QVERIFY(holesOf({0, 2, 4, 6.4, 8.4, 10.8, 12.8}).empty());
    }

    /// A slice that lies a little off its place is taken as it was measured; heights are those of the grid otherwise.
    void slicesLieWhereTheyWereMeasured() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> tremble(-0.06, 0.06);
        std::vector<double> heights;
        for (int k = 0; k < 40; ++k)
            if (k % 13 != 6)
                heights.push_back(-100 + 2.0 * k + (k % 39 == 0 ? 0 : tremble(random)));
        const auto fill = evenFill(heights, kSameMm);
        QVERIFY(fill && fill->slices.size() >= 40);
        for (std::size_t k = 0; k < fill->slices.size(); ++k) {
            const double expected = heights.front() + fill->gapMm * double(k);
            const SliceBlend& slice = fill->slices[k];
            QVERIFY(std::abs(heightOf(slice, heights) - expected) <= (slice.weight == 0 ? kSameMm : 1e-9));
            QVERIFY(slice.below <= slice.above && slice.weight >= 0 && slice.weight <= 1);
        }
        QVERIFY(heightOf(fill->slices.front(), heights) == heights.front());
        QVERIFY(heightOf(fill->slices.back(), heights) == heights.back());
    }

    /// A few slices that lie very close must not make hundreds of the others.
    void thereAreAtMostFourForEachMeasured() {
        std::vector<double> heights{0, 0.4};
        for (int k = 1; k <= 20; ++k)
            heights.push_back(3.0 * k);
        const auto fill = evenFill(heights, kSameMm);
        QVERIFY(fill && fill->slices.size() == 4 * heights.size());
        QVERIFY(measuredIn(*fill) >= 2);
        const auto fine = evenFill({0, 0.1, 0.2, 0.4}, 0.02);
        QVERIFY(fine && fine->slices.size() == 2);  // 0.3 mm at least
    }

    void wideHolesAreNotFilled() {
        QVERIFY(!evenFill({0, 5, 10, 41, 46}, kSameMm));
        QVERIFY(evenFill({0, 5, 10, 39, 44}, kSameMm));
        QVERIFY(!evenFill({0, 1, 2, 3, 13.5, 14.5}, kSameMm));
        QVERIFY(evenFill({0, 1, 2, 3, 12.5, 13.5}, kSameMm));
    }
};

QTEST_GUILESS_MAIN(EvenFillTest)
#include "even_fill_test.moc"
