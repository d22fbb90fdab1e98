/// Measures whether every ± of a measurement covers what it claims, and how biased the values are, on phantoms by
/// formula. It prints a table.
///   measurement_coverage [--trials N] [--only plates|angles|regions]
/// Columns of plates, at random angles and places, with clicks that miss a border by up to 0.45 mm:
///   stated, at most, no edge    trials, by what is said
///   bias, SD                    of the stated thickness [mm]
///   ±/1.96                      root mean square of what is stated for SD [mm]
///   holds                       stated intervals that contain the truth [%]
///   bounds hold                 "at most" that are true [%]
///   untold                      stated values, without "at most", that are farther off than the ± that is printed
/// Angles are those of two diameters of a ball, by four places on its edge; regions are balls, ellipses and polygons in
/// water, the flat ones across random axes of the patient.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <string>

#include "render/measure/angle.h"
#include "render/measure/distance.h"
#include "render/measure/edge.h"
#include "tests/support/scenes/edge_phantoms.h"
#include "tools/measure/coverage_row.h"

namespace pdr::test {
namespace {

using namespace measure;

struct Grid {
    dvec3 spacingMm, blurMm;
};
const Grid kGrids[]{
    {{0.9, 0.9, 2.5}, {0.6, 0.6, 0.9}}, {{0.7, 0.7, 1.0}, {0.6, 0.6, 0.7}}, {{0.45, 0.45, 0.6}, {0.5, 0.5, 0.5}}};

struct Tissue {
    Contrast hu;
    double noiseHu;
};
const Tissue kTissues[]{{{1000, 40}, 15}, {{1000, 40}, 40}, {{300, 40}, 20}};

/// Returns the place of a click near `truth` on a border across `normal`, moved to its edge.
std::optional<Place> clicked(const Volume& scan, dvec3 truth, dvec3 normal, std::mt19937& random) {
    std::uniform_real_distribution<double> hand(-0.45, 0.45), pixel(-0.25, 0.25);
    const dvec3 across = glm::normalize(glm::cross(normal, randomDirection(random)));
    const double miss = hand(random);
    const dvec3 click = truth + miss * normal + pixel(random) * across;
    const EdgeSearch found = edgeNear(scan, click);
    if (!found.edge)
        return {};
    return atEdge(clickedPlace(scan.geometry(), click, {normal, across, 0.5, 0}), *found.edge);
}

std::optional<Stated> plate(const Scanner& scanner, double thickness, Contrast hu, std::mt19937& random) {
    const dvec3 normal = randomDirection(random);
    const Volume scan = scannedPlate(scanner, thickness, normal, hu, thickness / 2 + 9, random);
    const auto a = clicked(scan, -thickness / 2 * normal, normal, random),
               b = clicked(scan, thickness / 2 * normal, normal, random);
    if (!a || !b)
        return {};
    return distance(scan.geometry(), *a, *b);
}

void plates(int trials) {
    std::printf("plates\n%-14s %-12s %5s %6s %7s %7s %6s %6s %6s %6s %6s %6s\n", "grid [mm]", "HU, noise", "mm",
                "stated", "at most", "no edge", "bias", "SD", "±/1.96", "holds", "bounds", "untold");
    unsigned seed = 0;
    for (const Grid& grid : kGrids)
        for (const Tissue& tissue : kTissues)
            for (const double thickness : {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 10.0, 30.0}) {
                std::mt19937 random(++seed);
                const Scanner scanner{grid.spacingMm, grid.blurMm, tissue.noiseHu};
                CoverageRow row;
                for (int trial = 0; trial < trials; ++trial)
                    row.add(plate(scanner, thickness, tissue.hu, random), thickness);
                std::printf("%-4g%-4g%-6g %4g/%-3g %-3g %5.1f ", grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z,
                            tissue.hu.inside, tissue.hu.outside, tissue.noiseHu, thickness);
                row.print();
            }
}

/// The angle at the middle of a ball between two places on its border.
std::optional<Stated> ballAngle(const Scanner& scanner, Contrast hu, double truth, std::mt19937& random) {
    const double radius = 15, t = truth * std::numbers::pi / 180;
    const Volume scan = scannedBall(scanner, radius, hu, radius + 9, random);
    const dvec3 u = randomDirection(random), w = glm::normalize(glm::cross(u, randomDirection(random)));
    const dvec3 v = std::cos(t) * u + std::sin(t) * w;
    const auto a = clicked(scan, radius * u, u, random), b = clicked(scan, radius * v, v, random),
               back = clicked(scan, -radius * u, -u, random), other = clicked(scan, -radius * v, -v, random);
    if (!a || !b || !back || !other)
        return {};
    const Result<Stated> found = angleOfLines({*back, *a}, {*other, *b});
    return found ? std::optional(*found) : std::nullopt;
}

void angles(int trials) {
    std::printf("angles of two diameters of a ball of 30 mm\n");
    unsigned seed = 1000;
    for (const Grid& grid : kGrids)
        for (const double truth : {2.0, 15.0, 45.0, 90.0, 150.0}) {
            std::mt19937 random(++seed);
            CoverageRow row;
            for (int trial = 0; trial < trials; ++trial)
                row.add(ballAngle({grid.spacingMm, dvec3(grid.blurMm.x), 15}, {1000, 40}, truth, random), truth);
            std::printf("%-4g%-4g%-6g %-12s %4.0f° ", grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z,
                        "1000/40 15", truth);
            row.print();
        }
}

MeasuredShape ball(double radius, std::mt19937&) {
    return Ball{dvec3(0), radius};
}

/// Returns two unit vectors along a plane of slices.
std::pair<dvec3, dvec3> alongSlices(std::mt19937& random) {
    const auto axis = std::uniform_int_distribution<glm::length_t>(0, 2)(random);
    dvec3 u(0), v(0);
    u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1;
    return {u, v};
}

MeasuredShape ellipse(double radius, std::mt19937& random) {
    const auto [u, v] = alongSlices(random);
    return PlaneEllipse{dvec3(0), radius * u, 0.6 * radius * v};
}

/// Returns a polygon in the shape of an L.
MeasuredShape polygon(double radius, std::mt19937& random) {
    const auto [u, v] = alongSlices(random);
    PlanePolygon shape{{}, glm::cross(u, v)};
    for (const dvec2 corner :
         {dvec2(-1, -1), dvec2(0.6, -1), dvec2(0.6, -0.3), dvec2(0, -0.3), dvec2(0, 0.9), dvec2(-1, 0.9)})
        shape.corners.push_back(0.9 * radius * (corner.x * u + corner.y * v));
    return shape;
}

struct Region {
    const char* name;
    MeasuredShape (*make)(double radius, std::mt19937& random);
    std::array<double, 4> radiiMm;
};
const Region kRegions[]{
    {"ball", ball, {3, 5, 8, 12}}, {"ellipse", ellipse, {6, 10, 15, 25}}, {"polygon", polygon, {6, 10, 15, 25}}};

/// Prints how often the mean of water lies in its interval, in trials in which there is one.
void meansOf(const Region& region, double radius, const Scanner& scanner, int trials, std::mt19937& random) {
    int stated = 0, held = 0, naive = 0;
    Sample count;
    for (int trial = 0; trial < trials; ++trial) {
        const Volume scan =
            scanned(gridAround(scanner, radius + 3, random), scanner, [](dvec3) { return 0.0; }, random);
        const auto found = regionStatistics(scan, region.make(radius, random));
        if (!found || !found->meanPlusMinus)
            continue;
        ++stated;
        count.add(double(found->count));
        held += std::abs(found->meanHu) <= *found->meanPlusMinus;
        naive += std::abs(found->meanHu) <= 1.96 * found->sdHu / std::sqrt(double(found->count));
    }
    std::printf("%-8s %-4g%-4g%-6g %-12s %4.0f mm %7.0f %7d %6.1f %6.1f\n", region.name, scanner.spacingMm.x,
                scanner.spacingMm.y, scanner.spacingMm.z, scanner.noiseGrainMm > 0 ? "correlated" : "white", radius,
                count.mean(), stated, percent(held, stated), percent(naive, stated));
    std::fflush(stdout);
}

void regions(int trials) {
    std::printf("means in water, noise 20 HU: region, grid [mm], noise, size, voxels, trials with a ±, holds [%%], "
                "SD/sqrt(n) holds [%%]\n");
    unsigned seed = 2000;
    for (const Region& region : kRegions)
        for (const Grid& grid : kGrids)
            for (const double grain : {0.0, 0.7})
                for (const double radius : region.radiiMm) {
                    std::mt19937 random(++seed);
                    meansOf(region, radius, {grid.spacingMm, grid.blurMm, 20, grain}, trials, random);
                }
}

}  // namespace
}  // namespace pdr::test

int main(int argc, char** argv) {
    int trials = 200;
    std::string only;
    for (int n = 1; n + 1 < argc; n += 2)
        if (!std::strcmp(argv[n], "--trials"))
            trials = std::atoi(argv[n + 1]);
        else if (!std::strcmp(argv[n], "--only"))
            only = argv[n + 1];
    const auto wanted = [&](const char* part) { return only.empty() || only == part; };
    if (wanted("regions"))
        pdr::test::regions(trials);
    if (wanted("angles"))
        pdr::test::angles(trials);
    if (wanted("plates"))
        pdr::test::plates(trials);
}
