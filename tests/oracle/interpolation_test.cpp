/// The values that the renderer meets, compared with those of an independent program (tests/oracle/make_numbers.py).

#include <QTest>

#include <cmath>

#include "render/kernel/flat_grid.h"
#include "render/kernel/volume_sampling.h"
#include "tests/support/oracle_numbers.h"

using namespace pdr;

class InterpolationTest : public QObject {
    Q_OBJECT

  private slots:
    void theGridLiesWhereTheOracleSaysSo_data() { test::addOracleRows(); }
    void theGridLiesWhereTheOracleSaysSo() {
        PDR_FETCH_ORACLE(numbers, volume);
        const dmat4& map = volume->geometry().patientFromIndex;
        for (int axis = 0; axis < 3; ++axis)
            QCOMPARE(volume->size()[axis], numbers["size"][std::size_t(axis)].get<int>());
        for (int column = 0; column < 4; ++column) {
            const dvec3 expected = test::vectorOf(numbers["patientFromIndex"][std::size_t(column)]);
            QVERIFY(glm::distance(dvec3(map[column]), expected) < 1e-6);
        }
    }

    void theRendererMeetsTheOraclesValues_data() { test::addOracleRows(); }
    void theRendererMeetsTheOraclesValues() {
        PDR_FETCH_ORACLE(numbers, volume);
        const FlatGrid grid = flatGrid(volume->voxels().data(), volume->size());
        const dmat4 indexFromPatient = glm::inverse(volume->geometry().patientFromIndex);
        QVERIFY(numbers["placesMmHu"].size() >= 1000);
        for (const nlohmann::json& place : numbers["placesMmHu"]) {
            const dvec3 index(indexFromPatient * dvec4(test::vectorOf(place), 1));
            const float hu = trilinearAt<float>(grid, {float(index.x), float(index.y), float(index.z)});
            QVERIFY2(std::abs(hu - place[3].get<double>()) < test::kOracleHu, place.dump().c_str());
        }
    }
};

QTEST_APPLESS_MAIN(InterpolationTest)
#include "interpolation_test.moc"
