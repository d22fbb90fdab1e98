/// Slices compared with those of an independent program (tests/oracle/make_numbers.py).

#include <QTest>

#include <cmath>

#include "render/slice/reslice.h"
#include "tests/support/oracle_numbers.h"
#include "tests/support/oracle_plane.h"

using namespace pdr;

class OracleSlicesTest : public QObject {
    Q_OBJECT

  private slots:
    void anObliqueSliceIsTheOracles_data() { test::addOracleRows(); }
    void anObliqueSliceIsTheOracles() {
        PDR_FETCH_ORACLE(numbers, volume);
        const nlohmann::json& expected = numbers["slice"]["hu"];
        const auto image = reslice(*volume, test::planeOf(numbers["slice"]));
        QCOMPARE(image->hu.size(), expected.size());
        int inside = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QCOMPARE(std::isnan(image->hu[i]), expected[i].is_null());
            if (expected[i].is_null())
                continue;
            QVERIFY(std::abs(image->hu[i] - expected[i].get<double>()) < test::kOracleHu);
            ++inside;
        }
        QVERIFY(inside > 1000);
    }

    /// A slice of one pixel about each place, seen along another direction each.
    void theHuUnderTheCursorAreTheOracles_data() { test::addOracleRows(); }
    void theHuUnderTheCursorAreTheOracles() {
        PDR_FETCH_ORACLE(numbers, volume);
        double turn = 0;
        for (const nlohmann::json& place : numbers["placesMmHu"]) {
            turn += 0.1;
            const dvec3 right(std::cos(turn), std::sin(turn), 0), down(0, 0, -1);
            const auto image = reslice(*volume, SlicePlane::around(test::vectorOf(place), right, down, 0.5, {1, 1}));
            QVERIFY2(std::abs(image->hu[0] - place[3].get<double>()) < test::kOracleHu, place.dump().c_str());
        }
    }
};

QTEST_APPLESS_MAIN(OracleSlicesTest)
#include "oracle_slices_test.moc"
