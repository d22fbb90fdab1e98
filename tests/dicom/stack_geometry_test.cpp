#include <QTest>

#include <algorithm>
#include <cmath>

#include "dicom/stack/stack_geometry.h"
#include "render/volume/sheared.h"

using namespace pdr;
using namespace pdr::dicom;

namespace {

SlicePlane planeAt(const std::string& name, dvec3 position) {
    return {name, {512, 512}, position, dvec3(1, 0, 0), dvec3(0, 1, 0), dvec2(0.5, 0.7)};
}

std::string letter(int i) {
    return std::string(1, char('a' + i));
}

/// Slices a, b, c ... at the given heights.
std::vector<SlicePlane> axial(const std::vector<double>& heights) {
    std::vector<SlicePlane> slices;
    for (const double z : heights)
        slices.push_back(planeAt(letter(int(slices.size())), {-100, -120, z}));
    return slices;
}

bool says(const StackAnalysis& analysis, const std::vector<std::string>& words) {
    return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
        return analysis.verdict.reason.find(word) != std::string::npos;
    });
}

/// Slices a, b, c ... of a gantry that was tilted by `degrees` about the rows, `tableMm` of table between them.
std::vector<SlicePlane> tilted(double degrees, int count, double tableMm) {
    const double tilt = degrees * 3.14159265358979 / 180;
    std::vector<SlicePlane> slices;
    for (int k = 0; k < count; ++k) {
        slices.push_back(planeAt(letter(k), {-123.5, -15.6, 792.3 + tableMm * k}));
        slices.back().columnDirection = dvec3(0, std::cos(tilt), -std::sin(tilt));
    }
    return slices;
}

bool notes(const StackAnalysis& analysis, const std::string& code, const std::vector<std::string>& words) {
    return std::ranges::any_of(analysis.verdict.notes, [&](const Note& note) {
        return note.code == code && std::ranges::all_of(words, [&](const std::string& word) {
                   return note.text.find(word) != std::string::npos;
               });
    });
}

double distance(const dmat4& map, int column, dvec3 expected) {
    return glm::length(dvec3(map[column]) - expected);
}

}  // namespace

class StackGeometryTest : public QObject {
    Q_OBJECT

  private slots:
    void evenStackHasItsGridInThePatient() {
        const auto analysis = analyseStack(axial({10, 12.5, 15}));
        QCOMPARE(analysis.verdict.stack, Stack::even);
        QVERIFY(analysis.verdict.reason.empty());
        QVERIFY(analysis.geometry.size == ivec3(512, 512, 3));
        const dmat4& map = analysis.geometry.patientFromIndex;
        QVERIFY(distance(map, 0, {0.5, 0, 0}) < 1e-12);
        QVERIFY(distance(map, 1, {0, 0.7, 0}) < 1e-12);
        QVERIFY(distance(map, 2, {0, 0, 2.5}) < 1e-12);
        QVERIFY(distance(map, 3, {-100, -120, 10}) < 1e-12);
    }

    void orderIsByPositionNotAsGiven() {
        const auto analysis = analyseStack(axial({15, 10, 12.5}));
        QVERIFY((analysis.order == std::vector<int>{1, 2, 0}));
        QVERIFY(distance(analysis.geometry.patientFromIndex, 3, {-100, -120, 10}) < 1e-12);
    }

    void rowsThatRunToTheLeftTurnTheNormal() {
        auto slices = axial({10, 12, 14});
        for (SlicePlane& slice : slices)
            slice.columnDirection = dvec3(0, -1, 0);
        const auto analysis = analyseStack(slices);
        QVERIFY((analysis.order == std::vector<int>{2, 1, 0}));
        QVERIFY(distance(analysis.geometry.patientFromIndex, 2, {0, 0, -2}) < 1e-12);
        QVERIFY(distance(analysis.geometry.patientFromIndex, 3, {-100, -120, 14}) < 1e-12);
    }

