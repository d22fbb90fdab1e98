/// Edges of plates, balls and steps by formula: where they are, how sure that is, and where there are none.

#include <QTest>

#include "render/kernel/volume_sampling.h"
#include "render/measure/distance.h"
#include "render/measure/edge.h"
#include "render/measure/trilinear.h"
#include "tests/support/scenes/edge_phantoms.h"
#include "tests/support/statistics.h"

using namespace pdr;
using namespace pdr::measure;
using test::Contrast;
using test::Scanner;

namespace {

const Scanner kThick{{0.9, 0.9, 2.5}, {0.6, 0.6, 0.9}, 15}, kThin{{0.7, 0.7, 1.0}, {0.6, 0.6, 0.7}, 15};
const Contrast kBone{1000, 40};

/// Gantries that were tilted by 18.5 and 35 degrees, one of them about both axes of the slice.
const Scanner kTilted{{0.5, 0.5, 1.19}, {0.6, 0.6, 0.7}, 15, 0.7, {0, 0.397}},
    kAskew{{0.7, 0.7, 0.82}, {0.6, 0.6, 0.6}, 15, 0.7, {-0.3, 0.48}};

/// Returns the scan of a half space that is `high` where dot(p, normal) > 0.
Volume scannedStep(const Scanner& scanner, dvec3 normal, double low, double high, std::mt19937& random) {
    const double blur = test::blurAlong(scanner, normal);
    return test::scanned(
        test::gridAround(scanner, 12, random), scanner,
        [=](dvec3 p) { return low + (high - low) * test::blurredStep(glm::dot(p, normal), blur); }, random);
}

/// Returns the plate's thickness as it is measured from clicks within 0.45 mm of its two borders.
std::optional<Stated> measuredPlate(const Volume& scan, double thickness, dvec3 normal, std::mt19937& random) {
    std::uniform_real_distribution<double> hand(-0.45, 0.45);
    const dvec3 across = glm::normalize(glm::cross(normal, test::randomDirection(random)));
    std::array<Place, 2> ends;
    for (const int side : {0, 1}) {
        const double along = hand(random);
        const dvec3 click = (side ? 1 : -1) * thickness / 2 * normal + along * normal + hand(random) / 2 * across;
        const EdgeSearch found = edgeNear(scan, click);
        if (!found.edge)
            return {};
        ends[std::size_t(side)] = atEdge(clickedPlace(scan.geometry(), click, {normal, across, 0.45, 0}), *found.edge);
    }
    return distance(scan.geometry(), ends[0], ends[1]);
}

}  // namespace

class EdgeTest : public QObject {
    Q_OBJECT

  private slots:
    void valuesBetweenVoxelsAreTheRenderers() {
        std::mt19937 random(1);
        const Volume scan = scannedStep({{0.9, 0.8, 2.5}, {0.6, 0.6, 0.9}, 200}, {0.6, 0, 0.8}, 0, 1000, random);
        const GridPlace grid(scan.geometry());
        FlatGrid flat{scan.voxels().data(),
                      scan.size(),
                      vec3(scan.size() - 1),
                      vec3(scan.size() - 2),
                      1,
                      scan.size().x,
                      std::int64_t(scan.size().x) * scan.size().y};
        std::uniform_real_distribution<float> within(-1, 1);
        for (int trial = 0; trial < 2000; ++trial) {
            const float x = within(random), y = within(random);
            const vec3 at = vec3(scan.size()) * (0.5f + 0.6f * vec3(x, y, within(random)));
            const double ours = huAt(scan, grid, dvec3(scan.geometry().patientFromIndex * dvec4(dvec3(at), 1)));
            QVERIFY(std::abs(ours - double(trilinearAt<float>(flat, {at.x, at.y, at.z}))) < 0.05);
        }
    }

    /// Two tenths of a step of the grid are the most that interpolation between voxels moves a sharp edge.
    void aStepIsWhereTheFormulaSays() {
        std::mt19937 random(2);
        test::Sample errors, inSigmas;
        for (int trial = 0; trial < 60; ++trial) {
            const dvec3 normal = test::randomDirection(random);
            const Volume scan = scannedStep(trial % 2 ? kThick : kThin, normal, 40, 400, random);
            const EdgeSearch found = edgeNear(scan, 0.6 * test::randomDirection(random));
            QVERIFY(found.edge);
            QVERIFY(glm::dot(found.edge->normal, normal) > 0.98);
            QVERIFY(std::abs(found.edge->lowHu - 40) < 30 && std::abs(found.edge->highHu - 400) < 30);
            QVERIFY(found.edge->noiseHu > 10 && found.edge->noiseHu < 22 && !found.edge->thin);
            const double error = glm::dot(found.edge->mm, normal);
            errors.add(error);
            inSigmas.add(std::pow(error / std::hypot(found.edge->edgeSigma, found.edge->gridSigma), 2));
        }
        QVERIFY2(std::abs(errors.mean()) < 0.03, qPrintable(QString::number(errors.mean())));
        QVERIFY2(inSigmas.mean() > 0.3 && inSigmas.mean() < 1.4, qPrintable(QString::number(inSigmas.mean())));
    }

