/// Hard cases 21 to 23: rays, boxes and cells. Each naive form is written out and must fail.

#include <QTest>

#include <random>

#include "render/kernel/transport/majorant_traversal.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

const vec3 kLow(-0.5f), kHigh(23.5f);

std::shared_ptr<const PreparedScene> cube() {
    return Flattener().prepare(
        test::plainScene(test::makeVolume({24, 24, 24}, dvec3(1), [](int, int, int) { return 0; }), 1e-6f));
}

/// The 26 directions along axes, in planes and along diagonals; zeros of both signs.
std::vector<vec3> mainDirections() {
    std::vector<vec3> directions;
    for (int n = 0; n < 27; ++n)
        if (n != 13)
            for (const float zero : {0.0f, -0.0f}) {
                vec3 d(float(n % 3) - 1, float(n / 3 % 3) - 1, float(n / 9) - 1);
                d = glm::normalize(d);
                for (int axis = 0; axis < 3; ++axis)
                    d[axis] = d[axis] == 0 ? zero : d[axis];
                directions.push_back(d);
            }
    return directions;
}

/// The 27 points where each coordinate is one of three.
std::vector<vec3> lattice(float a, float b, float c) {
    const float values[] = {a, b, c};
    std::vector<vec3> points;
    for (int n = 0; n < 27; ++n)
        points.emplace_back(values[n % 3], values[n / 3 % 3], values[n / 9]);
    return points;
}

/// The path of a flight: how far, in how many steps, and the integral of the bound along it.
struct Walk {
    double length = 0, integral = 0;
    int steps = 0;
};

Walk walked(const FlatScene& scene, vec3 origin, vec3 direction) {
    MajorantTraversal<float, true> flight;
    flight.start(scene.majorants, {origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}, 1e30f,
                 Random(1, 2, 3).stream(0, BounceDimension::distance));
    Walk walk;
    while (flight.isActive() && walk.steps < 1000) {
        const float from = flight.t;
        const float bound = flight.step(scene).majorant;
        walk.length += double(flight.t) - from;
        walk.integral += bound * (double(flight.t) - from);
        ++walk.steps;
    }
    return walk;
}

/// A grid walk that finds its next cell from its position: one unguarded division an axis.
Walk naiveWalk(vec3 origin, vec3 direction) {
    Walk walk;
    float t = 0;
    for (; walk.steps < 1000; ++walk.steps) {
        const vec3 p = origin + direction * t, cell = glm::floor(p / 4.0f);
        if (glm::any(glm::lessThan(p, kLow)) || glm::any(glm::greaterThan(p, kHigh)))
            break;
        const vec3 exit = ((cell + vec3(glm::greaterThan(direction, vec3(0)))) * 4.0f - p) / direction;
        const float step = std::min(exit.x, std::min(exit.y, exit.z));
        t += step;
        walk.length += step;
    }
    return walk;
}

bool same(double a, double b) {
    return std::fabs(a - b) <= 1e-5 * (1 + std::fabs(b));
}

}  // namespace

class GeometryTest : public QObject {
    Q_OBJECT

  private slots:
    /// Case 21. Origins on corners, edges and faces; directions with components 0 and -0.
    void zeroTimesInfinityInTheSlabTest() {
        const auto scene = cube();
        int naiveNaN = 0, hits = 0;
        for (const vec3 origin : lattice(kLow.x, 7, kHigh.x))
            for (const vec3 direction : mainDirections()) {
                const vec3 nearer = (kLow - origin) * (1.0f / direction),
                           farther = (kHigh - origin) * (1.0f / direction);
                naiveNaN += glm::any(glm::isnan(nearer)) || glm::any(glm::isnan(farther));
                const Interval<float> inside = clipped(origin, direction, kLow, kHigh, Interval<float>{0, 1e30f});
                QVERIFY(!std::isnan(inside.enter) && !std::isnan(inside.leave));
                const bool hit = inside.enter < inside.leave;
                hits += hit;
                // By points on the ray: inside means low <= p < high where the ray runs along a face.
                const auto holds = [&](float t) {
                    const vec3 p = origin + direction * t;
                    return glm::all(glm::greaterThanEqual(p, kLow)) && glm::all(glm::lessThan(p, kHigh));
                };
                QCOMPARE(hit, holds(1e-3f));
                if (hit)
                    QVERIFY(holds(0.999f * inside.leave) && !holds(1.001f * inside.leave));
                QVERIFY(same(walked(scene->flat, origin, direction).length, hit ? inside.leave - inside.enter : 0));
            }
        QVERIFY(naiveNaN > 100 && hits > 100);
    }

