/// Lines that the user has drawn: their corners, and how far away they are.

#include "render/scene/edit/drawn_outline.h"

#include <QTest>
#include <random>

using namespace pdr;

namespace {

std::vector<ImagePoint> circle(double radius, int corners, double tremble = 0) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> off(-tremble, tremble);
    std::vector<ImagePoint> outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners, r = radius + off(random);
        outline.push_back({0.1 + r * std::cos(angle), -0.2 + r * std::sin(angle)});
    }
    return outline;
}

}  // namespace

class DrawnOutlineTest : public QObject {
    Q_OBJECT

  private slots:
    void distancesAreThoseOfACircle() {
        const OutlineDistance distance(circle(0.25, 360));
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(-0.26, 0.26);
        double worst = 0;
        for (int i = 0; i < 10'000; ++i) {
            const dvec2 place(unit(random), unit(random));
            const double truth = 0.25 - glm::length(place);
            if (glm::all(glm::lessThan(glm::abs(place), dvec2(0.25))))
                worst = std::max(worst, std::fabs(distance.at(place + dvec2(0.1, -0.2)) - truth));
        }
        QVERIFY2(worst < distance.gridStep(), qPrintable(QString::number(worst)));
        QVERIFY(distance.gridStep() < 1.01 * 0.5 / 256);
        QVERIFY(distance.at({5, 5}) < -4 && distance.at({0.1, 3}) < -2.9);
    }

    /// Where a line crosses itself, what it goes around twice is outside: a figure of eight has two insides.
    void aLineMayCrossItself() {
        const OutlineDistance eight({{-1, -1}, {1, 1}, {1, -1}, {-1, 1}});
        QVERIFY(eight.at({0.8, 0}) > 0 && eight.at({-0.8, 0}) > 0);
        QVERIFY(eight.at({0, 0.5}) < 0 && eight.at({0, -0.5}) < 0);
    }

    void fewCornersKeepTheLine() {
        const std::vector<ImagePoint> drawn = circle(0.25, 900, 0.001), few = simplified(drawn, 0.002);
        QVERIFY2(few.size() > 10 && few.size() < 100, qPrintable(QString::number(few.size())));
        const OutlineDistance distance(few);
        for (const ImagePoint& point : drawn)
            QVERIFY(std::fabs(distance.at({point.x, point.y})) < 0.002 + distance.gridStep());
        QVERIFY(std::fabs(areaInside(few) / (M_PI * 0.25 * 0.25) - 1) < 0.02);
        QCOMPARE(simplified({{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0, 1}}, 1e-9).size(), std::size_t(4));
    }

    void aLineThereAndBackIsNone() {
        QVERIFY(simplified({{0, 0}, {0.5, 0}, {1, 0}, {0.5, 0}}, 0.01).empty());
        QVERIFY(simplified({{0, 0}, {1, 1}}, 0.01).empty());
        QVERIFY(simplified({}, 0.01).empty());
        QCOMPARE(areaInside({{0, 0}, {2, 0}, {2, 3}, {0, 3}}), 6.0);
    }
};

QTEST_APPLESS_MAIN(DrawnOutlineTest)
#include "drawn_outline_test.moc"
