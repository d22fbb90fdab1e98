/// Grey levels of windows, compared with whole fractions and pydicom (tests/oracle/make_windows.py).

#include <QTest>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "render/slice/grey_window.h"
#include "tests/support/places.h"

using namespace pdr;

class OracleWindowsTest : public QObject {
    Q_OBJECT

  private slots:
    /// 10,000 values of each function, without a level of difference.
    void everyLevelIsTheStandards() {
        std::ifstream file(PDR_SOURCE_DIR "/tests/oracle/numbers/windows.json");
        const std::map<std::string, VoiFunction> functions{{"LINEAR", VoiFunction::linear},
                                                           {"LINEAR_EXACT", VoiFunction::linearExact},
                                                           {"SIGMOID", VoiFunction::sigmoid}};
        std::map<std::string, int> compared;
        for (const nlohmann::json& each : nlohmann::json::parse(file)) {
            const std::string function = each["function"], levels = each["levels"];
            const GreyWindow window{each["centre"], each["width"], functions.at(function)};
            QVERIFY(window.valid());
            std::vector<float> hu;
            for (std::size_t n = 0; n < levels.size() / 2; ++n)
                hu.push_back(float(each["first"].get<double>() + double(n) * each["step"].get<double>()));
            const std::vector<std::uint8_t> pixels = greyPixels(window, hu);
            for (std::size_t n = 0; n < hu.size(); ++n) {
                const int expected = std::stoi(levels.substr(2 * n, 2), nullptr, 16);
                QCOMPARE(int(greyLevel(window, hu[n])), expected);
                QCOMPARE(int(pixels[4 * n]), expected);
                ++compared[function];
            }
        }
        for (const auto& [name, function] : functions)
            QCOMPARE(compared[name], 10'000);
    }
};

QTEST_APPLESS_MAIN(OracleWindowsTest)
#include "oracle_windows_test.moc"
