/// Values that are no HU, as floating-point numbers or of more than 16 bits: their range is known once they are read.

#include <QTest>

#include <algorithm>
#include <cmath>

#include "dicom/import.h"
#include "tests/support/dicom/enhanced_file.h"
#include "tests/support/dicom/loaded_series.h"
#include "tests/support/dicom/slice_folder.h"

using namespace pdr;
using namespace pdr::dicom;
using test::hasNote;
using test::loaded;
using test::SliceFile;

namespace {

/// How pixels are stored that are wider than 16 bits.
enum class Stored { whole, single, twice };

/// Puts such pixels in the place of those of `data`.
void putWide(DcmDataset& data, Stored stored, const std::vector<double>& pixels) {
    const auto count = static_cast<unsigned long>(pixels.size());
    const Uint16 bits = stored == Stored::twice ? 64 : 32;
    delete data.remove(DCM_PixelData);
    data.putAndInsertUint16(DCM_BitsAllocated, bits);
    data.putAndInsertUint16(DCM_BitsStored, bits);
    data.putAndInsertUint16(DCM_HighBit, bits - 1);
    if (stored == Stored::whole) {
        const std::vector<Sint32> numbers(pixels.begin(), pixels.end());
        data.putAndInsertUint16Array(DCM_PixelData, reinterpret_cast<const Uint16*>(numbers.data()), 2 * count);
    } else if (stored == Stored::single) {
        const std::vector<Float32> numbers(pixels.begin(), pixels.end());
        auto* element = new DcmFloatingPointSingle(DCM_FloatPixelData);
        element->putFloat32Array(numbers.data(), count);
        data.insert(element);
    } else {
        auto* element = new DcmFloatingPointDouble(DCM_DoubleFloatPixelData);
        element->putFloat64Array(pixels.data(), count);
        data.insert(element);
    }
}

}  // namespace

class WideValuesTest : public QObject {
    Q_OBJECT

  private slots:
    /// Values of 32 bits, and floating-point values, have no range until they are read: then a voxel is the value where
    /// all are whole numbers within 16 bits, a stored number where those lie within 16 bits, or else one of 65,536
    /// steps.
    void wideValuesAreExactOrRoundedToOneStep_data() {
        QTest::addColumn<Stored>("stored");
        QTest::addColumn<QList<double>>("numbers");
        QTest::addColumn<QString>("slope");
        QTest::addColumn<bool>("isExact");
        QTest::newRow("few of 32 bits") << Stored::whole << QList<double>{0, 5, 20} << "1" << true;
        QTest::newRow("far from 0") << Stored::whole << QList<double>{-200000, -190000, -140000} << "1" << true;
        QTest::newRow("of a slope") << Stored::whole << QList<double>{70000, 80000, 135535} << "0.25" << true;
        QTest::newRow("all of 32 bits") << Stored::whole << QList<double>{-2147483648., 0, 2147483647.} << "1" << false;
        QTest::newRow("whole floats") << Stored::single << QList<double>{-7, 0, 30000} << "1" << true;
        QTest::newRow("fractions") << Stored::single << QList<double>{0, 0.125, 19.5} << "1" << false;
        QTest::newRow("large floats") << Stored::single << QList<double>{0, 100, 1e9} << "1" << false;
        QTest::newRow("one float") << Stored::single << QList<double>{0.25, 0.25, 0.25} << "1" << true;
        QTest::newRow("doubles") << Stored::twice << QList<double>{-1e-5, 0, 1e-5} << "1" << false;
        QTest::newRow("doubles with a slope") << Stored::twice << QList<double>{0, 0.5, 1} << "-3" << false;
    }
    void wideValuesAreExactOrRoundedToOneStep() {
        QFETCH(Stored, stored);
        QFETCH(QList<double>, numbers);
        QFETCH(QString, slope);
        QFETCH(bool, isExact);
        const test::SliceFolder folder;
        folder.addStack(3, {}, "s", [&](int k, SliceFile& slice) {
            slice.change = [&, k](DcmDataset& data) {
                data.putAndInsertString(DCM_Modality, "MR");
                data.putAndInsertString(DCM_RescaleSlope, slope.toLatin1());
                data.putAndInsertString(DCM_RescaleIntercept, "2");
                putWide(data, stored, std::vector<double>(12, numbers[k]));  // no slice alone tells the range
            };
        });
        const Series series = folder.scan().series.at(0);
        QVERIFY2(series.verdict.loadable(), series.verdict.reason.c_str());
        QVERIFY(!series.unit.isHu);
        QCOMPARE(hasNote(series, "rounded"), !isExact);
        const Volume volume = loaded(series);
        QVERIFY(volume.remarks().find("clipped") == std::string::npos);
        for (int i = 0; i < 3; ++i) {
            const double value = numbers[i] * slope.toDouble() + 2;
            const double error = std::abs(unitOf(volume).valueOf(volume.voxels()[12 * std::size_t(i)]) - value);
            QVERIFY2(error <= (isExact ? 0 : series.unit.step / 2 * 1.000001),
                     qPrintable(QString("%1 of %2").arg(error).arg(value)));
        }
    }

