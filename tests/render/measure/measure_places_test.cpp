/// What is stated of measurements between places, against simulated places whose spread is known.

#include <QTest>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "render/measure/angle.h"
#include "render/measure/area.h"
#include "render/measure/distance.h"
#include "render/measure/line.h"
#include "render/measure/path.h"
#include "tests/support/statistics.h"

using namespace pdr;
using namespace pdr::measure;

namespace {

using Random = std::mt19937;

const VolumeGeometry kThickSlices = VolumeGeometry::aligned({100, 100, 40}, {0.9, 0.9, 2.5}, dvec3(0));

dvec3 normalVector(Random& random) {
    std::normal_distribution<double> normal;
    const double x = normal(random), y = normal(random);
    return {x, y, normal(random)};
}

dvec3 direction(Random& random) {
    return glm::normalize(normalVector(random));
}

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// A place whose spread is `root` times its transpose, so that root times a normal vector is a deviation of it.
struct Known {
    dvec3 truth;
    dmat3 root;

    Known(dvec3 mm, double sigma, Random& random) : truth(mm) {
        for (int column = 0; column < 3; ++column)
            root[column] = sigma * uniform(random, 0.2, 1.0) * direction(random);
    }
    Place measured(Random& random) const {
        Place place{.mm = truth + root * normalVector(random), .found = Found::onSlice};
        const Cause causes[]{Cause::grid, Cause::edge, Cause::hand};
        for (int column = 0; column < 3; ++column)
            place.spread.of(causes[column]) = glm::outerProduct(root[column], root[column]);
        return place;
    }
};

/// Returns the share of `trials` in which the truth lies where `measure` says.
double covered(double truth, int trials, const std::function<Stated()>& measure) {
    int held = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const Stated stated = measure();
        held += stated.low <= truth && truth <= stated.high;
    }
    return double(held) / trials;
}

bool near(double a, double b, double tolerance = 1e-9) {
    return std::abs(a - b) <= tolerance;
}

}  // namespace

class MeasurePlacesTest : public QObject {
    Q_OBJECT

  private slots:
    /// A click may be anywhere in a box of one step of the grid, a pixel of the screen and the slab.
    void aClickSpreadsLikeUniformBoxes() {
        Random random(1);
        const dvec3 right = direction(random), down = glm::normalize(glm::cross(right, direction(random)));
        const Place place = clickedPlace(kThickSlices, dvec3(0), {right, down, 0.8, 10});
        dmat3 sampled(0);
        const int trials = 200'000;
        for (int trial = 0; trial < trials; ++trial) {
            const auto within = [&](double width) { return uniform(random, -width / 2, width / 2); };
            const dvec3 grid(within(0.9), within(0.9), within(2.5));
            const dvec3 e = grid + within(0.8) * right + within(0.8) * down + within(10) * glm::cross(right, down);
            sampled += glm::outerProduct(e, e) / double(trials);
        }
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                QVERIFY2(near(place.spread.total()[i][j], sampled[i][j], 0.05),
                         qPrintable(QString("%1 %2").arg(place.spread.total()[i][j]).arg(sampled[i][j])));
    }

    void anEdgeReplacesWhatWasKnownAlongItsNormal() {
        Random random(2);
        const Place click = clickedPlace(kThickSlices, dvec3(0), {{1, 0, 0}, {0, 0, -1}, 0.5, 0});
        for (int trial = 0; trial < 20; ++trial) {
            const dvec3 normal = direction(random), across = glm::normalize(glm::cross(normal, direction(random)));
            const Place edge = movedToEdge(click, dvec3(1, 2, 3), normal, 0.1, 0.2, 1.5);
            const auto variance = [](const Place& place, dvec3 along) {
                return glm::dot(along, place.spread.total() * along);
            };
            QVERIFY(near(variance(edge, normal), 0.1 * 0.1 + 0.2 * 0.2));
            QVERIFY(near(variance(edge, across), glm::dot(across, click.spread.of(Cause::hand) * across)));
            QVERIFY(isAtEdge(edge) && edge.mm == dvec3(1, 2, 3) && edge.blurMm == 1.5);
        }
    }