    void obliqueStackKeepsItsDirections() {
        const dvec3 row = glm::normalize(dvec3(0.8, 0.5, -0.1));
        const dvec3 normal = glm::normalize(glm::cross(row, dvec3(0.1, 1, 0.4)));
        const dvec3 column = glm::cross(normal, row);
        std::vector<SlicePlane> slices;
        for (int k = 0; k < 5; ++k)
            slices.push_back(
                {letter(k), {64, 32}, dvec3(3, 4, 5) + normal * (1.25 * (4 - k)), row, column, dvec2(0.5, 0.5)});
        const auto analysis = analyseStack(slices);
        QCOMPARE(analysis.verdict.stack, Stack::even);
        QVERIFY(distance(analysis.geometry.patientFromIndex, 2, normal * 1.25) < 1e-9);
        QCOMPARE(analysis.order.front(), 4);
    }

    void roundedPositionsAreEven_data() {
        QTest::addColumn<QVector<double>>("heights");
        QTest::addColumn<QString>("noted");
        QTest::newRow("third decimal") << QVector<double>{-1691.5, -1691.1001, -1690.7, -1690.3, -1689.9} << "";
        QTest::newRow("two decimals of 0.625") << QVector<double>{0, 0.63, 1.25, 1.88, 2.5, 3.13, 3.75} << "";
        QTest::newRow("28.107 for 28.1075") << QVector<double>{18.1075, 23.1075, 28.107, 33.1075} << "";
        QTest::newRow("one decimal of 0.625") << QVector<double>{0, 0.6, 1.3, 1.9, 2.5, 3.1, 3.8} << "0.043 mm";
        QTest::newRow("one slice off") << QVector<double>{0, 1, 2.05, 3, 4} << "0.04 mm";
        QTest::newRow("a table that creeps") << QVector<double>{0, 1, 2.01, 3.03, 4.06, 5.1} << "";
        QTest::newRow("thick slices, a table that trembles")
            << QVector<double>{0, 5.1, 9.9, 15, 20.14, 25} << "0.12 mm";
    }
    void roundedPositionsAreEven() {
        QFETCH(QVector<double>, heights);
        QFETCH(QString, noted);
        const auto analysis = analyseStack(axial({heights.begin(), heights.end()}));
        QCOMPARE(QString::fromStdString(analysis.verdict.reason), QString());
        double furthest = 0;  // what was rounded does not add up over the slices
        for (int k = 0; k < int(heights.size()); ++k)
            furthest =
                std::max(furthest, std::abs((analysis.geometry.patientFromIndex * dvec4(0, 0, k, 1)).z - heights[k]));
        QVERIFY(furthest <= (noted.isEmpty() ? 0.02 : 0.15));
        QCOMPARE(analysis.verdict.notes.empty(), noted.isEmpty());
        if (!noted.isEmpty())
            QVERIFY2(
                analysis.verdict.notes[0].text.find(noted.toStdString() + " from an even grid") != std::string::npos,
                analysis.verdict.notes[0].text.c_str());
    }

    void tremblingSidewaysIsEven() {
        auto slices = axial({0, 1, 2, 3});
        slices[2].position->x += 0.05;
        const auto analysis = analyseStack(slices);
        QCOMPARE(analysis.verdict.stack, Stack::even);
        QCOMPARE(analysis.verdict.notes.size(), std::size_t(1));
        slices[2].position->x += 0.2;
        QCOMPARE(analyseStack(slices).verdict.stack, Stack::tilted);
    }

    /// However many slices there are: those beside the hole lie half a gap from an even grid.
    void aMissingSliceIsNeverRounding() {
        for (const double gap : {0.3, 0.625, 1.0, 5.0})
            for (const int count : {4, 20, 700})
                for (const int hole : {1, count / 2, count - 2}) {
                    std::vector<double> heights;
                    for (int k = 0; k < count; ++k)
                        if (k != hole)
                            heights.push_back(gap * k);
                    QCOMPARE(analyseStack(axial(heights)).verdict.stack, Stack::gap);
                }
    }

