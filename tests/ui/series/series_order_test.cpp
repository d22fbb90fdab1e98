/// The order of the series list, and the one word that it says of what is unusual.

#include <QTest>

#include "render/volume/sheared.h"
#include "ui/series/series_order.h"
#include "ui/text/series_words.h"

namespace pdr::ui {

/// A CT series of `slices` slices that lie `mm` apart and can be loaded.
static dicom::Series axial(double mm, int slices = 100) {
    dicom::Series series;
    series.series.modality = "CT";
    series.verdict.stack = dicom::Stack::even;
    series.geometry = VolumeGeometry::aligned({512, 512, slices}, {0.7, 0.7, mm}, {0, 0, 0});
    series.slices.resize(std::size_t(slices));
    return series;
}

static dicom::Series refused(dicom::Stack stack) {
    dicom::Series series = axial(0.1);
    series.verdict.stack = stack;
    return series;
}

static dicom::Series of(dicom::Series series, const char* patient, const char* study, const char* date) {
    series.patient.name = patient;
    series.study.uid = study;
    series.study.date = date;
    return series;
}

/// Turns the slices of a series: they are coronal then.
static dicom::Series coronal(double mm) {
    dicom::Series series = axial(mm);
    std::swap(series.geometry.patientFromIndex[1], series.geometry.patientFromIndex[2]);
    series.geometry.patientFromIndex[1] *= 0.7 / mm;
    series.geometry.patientFromIndex[2] *= mm / 0.7;
    return series;
}

class TestSeriesOrder : public QObject {
    Q_OBJECT

  private slots:
    void theThinnestEvenAxialCtIsFirst();
    void amongEqualsTheLongerIsFirst();
    void studiesStandByPatientAndNewestFirst();
    void distancesAreAlongTheNormal();
    void theGravestNoteIsTheWord();
    void whatIsUsualOrUnknownHasAWord();
};

void TestSeriesOrder::theThinnestEvenAxialCtIsFirst() {
    dicom::Series magnetic = axial(0.2);
    magnetic.series.modality = "MR";
    dicom::Series flow = axial(0.3);
    flow.unit = ValueUnit::other("ml/100ml/s");
    const dicom::ScanResult scan{{refused(dicom::Stack::notCt), refused(dicom::Stack::gap), magnetic, coronal(0.5),
                                  axial(5), axial(0.625), axial(1.25), flow},
                                 {}};
    const auto studies = listedStudies(scan);
    QCOMPARE(studies.size(), std::size_t(1));
    QCOMPARE(studies[0].series, (std::vector{5, 6, 4, 2, 7, 3, 1, 0}));
}

/// Rounding in the files makes no slice thinner.
void TestSeriesOrder::amongEqualsTheLongerIsFirst() {
    dicom::ScanResult scan{{axial(1.2499, 40), axial(1.25, 400), axial(1.2501, 400)}, {}};
    scan.series[1].series.number = 4;
    scan.series[2].series.number = 3;
    QCOMPARE(listedStudies(scan)[0].series, (std::vector{2, 1, 0}));
}

void TestSeriesOrder::studiesStandByPatientAndNewestFirst() {
    const dicom::ScanResult scan{
        {of(refused(dicom::Stack::gap), "Abel", "1", "20240101"), of(axial(1), "Roe", "2", "20200101"),
         of(axial(1), "Roe", "3", "20240101"), of(refused(dicom::Stack::gap), "Roe", "4", "20250101"),
         of(axial(1), "Doe", "5", "20100101"), of(axial(2), "Roe", "2", "20200101")},
        {}};
    std::vector<std::pair<int, std::vector<int>>> listed;
    for (const ListedStudy& study : listedStudies(scan))
        listed.emplace_back(study.patient, study.series);
    QCOMPARE(listed, (decltype(listed){{1, {4}}, {2, {2}}, {2, {1, 5}}, {2, {3}}, {3, {0}}}));
    QVERIFY(listedStudies({}).empty());
}

/// The step from slice to slice of a tilted stack is longer than the distance between the slices.
void TestSeriesOrder::distancesAreAlongTheNormal() {
    VolumeGeometry geometry = axial(2).geometry;
    QCOMPARE(sliceDrift(geometry).gapMm, 2.0);
    geometry.patientFromIndex[2].y = 1.5;
    QCOMPARE(sliceDrift(geometry).gapMm, 2.0);
    QVERIFY(isAxial(geometry));
    QVERIFY(!isAxial(coronal(2).geometry));
    QCOMPARE(sliceDrift(coronal(2).geometry).gapMm, 2.0);
}

void TestSeriesOrder::theGravestNoteIsTheWord() {
    const dicom::Note copies{"copies", "1 copy"}, lossy{"lossy", "1 slice"}, missing{"incomplete", "1 slice"};
    QCOMPARE(unusualWord({copies}), "copies");
    QCOMPARE(unusualWord({copies, missing}), "incomplete?");
    QCOMPARE(unusualWord({copies, missing, lossy}), "lossy");
    QCOMPARE(unusualWord({lossy, {"no-hu", "a perfusion map"}}), "no HU");
    QCOMPARE(verdictText({dicom::Stack::even, "", {copies, lossy}}), QString::fromUtf8("✓  lossy"));
}

void TestSeriesOrder::whatIsUsualOrUnknownHasAWord() {
    QCOMPARE(unusualWord({}), "");
    QCOMPARE(unusualWord({{"something-new", "a sentence"}}), "note");
    QCOMPARE(verdictText({dicom::Stack::even, "", {}}), QString::fromUtf8("✓  can be shown"));
    QCOMPARE(verdictText({dicom::Stack::noGeometry, "why", {}}), QString::fromUtf8("✗  missing position data"));
    QCOMPARE(verdictText({dicom::Stack::gap, "why", {{"lossy", "1"}}}), QString::fromUtf8("✗  a slice is missing"));
}

}  // namespace pdr::ui

QTEST_GUILESS_MAIN(pdr::ui::TestSeriesOrder)
#include "series_order_test.moc"
