/// Tests the findings of scans: patients made from formulas.

#include <QTest>

#include <tbb/global_control.h>

#include <random>

#include "render/segment/findings.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;
using segment::Findings;
using segment::findingsOn;

namespace {

struct Patient {
    double bloodHu = 45, lungHu = 40, marrowHu = 250, marrowTextureHu = 90, screwHu = 1200, noiseHu = 20;
};

bool inTube(dvec3 p, dvec2 centre, double radius) {
    return std::hypot(p.x - centre.x, p.y - centre.y) < radius;
}

/// A trunk of 300 x 200 x 100 mm with a lung, a vessel of 28 mm, a spine, and a screw of 10 mm in it.
std::shared_ptr<const Volume> scanOf(const Patient& patient) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const dvec3 spacing(2);
    return test::makeVolume({160, 110, 50}, spacing, [&](int i, int j, int k) {
        const dvec3 p = (dvec3(i, j, k) + 0.5) * spacing - dvec3(160, 110, 50);
        double hu = -1000, noise = patient.noiseHu;
        if (std::hypot(p.x / 150, p.y / 100) < 1)
            hu = 40;
        if (inTube(p, {-70, 0}, 50))
            hu = patient.lungHu;
        if (inTube(p, {20, 0}, 14))
            hu = patient.bloodHu;
        if (inTube(p, {20, 60}, 20)) {
            hu = patient.marrowHu;
            noise = std::hypot(noise, patient.marrowTextureHu);
        }
        if (inTube(p, {20, 60}, 5))
            hu = patient.screwHu;
        return std::clamp(hu + noise * normal(random), -1024.0, 3071.0);
    });
}

Findings found(const Patient& patient) {
    const auto scan = scanOf(patient);
    return findingsOn(*scan, scan->geometry());
}

}  // namespace

class FindingsTest : public QObject {
    Q_OBJECT

  private slots:
    void bloodWithContrastIsFoundWhereItIs() {
        for (const double hu : {220.0, 300.0, 420.0, 600.0}) {
            const Findings findings = found({.bloodHu = hu});
            QVERIFY(findings.blood);
            QVERIFY2(std::abs(*findings.blood - hu) < 15, qPrintable(QString::number(double(*findings.blood))));
        }
    }

    void aNativeScanHasNoContrast() {
        QVERIFY(!found({}).blood);
        QVERIFY(!found({.marrowHu = 400}).blood);
        QVERIFY(!found({.noiseHu = 30}).blood);
        QVERIFY(!found({.bloodHu = 90}).blood);  // a late phase
    }

    void noiseDoesNotHideContrast() {
        const Findings findings = found({.bloodHu = 350, .noiseHu = 45});
        QVERIFY(findings.blood && std::abs(*findings.blood - 350) < 15);
    }

    void lungsAndMetalAreMeasured() {
        const Findings plain = found({});
        QVERIFY(plain.lungMl < 30 && plain.metalMl == 0);
        const Findings lungs = found({.lungHu = -850});
        const double ml = 3.14159265 * 50 * 50 * 100 / 1000;
        QVERIFY2(std::abs(lungs.lungMl / ml - 1) < 0.1, qPrintable(QString::number(lungs.lungMl)));
        const Findings screw = found({.screwHu = 3000});
        QVERIFY2(std::abs(screw.metalMl / (3.14159265 * 25 * 100 / 1000) - 1) < 0.2,
                 qPrintable(QString::number(screw.metalMl)));
    }

    void theWidthIsThatOfTheBody() {
        const auto scan = scanOf({});
        QCOMPARE(findingsOn(*scan, scan->geometry()).widthMm, 320.0);
        QCOMPARE(findingsOn(*scan, scan->geometry().part({10, 0, 0}, {100, 110, 50})).widthMm, 200.0);
    }

    void nothingDependsOnThreads() {
        const auto scan = scanOf({.bloodHu = 350, .lungHu = -800, .screwHu = 3000});
        const Findings all = findingsOn(*scan, scan->geometry());
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        QVERIFY(findingsOn(*scan, scan->geometry()) == all);
    }

    void emptyAndTinyScansHaveNothing() {
        for (const ivec3 size : {ivec3(1), ivec3(3, 1, 1), ivec3(40, 40, 1)}) {
            const auto air = test::makeVolume(size, dvec3(1), [](int, int, int) { return -1024; });
            const Findings findings = findingsOn(*air, air->geometry());
            QVERIFY(!findings.blood && findings.lungMl == 0 && findings.metalMl == 0);
        }
    }
};

QTEST_APPLESS_MAIN(FindingsTest)
#include "findings_test.moc"