    void gapIsNamedWithFilesAndMillimetres() {
        const auto analysis = analyseStack(axial({0, 5, 10, 20}));
        QCOMPARE(analysis.verdict.stack, Stack::gap);
        QVERIFY(says(analysis, {"c and d", "10 mm apart", "5 mm"}));
    }

    void uneven_data() {
        QTest::addColumn<QVector<double>>("heights");
        QTest::newRow("one slice a seventh off") << QVector<double>{0, 1, 2.14, 3, 4};
        QTest::newRow("closer, then wider") << QVector<double>{0, 1, 2, 3.5, 5};
        QTest::newRow("creeping") << QVector<double>{0, 1, 2.1, 3.3, 4.6, 6};
        QTest::newRow("huge hole") << QVector<double>{-99.5, 103, 104.25, 105.5};
    }
    void uneven() {
        QFETCH(QVector<double>, heights);
        const auto analysis = analyseStack(axial({heights.begin(), heights.end()}));
        QCOMPARE(analysis.verdict.stack, Stack::gap);
        QVERIFY(says(analysis, {" mm"}));
    }

    void samePositionTwiceIsReported() {
        const auto analysis = analyseStack(axial({0, 1, 1, 2}));
        QCOMPARE(analysis.verdict.stack, Stack::doubled);
        QVERIFY((analysis.samePlace == std::vector<std::pair<int, int>>{{1, 2}}));
        QVERIFY(says(analysis, {"b and c", "1 mm"}));
    }

    void sameHeightElsewhereIsNoCopy() {
        auto slices = axial({0, 1, 2});
        slices.push_back(planeAt("d", {50, -120, 1}));
        const auto analysis = analyseStack(slices);
        QCOMPARE(analysis.verdict.stack, Stack::doubled);
        QVERIFY(analysis.samePlace.empty());
    }

    /// Each voxel lies where its slice lies, whichever way the gantry was tilted and the files are sorted.
    void aTiltedGantryShearsTheGrid() {
        for (const double degrees : {18.5, -18.5, 30.0, 2.0}) {
            std::vector<SlicePlane> slices = tilted(degrees, 8, 2.5);
            std::swap(slices[1], slices[6]);
            const auto analysis = analyseStack(slices);
            QCOMPARE(QString::fromStdString(analysis.verdict.reason), QString());
            QVERIFY(analysis.verdict.loadable());
            QVERIFY(analysis.geometry.size == ivec3(512, 512, 8));
            const dmat4& map = analysis.geometry.patientFromIndex;
            QVERIFY(distance(map, 0, {0.5, 0, 0}) < 1e-12);
            QVERIFY(distance(map, 1, 0.7 * *slices[0].columnDirection) < 1e-12);
            QVERIFY(distance(map, 2, {0, 0, 2.5}) < 1e-12);
            for (int k = 0; k < 8; ++k) {
                const SlicePlane& slice = slices[std::size_t(analysis.order[std::size_t(k)])];
                const dvec3 corner =
                    *slice.position + 511 * 0.5 * *slice.rowDirection + 300 * 0.7 * *slice.columnDirection;
                QVERIFY(glm::distance(dvec3(map * dvec4(511, 300, k, 1)), corner) < 1e-9);
            }
        }
    }

    void aTiltIsNotedWithItsAngle() {
        const auto analysis = analyseStack(tilted(18.5, 8, 2.5));
        QVERIFY(notes(analysis, "tilt", {"18.5 degrees", "0.793 mm a slice"}));
        QCOMPARE(analysis.verdict.notes.size(), std::size_t(1));
        QVERIFY(!notes(analyseStack(axial({0, 1, 2})), "tilt", {}));
    }

