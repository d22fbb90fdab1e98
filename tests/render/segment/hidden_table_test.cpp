/// The table goes and the patient stays: patients made from formulas, and every way found so far to lead the rule
/// astray.

#include <QTest>

#include "tests/support/dicom/lying_patients.h"

using namespace pdr;
using namespace pdr::test;
using segment::HiddenTable;

class HiddenTableTest : public QObject {
    Q_OBJECT

  private slots:
    /// Gap in mm, the lower the more it is pressed in; how much of the table may stay where it touches.
    void theTableGoes_data() {
        QTest::addColumn<double>("gap");
        QTest::addColumn<double>("stays");
        QTest::newRow("5 mm apart") << 5.0 << 0.0;
        QTest::newRow("2 mm apart") << 2.0 << 0.0;
        QTest::newRow("touching") << 0.0 << 0.1;
        QTest::newRow("pressed in by 4 mm") << -4.0 << 0.1;
        QTest::newRow("pressed in by 12 mm") << -12.0 << 0.1;
        QTest::newRow("pressed in by 20 mm") << -20.0 << 0.1;
    }
    void theTableGoes() {
        QFETCH(double, gap);
        QFETCH(double, stays);
        const Lying patient = onTable(gap);
        const HiddenTable table = hidden(*patient.volume);
        const Mistakes mistakes = mistakesOf(patient, table);
        QCOMPARE(mistakes.lost, 0);
        QVERIFY2(double(mistakes.kept) <= stays * double(mistakes.foreign), qPrintable(QString::number(mistakes.kept)));
        QCOMPARE(table.cutMl > 1, gap <= 0);
        QCOMPARE(table.parts, 1);
        QVERIFY(table.undecided.empty());
    }

    /// Small and thin things of a patient, and several of them.
    void thePatientStays_data() {
        QTest::addColumn<Anatomy>("anatomy");
        QTest::addColumn<int>("parts");
        QTest::newRow("one arm") << Anatomy([](dvec3 p) {
            return either(inTube(p, {0, 0}, 25) ? Matter::body : Matter::air, table(p, 28));
        }) << 1;
        QTest::newRow("two legs on a table") << Anatomy([](dvec3 p) {
            const bool leg = inTube(p, {-45, 0}, 35) || inTube(p, {45, 0}, 35);
            return either(leg ? Matter::body : Matter::air, table(p, 37));
        }) << 2;
        QTest::newRow("arms beside the trunk") << Anatomy([](dvec3 p) {
            const bool arm = inTube(p, {-80, 5}, 14) || inTube(p, {80, 5}, 14);
            return either(arm ? Matter::body : trunk(p), table(p, 47));
        }) << 3;
        QTest::newRow("arms overhead") << Anatomy([](dvec3 p) {
            const bool arm = inTube(p, {-30, 0}, 20) || inTube(p, {30, 0}, 20);
            return either(p.z > 10 ? (arm ? Matter::body : Matter::air) : trunk(p), table(p, 47));
        }) << 1;
        QTest::newRow("prone") << Anatomy([](dvec3 p) { return either(trunk(p), table(dvec3(p.x, -p.y, p.z), 47)); })
                               << 1;
        QTest::newRow("on the side") << Anatomy([](dvec3 p) {
            return either(trunk(dvec3(p.y, p.x, p.z)), table(p, 62));
        }) << 1;
        QTest::newRow("blanket with air beneath") << Anatomy([](dvec3 p) {
            const double r = std::hypot(p.x / 60, p.y / 45);
            const bool blanket = r > 1 + 3.0 / 45 && r < 1 + 7.0 / 45 && p.y < 20;
            return either(blanket ? Matter::foreign : trunk(p), table(p, 49));
        }) << 1;
        QTest::newRow("tilted table") << Anatomy([](dvec3 p) {
            return either(trunk(p), table(dvec3(p.x, p.y + 0.2 * p.z, p.z), 62));
        }) << 1;
    }
    void thePatientStays() {
        QFETCH(Anatomy, anatomy);
        QFETCH(int, parts);
        const Lying patient = lying(anatomy);
        const HiddenTable table = hidden(*patient.volume);
        const Mistakes mistakes = mistakesOf(patient, table);
        QCOMPARE(mistakes.lost, 0);
        QVERIFY2(mistakes.kept * 50 <= mistakes.foreign, qPrintable(QString::number(mistakes.kept)));
        QCOMPARE(table.parts, parts);
    }

