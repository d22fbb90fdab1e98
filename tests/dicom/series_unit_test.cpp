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

using Change = std::function<void(DcmDataset&)>;

/// Returns a change to another modality with a rescale.
Change modality(const char* name, const std::string& slope = "1", const std::string& intercept = "0") {
    return [=](DcmDataset& data) {
        data.putAndInsertString(DCM_Modality, name);
        data.putAndInsertString(DCM_RescaleSlope, slope.c_str());
        data.putAndInsertString(DCM_RescaleIntercept, intercept.c_str());
    };
}

/// Returns the only series of a folder with three such slices.
Series scanned(const test::SliceFolder& folder, const SliceFile& slice) {
    folder.addStack(3, slice);
    const ScanResult scan = folder.scan();
    return scan.series.size() == 1 ? scan.series.front() : Series();
}

/// Returns the only series of a file of three frames of the numbers 0, 1, 2, ..., altered by `change`, and by
/// `changeOwn` in the groups of each frame.
Series mapped(const Change& change, const std::function<void(DcmItem&)>& changeOwn) {
    static test::SliceFolder folder;  // outlives the series
    test::EnhancedFile file{.size = {4, 3}, .change = change};
    for (int k = 0; k < 3; ++k) {
        test::EnhancedFrame frame{.position = {0, 0, 2.0 * k}, .intercept = -1000, .change = changeOwn};
        for (int i = 0; i < 12; ++i)
            frame.raw.push_back(std::uint16_t(i));
        file.frames.push_back(frame);
    }
    test::writeEnhancedFile(folder.path() / "frames", file);
    const ScanResult scan = folder.scan();
    return scan.series.size() == 1 ? scan.series.front() : Series();
}

}  // namespace

class SeriesUnitTest : public QObject {
    Q_OBJECT

  private slots:
    void inHuOnlyWhatSaysSo_data() {
        QTest::addColumn<QString>("modality");
        QTest::addColumn<QString>("type");
        QTest::addColumn<bool>("isHu");
        QTest::newRow("CT that says nothing") << "CT"
                                              << "" << true;
        QTest::newRow("CT in HU") << "CT"
                                  << "HU" << true;
        QTest::newRow("CT as some spell it") << "CT"
                                             << "Houndsfield Unit" << true;
        QTest::newRow("CT, unspecified") << "CT"
                                         << "US" << false;
        QTest::newRow("effective atomic number") << "CT"
                                                 << "Z_EFF" << false;
        QTest::newRow("cone beam in HU") << "OT"
                                         << "HU" << true;
        QTest::newRow("cone beam") << "OT"
                                   << "" << false;
        QTest::newRow("angiography in HU") << "XA"
                                           << "HU" << true;
        QTest::newRow("angiography") << "XA"
                                     << "US" << false;
        QTest::newRow("no modality, in HU") << ""
                                            << "HU" << true;
        QTest::newRow("no modality") << ""
                                     << "" << false;
        QTest::newRow("MR that calls itself HU") << "MR"
                                                 << "HU" << false;
        QTest::newRow("PET that calls itself HU") << "PT"
                                                  << "HU" << false;
    }
    void inHuOnlyWhatSaysSo() {
        QFETCH(QString, modality);
        QFETCH(QString, type);
        QFETCH(bool, isHu);
        const test::SliceFolder folder;
        const Series series = scanned(folder, {.change = [&](DcmDataset& data) {
                                          data.putAndInsertString(DCM_Modality, modality.toLatin1());
                                          data.putAndInsertString(DCM_RescaleType, type.toLatin1());
                                      }});
        QVERIFY(series.verdict.loadable());
        QCOMPARE(series.unit.isHu, isHu);
        QCOMPARE(hasNote(series, "no-hu"), !isHu);
        QCOMPARE(unitOf(loaded(series)), series.unit);
    }