    void theStepOfTheGridIsItsSpacingAlongAnAxis() {
        QVERIFY(near(stepAlongMm(kThickSlices, {0, 0, 1}), 2.5));
        QVERIFY(near(stepAlongMm(kThickSlices, {0, 1, 0}), 0.9));
        QVERIFY(near(stepAlongMm(kThickSlices, {0, 0.6, 0.8}), std::hypot(0.9 * 0.6, 2.5 * 0.8)));
    }

    void theLargestVarianceIsThatOfTheWorstDirection() {
        Random random(3);
        for (int trial = 0; trial < 50; ++trial) {
            const Known known(dvec3(0), 1, random);
            const dmat3 covariance = known.root * glm::transpose(known.root);
            double largest = 0;
            for (int n = 0; n < 20'000; ++n) {
                const dvec3 u = direction(random);
                largest = std::max(largest, glm::dot(u, covariance * u));
            }
            QVERIFY(largest <= largestVariance(covariance) + 1e-12);
            QVERIFY(largest >= 0.995 * largestVariance(covariance));
        }
    }

    /// Each configuration may leave the band once in some 10^5: 3 standard deviations of 2000 trials are 1.5 %.
    void distancesLieInTheirIntervals() {
        Random random(4);
        test::Sample share;
        for (int configuration = 0; configuration < 100; ++configuration) {
            const double truth = uniform(random, 2, 40);
            const Known a(dvec3(5, -7, 9), uniform(random, 0.05, 0.5), random),
                b(a.truth + truth * direction(random), uniform(random, 0.05, 0.5), random);
            const double held =
                covered(truth, 2000, [&] { return distance(kThickSlices, a.measured(random), b.measured(random)); });
            QVERIFY2(held > 0.93 && held < 0.985, qPrintable(QString("%1 at %2 mm").arg(held).arg(truth)));
            share.add(held);
        }
        QVERIFY2(near(share.mean(), 0.95, 0.004), qPrintable(QString::number(share.mean())));
    }

    /// Spread across the line lengthens it, and more so the shorter it is. The value corrects for that.
    void distancesAreRightOnAverage() {
        Random random(5);
        const Known a(dvec3(0), 0.5, random), b(dvec3(4, 0, 0), 0.5, random);
        test::Sample stated, raw;
        for (int trial = 0; trial < 100'000; ++trial) {
            const Place from = a.measured(random), to = b.measured(random);
            stated.add(distance(kThickSlices, from, to).value);
            raw.add(glm::distance(from.mm, to.mm));
        }
        QVERIFY(raw.mean() > 4.02);
        QVERIFY2(near(stated.mean(), 4, 0.01), qPrintable(QString::number(stated.mean())));
    }

    void closePlacesAreAtMostSoFarApart() {
        Random random(6);
        for (const double truth : {0.0, 0.2, 0.6}) {
            const Known a(dvec3(0), 0.6, random), b(truth * direction(random), 0.6, random);
            int bounds = 0, held = 0;
            const int trials = 4000;
            for (int trial = 0; trial < trials; ++trial) {
                const Stated stated = distance(kThickSlices, a.measured(random), b.measured(random));
                bounds += stated.bound == Bound::atMost && stated.limit == Limit::spread;
                held += truth <= stated.high;
            }
            QVERIFY(bounds > 0.9 * trials);
            QVERIFY2(held > 0.97 * trials, qPrintable(QString("%1 of %2 at %3").arg(held).arg(trials).arg(truth)));
        }
    }

