#include <QCryptographicHash>
#include <QTest>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "dicom/import.h"
#include "render/volume/sheared.h"
#include "tests/support/dicom/shared_data.h"

using namespace pdr;
using namespace pdr::dicom;

namespace {

ScanResult scanned(const std::string& folder) {
    Result<ScanResult> result = scanFolder(test::sharedCt() / folder, noProgress);
    return result ? *std::move(result) : ScanResult{};
}

/// Returns the values of all voxels, in HU or not, rounded to 16 bits as the known ones are.
std::vector<std::int16_t> valuesOf(const Volume& volume) {
    const ValueUnit unit = unitOf(volume);
    std::vector<std::int16_t> values;
    values.reserve(volume.voxels().size());
    for (const std::int16_t voxel : volume.voxels())
        values.push_back(std::int16_t(std::clamp(std::round(unit.valueOf(voxel)), -32768.0, 32767.0)));
    return values;
}

std::string checksumOf(const Volume& volume) {
    const std::vector<std::int16_t> values = valuesOf(volume);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(QByteArrayView(reinterpret_cast<const char*>(values.data()), qsizetype(2 * values.size())));
    return hash.result().toHex().toStdString();
}

double meanOf(const Volume& volume, bool withPadding) {
    const std::vector<std::int16_t> values = valuesOf(volume);
    std::int64_t sum = 0, count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!withPadding && volume.isPadding(i))
            continue;
        sum += values[i];
        ++count;
    }
    return double(sum) / double(count);
}

bool near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

const Series* withUid(const ScanResult& scan, const std::string& uid, int slices) {
    for (const Series& series : scan.series) {
        if (series.series.uid == uid && !series.series.resampled && int(series.slices.size()) == slices)
            return &series;
    }
    return nullptr;
}

int loadable(const ScanResult& scan) {
    return int(
        std::count_if(scan.series.begin(), scan.series.end(), [](const Series& s) { return s.verdict.loadable(); }));
}

bool noteSays(const Series& series, const std::string& word) {
    return std::any_of(series.verdict.notes.begin(), series.verdict.notes.end(),
                       [&](const Note& note) { return note.text.find(word) != std::string::npos; });
}

}  // namespace

class RealSeriesTest : public QObject {
    Q_OBJECT

  private slots:
    /// Every series whose checksum is known and whose pixels can be decoded has that checksum.
    void knownChecksumsAreMet() {
        PDR_NEEDS_SHARED_CT();
        std::ifstream file(test::sharedFolder() / "data" / "exp_dev.jsonl");
        int met = 0;
        for (std::string line; std::getline(file, line);) {
            const auto expected = nlohmann::json::parse(line);
            if (expected.value("hash_type", "") != "int16 HU")
                continue;
            const std::string folder = expected["dir"].get<std::string>().substr(4);
            const ScanResult scan = scanned(folder);
            const Series* series = withUid(scan, expected["uid"], expected["n"]);
            if (!series || series->verdict.stack == Stack::unreadable)
                continue;
            const auto volume = loadSeries(*series, Padding::keep, noProgress);
            if (!volume)
                continue;
            QVERIFY2(checksumOf(*volume) == expected["sha256"].get<std::string>(), folder.c_str());
            QVERIFY(near(meanOf(*volume, true), expected["mean"], 1e-9));
            QVERIFY(near(meanOf(*volume, false), expected["mean_nopad"], 1e-9));
            QCOMPARE(volume->paddingCount(), expected["n_pad"].get<std::size_t>());
            ++met;
        }
        // The others: multi-frame (3, two of them below), colour (3), copies left out, an odd slice listed apart.
        QCOMPARE(met, 39);
    }

    /// Two frames of a perfusion map, from the top down along the normal of their mirrored rows.
    void framesHaveTheirChecksum() {
        PDR_NEEDS_SHARED_CT();
        for (const char* folder : {"enhanced_ct_le", "enhanced_ct_rle"}) {
            const ScanResult scan = scanned(folder);
            QCOMPARE(scan.series.size(), std::size_t(1));
            const Series& series = scan.series.front();
            QVERIFY2(series.verdict.loadable(), series.verdict.reason.c_str());
            QVERIFY(series.geometry.size == ivec3(512, 512, 2));
            QVERIFY(glm::distance(series.geometry.spacingMm(), dvec3(0.388672, 0.388672, 10)) < 1e-9);
            QVERIFY(near(series.geometry.patientFromIndex[3].z, -149, 1e-9));
            QVERIFY(noteSays(series, "RCBF, ml/100ml/s"));
            const auto volume = loadSeries(series, Padding::keep, noProgress);
            QVERIFY2(bool(volume), volume ? "" : volume.error().text().c_str());
            QCOMPARE(checksumOf(*volume).substr(0, 16), std::string("53bfa701eeafd41c"));
        }
    }