    /// Bone in air and air in bone: what is halfway does not depend on which side is bright.
    void aPlateIsAsThickAsTheFormulaSays() {
        std::mt19937 random(3);
        for (const Contrast contrast : {kBone, Contrast{-900, 50}}) {
            test::Sample errors;
            int held = 0, count = 0;
            for (int trial = 0; trial < 40; ++trial) {
                const dvec3 normal = test::randomDirection(random);
                const double thickness = trial % 2 ? 8 : 5;
                const Volume scan = test::scannedPlate(kThin, thickness, normal, contrast, 13, random);
                const auto stated = measuredPlate(scan, thickness, normal, random);
                QVERIFY(stated && stated->bound == Bound::none);
                errors.add(stated->value - thickness);
                held += stated->low <= thickness && thickness <= stated->high;
                ++count;
            }
            QVERIFY2(std::abs(errors.mean()) < 0.025, qPrintable(QString::number(errors.mean())));
            QVERIFY2(held >= 34, qPrintable(QString("%1 of %2").arg(held).arg(count)));
        }
    }

    /// A blurred plate of 2 mm or less looks thicker than it is: no number may say so without a word.
    void aThinPlateIsAtMostSoThick() {
        std::mt19937 random(4);
        int bounds = 0, held = 0;
        for (int trial = 0; trial < 60; ++trial) {
            const dvec3 normal = test::randomDirection(random);
            const double thickness = trial % 2 ? 1 : 2;
            const Volume scan = test::scannedPlate(kThin, thickness, normal, kBone, 10, random);
            const auto stated = measuredPlate(scan, thickness, normal, random);
            bounds += stated && stated->bound == Bound::atMost && stated->limit == Limit::thin;
            held += !stated || stated->high >= thickness;
        }
        QVERIFY2(bounds >= 58 && held == 60, qPrintable(QString("%1, %2").arg(bounds).arg(held)));
    }

    /// Steps and plates of a tilted scan are where they are in the patient, as surely as those of an upright one.
    void aTiltedScanMeasuresAsAnUprightOne() {
        std::mt19937 random(9);
        for (const Scanner& scanner : {kTilted, kAskew}) {
            test::Sample steps, inSigmas, plates;
            int held = 0;
            for (int trial = 0; trial < 40; ++trial) {
                const dvec3 normal = test::randomDirection(random);
                const Volume step = scannedStep(scanner, normal, 40, 400, random);
                const EdgeSearch found = edgeNear(step, 0.6 * test::randomDirection(random));
                QVERIFY(found.edge);
                QVERIFY(glm::dot(found.edge->normal, normal) > 0.98);
                const double error = glm::dot(found.edge->mm, normal), thickness = trial % 2 ? 8 : 5;
                steps.add(error);
                inSigmas.add(std::pow(error / std::hypot(found.edge->edgeSigma, found.edge->gridSigma), 2));
                const Volume plate = test::scannedPlate(scanner, thickness, normal, kBone, 13, random);
                const auto stated = measuredPlate(plate, thickness, normal, random);
                QVERIFY(stated && stated->bound == Bound::none);
                plates.add(stated->value - thickness);
                held += stated->low <= thickness && thickness <= stated->high;
            }
            QVERIFY2(std::abs(steps.mean()) < 0.03, qPrintable(QString::number(steps.mean())));
            QVERIFY2(inSigmas.mean() > 0.3 && inSigmas.mean() < 1.6, qPrintable(QString::number(inSigmas.mean())));
            QVERIFY2(std::abs(plates.mean()) < 0.025, qPrintable(QString::number(plates.mean())));
            QVERIFY2(held >= 34, qPrintable(QString::number(held)));
        }
    }

