#pragma once
/// Reads the numbers of tests/oracle/numbers, which an independent program made, and the volumes that they are of.

#include <QTest>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "dicom/import.h"
#include "tests/support/dicom/shared_data.h"
#include "tests/support/scenes/made_volume.h"

namespace pdr::test {

/// Largest difference of an interpolated value from the oracle's [HU]: our places are in single precision.
inline constexpr double kOracleHu = 0.05;

inline nlohmann::json oracleNumbers(const std::string& name) {
    std::ifstream file(PDR_SOURCE_DIR "/tests/oracle/numbers/" + name + ".json");
    return nlohmann::json::parse(file);
}

inline dvec3 vectorOf(const nlohmann::json& numbers) {
    return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

/// Returns the volume of that name, "made", "sheared" or "chest"; none if the shared data is missing or cannot be read.
inline std::optional<Volume> oracleVolume(const std::string& name) {
    if (name == "made")
        return madeVolume();
    if (name == "sheared")
        return shearedVolume();
    const auto scan = dicom::scanFolder(sharedCt() / "chest_contrast", noProgress);
    if (!scan || scan->series.empty())
        return std::nullopt;
    auto volume = dicom::loadSeries(scan->series.front(), dicom::Padding::maskAsAir, noProgress);
    return volume ? std::optional(*std::move(volume)) : std::nullopt;
}

/// Adds a row for each volume whose numbers are in the tree.
inline void addOracleRows() {
    QTest::addColumn<std::string>("name");
    QTest::newRow("made by a rule") << std::string("made");
    QTest::newRow("the same, with a tilted gantry") << std::string("sheared");
    QTest::newRow("chest with contrast") << std::string("chest");
}

}  // namespace pdr::test

/// Fetches the row of addOracleRows() as `numbers` and `volume`, or leaves the test function for want of data.
#define PDR_FETCH_ORACLE(numbers, volume)                               \
    QFETCH(std::string, name);                                          \
    if (name == "chest")                                                \
        PDR_NEEDS_SHARED_CT();                                          \
    const nlohmann::json numbers = pdr::test::oracleNumbers(name);      \
    const std::optional<Volume> volume = pdr::test::oracleVolume(name); \
    QVERIFY(volume.has_value())