    /// Without a sign and an intercept, there is no number for air.
    void ctWithoutRescaleMayBeHuOnlyWithASign() {
        for (const bool isSigned : {true, false}) {
            const test::SliceFolder folder;
            const Series series = scanned(folder, {.isSigned = isSigned, .change = [](DcmDataset& data) {
                                                       delete data.remove(DCM_RescaleSlope);
                                                       delete data.remove(DCM_RescaleIntercept);
                                                   }});
            QCOMPARE(series.unit.isHu, isSigned);
            QCOMPARE(hasNote(series, "rescale"), isSigned);
        }
    }

    /// Labels, doses and images without a place are no volumes of values.
    void othersAreRefusedAsBefore() {
        for (const char* name : {"SEG", "RTDOSE", "US", "CR"}) {
            const test::SliceFolder folder;
            QCOMPARE(scanned(folder, {.change = modality(name)}).verdict.stack, Stack::notCt);
        }
        const test::SliceFolder folder;
        const Series series = scanned(folder, {.change = [](DcmDataset& data) {
                                          modality("MR")(data);
                                          delete data.remove(DCM_ImagePositionPatient);
                                      }});
        QVERIFY(series.verdict.reason.ends_with("MR, not CT"));
    }

    /// Nothing is noted on a series that is refused; its values are no HU all the same.
    void whatIsRefusedIsNoHuEither() {
        const test::SliceFolder folder;
        folder.addStack(1, {.change = modality("MR", "0.5")});
        const Series series = folder.scan().series.at(0);
        QVERIFY(!series.verdict.loadable());
        const auto volume = loadSeries(series, Padding::keep, noProgress);
        QVERIFY(volume);
        QCOMPARE(unitOf(*volume), ValueUnit::other("", 0.5));
    }

    /// A voxel and its unit give what slope and intercept give, to the last digit of double precision.
    void everyStoredNumberKeepsItsValue_data() {
        QTest::addColumn<bool>("isSigned");
        QTest::addColumn<int>("bits");
        QTest::addColumn<QString>("slope");
        QTest::addColumn<QString>("intercept");
        QTest::newRow("12 bits") << false << 12 << "1"
                                 << "0";
        QTest::newRow("16 bits without sign") << false << 16 << "1"
                                              << "0";
        QTest::newRow("16 bits with sign") << true << 16 << "1"
                                           << "0";
        QTest::newRow("PET") << true << 16 << "0.37192"
                             << "0";
        QTest::newRow("with intercept") << false << 16 << "2.5"
                                        << "-17.3";
        QTest::newRow("negative") << false << 16 << "-0.1"
                                  << "3";
        QTest::newRow("negative with sign") << true << 16 << "-3"
                                            << "7";
    }
    void everyStoredNumberKeepsItsValue() {
        QFETCH(bool, isSigned);
        QFETCH(int, bits);
        QFETCH(QString, slope);
        QFETCH(QString, intercept);
        std::vector<std::uint16_t> raw;
        for (int i = 0; i < 256 * 256; ++i)
            raw.push_back(std::uint16_t(i % (1 << bits)));
        const test::SliceFolder folder;
        const Series series = scanned(folder, {.size = {256, 256},
                                               .raw = raw,
                                               .isSigned = isSigned,
                                               .bitsStored = bits,
                                               .change = modality("MR", slope.toStdString(), intercept.toStdString())});
        const Volume volume = loaded(series);
        QVERIFY(!hasNote(series, "rounded"));
        QVERIFY(volume.remarks().find("clipped") == std::string::npos);
        for (std::size_t i = 0; i < raw.size(); ++i) {
            const double stored = isSigned ? double(std::int16_t(raw[i])) : double(raw[i]);
            const double value = stored * slope.toDouble() + intercept.toDouble();
            const double error = std::abs(unitOf(volume).valueOf(volume.voxels()[i]) - value);
            QVERIFY2(error <= 1e-10 * 65536, qPrintable(QString("%1 of %2").arg(error).arg(value)));
        }
    }

