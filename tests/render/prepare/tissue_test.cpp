/// The kernel's optical properties of HU agree with the curve: in pieces, on nodes and steps, and beyond the ends, one
/// at a time and in lanes.

#include <QTest>

#include "render/kernel/medium.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

/// Rises, jumps at 200, falls, and ends above 0; each end of a piece has another material.
TransferFunction steps() {
    const auto node = [](float hu, float opacity, float shade) {
        return TransferNode{hu, opacity, vec3(shade, 1 - shade, 0.5f), vec3(2 * shade), vec3(shade / 2), shade};
    };
    return {2, {node(-100, 0.1f, 0.1f), node(200, 0.5f, 0.9f), node(200, 0.8f, 0.2f), node(300, 0.3f, 0.6f)}};
}

constexpr float kPlaces[] = {-3000, -100.5f, -100, -50, 0, 125, 199.5f, 200, 200.5f, 250, 299, 300, 301, 4000};

bool close(vec3 a, vec3 b) {
    return glm::all(glm::lessThan(glm::abs(a - b), vec3(1e-5f)));
}

}  // namespace

class TissueTest : public QObject {
    Q_OBJECT

  private slots:
    void stepsBelongToTheTissueAboveThem() {
        const TransferTables tables(steps());
        QCOMPARE(opacity(tables.flat(), 200.0f), 0.8f);
        QCOMPARE(materialAt(tables.flat(), 200.0f).roughness, 0.2f);
        QVERIFY(opacity(tables.flat(), std::nextafter(200.0f, 0.0f)) < 0.5001f);
    }

    void everyPropertyIsTheCurves() {
        const TransferFunction function = steps();
        const TransferTables tables(function);
        for (const float hu : kPlaces) {
            const TransferNode truth = function.at(hu);
            const Material found = materialAt(tables.flat(), hu);
            QVERIFY(close(found.albedo, truth.albedo) && close(found.emission, truth.emission));
            QVERIFY(close(found.specular, truth.specular) && std::fabs(found.roughness - truth.roughness) < 1e-5f);
            QVERIFY(std::fabs(opacity(tables.flat(), hu) - truth.opacity) < 1e-6f);
            QVERIFY(std::fabs(function.opacityAt(hu) - truth.opacity) < 1e-6f);
        }
    }

    void lanesFindTheSameExtinction() {
        const TransferTables tables(steps());
        for (const float hu : kPlaces)
            for (int lane = 0; lane < kLanes; ++lane) {
                FloatLanes many{};
                many[lane] = hu;
                QCOMPARE(extinctionOf(tables.flat(), many)[lane], extinctionOf(tables.flat(), hu));
                QVERIFY(std::fabs(extinctionOf(tables.flat(), hu) - 2 * steps().at(hu).opacity) < 2e-6f);
            }
    }
};

QTEST_GUILESS_MAIN(TissueTest)
#include "tissue_test.moc"