    /// Lungs are air; what lies in them, attached or not, belongs to the patient. So does the air.
    void lungsAndTheirVesselsStay() {
        const Lying patient = lying([](dvec3 p) {
            const bool lung = (inTube(p, {-28, 0}, 24) || inTube(p, {28, 0}, 24)) && std::abs(p.z) < 52;
            const bool attached = inTube(p, {-28, 0}, 2.6);  // at both ends
            const bool vessel = attached || (inTube(p, {28, 0}, 2.6) && std::abs(p.z) < 45);
            return lung && !vessel ? Matter::air : either(trunk(p), table(p, 48));
        });
        const HiddenTable table = hidden(*patient.volume);
        QCOMPARE(mistakesOf(patient, table).lost, 0);
        QCOMPARE(table.cutMl, 0.0);
        QVERIFY(std::abs(table.bodyMl / (3.14159265 * 60 * 45 * 120 / 1000) - 1) < 0.01);
        for (std::size_t i = 0; i < patient.truth.size(); ++i) {
            const int x = int(i % 128), y = int(i / 128 % 96);
            if (inTube(dvec3(x - 63.5, y - 47.5, 0) * 1.5, {-28, 0}, 24))
                QVERIFY(table.body->voxels()[i] == patient.volume->voxels()[i]);
        }
    }

    /// An ear is thin, but not long.
    void shortThinThingsStay() {
        const Lying patient = lying([](dvec3 p) {
            const bool ear = std::abs(p.y) < 14 && std::abs(p.z) < 2.4 && p.x < -55 && p.x > -95;
            return either(ear ? Matter::body : trunk(p), table(p, 48));
        });
        QCOMPARE(mistakesOf(patient, hidden(*patient.volume)).lost, 0);
    }

    void oneAndTwoSlices() {
        for (const int slices : {1, 2}) {
            const Lying patient =
                lying([](dvec3 p) { return either(trunk(p), table(p, 48)); }, {128, 96, slices}, kLyingSpacingMm);
            const HiddenTable table = hidden(*patient.volume);
            const Mistakes mistakes = mistakesOf(patient, table);
            QCOMPARE(mistakes.lost, 0);
            QCOMPARE(mistakes.kept, 0);
            QVERIFY(mistakes.foreign > 0 && table.undecided.empty());
        }
    }

    /// Cells at the end of an axis hold fewer voxels than others, and are cells.
    void sizesThatAreNoMultipleOfACell() {
        for (const ivec3 size : {ivec3(257, 181, 23), ivec3(255, 183, 24), ivec3(256, 182, 25)}) {
            const Lying patient =
                lying([](dvec3 p) { return either(trunk(p), table(p, 48)); }, size, dvec3(0.7, 0.9, 1.1));
            const Mistakes mistakes = mistakesOf(patient, hidden(*patient.volume));
            QCOMPARE(mistakes.lost, 0);
            QCOMPARE(mistakes.kept, 0);
        }
    }

    void noiseTakesNothingFromThePatient_data() {
        QTest::addColumn<double>("noiseHu");
        QTest::addRow("30 HU") << 30.0;
        QTest::addRow("60 HU") << 60.0;
    }
    void noiseTakesNothingFromThePatient() {
        QFETCH(double, noiseHu);
        const Lying patient = onTable(3, noiseHu);
        const Mistakes mistakes = mistakesOf(patient, hidden(*patient.volume));
        QCOMPARE(mistakes.lost, 0);
        QVERIFY(mistakes.kept * 100 <= mistakes.foreign);
    }

    /// The body reaches the border at three sides; then only what is a piece of its own is taken away.
    void aSmallFieldOfViewLosesNothing() {
        for (const double gap : {3.0, -8.0}) {
            const auto anatomy = [=](dvec3 p) { return either(trunk(p + dvec3(0, 15, 0)), table(p, 30 + gap)); };
            const Lying patient = lying(anatomy, {56, 60, 48});
            const HiddenTable table = hidden(*patient.volume);
            const Mistakes mistakes = mistakesOf(patient, table);
            QCOMPARE(mistakes.lost, 0);
            if (gap > 0)
                QCOMPARE(mistakes.kept, 0);
            else
                QCOMPARE(table.cutMl, 0.0);
        }
    }

    /// An opening would take the vault of a dry skull: it is not done.
    void aDrySkullStays() {
        const Lying patient = lying(
            [](dvec3 p) {
                const double r = glm::length(p);
                const bool base = p.z < -25 && r < 60;
                return either(r < 60 && (r > 55 || base) ? Matter::body : Matter::air, table(p, 65));
            },
            {128, 112, 56});
        const HiddenTable table = hidden(*patient.volume);
        QVERIFY2(table.undecided.empty(), table.undecided.c_str());
        const Mistakes mistakes = mistakesOf(patient, table);
        QCOMPARE(mistakes.lost, 0);
        QCOMPARE(mistakes.kept, 0);
        QCOMPARE(table.cutMl, 0.0);
    }
};

QTEST_APPLESS_MAIN(HiddenTableTest)
#include "hidden_table_test.moc"