    /// Case 22. Components whose inverse is infinite or huge: as good as 0.
    void denormalDirectionHasAnInfiniteInverse() {
        const auto scene = cube();
        QVERIFY(std::isinf(1 / 1e-40f));
        for (const vec3 origin : lattice(kLow.x, 7, kHigh.x))
            for (const float tiny : {1e-45f, 1e-40f, 1e-38f, 1e-20f, 1e-19f, 1e-12f})
                for (const vec3 direction : {vec3(1, tiny, -tiny), vec3(-tiny, -1, tiny), vec3(tiny, tiny, 1)}) {
                    const Interval<float> inside = clipped(origin, direction, kLow, kHigh, Interval<float>{0, 1e30f});
                    const Interval<double> exact =
                        clipped(dvec3(origin), dvec3(direction), dvec3(kLow), dvec3(kHigh), Interval<double>{0, 1e30});
                    QVERIFY(!std::isnan(inside.enter) && !std::isnan(inside.leave));
                    const Walk walk = walked(scene->flat, origin, direction);
                    QVERIFY(std::isfinite(walk.length) && walk.steps < 30);
                    if (origin == vec3(7))  // on a face the sign of a denormal decides, and nothing depends on it
                        QVERIFY(same(walk.length, exact.leave) && same(inside.leave, exact.leave));
                }
    }

    /// Case 23. Along edges and through corners of cells, forwards and backwards.
    void rayAlongACellEdgeStallsTheGridWalk() {
        const auto prepared = test::prepared(test::plainScene(cube()->volume, 1e-6f));
        auto bounds = std::make_shared<Majorants>(*prepared->majorants);
        bounds->coarse.assign(bounds->coarse.size(), 1e9f);  // so that fine cells are walked
        prepared->flat.majorants.coarse = bounds->coarse.data();
        int naiveFailures = 0;
        for (const vec3 origin : lattice(4, 12, 20))
            for (const vec3 direction : mainDirections()) {
                const double chord = clipped(origin, direction, kLow, kHigh, Interval<float>{0, 1e30f}).leave;
                const Walk walk = walked(prepared->flat, origin, direction), naive = naiveWalk(origin, direction);
                naiveFailures += naive.steps == 1000 || !same(naive.length, chord);
                QVERIFY2(same(walk.length, chord), qPrintable(QString("%1, not %2").arg(walk.length).arg(chord)));
                QVERIFY(walk.steps <= 6 + 6 + 6 + 3);
            }
        QVERIFY2(naiveFailures > 200, qPrintable(QString::number(naiveFailures)));
    }

    /// Case 23, no cell is skipped or met twice: the integral of bounds that differ from cell to cell.
    void gridWalkSkipsACell() {
        const auto prepared = test::prepared(test::plainScene(cube()->volume, 1e-6f));
        auto bounds = std::make_shared<Majorants>(*prepared->majorants);
        bounds->coarse.assign(bounds->coarse.size(), 1e12f);
        std::mt19937 random(3);
        std::uniform_real_distribution<float> unit(-1, 1);
        for (float& bound : bounds->fine)
            bound = 1e-10f * (1.5f + unit(random));  // too thin for a collision
        prepared->flat.majorants.coarse = bounds->coarse.data();
        prepared->flat.majorants.fine = bounds->fine.data();
        for (int ray = 0; ray < 300; ++ray) {
            vec3 direction = glm::normalize(vec3(unit(random), unit(random), unit(random)));
            vec3 origin = vec3(11.5f) + 11.0f * vec3(unit(random), unit(random), unit(random));
            if (ray % 3 == 0)
                origin = glm::min(glm::round(origin / 4.0f) * 4.0f, 20.0f);  // on a corner
            const Walk walk = walked(prepared->flat, origin, direction);
            double truth = 0;
            const int parts = 20000;
            for (int i = 0; i < parts; ++i) {
                const dvec3 p = dvec3(origin) + dvec3(direction) * (walk.length * (i + 0.5) / parts);
                const ivec3 cell(p / 4.0 + 1.0);
                truth += bounds->fine[std::size_t((cell.z * 8 + cell.y) * 8 + cell.x)] * walk.length / parts;
            }
            QVERIFY2(std::fabs(walk.integral / truth - 1) < 2e-3, qPrintable(QString::number(walk.integral / truth)));
        }
    }
};

QTEST_GUILESS_MAIN(GeometryTest)
#include "geometry_test.moc"
