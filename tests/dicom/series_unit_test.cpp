#include <QTest>

#include <algorithm>
#include <cmath>

#include "dicom/import.h"
#include "tests/support/dicom/slice_folder.h"

using namespace pdr;
using namespace pdr::dicom;
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

bool hasNote(const Series& series, const std::string& code) {
    return std::ranges::count(series.verdict.notes, code, &Note::code) > 0;
}

Volume loaded(const Series& series) {
    auto volume = loadSeries(series, Padding::maskAsAir, noProgress);
    if (!volume)
        qFatal("%s", volume.error().text().c_str());
    return *std::move(volume);
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
        for (const char* name : {"SEG", "RTDOSE", "US", "CR", ""}) {
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

    void valuesOfMoreThanSixteenBitsAreRefused() {
        const test::SliceFolder folder;
        const Series series = scanned(folder, {.size = {4, 4}, .change = [](DcmDataset& data) {
                                                   modality("MR")(data);
                                                   data.putAndInsertUint16(DCM_BitsAllocated, 32);
                                                   const std::vector<Uint16> words(32);
                                                   data.putAndInsertUint16Array(DCM_PixelData, words.data(), 32);
                                               }});
        QCOMPARE(series.verdict.stack, Stack::unreadable);
        QVERIFY(series.verdict.reason.find("no HU") != std::string::npos);
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