    /// A table may give the values; numbers beyond its ends have those there.
    void valuesOfATable() {
        const std::vector<std::uint16_t> values{7, 40000, 300};
        for (const char* type : {"OD", "HU"}) {
            const test::SliceFolder folder;
            const Series series = scanned(folder, {.change = [&](DcmDataset& data) {
                                              delete data.remove(DCM_RescaleSlope);
                                              delete data.remove(DCM_RescaleIntercept);
                                              DcmItem& table = test::itemIn(data, DCM_ModalityLUTSequence);
                                              auto* descriptor =
                                                  new DcmUnsignedShort(DcmTag(DCM_LUTDescriptor, EVR_US));
                                              const Uint16 numbers[]{3, 2, 16};
                                              descriptor->putUint16Array(numbers, 3);
                                              table.insert(descriptor, true);
                                              table.putAndInsertString(DCM_ModalityLUTType, type);
                                              auto* data16 = new DcmOtherByteOtherWord(DcmTag(DCM_LUTData, EVR_OW));
                                              data16->putUint16Array(values.data(), 3);
                                              table.insert(data16, true);
                                          }});
            QVERIFY2(series.verdict.loadable(), series.verdict.reason.c_str());
            QVERIFY(!hasNote(series, "rounded") && !hasNote(series, "rescale"));
            const Volume volume = loaded(series);
            const ValueUnit unit = unitOf(volume);
            QCOMPARE(unit.isHu, type == std::string("HU"));
            if (!unit.isHu)
                QCOMPARE(unit.name, std::string("OD"));
            for (int i = 0; i < 12; ++i) {
                const double value = values[std::size_t(std::clamp(i - 2, 0, 2))];
                QCOMPARE(unit.valueOf(volume.voxels()[std::size_t(i)]), unit.isHu ? std::min(value, 32767.) : value);
            }
        }
    }

    /// PET scales each slice for itself. Then all share one step, half of which no value is off.
    void slicesOfDifferentScalesAreRoundedToOneStep() {
        const test::SliceFolder folder;
        const double slopes[] = {0.5, 2, 1.25};
        folder.addStack(3, {}, "s", [&](int k, SliceFile& slice) {
            slice.raw = {0, 100, 32767, 12345};
            slice.change = modality("PT", std::to_string(slopes[k]).c_str());
        });
        const Series series = folder.scan().series.at(0);
        QVERIFY(hasNote(series, "rounded"));
        const Volume volume = loaded(series);
        const ValueUnit unit = unitOf(volume);
        QCOMPARE(unit, series.unit);
        for (std::size_t k = 0; k < 3; ++k)
            for (const auto& [i, stored] : {std::pair(0, 0), {1, 100}, {2, 32767}, {3, 12345}}) {
                const double value = unit.valueOf(volume.voxels()[k * 12 + std::size_t(i)]);
                QVERIFY(std::abs(value - stored * slopes[k]) <= unit.step / 2 * 1.001);
            }
    }

    void theUnitIsThatOfTheFiles() {
        const auto nameIn = [](const Change& change) {
            const test::SliceFolder folder;
            return scanned(folder, {.change = change}).unit.name;
        };
        QCOMPARE(nameIn([](DcmDataset& data) {
                     modality("PT", "0.5")(data);
                     data.putAndInsertString(DCM_Units, "BQML");
                 }),
                 std::string("Bq/ml"));
        QCOMPARE(nameIn(modality("MR")), std::string());
        const auto mapped = [](double slope) {
            return [slope](DcmDataset& data) {
                modality("MR", "0.5")(data);
                DcmItem *map = nullptr, *code = nullptr;
                data.findOrCreateSequenceItem(DCM_RealWorldValueMappingSequence, map);
                map->putAndInsertFloat64(DCM_RealWorldValueSlope, slope);
                map->putAndInsertFloat64(DCM_RealWorldValueIntercept, 0);
                map->findOrCreateSequenceItem(DCM_MeasurementUnitsCodeSequence, code);
                code->putAndInsertString(DCM_CodeValue, "ms");
            };
        };
        QCOMPARE(nameIn(mapped(0.5)), std::string("ms"));
        QCOMPARE(nameIn(mapped(0.25)), std::string());  // the values of the rescale are others
    }