    void chestLoadsWithItsGridAndWithoutItsPadding() {
        PDR_NEEDS_SHARED_CT();
        const ScanResult scan = scanned("chest_contrast");
        QCOMPARE(scan.series.size(), std::size_t(1));
        const Series& series = scan.series.front();
        QVERIFY(series.verdict.loadable());
        QVERIFY(series.geometry.size == ivec3(512, 512, 100));
        QVERIFY(glm::distance(series.geometry.spacingMm(), dvec3(0.898438, 0.898438, 2.5)) < 1e-9);
        QVERIFY(glm::distance(dvec3(series.geometry.patientFromIndex[3]), dvec3(-228.8, -220, -236.5)) < 1e-9);
        const auto volume = loadSeries(series, Padding::maskAsAir, noProgress);
        QVERIFY(bool(volume));
        QCOMPARE(int(volume->lowestHu()), -1024);
        QCOMPARE(int(volume->highestHu()), 3071);
        QCOMPARE(volume->paddingCount(), std::size_t(5577200));
        QCOMPARE(int(*std::min_element(volume->voxels().begin(), volume->voxels().end())), -1024);
        const auto at = [&](int x, int y, int k) {
            return int(volume->voxels()[(std::size_t(k) * 512 + y) * 512 + x]);
        };
        QCOMPARE(at(256, 256, 50), -291);
        QCOMPARE(at(150, 200, 50), -863);
        QCOMPARE(at(256, 330, 20), 208);
        QCOMPARE(at(240, 180, 75), 216);
    }

    void evenStacksLoad_data() {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("slices");
        QTest::addColumn<double>("pixelMm");
        QTest::addColumn<double>("gapMm");
        QTest::addColumn<double>("mean");
        QTest::addColumn<double>("meanTolerance");
        QTest::newRow("ct_plus_rtstruct")
            << "ct_plus_rtstruct" << 512 << 2 << 0.488281 << 5.0 << -835.510576248 << 1e-8;
        QTest::newRow("duplicates") << "duplicates" << 512 << 5 << 0.78125 << 1.0 << -620.207479095 << 1e-8;
        QTest::newRow("rescale_per_slice")
            << "rescale_per_slice" << 512 << 4 << 0.78125 << 1.0 << -788.753465176 << 0.1;
        QTest::newRow("reformat") << "reformat_mixed_orient" << 512 << 19 << 0.703125 << 3.0 << -657.821044721 << 1e-8;
        QTest::newRow("dicomdir_tree") << "dicomdir_tree" << 16 << 5 << 0.488281 << 2.5 << -138.53125 << 1e-8;
        QTest::newRow("truncated") << "truncated" << 512 << 2 << 0.78125 << 1.0 << (-643.631137848 - 643.804855347) / 2
                                   << 1e-8;
    }
    void evenStacksLoad() {
        PDR_NEEDS_SHARED_CT();
        QFETCH(QString, folder);
        QFETCH(int, columns);
        QFETCH(int, slices);
        QFETCH(double, pixelMm);
        QFETCH(double, gapMm);
        QFETCH(double, mean);
        QFETCH(double, meanTolerance);
        const ScanResult scan = scanned(folder.toStdString());
        QCOMPARE(loadable(scan), 1);
        const Series& series = scan.series.front();
        QVERIFY(series.verdict.loadable());
        QVERIFY(series.geometry.size == ivec3(columns, columns, slices));
        QVERIFY(glm::distance(series.geometry.spacingMm(), dvec3(pixelMm, pixelMm, gapMm)) < 1e-6);
        const auto volume = loadSeries(series, Padding::keep, noProgress);
        QVERIFY(bool(volume));
        QVERIFY(near(meanOf(*volume, true), mean, meanTolerance));
    }