    void positionsOfATiltedGantryMayTremble() {
        std::vector<SlicePlane> slices = tilted(15, 40, 3);
        for (std::size_t k = 0; k < slices.size(); ++k)
            *slices[k].position += dvec3(0.04, -0.05, 0.03) * std::sin(2.3 * double(k));
        const auto analysis = analyseStack(slices);
        QCOMPARE(QString::fromStdString(analysis.verdict.reason), QString());
        QVERIFY(notes(analysis, "uneven", {}));
        for (std::size_t k = 0; k < slices.size(); ++k) {
            const dvec3 put(analysis.geometry.patientFromIndex * dvec4(0, 0, double(k), 1));
            QVERIFY(glm::distance(put, *slices[k].position) < 0.12);
        }
        slices[20].position->y += 0.5;
        const auto crooked = analyseStack(slices);
        QCOMPARE(crooked.verdict.stack, Stack::tilted);
        QVERIFY2(says(crooked, {"mm sideways of the straight line"}), crooked.verdict.reason.c_str());
    }

    void noGantryTiltsByMoreThan40Degrees() {
        QVERIFY(analyseStack(tilted(39.5, 8, 2.5)).verdict.loadable());
        const auto analysis = analyseStack(tilted(-40.5, 8, 2.5));
        QCOMPARE(analysis.verdict.stack, Stack::tilted);
        QVERIFY2(says(analysis, {"40.5 degrees", "1.624 mm", "1.901 mm", "40 degrees"}),
                 analysis.verdict.reason.c_str());
    }

    /// Two halves of a tilted stack on grids of their own, and two stacks on parallel tables whose slices are not.
    void piecesOfATiltedStackAreOne() {
        const VolumeGeometry whole = analyseStack(tilted(20, 20, 2.5)).geometry;
        const VolumeGeometry below = whole.part(ivec3(0), {512, 512, 10}),
                             above = whole.part({0, 0, 10}, {256, 512, 10});
        QVERIFY(continues(below, above) && continues(above, below));
        QVERIFY(!continues(below, whole.part({0, 0, 16}, {256, 512, 4})));
        const VolumeGeometry upright = analyseStack(axial({817.3, 819.8, 822.3})).geometry;
        QVERIFY(!continues(below, upright));
    }

    void unevenGapsOfATiltedGantryAreNamed() {
        std::vector<SlicePlane> slices;
        const double tilt = 15.5 * 3.14159265358979 / 180;
        for (const double z : {0.0, 4.0, 5.08, 12.08, 16.08, 20.08, 24.08}) {
            slices.push_back(planeAt(letter(int(slices.size())), {0, 0, z}));
            slices.back().columnDirection = dvec3(0, std::cos(tilt), -std::sin(tilt));
        }
        const auto analysis = analyseStack(slices);
        QCOMPARE(analysis.verdict.stack, Stack::gap);
        QVERIFY2(says(analysis, {"apart", "c and d", "6.745 mm", "3.855 mm"}), analysis.verdict.reason.c_str());
    }

    void doubledSliceDoesNotHideAHole() {
        const auto analysis = analyseStack(axial({0, 1, 1, 2, 5, 6, 7}));
        QCOMPARE(analysis.verdict.stack, Stack::doubled);
        QVERIFY2(says(analysis, {"b and c", "d and e", "3 mm apart"}), analysis.verdict.reason.c_str());
    }

    void worstPlaceIsNamedNotTheFirst() {
        std::vector<double> heights{0};
        for (int k = 1; k <= 16; ++k)
            heights.push_back(heights.back() + (k <= 8 ? 1.04 : 0.96));
        const auto analysis = analyseStack(axial(heights));
        QCOMPARE(analysis.verdict.stack, Stack::gap);
        QVERIFY2(says(analysis, {"i lies 0.169 mm"}), analysis.verdict.reason.c_str());
    }

    void spacingTooSmallToBeTrueIsNoGeometry() {
        auto slices = axial({0, 1});
        slices[0].spacingMm = slices[1].spacingMm = dvec2(1e-300, 1);
        const auto analysis = analyseStack(slices);
        QCOMPARE(analysis.verdict.stack, Stack::noGeometry);
        QVERIFY2(says(analysis, {"a", "1e-300 mm"}), analysis.verdict.reason.c_str());
    }