    /// Nothing was measured there, and air has no value that is known.
    void paddingGetsTheLowestValue() {
        const test::SliceFolder folder;
        const Series series = scanned(folder, {.raw = {500, 7, 9}, .change = [](DcmDataset& data) {
                                                   modality("MR")(data);
                                                   data.putAndInsertSint16(DCM_PixelPaddingValue, 500);
                                               }});
        const Volume volume = loaded(series);
        QVERIFY(volume.isPadding(0));
        QCOMPARE(volume.voxels()[0], volume.lowestHu());
        QCOMPARE(volume.lowestHu(), std::int16_t(3));
    }

    /// A 3D angiography whose groups call its values HU is one in HU; one that does not is a volume of other values.
    void framesOfAnotherModalityMayStateHu() {
        for (const char* type : {"HU", "US"}) {
            const Series series = mapped(
                [=](DcmDataset& data) { data.putAndInsertString(DCM_Modality, "XA"); },
                [=](DcmItem& own) {
                    test::itemIn(own, DCM_PixelValueTransformationSequence).putAndInsertString(DCM_RescaleType, type);
                });
            QVERIFY(series.verdict.loadable());
            QCOMPARE(series.unit.isHu, type == std::string("HU"));
            if (series.unit.isHu)
                QVERIFY(series.verdict.notes.at(0).text.find("XA, not CT") != std::string::npos);
        }
    }

    /// Enhanced MR is a volume of other values, whatever its groups call them.
    void enhancedMrIsNoHu() {
        const Series series = mapped([](DcmDataset& data) { data.putAndInsertString(DCM_Modality, "MR"); },
                                     [](DcmItem& own) {
                                         DcmItem& rescale = test::itemIn(own, DCM_PixelValueTransformationSequence);
                                         rescale.putAndInsertString(DCM_RescaleSlope, "0.5");
                                         rescale.putAndInsertString(DCM_RescaleIntercept, "3");
                                     });
        QVERIFY(series.verdict.loadable());
        QCOMPARE(series.unit, ValueUnit::other("", 0.5, 3));
        const Volume volume = loaded(series);
        for (std::size_t i = 0; i < 12; ++i)
            QCOMPARE(unitOf(volume).valueOf(volume.voxels()[i]), double(i) * 0.5 + 3);
    }

    void anotherQuantityIsNoHu() {
        const Series series = mapped({}, [](DcmItem& own) {
            test::itemIn(own, DCM_CTImageFrameTypeSequence)
                .putAndInsertString(DCM_FrameType, "DERIVED\\PRIMARY\\PERFUSION\\RCBF");
            DcmItem& map = test::itemIn(own, DCM_RealWorldValueMappingSequence);
            test::itemIn(map, DCM_MeasurementUnitsCodeSequence).putAndInsertString(DCM_CodeValue, "ml/100ml/s");
        });
        QVERIFY(series.verdict.loadable());
        QCOMPARE(series.verdict.notes.size(), std::size_t(1));
        QCOMPARE(series.verdict.notes[0].code, std::string("no-hu"));
        QVERIFY(series.verdict.notes[0].text.find("RCBF, ml/100ml/s") != std::string::npos);
        QCOMPARE(series.unit, ValueUnit::other(""));  // the mapping states no slope, so the unit is not sure
    }

    /// What is in HU is what a planner wants, however many slices others have.
    void seriesInHuComeFirst() {
        const test::SliceFolder folder;
        folder.addStack(9, {.seriesUid = "1.2.3.7", .change = modality("MR")}, "mr");
        folder.addStack(3, {.seriesUid = "1.2.3.8"}, "ct");
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(2));
        QVERIFY(scan.series[0].unit.isHu && !scan.series[1].unit.isHu);
    }
};

QTEST_GUILESS_MAIN(SeriesUnitTest)
#include "series_unit_test.moc"
