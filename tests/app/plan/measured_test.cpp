/// What each kind of measurement says of a scan: value, ±, texts and refusals.

#include <QTest>
#include <cmath>
#include <numbers>

#include "app/plan/marks_csv.h"
#include "app/plan/measured.h"
#include "app/plan/slice_region.h"
#include "tests/support/scenes/scenes.h"

namespace pdr::app {
namespace {

/// A scan of 40 x 40 x 20 voxels of 1 x 1 x 2 mm whose HU rise by 10 a millimetre to the left, 0 HU at its middle.
std::shared_ptr<const Volume> ramp() {
    return test::makeVolume({40, 40, 20}, dvec3(1, 1, 2), [](int i, int, int) { return 10 * (i - 20); });
}

dvec3 voxelMm(const Volume& volume, dvec3 index) {
    return dvec3(volume.geometry().patientFromIndex * dvec4(index, 1));
}

Measurement measurementOf(MeasureKind kind, const std::vector<dvec3>& places, double sigmaMm = 0) {
    Measurement measurement{1, kind, "", {}};
    for (const dvec3& mm : places) {
        measurement.places.push_back(measure::typedPlace(mm));
        measurement.places.back().spread.of(measure::Cause::hand) = dmat3(sigmaMm * sigmaMm);
    }
    return measurement;
}

QString said(const Text& text) {
    return QString::fromStdString(text);
}

/// Four places: a line along x, and one that is turned against it by `degrees` in the axial plane, 30 mm further.
std::vector<dvec3> twoLines(double degrees) {
    const double radians = degrees * std::numbers::pi / 180;
    return {{0, 0, 0}, {20, 0, 0}, {0, 30, 0}, {20 * std::cos(radians), 30 + 20 * std::sin(radians), 0}};
}

}  // namespace

class MeasuredTest : public QObject {
    Q_OBJECT

  private slots:
    void everyKindHasItsPlaces() {
        QCOMPARE(placesOf(MeasureKind::point), std::size_t(1));
        QCOMPARE(placesOf(MeasureKind::distance), std::size_t(2));
        QCOMPARE(placesOf(MeasureKind::ball), std::size_t(2));
        QCOMPARE(placesOf(MeasureKind::angle), std::size_t(3));
        QCOMPARE(placesOf(MeasureKind::lines), std::size_t(4));
        QCOMPARE(placesOf(MeasureKind::ellipse), std::size_t(3));
        QCOMPARE(mostPlacesOf(MeasureKind::ellipse), std::size_t(3));
        QVERIFY(placesOf(MeasureKind::polygon) == 3 && mostPlacesOf(MeasureKind::polygon) == kMostCorners);
        QVERIFY(!isBetweenEdges(MeasureKind::point) && !isBetweenEdges(MeasureKind::ball));
        QVERIFY(!isBetweenEdges(MeasureKind::ellipse) && isFlat(MeasureKind::ellipse) && !isFlat(MeasureKind::ball));
    }

    void aDistanceIsStatedWithItsPlusMinus() {
        const auto found = measured(measurementOf(MeasureKind::distance, {{0, 0, 0}, {3, 4, 0}}, 0.02), *ramp());
        QVERIFY(found && found->unit == measure::Unit::mm && found->bound == measure::Bound::none);
        QVERIFY(std::abs(found->value - 5) < 1e-3);
        QVERIFY(std::abs(found->plusMinus.value() - 1.96 * 0.02 * std::numbers::sqrt2) < 1e-9);
        QCOMPARE(said(found->text), QString("5.0 ± 0.1 mm"));
        QVERIFY2(said(found->details).startsWith("Hand ±0.1."), found->details.c_str());
    }

    void aBoundAndTypedPlacesHaveNoPlusMinus() {
        QVERIFY(!measured(measurementOf(MeasureKind::distance, {{0, 0, 0}, {3, 4, 0}}), *ramp())->plusMinus);
        const auto bound = measured(measurementOf(MeasureKind::distance, {{0, 0, 0}, {1, 0, 0}}, 2), *ramp());
        QVERIFY(bound && bound->bound == measure::Bound::atMost && !bound->plusMinus);
    }

