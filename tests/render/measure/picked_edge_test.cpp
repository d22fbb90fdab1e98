/// Places that were picked in an image and moved to an edge: where the ray meets it, whatever the look has made of the
/// depth, with a spread that holds what it says.

#include <QTest>

#include "render/measure/picked_edge.h"
#include "tests/support/scenes/edge_phantoms.h"
#include "tests/support/statistics.h"

using namespace pdr;
using namespace pdr::measure;
using test::Scanner;

namespace {

const Scanner kScanner{{0.9, 0.9, 2.5}, {0.6, 0.6, 0.9}, 15};

/// Returns the scan of bone where dot(p, normal) > 0, and soft tissue elsewhere.
Volume scannedStep(dvec3 normal, std::mt19937& random) {
    const double blur = test::blurAlong(kScanner, normal);
    return test::scanned(
        test::gridAround(kScanner, 14, random), kScanner,
        [=](dvec3 p) { return 40 + 960 * test::blurredStep(glm::dot(p, normal), blur); }, random);
}

/// Returns a direction that lies `degrees` off `normal`.
dvec3 aslant(dvec3 normal, double degrees, std::mt19937& random) {
    const dvec3 across = glm::normalize(glm::cross(normal, test::randomDirection(random)));
    return std::cos(glm::radians(degrees)) * normal + std::sin(glm::radians(degrees)) * across;
}

Place pickedAt(const Volume& scan, dvec3 mm, dvec3 ray) {
    return pickedPlace(scan.geometry(), mm, ray, 0.6, 0.15);
}

}  // namespace

class PickedEdgeTest : public QObject {
    Q_OBJECT

  private slots:
    /// Rays come from cameras in float, so they may be a little longer than 1; no variance is negative for that.
    void aPickHasNoNegativeVariance() {
        std::mt19937 random(2);
        const VolumeGeometry grid = VolumeGeometry::aligned({4, 4, 4}, dvec3(1), dvec3(0));
        for (int trial = 0; trial < 100; ++trial) {
            const dvec3 ray = test::randomDirection(random) * (1 + 1e-7);
            const Place place = pickedPlace(grid, dvec3(1), ray, 30, 0.06);
            const double along = glm::dot(ray, place.spread.of(Cause::hand) * ray);
            QVERIFY2(std::abs(along) < 1e-14, qPrintable(QString::number(along)));
        }
    }

    /// A look finds the surface up to 2 mm too deep or 0.5 mm too near; the edge is where the ray meets the half level.
    void aPlaceGoesAlongItsRayToTheEdge() {
        std::mt19937 random(3);
        test::Sample off;
        for (const double degrees : {0.0, 25.0, 45.0, 60.0})
            for (const double depth : {-0.5, 0.6, 1.2, 1.8})
                for (int trial = 0; trial < 8; ++trial) {
                    const dvec3 normal = test::randomDirection(random), ray = aslant(normal, degrees, random);
                    const Volume scan = scannedStep(normal, random);
                    const Place place = onEdge(scan, pickedAt(scan, depth * ray, ray), ray);
                    QCOMPARE(place.found, Found::pickedEdge);
                    const double along = glm::dot(place.mm, ray);
                    QVERIFY(glm::length(place.mm - along * ray) < 1e-9);  // still under the pointer
                    QVERIFY2(std::abs(along) < 0.6, qPrintable(QString::number(along)));
                    off.add(along);
                }
        QVERIFY2(std::abs(off.mean()) < 0.05, qPrintable(QString::number(off.mean())));
    }

    void itsSpreadIsThatOfTheEdgeAndThePixel() {
        std::mt19937 random(4);
        int held = 0;
        constexpr int kTrials = 300;
        for (int trial = 0; trial < kTrials; ++trial) {
            const dvec3 normal = test::randomDirection(random), ray = aslant(normal, 40, random);
            const Volume scan = scannedStep(normal, random);
            const Place place = onEdge(scan, pickedAt(scan, 1.2 * ray, ray), ray);
            const double sigma = std::sqrt(glm::dot(normal, place.spread.total() * normal));
            held += std::abs(glm::dot(place.mm, normal)) <= 1.96 * sigma;
            QVERIFY(place.spread.of(Cause::light) == dmat3(0));
            const dmat3& hand = place.spread.of(Cause::hand);
            QVERIFY(glm::dot(normal, hand * normal) < 2e-3);  // along the edge alone, and widened by the slant
            const dvec3 down = glm::normalize(ray - glm::dot(ray, normal) * normal);
            QVERIFY(std::abs(glm::dot(down, hand * down) - std::pow(0.15 / std::cos(glm::radians(40.0)), 2)) < 8e-3);
        }
        QVERIFY2(held >= 0.92 * kTrials, qPrintable(QString::number(held)));
    }

    /// Voxels and averages cut the corners of what curves: the spread allows for that.
    void theSurfaceOfABallLiesInTheSpread() {
        std::mt19937 random(7);
        constexpr double kRadius = 25;
        constexpr int kScans = 6, kPlaces = 50;
        int held = 0;
        for (int scanned = 0; scanned < kScans; ++scanned) {
            const Volume scan = test::scannedBall(kScanner, kRadius, {1000, 40}, kRadius + 9, random);
            for (int n = 0; n < kPlaces; ++n) {
                const dvec3 outwards = test::randomDirection(random), ray = -aslant(outwards, 30, random);
                const Place place = onEdge(scan, pickedAt(scan, kRadius * outwards + 1.2 * ray, ray), ray);
                const dvec3 there = glm::normalize(place.mm);
                const double sigma = std::sqrt(glm::dot(there, place.spread.total() * there));
                held += std::abs(glm::length(place.mm) - kRadius) <= 1.96 * sigma;
            }
        }
        QVERIFY2(held >= 0.93 * kScans * kPlaces, qPrintable(QString::number(held)));
    }

    /// Where the ray grazes the edge, it does not say where on the edge a place lies.
    void aGrazingRayMovesAcrossTheEdge() {
        std::mt19937 random(5);
        const dvec3 normal(1, 0, 0), ray = aslant(normal, 80, random);
        const Volume scan = scannedStep(normal, random);
        const dvec3 picked = 1.0 * normal;
        const Place place = onEdge(scan, pickedAt(scan, picked, ray), ray);
        QCOMPARE(place.found, Found::pickedEdge);
        QVERIFY(glm::distance(place.mm, picked) < 1.5);
        const dvec3 along = glm::normalize(ray - glm::dot(ray, normal) * normal);
        QVERIFY(glm::dot(along, place.spread.of(Cause::light) * along) > 0.5 * 0.6 * 0.6);
    }

    /// Nobody knows then how deep the look shows what it shows.
    void withoutAnEdgeAPlaceStaysAsUnsureAsTheLook() {
        std::mt19937 random(6);
        const Volume scan = scannedStep({1, 0, 0}, random);
        const Place picked = pickedAt(scan, {-8, 0, 0}, {1, 0, 0}), place = onEdge(scan, picked, {1, 0, 0});
        QVERIFY(place == offEdge(picked, {1, 0, 0}));
        QVERIFY(place.mm == picked.mm && place.found == Found::picked);
        QVERIFY(std::abs(place.spread.of(Cause::light)[0][0] - (0.6 * 0.6 + 1.2 * 1.2)) < 1e-12);
        QCOMPARE(place.spread.of(Cause::light)[1][1], 0.0);
    }
};

QTEST_GUILESS_MAIN(PickedEdgeTest)
#include "picked_edge_test.moc"
