/// The table goes and the patient stays: patients made from formulas, and every way found so far to lead the rule
/// astray.

#include "render/segment/hidden_table.h"

#include <QTest>

#include <tbb/global_control.h>

#include "render/base/errors.h"
#include "tests/support/lying_patients.h"

using namespace pdr;
using namespace pdr::test;
using segment::HiddenTable;

namespace {

HiddenTable hidden(const Volume& volume) {
    return *segment::hideTable(volume, noProgress);
}

/// `volume` mirrored along an axis.
std::shared_ptr<const Volume> mirrored(const Volume& volume, int axis) {
    const ivec3 size = volume.size();
    return makeVolume(size, volume.geometry().spacingMm(), [&](int i, int j, int k) {
        ivec3 at(i, j, k);
        at[axis] = size[axis] - 1 - at[axis];
        return volume.voxels()[(std::size_t(at.z) * size.y + at.y) * size.x + at.x];
    });
}

bool sameVoxels(const Volume& a, const Volume& b) {
    return std::equal(a.voxels().begin(), a.voxels().end(), b.voxels().begin(), b.voxels().end());
}

Lying onTable(double gap, double noiseHu = 0) {
    return lying([=](dvec3 p) { return either(trunk(p), table(p, 45 + gap)); }, kLyingSize, kLyingSpacingMm, noiseHu);
}

}  // namespace

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

    void whatIsHiddenIsAirAndTheRestIsAsItWas() {
        const Lying patient = onTable(3);
        const HiddenTable table = hidden(*patient.volume);
        std::int64_t seen = 0;
        for (std::size_t i = 0; i < patient.truth.size(); ++i) {
            const int before = patient.volume->voxels()[i], after = table.body->voxels()[i];
            QVERIFY(after == before || after == Volume::kAirHu);
            seen += after != before && before > -300;
        }
        QVERIFY(std::abs(table.hiddenMl - double(seen) * 1.5 * 1.5 * 2.5 / 1000) < 1e-9);
        QVERIFY(table.body->geometry().patientFromIndex == patient.volume->geometry().patientFromIndex);
    }

    void thePartsAreMeasured() {
        const HiddenTable table = hidden(*onTable(3).volume);
        const double trunkMl = 3.14159265 * 60 * 45 * 120 / 1000;
        QVERIFY2(std::abs(table.bodyMl / trunkMl - 1) < 0.01, qPrintable(QString::number(table.bodyMl)));
        const double tableMl = double(mistakesOf(onTable(3), table).foreign) * 1.5 * 1.5 * 2.5 / 1000;
        QVERIFY2(std::abs(table.hiddenMl / tableMl - 1) < 1e-9, qPrintable(QString::number(table.hiddenMl)));
        const dvec3 edges = dvec3(table.bodyBox.size) * kLyingSpacingMm;
        QVERIFY(std::abs(edges.x - 120) < 4 && std::abs(edges.y - 90) < 4 && edges.z == 120);
        QVERIFY(glm::length(table.bodyBox.centreMm() - onTable(3).volume->geometry().centreMm()) < 3);
    }

    /// A view that holds the outline holds the body, and hardly more.
    void theOutlineIsTheBodys() {
        const Lying patient = onTable(3);
        const auto outline = hidden(*patient.volume).outlineMm;
        for (const dvec3 way :
             {dvec3(1, 0, 0), dvec3(-0.6, 0.8, 0), dvec3(0, -1, 0), dvec3(0.5, 0.5, 0.7), dvec3(0, 0.6, -0.8)}) {
            double ofBody = -1e9, ofOutline = -1e9;
            for (std::size_t i = 0; i < patient.truth.size(); ++i)
                if (patient.truth[i] == Matter::body)
                    ofBody = std::max(
                        ofBody, glm::dot(way, (dvec3(i % 128, i / 128 % 96, i / 128 / 96) + 0.5) * kLyingSpacingMm));
            for (const dvec3& place : *outline)
                ofOutline = std::max(ofOutline, glm::dot(way, place));
            QVERIFY2(std::abs(ofOutline - ofBody) < 2.5, qPrintable(QString::number(ofOutline - ofBody)));
        }
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

    void withoutATableNothingIsHidden() {
        for (const Anatomy& anatomy : {Anatomy(trunk), Anatomy([](dvec3) { return Matter::body; })}) {
            const Lying patient = lying(anatomy);
            const HiddenTable table = hidden(*patient.volume);
            QVERIFY(!table.body);
            QCOMPARE(table.hiddenMl, 0.0);
            QVERIFY(table.undecided.empty());
            QVERIFY(segment::tableText(table).empty());
        }
    }

    void hiddenTwiceIsHiddenOnce() {
        for (const double gap : {5.0, 0.0, -12.0}) {
            const HiddenTable once = hidden(*onTable(gap).volume);
            const HiddenTable twice = hidden(*once.body);
            QVERIFY2(twice.hiddenMl < 1 && !twice.body, qPrintable(QString::number(twice.hiddenMl)));
        }
    }

    void mirroredScansHaveMirroredMasks() {
        const Lying patient = lying([](dvec3 p) {
            const bool arm = inTube(p, {-80, 5}, 14);
            return either(arm ? Matter::body : trunk(p), table(dvec3(p.x + 10, p.y, p.z), 42 + 0.1 * p.z));
        });
        const HiddenTable straight = hidden(*patient.volume);
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(sameVoxels(*hidden(*mirrored(*patient.volume, axis)).body, *mirrored(*straight.body, axis)));
    }

    void anyNumberOfThreadsGivesTheSame() {
        const auto patient = onTable(-8, 30).volume;
        const HiddenTable many = hidden(*patient);
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        const HiddenTable alone = hidden(*patient);
        QVERIFY(sameVoxels(*many.body, *alone.body));
        QCOMPARE(many.hiddenMl, alone.hiddenMl);
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

    void whatCannotBeKnownIsSaid_data() {
        QTest::addColumn<Anatomy>("anatomy");
        QTest::addColumn<double>("sliceMm");
        QTest::addColumn<QString>("reason");
        const Anatomy lyingMan = [](dvec3 p) { return either(trunk(p), table(p, 48)); };
        QTest::newRow("air") << Anatomy([](dvec3) { return Matter::air; }) << 2.5 << "nothing is as thick";
        QTest::newRow("a table alone") << Anatomy([](dvec3 p) { return table(p, 0); }) << 2.5 << "nothing is as thick";
        QTest::newRow("more shells than body") << Anatomy([](dvec3 p) {
            const bool body = inTube(p, {0, -40}, 15);
            return either(body ? Matter::body : Matter::air, either(table(p, 0), table(p, 30)));
        }) << 2.5 << "more than half";
        QTest::newRow("thick slices") << lyingMan << 6.0 << "5 mm apart";
    }
    void whatCannotBeKnownIsSaid() {
        QFETCH(Anatomy, anatomy);
        QFETCH(double, sliceMm);
        QFETCH(QString, reason);
        const Lying patient = lying(anatomy, kLyingSize, dvec3(1.5, 1.5, sliceMm));
        const HiddenTable table = hidden(*patient.volume);
        QVERIFY(!table.body);
        QVERIFY2(QString::fromStdString(table.undecided).contains(reason), table.undecided.c_str());
        QVERIFY(table.bodyBox.size == patient.volume->size());
        QCOMPARE(QString::fromStdString(segment::tableText(table)),
                 "No table was hidden, because " + QString::fromStdString(table.undecided) + ".");
    }

    void metalOutsideTheBodyIsNotHidden() {
        const Lying patient = onTable(5);
        const auto withPin = [&](int x, int y) {
            return makeVolume(kLyingSize, kLyingSpacingMm, [&](int i, int j, int k) {
                const bool pin = i == x && std::abs(j - y) < 3 && k == 20;
                return pin ? 3000 : int(patient.volume->voxels()[(std::size_t(k) * 96 + j) * 128 + i]);
            });
        };
        QVERIFY(hidden(*withPin(110, 20)).undecided.find("metal") != std::string::npos);
        const HiddenTable inside = hidden(*withPin(64, 48));
        QVERIFY(inside.undecided.empty() && inside.body);
    }

    void theSentencesSayWhatIsHidden() {
        HiddenTable table;
        table.body = std::make_shared<const Volume>(VolumeGeometry::aligned({1, 1, 1}, dvec3(1), dvec3(0)), Voxels(1));
        table.hiddenMl = 884.4;
        QCOMPARE(segment::tableText(table), std::string("Table and holder hidden: 884 ml outside the body."));
        table.cutMl = 33.7;
        QCOMPARE(segment::tableText(table), std::string("Table and holder hidden: 884 ml outside the body. 34 ml of it "
                                                        "touched the skin: check the edge."));
        table.cutMl = 0;
        table.parts = 2;
        QCOMPARE(segment::tableText(table), std::string("Table and holder hidden: 884 ml outside the body. 2 separate "
                                                        "parts are kept."));
    }

    void picturesSayByWhichRule() {
        const HiddenTable table = hidden(*onTable(3).volume);
        const QString expected = QString("%1 ml of %2 ml, rule 1, -250 HU, 3 mm, 10 mm")
                                     .arg(table.hiddenMl, 0, 'f', 0)
                                     .arg(table.hiddenMl + table.bodyMl, 0, 'f', 0);
        QCOMPARE(QString::fromStdString(table.body->hidden()), expected);
        QVERIFY(onTable(3).volume->hidden().empty());
    }

    void itEndsWhereItIsStopped() {
        const auto patient = onTable(0).volume;
        int steps = 0;
        (void)*segment::hideTable(*patient, [&](double, std::string_view) { return ++steps > 0; });
        QVERIFY(steps > 3);
        for (int last = 1; last <= steps; ++last) {
            int told = 0;
            const auto result = segment::hideTable(*patient, [&](double fraction, std::string_view step) {
                return fraction >= 0 && fraction <= 1 && !step.empty() && ++told < last;
            });
            QVERIFY(!result && result.error().kind == ErrorKind::cancelled);
            QCOMPARE(told, last);
        }
    }
};

QTEST_APPLESS_MAIN(HiddenTableTest)
#include "hidden_table_test.moc"
