/// The texts of images, cuts and lamps: sides are the patient's, and nothing absent is named.

#include <QTest>

#include "ui/annotation/annotation_text.h"
#include "ui/annotation/scale_bar.h"
#include "ui/light/light_text.h"
#include "ui/text/cut_text.h"
#include "ui/text/series_text.h"

namespace pdr::ui {

class TestAnnotationText : public QObject {
    Q_OBJECT

  private slots:
    void whatIsNotThereYetIsNotNamed();
    void aCutIsSaidWithItsLengths();
    void aLampShinesFromThePatientsSide();
    void theBarIsAsLongAsItSays();
    void whoItIsTakesThreeLines();
};

void TestAnnotationText::whatIsNotThereYetIsNotNamed() {
    QCOMPARE(annotationTexts({.look = "Bones alone", .notShown = "Only bones are shown."}),
             QStringList({"Bones alone", "Only bones are shown."}));
    QCOMPARE(annotationTexts({.look = "Bones alone", .maskAwaited = true}),
             QStringList("Bones alone (the rest is not yet removed)"));
    QCOMPARE(annotationTexts({.look = "Vessels", .ctDenoised = true}), QStringList({"Vessels", "CT denoised"}));
}

void TestAnnotationText::aCutIsSaidWithItsLengths() {
    const Uncut uncut{{-100, -80, 0}, {100, 80, 300}};
    QCOMPARE(cutText(Clip{}, uncut), QString());
    Clip clip = withCutOff({}, uncut, 2, 47.1);
    QCOMPARE(cutText(clip, uncut), "cut: front 47.1 mm");
    clip = withCutOff(clip, uncut, 5, 20);
    clip.planes = {{{0, 12, 150}, {0, -1, 0}}};
    clip.freehand.resize(2);
    QCOMPARE(cutText(clip, uncut), "cut: front 47.1 mm; head 20.0 mm; Coronal: -12.0 mm from the middle; 2 drawn");
    clip.freehand.clear();
    QCOMPARE(cutText(clip, {}), "cut: box of 200 x 113 x 280 mm; Coronal");
}

/// Seen from the front, what is left on the screen is the patient's right.
void TestAnnotationText::aLampShinesFromThePatientsSide() {
    const Camera front{.eyeMm = {0, -1000, 0}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}};
    const Camera back{.eyeMm = {0, 1000, 0}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}};
    const auto lamp = [](double x, double y, double z) {
        return SphereLamp{"Key", glm::normalize(dvec3(x, y, z)), 1, vec3(1)};
    };
    QCOMPARE(lampText(lamp(-1, 0, 0), front), "Key: from R");
    QCOMPARE(lampText(lamp(1, 0, 0), front), "Key: from L");
    QCOMPARE(lampText(lamp(-1, 0, 0), back), "Key: from L");
    QCOMPARE(lampText(lamp(-1, 0.5543, 0), front), QString::fromUtf8("Key: from R, 29° from above"));
    QCOMPARE(lampText(lamp(1, -1, 1), front), QString::fromUtf8("Key: from LA, 35° from below"));
    QCOMPARE(lampText(lamp(0.5, 0, -1), front), "Key: from PL, from behind");
    QCOMPARE(lampText(lamp(0, 0, 1), front), "Key: beside the eye");
    QCOMPARE(lampText(lamp(0, 1, 0), front), QString::fromUtf8("Key: 90° from above"));
}

void TestAnnotationText::theBarIsAsLongAsItSays() {
    const Camera parallel{.type = Camera::Type::orthographic, .heightMm = 300};
    const auto bar = scaleBar(parallel, 600, 250);
    QVERIFY(bar && bar->text == "100 mm");
    QCOMPARE(bar->pixels, 200.0);
    Camera perspective;
    const double height = 500, mm = perspective.heightInFocusMm();
    perspective.focusMm = 400;  // nearer than the centre
    const auto there = scaleBar(perspective, height, 100);
    QVERIFY(there && there->text.endsWith(" mm at the centre's depth"));
    QCOMPARE(there->pixels, there->text.section(' ', 0, 0).toDouble() * height / mm);
    QVERIFY(!scaleBar(parallel, 600, 0));
}

void TestAnnotationText::whoItIsTakesThreeLines() {
    dicom::Series series;
    series.patient = {"Doe^Jane", "4711", "19600517", "F"};
    series.study.date = "20240131";
    series.series.description = "Thorax";
    QCOMPARE(patientLines(series), QStringList({"Doe, Jane", QString::fromUtf8("born 1960-05-17 · ID 4711"),
                                                QString::fromUtf8("2024-01-31 · Thorax")}));
    series.patient = {};
    series.study.date = {};
    QCOMPARE(patientLines(series), QStringList({"Name not given", "Thorax"}));
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestAnnotationText)
#include "annotation_text_test.moc"