    void oneSliceShiftedSidewaysIsRefused() {
        auto slices = axial({0, 1, 2, 3});
        slices[2].position->x += 3;
        const auto analysis = analyseStack(slices);
        QCOMPARE(analysis.verdict.stack, Stack::tilted);
        QVERIFY(says(analysis, {"c", "3 mm sideways"}));
    }

    void roundedDirectionCosinesAreNoTilt() {
        std::vector<SlicePlane> slices;
        const double angle = 0.3;
        for (int k = 0; k < 200; ++k) {
            slices.push_back(planeAt(std::to_string(k), dvec3(0, std::sin(angle), std::cos(angle)) * (1.5 * k)));
            slices.back().columnDirection =
                dvec3(0, std::round(std::cos(angle) * 1e4) / 1e4, -std::round(std::sin(angle) * 1e4) / 1e4);
        }
        QCOMPARE(QString::fromStdString(analyseStack(slices).verdict.reason), QString());
    }

    void missingGeometryIsNamed() {
        auto slices = axial({0, 1, 2});
        slices[1].position.reset();
        slices[1].spacingMm.reset();
        const auto analysis = analyseStack(slices);
        QCOMPARE(analysis.verdict.stack, Stack::noGeometry);
        QVERIFY(says(analysis, {"b", "position", "pixel spacing"}));
        QVERIFY((analysis.order == std::vector<int>{0, 1, 2}));
    }

    void impossibleNumbersAreNoGeometry() {
        auto slices = axial({0, 1});
        slices[0].spacingMm = dvec2(0, 1);
        QCOMPARE(analyseStack(slices).verdict.stack, Stack::noGeometry);
        slices = axial({0, 1});
        slices[0].rowDirection = slices[1].rowDirection = dvec3(0, 0, 0);
        QCOMPARE(analyseStack(slices).verdict.stack, Stack::noGeometry);
        slices[0].rowDirection = slices[1].rowDirection = dvec3(0, 1, 0);
        QCOMPARE(analyseStack(slices).verdict.stack, Stack::noGeometry);
    }

    void singleSliceIsNoVolume() { QCOMPARE(analyseStack(axial({3})).verdict.stack, Stack::singleSlice); }

    void mixedSlicesAreRefused() {
        auto slices = axial({0, 1, 2});
        slices[1].size = {512, 256};
        auto analysis = analyseStack(slices);
        QCOMPARE(analysis.verdict.stack, Stack::mixedSize);
        QVERIFY(says(analysis, {"512 x 256", "a", "b"}));
        QCOMPARE(analysis.geometry.size.x, 0);

        slices = axial({0, 1, 2});
        slices[2].spacingMm = dvec2(0.6, 0.7);
        QCOMPARE(analyseStack(slices).verdict.stack, Stack::mixedSize);

        slices = axial({0, 1, 2});
        slices[2].columnDirection = dvec3(0, 0, 1);
        analysis = analyseStack(slices);
        QCOMPARE(analysis.verdict.stack, Stack::mixedOrientation);
        QVERIFY(says(analysis, {"a and c"}));
    }

    void oddOnesOutAreParted() {
        auto slices = axial({0, 1, 2, 3, 4, 5});
        slices[0].columnDirection = dvec3(0, 0, 1);
        slices[3].size = {64, 64};
        const auto parts = splitByGrid(slices);
        QVERIFY((parts == std::vector<std::vector<int>>{{1, 2, 4, 5}, {0, 3}}));
    }

    void twoStacksInOneSeriesAreBothKept() {
        auto slices = axial({0, 0, 1, 1, 2, 2});
        for (int i : {1, 3, 5})
            slices[i].rowDirection = dvec3(0, 0, 1);
        QVERIFY((splitByGrid(slices) == std::vector<std::vector<int>>{{0, 2, 4}, {1, 3, 5}}));
    }
};

QTEST_APPLESS_MAIN(StackGeometryTest)
#include "stack_geometry_test.moc"