    /// Lines are taken as they were drawn: 60 degrees are not 120, which is said as well.
    void twoLinesFormTheAngleOfTheirDirections() {
        for (const double degrees : {30.0, 60.0, 120.0, 150.0}) {
            const auto found = measured(measurementOf(MeasureKind::lines, twoLines(degrees), 0.1), *ramp());
            QVERIFY(found && found->unit == measure::Unit::degrees);
            QVERIFY(std::abs(found->value - degrees) < 1e-9);
            const QString other = QString("On their other side %1 ± ").arg(180 - degrees, 0, 'f', 1);
            QVERIFY2(said(found->details).startsWith(other), found->details.c_str());
        }
    }

    void anAngleOfLinesIsAlsoSaidAsItIsSeen() {
        std::vector<dvec3> places = twoLines(60);
        places[3].z = 40;  // the second line rises, which cannot be seen from the feet
        const auto found = measured(measurementOf(MeasureKind::lines, places, 0.1), *ramp());
        QVERIFY(found->value > 70);
        QVERIFY2(said(found->details).contains("Seen from the feet 60.0 ± "), found->details.c_str());
        QVERIFY2(!said(found->details).contains("Seen from the left"), found->details.c_str());  // the first is a point
    }

    void parallelLinesAreWithinABound() {
        const auto found = measured(measurementOf(MeasureKind::lines, twoLines(0), 0.1), *ramp());
        QVERIFY(found && found->bound == measure::Bound::atMost && !found->plusMinus);
        const auto none =
            measured(measurementOf(MeasureKind::lines, {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), *ramp());
        QVERIFY(!none && said(none.error().what).contains("too short"));
    }

    /// An end that is seen through fog takes its line's direction, however long the line is: the end is named.
    void anAngleNamesTheEndThatIsNotKnownWellEnough() {
        const auto refused = [](MeasureKind kind, std::vector<dvec3> places, std::size_t unsure) {
            Measurement measurement = measurementOf(kind, places, 0.1);
            for (measure::Place& place : measurement.places)  // all were picked, and one of them through fog
                place.spread.of(measure::Cause::light)[2][2] = &place == &measurement.places[unsure] ? 100 : 1;
            const auto found = measured(measurement, *ramp());
            return found ? QString() : said(found.error().what) + ". " + said(found.error().hint);
        };
        const QString why =
            " place is known only to ± 20 mm. It was seen through translucent tissue. "
            "Drag it to where it belongs on a slice.";
        const QStringList names{"the first", "the second", "the third", "the fourth"};
        for (std::size_t unsure = 0; unsure < 4; ++unsure) {
            const QString sentence = names[int(unsure)] + why;
            QCOMPARE(refused(MeasureKind::lines, twoLines(60), unsure), sentence);
            if (unsure < 3)
                QCOMPARE(refused(MeasureKind::angle, {{20, 0, 0}, {0, 0, 0}, {0, 20, 0}}, unsure), sentence);
        }
        // A line without a length has no direction, however sure its ends are.
        QVERIFY(refused(MeasureKind::angle, {{20, 0, 0}, {0, 0, 0}, {0, 0, 0}}, 0).contains("the first"));
        QVERIFY(refused(MeasureKind::angle, {{20, 0, 0}, {20, 0, 0}, {0, 20, 0}}, 0).contains("too short"));
    }

    /// What is stated at a place is what a slice shows there.
    void aPointSaysTheHuThere() {
        const auto volume = ramp();
        for (const double index : {3.0, 20.0, 20.25, 38.9}) {
            const auto found =
                measured(measurementOf(MeasureKind::point, {voxelMm(*volume, {index, 7.3, 4.6})}), *volume);
            QVERIFY(found && found->unit == measure::Unit::hu && !found->plusMinus);
            QVERIFY(std::abs(found->value - 10 * (index - 20)) < 1e-9);
        }
        const auto text = [&](double index) {
            return said(measured(measurementOf(MeasureKind::point, {voxelMm(*volume, {index, 7, 4})}), *volume)->text);
        };
        QCOMPARE(text(20.27), QString("3 HU"));
        QCOMPARE(text(19.98), QString("0 HU"));
        const auto outside = measured(measurementOf(MeasureKind::point, {voxelMm(*volume, {60, 7, 4})}), *volume);
        QVERIFY(!outside && !outside.error().what.empty());
    }

    /// Values that are no HU are stated as what they stand for, in files and texts alike.
    void otherValuesAreNoHu() {
        const auto hu = ramp();
        const ValueUnit unit = ValueUnit::other("Bq/ml", 0.25, 1000);
        const Volume volume(hu->geometry(), Voxels(hu->voxels().begin(), hu->voxels().end()), {}, unitWord(unit));
        const dvec3 middle = voxelMm(volume, {18, 20, 10});
        const auto point = measured(measurementOf(MeasureKind::point, {middle}), volume);
        QCOMPARE(point->value, 1000 - 0.25 * 20);
        QCOMPARE(said(point->text), QString("995.0 Bq/ml"));
        QCOMPARE(unitWord(*point), std::string("Bq/ml"));
        const auto ball = measured(measurementOf(MeasureKind::ball, {middle, middle + dvec3(0, 8, 0)}), volume);
        QVERIFY(ball && ball->region && std::abs(ball->value - 995) < 1e-9);
        QCOMPARE(ball->region->lowestHu, 1000 - 0.25 * 100);
        const auto inHu = measured(measurementOf(MeasureKind::ball, {middle, middle + dvec3(0, 8, 0)}), *hu);
        QVERIFY(std::abs(*ball->plusMinus - 0.25 * *inHu->plusMinus) < 1e-9);
        QVERIFY(std::abs(ball->region->sdHu - 0.25 * inHu->region->sdHu) < 1e-9);
        for (const QString& text : {said(ball->text), said(ball->details)})
            QVERIFY2(text.contains("Bq/ml") && !text.contains("HU"), qPrintable(text));
        const std::string csv = marksCsv({{1, MeasureKind::ball, "", "Ball 1", ball, {}}});
        QVERIFY2(csv.find(",995.00000,") != std::string::npos && csv.find(",Bq/ml,") != std::string::npos, csv.c_str());
        QVERIFY2(csv.find(".\",,,,1037,") != std::string::npos, csv.c_str());  // columns in HU are empty
    }

    /// The second place lies on the surface: the ball reaches as far as it, on either side.
    void aBallHoldsTheVoxelsAsFarAsItsSecondPlace() {
        const auto volume = ramp();
        const dvec3 middle = voxelMm(*volume, {18, 20, 10});
        const auto found = measured(measurementOf(MeasureKind::ball, {middle, middle + dvec3(0, 8, 0)}), *volume);
        QVERIFY(found && found->region && found->unit == measure::Unit::hu);
        std::size_t inside = 0;
        for (int k = 0; k < 20; ++k)
            for (int j = 0; j < 40; ++j)
                for (int i = 0; i < 40; ++i)
                    inside += glm::length(voxelMm(*volume, {i, j, k}) - middle) <= 8;
        QCOMPARE(found->region->count, inside);
        QVERIFY(std::abs(found->value + 20) < 1e-9);
        QCOMPARE(found->region->lowestHu, -100.0);
        QCOMPARE(found->region->highestHu, 60.0);
        QVERIFY(found->plusMinus == found->region->meanPlusMinus && found->plusMinus > 0);
        QVERIFY2(said(found->text).contains(QString::fromUtf8("±")), found->text.c_str());
        const QString counted =
            QString("-100 to 60 HU, %1 voxels, %2 ml.").arg(inside).arg(0.002 * double(inside), 0, 'f', 2);
        QVERIFY2(said(found->details).contains(counted), found->details.c_str());
    }

    void aBallOfAFewVoxelsHasNoPlusMinusAndAnEmptyOneIsRefused() {
        const auto volume = ramp();
        const dvec3 voxel = voxelMm(*volume, {20, 20, 10});
        const auto few = measured(measurementOf(MeasureKind::ball, {voxel, voxel + dvec3(1, 0, 0)}), *volume);
        QVERIFY(few && few->region->count == 5 && !few->plusMinus);
        const dvec3 between = voxel + dvec3(0.5, 0.5, 1);
        const auto none = measured(measurementOf(MeasureKind::ball, {between, between + dvec3(0.2, 0, 0)}), *volume);
        QVERIFY(!none && !none.error().hint.empty());
        const auto huge = measured(measurementOf(MeasureKind::ball, {voxel, voxel + dvec3(1000, 0, 0)}), *volume);
        QVERIFY(!huge && said(huge.error().what).contains("200000"));
    }

    /// Counted by the distances to both foci, in the slice that is nearest.
    void anEllipseHoldsTheVoxelsOfItsSlice() {
        const auto volume = ramp();
        const dvec3 middle = voxelMm(*volume, {18, 20, 10.4}), focus(std::sqrt(81.0 - 25), 0, 0);
        const auto found = measured(
            measurementOf(MeasureKind::ellipse, {middle, middle + dvec3(9, 0, 0), middle + dvec3(4, -5, 0)}, 0.1),
            *volume);
        QVERIFY(found && found->region && found->area && found->unit == measure::Unit::hu);
        std::size_t inside = 0;
        for (int j = 0; j < 40; ++j)
            for (int i = 0; i < 40; ++i) {
                const dvec3 mm = voxelMm(*volume, {i, j, 10.4});
                inside += glm::distance(mm, middle - focus) + glm::distance(mm, middle + focus) <= 18 + 1e-9;
            }
        QCOMPARE(found->region->count, inside);
        QVERIFY(!found->region->cut && std::abs(found->value + 20) < 1e-9);
        QVERIFY(found->plusMinus == found->region->meanPlusMinus && found->plusMinus > 0);
        QVERIFY(std::abs(found->area->value - 45 * std::numbers::pi) < 1e-9);
        QVERIFY2(said(found->details).startsWith("Area 141"), found->details.c_str());
        QVERIFY2(said(found->details).contains(QString("median -20 HU, -110 to 70 HU, %1 voxels").arg(inside)),
                 found->details.c_str());
    }

    /// Whichever way round it was drawn, of two slices as near it takes the same one.
    void anEllipseBetweenTwoSlicesTakesOneOfThem() {
        const auto volume =
            test::makeVolume({40, 40, 20}, dvec3(1, 1, 2), [](int, int, int k) { return k == 10 ? 0 : 100; });
        const dvec3 middle = voxelMm(*volume, {18, 20, 10.5}), right(6, 0, 0), down(0, 6, 0);
        for (const dvec3& other : {down, -down}) {
            const auto found =
                measured(measurementOf(MeasureKind::ellipse, {middle, middle + right, middle + other}), *volume);
            QVERIFY(found && found->value == 0 && found->region->sdHu == 0);
        }
    }

    void anEllipseWithoutAPlaneOrOutsideIsRefused() {
        const auto volume = ramp();
        const dvec3 voxel = voxelMm(*volume, {20, 20, 10});
        const auto at = [&](dvec3 a, dvec3 b) {
            return measured(measurementOf(MeasureKind::ellipse, {voxel, voxel + a, voxel + b}), *volume);
        };
        const auto line = at({3, 0, 0}, {5, 0, 0});
        QVERIFY(!line && !line.error().hint.empty());
        const auto few = at({1, 0, 0}, {0, 1, 0});
        QVERIFY(few && few->region->count == 5 && !few->plusMinus && said(few->text).contains("too few voxels"));
        const auto huge = at({400, 0, 0}, {0, 400, 0});
        QVERIFY(!huge && said(huge.error().what).contains("200000"));
        const auto outside =
            measured(measurementOf(MeasureKind::ellipse,
                                   {voxel + dvec3(50, 0, 0), voxel + dvec3(55, 0, 0), voxel + dvec3(50, 5, 0)}),
                     *volume);
        QVERIFY(!outside && !outside.error().hint.empty());
    }

    /// A polygon with a notch: its area by its corners, its voxels by what is left of a rectangle.
    void aPolygonStatesItsAreaAndTheVoxelsInIt() {
        const auto volume = ramp();
        const auto at = [&](double i, double j) { return voxelMm(*volume, {i, j, 10.2}); };
        std::vector<dvec3> corners{at(5.5, 5.5),   at(15.5, 5.5),  at(15.5, 15.5),
                                   at(10.5, 15.5), at(10.5, 10.5), at(5.5, 10.5)};
        for (int way = 0; way < 2; ++way) {
            const auto found = measured(measurementOf(MeasureKind::polygon, corners, 0.1), *volume);
            QVERIFY(found && found->unit == measure::Unit::mm2 && found->region && found->area);
            QVERIFY(std::abs(found->value - 75) < 1e-9 && found->plusMinus > 0);
            QCOMPARE(found->region->count, std::size_t(75));
            QVERIFY(std::abs(found->region->meanHu - 10 * ((40 * 5 + 65 * 10) / 75.0 - 20)) < 1e-9);
            QCOMPARE(found->region->lowestHu, -140.0);
            QCOMPARE(found->region->highestHu, -50.0);
            QVERIFY2(said(found->text).startsWith("75"), found->text.c_str());
            QVERIFY2(said(found->details).contains("Mean ") && said(found->details).contains("75 voxels"),
                     found->details.c_str());
            std::ranges::reverse(corners);
        }
    }

    /// What has an area but no voxel says why it has no mean; what has none, or is crossed or bent, is refused.
    void aPolygonThatEnclosesNothingIsRefused() {
        const auto volume = ramp();
        const auto of = [&](const std::vector<dvec3>& indices) {
            std::vector<dvec3> corners;
            for (const dvec3& index : indices)
                corners.push_back(voxelMm(*volume, index));
            return measured(measurementOf(MeasureKind::polygon, corners), *volume);
        };
        const auto tiny = of({{5.2, 5.2, 10}, {5.4, 5.2, 10}, {5.4, 5.4, 10}});
        QVERIFY(tiny && !tiny->region && tiny->area);
        QVERIFY2(said(tiny->details).startsWith("No voxel's centre"), tiny->details.c_str());
        for (const auto& each :
             {of({{5, 5, 10}, {10, 10, 10}, {15, 15, 10}}), of({{5, 5, 10}, {15, 16, 10}, {15, 5, 10}, {5, 15, 10}}),
              of({{5, 5, 10}, {15, 5, 10}, {15, 15, 12}, {5, 15, 10}})})
            QVERIFY(!each && !each.error().hint.empty());
        const auto few = of({{5.5, 5.5, 10}, {8.5, 5.5, 10}, {8.5, 8.5, 10}, {5.5, 8.5, 10}});
        QVERIFY(few && few->region->count == 9 && said(few->details).contains("too few voxels"));
    }

    /// Its axes stay perpendicular, its middle takes it along, and an end of an axis turns it.
    void anEllipseStaysOneWhenAPlaceMoves() {
        Measurement one = measurementOf(MeasureKind::ellipse, {{0, 0, 0}, {4, 0, 0}, {1, 2, 0}});
        const auto is = [&](dvec3 a, dvec3 b, dvec3 c) {
            return glm::length(one.places[0].mm - a) + glm::length(one.places[1].mm - b) +
                       glm::length(one.places[2].mm - c) <
                   1e-12;
        };
        settle(one);
        QVERIFY(is({0, 0, 0}, {4, 0, 0}, {0, 2, 0}));
        movePlace(one, 0, measure::typedPlace({1, 1, 0}));
        QVERIFY(is({1, 1, 0}, {5, 1, 0}, {1, 3, 0}));
        movePlace(one, 1, measure::typedPlace({1, 7, 0}));
        QVERIFY(is({1, 1, 0}, {1, 7, 0}, {-1, 1, 0}));
        movePlace(one, 2, measure::typedPlace({-4, 3, 0}));
        QVERIFY(is({1, 1, 0}, {1, 7, 0}, {-4, 1, 0}));
    }
};

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::MeasuredTest)
#include "measured_test.moc"