    /// A tilted scan does not lengthen a ball along the table, nor across it.
    void aBallOfATiltedScanHasItsDiameter() {
        std::mt19937 random(10);
        Scanner scanner = kTilted;
        scanner.blurMm = dvec3(0.6);
        const Volume scan = test::scannedBall(scanner, 12, kBone, 20, random);
        test::Sample diameters;
        for (int trial = 0; trial < 40; ++trial) {
            const dvec3 out = trial % 4 == 0 ? dvec3(0, 0, 1) : test::randomDirection(random);
            const EdgeSearch a = edgeNear(scan, 12.4 * out), b = edgeNear(scan, -11.7 * out);
            QVERIFY(a.edge && b.edge);
            diameters.add(glm::distance(a.edge->mm, b.edge->mm) - 24);
            QVERIFY(glm::dot(a.edge->normal, out) < -0.98);
        }
        QVERIFY2(std::abs(diameters.mean()) < 0.2, qPrintable(QString::number(diameters.mean())));
    }

    void whatWasClickedOnASliceStaysInIt() {
        std::mt19937 random(5);
        const dvec3 normal = glm::normalize(dvec3(0.6, 0.2, 0.75)), slice(0, 0, 1);
        const Volume scan = scannedStep(kThin, normal, 0, 1000, random);
        const EdgeSearch found = edgeNear(scan, {0.7, -0.4, 0.3}, slice);
        QVERIFY(found.edge);
        QVERIFY(std::abs(found.edge->mm.z - 0.3) < 1e-9 && std::abs(found.edge->normal.z) < 1e-9);
        QVERIFY(std::abs(glm::dot(found.edge->mm, normal)) < 0.1);
    }

    /// A blur of s moves the half level of a ball inwards by s^2 over its radius, and so does the disc: 0.06 mm here.
    void aBallHasItsDiameter() {
        std::mt19937 random(6);
        const Scanner even{{0.7, 0.7, 1.0}, {0.6, 0.6, 0.6}, 15};
        const Volume scan = test::scannedBall(even, 12, kBone, 20, random);
        test::Sample errors;
        for (int trial = 0; trial < 40; ++trial) {
            const dvec3 out = test::randomDirection(random);
            const EdgeSearch a = edgeNear(scan, 12.4 * out), b = edgeNear(scan, -11.7 * out);
            QVERIFY(a.edge && b.edge);
            errors.add(glm::length(a.edge->mm) - 12);
            errors.add(glm::length(b.edge->mm) - 12);
        }
        QVERIFY2(errors.mean() < 0 && errors.mean() > -0.1, qPrintable(QString::number(errors.mean())));
    }

    void whereThereIsNoEdgeTheReasonIsSaid() {
        std::mt19937 random(7);
        const dvec3 normal(1, 0, 0);
        const Volume scan = scannedStep(kThin, normal, 0, 1000, random);
        QCOMPARE(edgeNear(scan, {500, 0, 0}).why, NoEdge::outside);
        QVERIFY(!edgeNear(scan, {500, 0, 0}).edge);
        for (const double away : {-6.0, 6.0})
            QVERIFY(!edgeNear(scan, {away, 0, 0}).edge);
        for (const double away : {-2.2, 2.2})
            QVERIFY(edgeNear(scan, {away, 0, 0}).edge);
        const Volume faint = scannedStep({kThin.spacingMm, kThin.blurMm, 30}, normal, 0, 110, random);
        QVERIFY(!edgeNear(faint, dvec3(0)).edge);
        QCOMPARE(edgeNear(faint, dvec3(0)).why, NoEdge::faint);
        std::vector<bool> padding;
        for (const std::int16_t hu : scan.voxels())
            padding.push_back(hu < 500);
        const Volume padded(scan.geometry(), Voxels(scan.voxels().begin(), scan.voxels().end()), padding);
        QVERIFY(!edgeNear(padded, dvec3(0)).edge);
        QCOMPARE(edgeNear(padded, dvec3(0)).why, NoEdge::padding);
        for (const NoEdge why : {NoEdge::outside, NoEdge::far, NoEdge::faint, NoEdge::padding, NoEdge::cramped})
            QVERIFY(!noEdgeText(why).empty());
    }

    /// A mirrored scan has mirrored edges: no side is favoured.
    void anEdgeFavoursNoSide() {
        std::mt19937 random(8);
        const Volume scan = scannedStep(kThin, glm::normalize(dvec3(0.8, 0.5, 0.3)), 0, 600, random);
        Voxels inverted;
        for (const std::int16_t hu : scan.voxels())
            inverted.push_back(std::int16_t(600 - hu));
        const Volume other(scan.geometry(), inverted);
        const EdgeSearch a = edgeNear(scan, {0.5, 0.2, -0.3}), b = edgeNear(other, {0.5, 0.2, -0.3});
        QVERIFY(a.edge && b.edge);
        QVERIFY(glm::distance(a.edge->mm, b.edge->mm) < 0.02 && glm::dot(a.edge->normal, b.edge->normal) < -0.999);
    }
};

QTEST_APPLESS_MAIN(EdgeTest)
#include "edge_test.moc"
