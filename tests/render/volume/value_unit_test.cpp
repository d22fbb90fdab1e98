#include "render/volume/value_unit.h"

#include <QTest>

#include "render/slice/unit_window.h"
#include "render/volume/reconstruction.h"
#include "render/volume/volume.h"

using namespace pdr;

class ValueUnitTest : public QObject {
    Q_OBJECT

  private slots:
    void itsWordReadsBackAsTheSameUnit() {
        for (const ValueUnit& unit :
             {ValueUnit(), ValueUnit::other(""), ValueUnit::other("Bq/ml"), ValueUnit::other("10*3/ul"),
              ValueUnit::other("Bq/ml", 0.1, 0), ValueUnit::other("", 1, 32768), ValueUnit::other("ms", 1e-20, -1e20),
              ValueUnit::other("", 100000, 100000)}) {
            QCOMPARE(unitIn(unitWord(unit)), unit);
            QCOMPARE(unitIn("lossy " + unitWord(unit) + " clipped"), unit);
            QCOMPARE(unitIn("lossy " + unitWord(unit) + ", interpolated slices"), unit);
        }
    }

    /// What cannot be read must not pass for HU.
    void aDamagedWordIsNoHu() {
        for (const char* word : {"no-hu:", "no-hu:a=", "no-hu:a=1", "no-hu:a=x@0", "no-hu:a=0@0", "no-hu:a=-1@0",
                                 "no-hu:a=1@inf", "no-hu:=@"})
            QVERIFY2(!unitIn(word).isHu && unitIn(word).isPlain(), word);
        QVERIFY(unitIn("no-humour").isHu && unitIn("also-no-hu").isHu && unitIn("").isHu);
    }

    void aNameIsOneShortWord() {
        QCOMPARE(ValueUnit::other("a b,c=d\n\xc3\xa9").name, std::string("a_b_c_d___"));
        QCOMPARE(ValueUnit::other(std::string(100, 'x')).name.size(), ValueUnit::kLongestName);
    }

    /// A copy with other voxels that lost its unit would pass for HU.
    void copiesOfAVolumeKeepItsUnit() {
        const ValueUnit unit = ValueUnit::other("Bq/ml", 0.25, 3);
        const VolumeGeometry geometry = VolumeGeometry::aligned({2, 2, 2}, dvec3(1), dvec3(0));
        const Volume volume(geometry, Voxels(8, 5), {}, unitWord(unit));
        QCOMPARE(unitOf(volume), unit);
        QCOMPARE(unitOf(volume.withVoxels(Voxels(8, 1), "")), unit);
        QCOMPARE(unitOf(Volume(volume).clamped(0, 1)), unit);
        QCOMPARE(unitOf(reconstructed(volume, Reconstruction::cubic)), unit);
    }

    void decimalsTellNeighboursApart() {
        for (const auto& [step, decimals] : {std::pair(1.0, 0), {2.5, 0}, {0.5, 1}, {0.1, 1}, {0.09, 2}, {1e-30, 9}})
            QCOMPARE(ValueUnit::other("", step).decimals(), decimals);
    }

    /// Black and white lie at the same values, whatever the voxels are.
    void windowsOfValuesAndVoxelsAgree() {
        const ValueUnit unit = ValueUnit::other("", 0.25, 100);
        for (const VoiFunction function : {VoiFunction::linear, VoiFunction::linearExact, VoiFunction::sigmoid}) {
            const GreyWindow values{140, 31, function}, voxels = inVoxels(values, unit);
            for (double voxel = 0; voxel < 400; ++voxel)
                QCOMPARE(greyLevel(voxels, float(voxel)), greyLevel(values, float(unit.valueOf(voxel))));
        }
        const GreyWindow exact{140, 31, VoiFunction::linearExact};
        QCOMPARE(inValues(inVoxels(exact, unit), unit), exact);
        QCOMPARE(inVoxels({50, 350}, {}), (GreyWindow{50, 350}));
    }
};

QTEST_GUILESS_MAIN(ValueUnitTest)
#include "value_unit_test.moc"