    /// Two makers, tilted either way; one states no tilt, the other one of no use. Every slice lies where its file
    /// says.
    void tiltedGantriesLoadOnAShearedGrid_data() {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<double>("pixelMm");
        QTest::addColumn<double>("gapMm");
        QTest::addColumn<double>("shearMm");
        QTest::addColumn<dvec3>("first");
        QTest::addColumn<dvec3>("last");
        QTest::addColumn<double>("mean");
        QTest::addColumn<QString>("noted");
        QTest::newRow("GE") << "mixed_study_tilt" << 0.482421875 << 2.37081 << 0.79326
                            << dvec3(-123.5, -15.641, 792.345) << dvec3(-123.5, -15.641, 809.845) << -846.773180485
                            << "18.5 degrees";
        QTest::newRow("Siemens") << "tilt_siemens4" << 0.417969 << 4.85148 << 1.20961
                                 << dvec3(-106.791, -256.619, -61.9519) << dvec3(-106.791, -256.619, -46.9519)
                                 << -897.068127632 << "14.0 degrees";
    }
    void tiltedGantriesLoadOnAShearedGrid() {
        PDR_NEEDS_SHARED_CT();
        QFETCH(QString, folder);
        QFETCH(double, pixelMm);
        QFETCH(double, gapMm);
        QFETCH(double, shearMm);
        QFETCH(dvec3, first);
        QFETCH(dvec3, last);
        QFETCH(double, mean);
        QFETCH(QString, noted);
        const ScanResult scan = scanned(folder.toStdString());
        QCOMPARE(loadable(scan), 1);
        const Series& series = scan.series.front();
        QCOMPARE(QString::fromStdString(series.verdict.reason), QString());
        QVERIFY(noteSays(series, noted.toStdString()));
        QVERIFY(glm::distance(statedSpacingMm(series.geometry), dvec3(pixelMm, pixelMm, gapMm)) < 1e-4);
        QVERIFY(std::abs(glm::length(sliceDrift(series.geometry).sidewaysMm) - shearMm) < 1e-4);
        const dmat4& map = series.geometry.patientFromIndex;
        QVERIFY(glm::distance(dvec3(map[3]), first) < 1e-3);
        QVERIFY(glm::distance(dvec3(map * dvec4(0, 0, series.geometry.size.z - 1, 1)), last) < 1e-3);
        const auto volume = loadSeries(series, Padding::keep, noProgress);
        QVERIFY(bool(volume));
        QVERIFY(near(meanOf(*volume, true), mean, 1e-8));
        QVERIFY(volume->remarks().find("tilt") != std::string::npos);
    }

    void rescaleIsTakenFromEachSlice() {
        PDR_NEEDS_SHARED_CT();
        const ScanResult scan = scanned("rescale_per_slice");
        const auto volume = loadSeries(scan.series.front(), Padding::keep, noProgress);
        QVERIFY(bool(volume));
        const double expected[] = {-644.892330170, -1292.084609985, -645.695178986, -572.341741562};
        const std::size_t count = 512 * 512;
        for (int k = 0; k < 4; ++k) {
            double sum = 0;
            for (std::size_t i = 0; i < count; ++i)
                sum += volume->voxels()[std::size_t(k) * count + i];
            QVERIFY(near(sum / double(count), expected[k], k == 3 ? 0.5 : 1e-8));
        }
    }

    void unevenStacksAreRefusedWithFilesAndMillimetres_data() {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<int>("stack");
        QTest::addColumn<QStringList>("words");
        QTest::newRow("missing_slice") << "missing_slice" << int(Stack::gap)
                                       << QStringList{"10 mm apart", "5 mm", "IM-0001-0010-0001.dcm",
                                                      "IM-0001-0009-0001.dcm"};
        QTest::newRow("missing_tags") << "missing_tags" << int(Stack::noGeometry)
                                      << QStringList{"CT-MONO2-16-ankle", "position", "orientation", "pixel spacing"};
        QTest::newRow("pet_not_ct") << "pet_not_ct" << int(Stack::singleSlice) << QStringList{"at least two"};
        QTest::newRow("cr_monochrome1") << "cr_monochrome1" << int(Stack::notCt) << QStringList{"CR, not CT"};
        QTest::newRow("charsets") << "charsets" << int(Stack::notCt) << QStringList{"OT, not CT"};
        QTest::newRow("tiny_ct") << "tiny_ct" << int(Stack::singleSlice) << QStringList{"at least two"};
    }
    void unevenStacksAreRefusedWithFilesAndMillimetres() {
        PDR_NEEDS_SHARED_CT();
        QFETCH(QString, folder);
        QFETCH(int, stack);
        QFETCH(QStringList, words);
        ScanResult scan = scanned(folder.toStdString());
        std::erase_if(scan.series, [](const Series& each) { return each.series.resampled; });
        QCOMPARE(loadable(scan), 0);
        const Series& series = scan.series.front();
        QCOMPARE(int(series.verdict.stack), stack);
        for (const QString& word : words)
            QVERIFY2(series.verdict.reason.find(word.toStdString()) != std::string::npos,
                     series.verdict.reason.c_str());
        const auto refused = loadSeries(series, Padding::maskAsAir, noProgress);
        QVERIFY(!refused);
        QCOMPARE(refused.error().what, series.verdict.reason);
    }