    /// What is no number was not measured, and must not widen the steps.
    void whatIsNoNumberHasNoPartInTheRange() {
        constexpr double kPadding = -1e30;
        for (const double none : {double(NAN), double(INFINITY), kPadding}) {
            const test::SliceFolder folder;
            folder.addStack(3, {.change = [&](DcmDataset& data) {
                                data.putAndInsertString(DCM_Modality, "MR");
                                std::vector<double> pixels(12, 3);
                                pixels[0] = none;
                                putWide(data, Stored::twice, pixels);
                                data.putAndInsertFloat64(DCM_DoubleFloatPixelPaddingValue, kPadding);
                            }});
            const Series series = folder.scan().series.at(0);
            QCOMPARE(series.unit, ValueUnit::other(""));
            const Volume volume = loaded(series);
            QVERIFY(volume.isPadding(0) && !volume.isPadding(1));
            QCOMPARE(int(volume.voxels()[0]), 3);
            QCOMPARE(int(volume.voxels()[1]), 3);
        }
    }

    /// Parametric maps are the multi-frame images that hold floating-point numbers.
    void mapsOfFloatingPointFramesLoad() {
        for (const E_TransferSyntax coding : {EXS_LittleEndianExplicit, EXS_BigEndianExplicit}) {
            test::EnhancedFile file{.size = {4, 3}};
            for (int k = 0; k < 3; ++k)
                file.frames.push_back({.position = {0, 0, 2.0 * k}, .change = [](DcmItem& own) {
                                           own.findAndDeleteElement(DCM_PixelValueTransformationSequence);
                                       }});
            file.change = [&](DcmDataset& data) {
                data.putAndInsertString(DCM_SOPClassUID, UID_ParametricMapStorage);
                data.putAndInsertString(DCM_Modality, "MR");
                std::vector<double> pixels(36);
                for (std::size_t i = 0; i < pixels.size(); ++i)
                    pixels[i] = double(i) - 5;
                putWide(data, Stored::single, pixels);
                DcmItem& shared = test::itemIn(data, DCM_SharedFunctionalGroupsSequence);
                DcmItem& map = test::itemIn(shared, DCM_RealWorldValueMappingSequence);
                map.putAndInsertFloat64(DCM_RealWorldValueSlope, 1);
                map.putAndInsertFloat64(DCM_RealWorldValueIntercept, 0);
                test::itemIn(map, DCM_MeasurementUnitsCodeSequence).putAndInsertString(DCM_CodeValue, "um2/s");
            };
            const test::SliceFolder folder;
            test::writeEnhancedFile(folder.path() / "map", file, coding);
            const Series series = folder.scan().series.at(0);
            QVERIFY2(series.verdict.loadable(), series.verdict.reason.c_str());
            QCOMPARE(series.unit, ValueUnit::other("um2/s"));
            const Volume volume = loaded(series);
            for (int i = 0; i < 36; ++i)
                QCOMPARE(int(volume.voxels()[std::size_t(i)]), i - 5);
        }
    }
};

QTEST_GUILESS_MAIN(WideValuesTest)
#include "wide_values_test.moc"