    /// Two edges closer than 2.5 steps of the grid, or than twice their own width, are blurred into one.
    void thinThingsAreAtMostSoThick() {
        const auto edge = [](dvec3 mm, double blur) {
            return movedToEdge(clickedPlace(kThickSlices, mm, {{1, 0, 0}, {0, 1, 0}, 0.1, 0}), mm, dvec3(0, 0, 1), 0.05,
                               0, blur);
        };
        const auto atMost = [&](dvec3 to, double blur) {
            const Stated stated = distance(kThickSlices, edge(dvec3(0), 1), edge(to, blur));
            return stated.bound == Bound::atMost && stated.limit == Limit::thin && stated.high >= glm::length(to);
        };
        QVERIFY(atMost({0, 0, 6.2}, 1) && !atMost({0, 0, 6.3}, 1));
        QVERIFY(atMost({2.4, 0, 0}, 1) && !atMost({2.6, 0, 0}, 1));
        QVERIFY(atMost({0, 0, 7.9}, 4) && !atMost({0, 0, 8.1}, 4));
        const Place free = clickedPlace(kThickSlices, {0, 0, 6}, {{1, 0, 0}, {0, 1, 0}, 0.1, 0});
        QCOMPARE(distance(kThickSlices, edge(dvec3(0), 1), free).bound, Bound::none);
    }

    /// A thin wall at one end of a long way makes its length less sure, and no bound of it.
    void aThinWallAtAnEndIsPartOfTheInterval() {
        const auto edge = [](dvec3 mm, bool thin) {
            Place place = movedToEdge(clickedPlace(kThickSlices, mm, {{1, 0, 0}, {0, 1, 0}, 0.1, 0}), mm,
                                      dvec3(1, 0, 0), 0.05, 0.02, 1.6);
            place.thin = thin;
            return place;
        };
        const auto measured = [&](double mm, bool thin) {
            return distance(kThickSlices, edge(dvec3(0), thin), edge({mm, 0, 0}, false));
        };
        QVERIFY(measured(6, true).bound == Bound::atMost && measured(6, true).limit == Limit::thin);
        const Stated sure = measured(170, false), thin = measured(170, true);
        QCOMPARE(thin.bound, Bound::none);
        QCOMPARE(thin.value, sure.value);
        QVERIFY(std::abs(std::pow(thin.plusMinus(), 2) - std::pow(sure.plusMinus(), 2) - 0.64) < 1e-9);
        QVERIFY(std::abs(thin.high - thin.value - thin.plusMinus()) < 1e-9);
    }

    void anglesLieInTheirIntervals() {
        Random random(7);
        test::Sample inSpace, ofLines, inPlane;
        for (int configuration = 0; configuration < 100; ++configuration) {
            const double truth = uniform(random, 15, 165), t = truth * std::numbers::pi / 180;
            const dvec3 u = direction(random), w = glm::normalize(glm::cross(u, direction(random)));
            const dvec3 v = std::cos(t) * u + std::sin(t) * w, normal = glm::cross(u, w);
            const auto known = [&](dvec3 mm) { return Known(mm, 0.5, random); };
            const Known apex = known(dvec3(1, 2, 3)), a = known(apex.truth + uniform(random, 15, 40) * u),
                        b = known(apex.truth + uniform(random, 15, 40) * v);
            const Known from = known(dvec3(-20, 5, 0)), to = known(from.truth + 25.0 * v + 7.0 * normal),
                        flat = known(from.truth + 25.0 * v);
            const auto at = [&](const Known& place) { return place.measured(random); };
            inSpace.add(covered(truth, 1000, [&] { return *measure::angle(at(a), at(apex), at(b)); }));
            ofLines.add(covered(truth, 1000, [&] { return *angleOfLines({at(apex), at(a)}, {at(from), at(flat)}); }));
            inPlane.add(covered(truth, 1000, [&] {
                return *angleInPlane({at(apex), at(a)}, {at(from), at(to)}, normal);
            }));
        }
        for (const test::Sample* each : {&inSpace, &ofLines, &inPlane})
            QVERIFY2(near(each->mean(), 0.95, 0.006), qPrintable(QString::number(each->mean())));
    }