    void localizerAndColourCaptureStandApart() {
        PDR_NEEDS_SHARED_CT();
        const ScanResult scan = scanned("mixed_study_tilt");
        QCOMPARE(scan.series.size(), std::size_t(3));
        QCOMPARE(int(scan.series[0].slices.size()), 8);
        QVERIFY(scan.problems.empty());
        const auto says = [&](const std::string& word) {
            return std::any_of(scan.series.begin(), scan.series.end(), [&](const Series& series) {
                return series.verdict.stack == Stack::notCt && series.verdict.reason.find(word) != std::string::npos;
            });
        };
        QVERIFY(says("localizer"));
        QVERIFY(says("colour"));
    }

    void copiesAreLeftOutWithANote() {
        PDR_NEEDS_SHARED_CT();
        const ScanResult scan = scanned("duplicates");
        QVERIFY(noteSays(scan.series.front(), "2 copies"));
        QVERIFY(noteSays(scan.series.front(), "resent_000066.dcm"));
    }

    void truncatedSliceIsNamedAndTheRestLoads() {
        PDR_NEEDS_SHARED_CT();
        const ScanResult scan = scanned("truncated");
        QVERIFY(std::any_of(scan.problems.begin(), scan.problems.end(),
                            [](const Problem& p) { return p.file.filename() == "000117.dcm" && !p.reason.empty(); }));
        QVERIFY(noteSays(scan.series.front(), "000117.dcm"));
    }

    void oddOrientationIsListedByItself() {
        PDR_NEEDS_SHARED_CT();
        const ScanResult scan = scanned("reformat_mixed_orient");
        QCOMPARE(scan.series.size(), std::size_t(2));
        QCOMPARE(scan.series[1].slices.size(), std::size_t(1));
        QCOMPARE(scan.series[1].slices[0].file.filename().string(), std::string("1-001.dcm"));
        QCOMPARE(scan.series[1].series.uid, scan.series[0].series.uid);
        QVERIFY(noteSays(scan.series[0], "1 slice"));
    }

    void lossyImagesAreCloseToTheirReference_data() {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<double>("mean");
        QTest::newRow("8 bit") << "JPEGProcess1" << -967.867026562;
        QTest::newRow("12 bit") << "JPEGProcess2_4" << -950.108594801;
        QTest::newRow("12 bit spectral") << "JPEGProcess6_8" << -950.108594801;
        QTest::newRow("12 bit progressive") << "JPEGProcess10_12" << -950.108594801;
    }
    void lossyImagesAreCloseToTheirReference() {
        PDR_NEEDS_SHARED_CT();
        QFETCH(QString, folder);
        QFETCH(double, mean);
        const ScanResult scan = scanned("transfer_syntaxes/" + folder.toStdString());
        QCOMPARE(scan.series.size(), std::size_t(1));
        const auto volume = loadSeries(scan.series.front(), Padding::keep, noProgress);
        QVERIFY(bool(volume));
        QVERIFY(near(meanOf(*volume, true), mean, 0.5));
    }

    void namesAreUtf8_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("name");
        QTest::newRow("Arab") << "chrArab.dcm" << QStringLiteral("قباني^لنزار");
        QTest::newRow("Fren") << "chrFren.dcm" << QStringLiteral("Buc^Jérôme");
        QTest::newRow("Greek") << "chrGreek.dcm" << QStringLiteral("Διονυσιος");
        QTest::newRow("H31") << "chrH31.dcm" << QStringLiteral("Yamada^Tarou=山田^太郎=やまだ^たろう");
        QTest::newRow("I2") << "chrI2.dcm" << QStringLiteral("Hong^Gildong=洪^吉洞=홍^길동");
        QTest::newRow("X1") << "chrX1.dcm" << QStringLiteral("Wang^XiaoDong=王^小東");
    }
    void namesAreUtf8() {
        PDR_NEEDS_SHARED_CT();
        QFETCH(QString, file);
        QFETCH(QString, name);
        const ScanResult scan = scanned("charsets");
        for (const Series& series : scan.series) {
            if (series.slices.front().file.filename() != file.toStdString())
                continue;
            QCOMPARE(QString::fromStdString(series.patient.name), name);
            return;
        }
        QFAIL("the file is not among the series");
    }
};

QTEST_APPLESS_MAIN(RealSeriesTest)
#include "real_series_test.moc"
