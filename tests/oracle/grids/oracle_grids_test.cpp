/// Volume files that SimpleITK, nibabel and pynrrd wrote, compared with what they read in them
/// (tests/oracle/grids/make_grids.py).

#include <QTest>

#include <fstream>
#include <nlohmann/json.hpp>

#include "render/volume/file/grid_file.h"
#include "tests/support/places.h"

using namespace pdr;

namespace fs = std::filesystem;

class OracleGridsTest : public QObject {
    Q_OBJECT

    static void compare(const fs::path& path, const nlohmann::json& expected) {
        const auto grid = readGridFile(path);
        QVERIFY2(bool(grid), grid ? "" : grid.error().text().c_str());
        for (int axis = 0; axis < 3; ++axis)
            QCOMPARE(grid->geometry.size[axis], expected["size"][std::size_t(axis)].get<int>());
        // Places to a millionth of a millimetre: NIfTI-1 rounds to float
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column) {
                const double there = expected["patientFromIndex"][std::size_t(row)][std::size_t(column)];
                const double off = grid->geometry.patientFromIndex[column][row] - there;
                QVERIFY2(std::abs(off) < 1e-5, (path.string() + ": " + std::to_string(off)).c_str());
            }
        std::vector<double> values(grid->geometry.voxelCount());
        QVERIFY(bool(GridSamples(*grid).read(values)));
        for (std::size_t i = 0; i < values.size(); ++i)
            QCOMPARE(values[i] * grid->slope + grid->intercept, expected["values"][i].get<double>());
    }

  private slots:
    void everyFileIsReadAsItsWriterReadsIt() {
        const fs::path folder(PDR_SOURCE_DIR "/tests/oracle/grids");
        std::ifstream file(folder / "grids.json");
        const nlohmann::json all = nlohmann::json::parse(file);
        QCOMPARE(all.size(), std::size_t(18));
        for (const auto& [name, expected] : all.items())
            compare(folder / "files" / name, expected);
    }
};

QTEST_APPLESS_MAIN(OracleGridsTest)
#include "oracle_grids_test.moc"