    /// Spread opens an angle of 0 and closes one of 180 degrees: neither is ever measured right.
    void nearlyStraightAnglesAreBounds() {
        Random random(8);
        for (const double truth : {0.0, 2.0, 4.0}) {
            const double t = truth * std::numbers::pi / 180;
            const Known apex(dvec3(0), 0.5, random), a({20, 0, 0}, 0.5, random),
                b(30.0 * dvec3(std::cos(t), std::sin(t), 0), 0.5, random), opposite(-b.truth, 0.5, random);
            int held = 0, heldOpposite = 0, bounds = 0;
            const int trials = 4000;
            for (int trial = 0; trial < trials; ++trial) {
                const Place from = a.measured(random), middle = apex.measured(random);
                const Stated small = *measure::angle(from, middle, b.measured(random)),
                             large = *measure::angle(from, middle, opposite.measured(random));
                held += small.low <= truth && truth <= small.high;
                heldOpposite += large.low <= 180 - truth && 180 - truth <= large.high;
                bounds += small.bound == Bound::atMost && large.bound == Bound::atLeast && small.low == 0;
            }
            QVERIFY2(held > 0.95 * trials && heldOpposite > 0.95 * trials,
                     qPrintable(QString("%1: %2, %3").arg(truth).arg(held).arg(heldOpposite)));
            QVERIFY(bounds > 0.6 * trials && (truth > 2 || bounds > 0.97 * trials));
        }
        const Stated exact = *measure::angle(typedPlace({1, 0, 0}), typedPlace(dvec3(0)), typedPlace({-1, 0, 0}));
        QVERIFY(near(exact.value, 180));
    }

    void twoLinesFormTwoAngles() {
        const DrawnLine right{typedPlace(dvec3(0)), typedPlace({10, 0, 0})},
            up{typedPlace({3, 0, 0}), typedPlace({4, std::sqrt(3.0), 5})};
        QVERIFY(near(angleInPlane(right, up, {0, 0, 1})->value, 60));
        QVERIFY(near(supplement(*angleInPlane(right, up, {0, 0, 1})).value, 120));
        QVERIFY(near(angleOfLines(right, up)->value, std::acos(1 / std::sqrt(29.0)) * 180 / std::numbers::pi));
        const Stated small{.value = 4, .low = 0, .high = 4, .bound = Bound::atMost};
        QCOMPARE(supplement(small).bound, Bound::atLeast);
        QCOMPARE(supplement(small).low, 176.0);
        QVERIFY(!angleOfLines(right, {right.from, right.from}));
    }

    void areasLieInTheirIntervals() {
        Random random(9);
        test::Sample share;
        for (int configuration = 0; configuration < 100; ++configuration) {
            const dvec3 u = direction(random), w = glm::normalize(glm::cross(u, direction(random)));
            const double radius = uniform(random, 5, 20);
            const int corners = 3 + configuration % 10;
            std::vector<Known> outline;
            for (int n = 0; n < corners; ++n) {
                const double turn = 2 * std::numbers::pi * n / corners;
                outline.emplace_back(radius * (std::cos(turn) * u + std::sin(turn) * w), 0.5, random);
            }
            const double truth = corners * radius * radius / 2 * std::sin(2 * std::numbers::pi / corners);
            share.add(covered(truth, 1000, [&] {
                std::vector<Place> places;
                for (const Known& each : outline)
                    places.push_back(each.measured(random));
                return *polygonArea(places, glm::cross(u, w));
            }));
        }
        QVERIFY2(near(share.mean(), 0.95, 0.006), qPrintable(QString::number(share.mean())));
    }

    void anAreaDependsOnNeitherPlaceNorTurn() {
        std::vector<Place> square{typedPlace({1000, 0, 0}), typedPlace({1010, 0, 0}), typedPlace({1010, 0, 5}),
                                  typedPlace({1000, 0, 5})};
        QVERIFY(near(polygonArea(square, {0, 1, 0})->value, 50));
        std::ranges::reverse(square);
        QVERIFY(near(polygonArea(square, {0, 1, 0})->value, 50));
        std::swap(square[0], square[1]);
        QVERIFY(!polygonArea(square, {0, 1, 0}));
        square.resize(2);
        QVERIFY(!polygonArea(square, {0, 1, 0}));
    }

