/// Windows: what the standard says of their ends, and the presets. tests/oracle compares every level.

#include <QTest>

#include <cmath>
#include <set>
#include <string>

#include "render/slice/window_presets.h"

using namespace pdr;

class GreyWindowTest : public QObject {
    Q_OBJECT

  private slots:
    /// C.11.2.1.2.1: a linear window of width w has w - 1 steps from black to white.
    void aLinearWindowIsBlackAndWhiteWhereTheStandardSaysSo() {
        const GreyWindow window{2048, 4096};
        QCOMPARE(greyLevel(window, 0), 0);
        QCOMPARE(greyLevel(window, 4095), 255);
        const GreyWindow narrow{2048, 2};  // its only step is from 2047 to 2048
        QCOMPARE(greyLevel(narrow, 2047), 0);
        QCOMPARE(greyLevel(narrow, 2048), 255);
        const GreyWindow one{0, 1};  // a threshold at -0.5
        QCOMPARE(greyLevel(one, -0.5f), 0);
        QCOMPARE(greyLevel(one, -0.25f), 255);
    }

    void anExactWindowIsAsWideAsItSays() {
        const GreyWindow window{100, 200, VoiFunction::linearExact};
        QCOMPARE(greyLevel(window, 0), 0);
        QCOMPARE(greyLevel(window, 0.5f), 1);  // 0.6375
        QCOMPARE(greyLevel(window, 200), 255);
        QCOMPARE(greyLevel(window, 100), 128);  // 127.5
    }

    void aSigmoidIsSymmetricAboutItsCentre() {
        const GreyWindow window{40, 80, VoiFunction::sigmoid};
        QCOMPARE(greyLevel(window, 40), 128);
        for (float away = 1; away < 200; away += 7)
            QVERIFY(std::abs(greyLevel(window, 40 - away) + greyLevel(window, 40 + away) - 255) <= 1);
        QCOMPARE(greyLevel(window, -1000), 0);
        QCOMPARE(greyLevel(window, 1000), 255);
    }

    void windowsThatTheStandardForbidsAreNotValid() {
        for (const VoiFunction function : {VoiFunction::linear, VoiFunction::linearExact, VoiFunction::sigmoid}) {
            QVERIFY((GreyWindow{0, 1, function}.valid()));
            QCOMPARE((GreyWindow{0, 0.5, function}.valid()), function != VoiFunction::linear);
            for (const double width : {0.0, -3.0, double(NAN), double(INFINITY)})
                QVERIFY((!GreyWindow{0, width, function}.valid()));
            QVERIFY((!GreyWindow{NAN, 10, function}.valid()));
        }
    }

    /// Nothing outside the volume passes for dark tissue.
    void whatHasNoHuHasTheColourOfTheGround() {
        const float hu[] = {NAN, -2000, 50, 2000};
        const std::vector<std::uint8_t> expected{10, 20, 30, 255, 0, 0, 0, 255, 128, 128, 128, 255, 255, 255, 255, 255};
        QVERIFY(greyPixels({50, 350}, hu, {10, 20, 30}) == expected);
    }

    void presetsHaveNamesOfTheirOwnAndStandInTheOrderOfTheirKeys() {
        std::set<std::string> names;
        char last = '1';
        for (const WindowPreset& preset : windowPresets()) {
            QVERIFY(preset.window.valid() && preset.key >= last && preset.key <= '8');
            names.insert(preset.name);
            last = preset.key;
        }
        QCOMPARE(last, '8');
        QCOMPARE(names.size(), windowPresets().size());
        QVERIFY(windowPresets().front().window == GreyWindow());
    }

    /// One voxel in 1000 is darker than black, and one brighter than white; padding does not count.
    void theWholeRangeLeavesOutAThousandthAtEitherEnd() {
        Voxels voxels;
        std::vector<bool> padding;
        for (int i = 0; i < 100 * 100; ++i) {
            voxels.push_back(std::int16_t(i < 5000 ? -1024 : (i - 5000) / 5));
            padding.push_back(i < 5000);
        }
        const Volume ramp(VolumeGeometry::aligned({100, 100, 1}, {1, 1, 1}, {0, 0, 0}), voxels, padding);
        const GreyWindow window = wholeRange(ramp);
        QCOMPARE(window.centre - window.width / 2, 0.5);
        QCOMPARE(window.centre + window.width / 2, 998.5);
        QCOMPARE(greyLevel(window, 0), 0);
        QCOMPARE(greyLevel(window, 999), 255);
        const Volume flat(VolumeGeometry::aligned({2, 2, 2}, {1, 1, 1}, {0, 0, 0}), Voxels(8, 7));
        QVERIFY(wholeRange(flat).valid());
    }
};

QTEST_APPLESS_MAIN(GreyWindowTest)
#include "grey_window_test.moc"
