/// Label maps that highdicom, nibabel and SimpleITK wrote, laid on their scan (tests/oracle/labels/make_labels.py).

#include <QTest>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/scan/scan_labels.h"
#include "app/scan/scan_place.h"
#include "tests/support/places.h"

using namespace pdr;

namespace fs = std::filesystem;

namespace {

const fs::path kFolder(PDR_SOURCE_DIR "/tests/oracle/labels");

std::string hexOf(const LabelColour& colour) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", unsigned(colour[0]), unsigned(colour[1]), unsigned(colour[2]));
    return text;
}

}  // namespace

class OracleLabelsTest : public QObject {
    Q_OBJECT

    static void compare(const dicom::Series& series, const std::string& name, const nlohmann::json& expected) {
        const auto map =
            app::readScanLabels(kFolder / "files" / name, series.geometry, &series, Resampling::refused, noProgress);
        QVERIFY2(bool(map), map ? "" : map.error().text().c_str());
        const auto labels = expected["labels"].get<std::vector<std::uint8_t>>();
        QCOMPARE(std::vector<std::uint8_t>(map->labels.begin(), map->labels.end()), labels);
        std::vector<std::string> names, colours;
        for (const MappedPart& part : map->parts) {
            names.push_back(part.name);
            colours.push_back(hexOf(part.colour));
        }
        QCOMPARE(names, expected["names"].get<std::vector<std::string>>());
        if (expected.contains("colours"))
            QCOMPARE(colours, expected["colours"].get<std::vector<std::string>>());
    }

  private slots:
    void everyMapLiesWhereItsWriterPutIt() {
        const auto scan = app::scanPlace(kFolder / "files" / "ct", noProgress);
        QVERIFY(bool(scan));
        std::ifstream file(kFolder / "labels.json");
        const nlohmann::json all = nlohmann::json::parse(file);
        QCOMPARE(all.size(), std::size_t(9));
        for (const auto& [name, expected] : all.items())
            compare(scan->series.front(), name, expected);
    }
};

QTEST_APPLESS_MAIN(OracleLabelsTest)
#include "oracle_labels_test.moc"