    void areasOfEllipsesLieInTheirIntervals() {
        Random random(12);
        test::Sample share;
        for (int configuration = 0; configuration < 100; ++configuration) {
            const dvec3 u = uniform(random, 5, 20) * direction(random);
            const dvec3 v = uniform(random, 5, 20) * glm::normalize(glm::cross(u, direction(random)));
            const dvec3 middle = uniform(random, 0, 500) * direction(random);
            const Known places[]{{middle, 0.3, random}, {middle + u, 0.3, random}, {middle + v + 0.4 * u, 0.3, random}};
            share.add(covered(std::numbers::pi * glm::length(u) * glm::length(v), 1000, [&] {
                return *ellipseArea(places[0].measured(random), places[1].measured(random), places[2].measured(random));
            }));
        }
        QVERIFY2(near(share.mean(), 0.95, 0.006), qPrintable(QString::number(share.mean())));
        const Place end = typedPlace({10, 0, 0}), middle = typedPlace({0, 0, 0});
        QVERIFY(near(ellipseArea(middle, end, typedPlace({3, 5, 0}))->value, 50 * std::numbers::pi));
        QVERIFY(!ellipseArea(middle, end, typedPlace({20, 0, 0})));
        Random wide(13);
        const Known unsure(dvec3(0, 0.1, 0), 5, wide);
        QCOMPARE(ellipseArea(middle, end, unsure.measured(wide))->bound, Bound::atMost);
    }

    void pathsLieInTheirIntervals() {
        Random random(10);
        test::Sample share;
        for (int configuration = 0; configuration < 100; ++configuration) {
            std::vector<Known> path{Known(dvec3(0), 0.3, random)};
            double truth = 0;
            for (int n = 0; n < 6; ++n) {
                const double step = uniform(random, 6, 20);
                truth += step;
                path.emplace_back(path.back().truth + step * direction(random), 0.3, random);
            }
            share.add(covered(truth, 1000, [&] {
                std::vector<Place> places;
                for (const Known& each : path)
                    places.push_back(each.measured(random));
                return *pathLength(places);
            }));
        }
        QVERIFY2(near(share.mean(), 0.95, 0.006), qPrintable(QString::number(share.mean())));
        const Place here = Known(dvec3(0), 0.3, random).measured(random);
        QVERIFY(!pathLength(std::vector{here, here}) && !pathLength(std::vector{here}));
    }

    /// The tip names what each cause brings: together they are the whole.
    void theSharesAddUp() {
        Random random(11);
        const Place a = clickedPlace(kThickSlices, dvec3(0), {{1, 0, 0}, {0, 1, 0}, 0.7, 0}),
                    b = movedToEdge(clickedPlace(kThickSlices, dvec3(0), {{1, 0, 0}, {0, 1, 0}, 0.7, 0}), {30, 0, 0},
                                    {1, 0, 0}, 0.1, 0.05, 1);
        const Stated stated = distance(kThickSlices, a, b);
        QVERIFY(near(stated.share(Cause::edge), 1.96 * 0.1));
        QVERIFY(near(stated.share(Cause::hand), 1.96 * 0.7 / std::sqrt(12)));
        QVERIFY(near(stated.share(Cause::grid), 1.96 * std::hypot(0.9 / std::sqrt(12), 0.05)));
        QVERIFY(near(stated.high - stated.value, stated.plusMinus()));
        QCOMPARE(distance(kThickSlices, typedPlace(dvec3(0)), typedPlace({3, 4, 0})).plusMinus(), 0.0);
    }
};

QTEST_APPLESS_MAIN(MeasurePlacesTest)
#include "measure_places_test.moc"
