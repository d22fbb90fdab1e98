/// Tests the report on a hidden table: how much, where, by which rule, or why it is not known; and what it must not
/// depend on.

#include <QTest>

#include <tbb/global_control.h>

#include "tests/support/dicom/lying_patients.h"

using namespace pdr;
using namespace pdr::test;
using segment::HiddenTable;

namespace {

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

}  // namespace

class TableFactsTest : public QObject {
    Q_OBJECT

  private slots:
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

    /// The window hides the table in the memory of the scan: the same voxels and figures, and what is lost is handed
    /// out.
    void inPlaceIsTheSame() {
        const auto patient = onTable(-8, 30).volume;
        const HiddenTable copied = hidden(*patient);
        Voxels restored(copied.body->voxels().begin(), copied.body->voxels().end());
        const std::size_t area = restored.size() / std::size_t(patient->size().z);
        const auto restore = [&](int z, std::span<const std::int16_t> scan, std::span<const std::int16_t>) {
            std::ranges::copy(scan, restored.begin() + std::ptrdiff_t(area * std::size_t(z)));
        };
        Volume scan = *patient;
        const std::int16_t* memory = scan.voxels().data();
        const auto inPlace = *segment::hideTableIn(std::move(scan), restore, noProgress);
        QVERIFY(inPlace.volume->voxels().data() == memory);
        QVERIFY(inPlace.table.body == inPlace.volume);
        QVERIFY(sameVoxels(*inPlace.volume, *copied.body));
        QVERIFY(std::ranges::equal(restored, patient->voxels()));
        QCOMPARE(inPlace.volume->hidden(), copied.body->hidden());
        QVERIFY(inPlace.volume->storedRange() == copied.body->storedRange());
        QCOMPARE(inPlace.volume->highestHu(), copied.body->highestHu());
        QCOMPARE(inPlace.table.hiddenMl, copied.hiddenMl);
        QCOMPARE(inPlace.table.cutMl, copied.cutMl);
    }

    void withoutATableTheScanStaysInPlace() {
        const auto alone = lying(trunk).volume;
        const auto none = [](int, std::span<const std::int16_t>, std::span<const std::int16_t>) {};
        const auto inPlace = *segment::hideTableIn(Volume(*alone), none, noProgress);
        QVERIFY(!inPlace.table.body);
        QVERIFY(sameVoxels(*inPlace.volume, *alone));
        QVERIFY(inPlace.volume->hidden().empty());
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

    /// Metal outside the body may be a frame: it stays with what it touches, and nothing else is hidden than without
    /// it.
    void metalOutsideTheBodyStaysWithWhatItTouches_data() {
        QTest::addColumn<dvec3>("middle");
        QTest::addColumn<double>("tableTop");
        QTest::addColumn<double>("keptMl");
        QTest::newRow("beside the body") << dvec3(70, -45, 0) << 50.0 << 0.7;
        QTest::newRow("near the skin") << dvec3(0, -54, 0) << 50.0 << 0.7;
        QTest::newRow("in the skin") << dvec3(0, -45, 0) << 50.0 << 0.0;  // and taken for body
        QTest::newRow("on the table") << dvec3(40, 50, 0) << 50.0 << 100.0;
        QTest::newRow("on a table that is pressed in") << dvec3(70, 38, 0) << 38.0 << 100.0;
        QTest::newRow("with a handle") << dvec3(70, -45, 30) << 50.0 << 1.5;
    }
    void metalOutsideTheBodyStaysWithWhatItTouches() {
        QFETCH(dvec3, middle);
        QFETCH(double, tableTop);
        QFETCH(double, keptMl);
        const auto withHandle = [&](dvec3 p) {
            const bool handle = middle.z > 0 && inTube(p, middle, 4) && p.z > 0 && p.z < 40;
            return handle ? Matter::foreign : either(trunk(p), table(p, tableTop));
        };
        const auto volume = lying(withHandle).volume;
        const auto inPin = [&](int i, int j, int k) {
            const dvec3 place = (dvec3(i, j, k) + 0.5 - dvec3(kLyingSize) * 0.5) * kLyingSpacingMm;
            return glm::length(place - middle) < 5;
        };
        const auto at = [](const Volume& of, int i, int j, int k) {
            return int(of.voxels()[(std::size_t(k) * kLyingSize.y + j) * kLyingSize.x + i]);
        };
        const auto pinned = makeVolume(kLyingSize, kLyingSpacingMm, [&](int i, int j, int k) {
            return inPin(i, j, k) ? 3000 : at(*volume, i, j, k);
        });
        const HiddenTable without = hidden(*volume), with = hidden(*pinned);
        QVERIFY(with.undecided.empty() && without.body);
        const Volume& shown = with.body ? *with.body : *pinned;
        for (int k = 0; k < kLyingSize.z; ++k)
            for (int j = 0; j < kLyingSize.y; ++j)
                for (int i = 0; i < kLyingSize.x; ++i) {
                    QVERIFY(!inPin(i, j, k) || at(shown, i, j, k) == 3000);
                    const bool was = at(*without.body, i, j, k) == at(*volume, i, j, k);
                    QVERIFY(inPin(i, j, k) || !was || at(shown, i, j, k) == at(*volume, i, j, k));
                }
        QVERIFY2(with.metalMl >= 0.4 * keptMl && with.metalMl <= 2.5 * keptMl,
                 qPrintable(QString::number(with.metalMl)));
        QVERIFY(with.hiddenMl <= without.hiddenMl + 0.1 && with.hiddenMl + 1.5 * with.metalMl >= without.hiddenMl);
        QCOMPARE(segment::tableText(with).find("Metal outside") != std::string::npos, with.metalMl > 0);
        QCOMPARE(without.metalMl, 0.0);
        QVERIFY((without.cutMl > 1) == (tableTop < 45) && with.cutMl <= (tableTop < 45 ? 0 : without.cutMl));
    }

    /// Wires are thinner than cells; a view has room for what stays.
    void aFrameStaysWhole() {
        const auto frame = [](dvec3 p) {
            const double radius = std::hypot(p.x, p.y);
            return p.y < 0 && std::abs(p.z) < 4 && radius > 64 && radius < 67;
        };
        const auto scan = lying([](dvec3 p) { return either(trunk(p), table(p, 50)); }).volume;
        const auto framed = makeVolume(kLyingSize, kLyingSpacingMm, [&](int i, int j, int k) {
            const dvec3 place = (dvec3(i, j, k) + 0.5 - dvec3(kLyingSize) * 0.5) * kLyingSpacingMm;
            return frame(place) ? ((i + j) % 4 == 0 ? 3000 : -600)
                                : int(scan->voxels()[(std::size_t(k) * kLyingSize.y + j) * kLyingSize.x + i]);
        });
        const HiddenTable table = hidden(*framed);
        QVERIFY(table.body && std::abs(table.hiddenMl - hidden(*scan).hiddenMl) < 1);
        std::size_t lost = 0;
        for (std::size_t i = 0; i < framed->voxels().size(); ++i)
            lost += framed->voxels()[i] > 2500 && table.body->voxels()[i] != framed->voxels()[i];
        QCOMPARE(lost, std::size_t(0));
        QVERIFY(table.bodyBox.size.y > hidden(*scan).bodyBox.size.y);
    }

    void metalInTheBodyIsItsOwn() {
        const Lying patient = onTable(5);
        const auto implanted = makeVolume(kLyingSize, kLyingSpacingMm, [&](int i, int j, int k) {
            const bool pin = i == 64 && std::abs(j - 48) < 3 && k == 20;
            return pin ? 3000 : int(patient.volume->voxels()[(std::size_t(k) * 96 + j) * 128 + i]);
        });
        const HiddenTable table = hidden(*implanted);
        QVERIFY(table.undecided.empty() && table.body && table.metalMl == 0);
        QVERIFY(segment::tableText(table).find("Metal") == std::string::npos);
    }

    void theSentencesSayWhatIsHidden() {
        HiddenTable table;
        table.body =
            std::make_shared<const Volume>(VolumeGeometry::aligned({1, 1, 1}, dvec3(1), dvec3(0)), Voxels(1, 0));
        table.hiddenMl = 884.4;
        QCOMPARE(segment::tableText(table), std::string("Table and holder hidden: 884 ml outside the body."));
        table.cutMl = 33.7;
        QCOMPARE(segment::tableText(table), std::string("Table and holder hidden: 884 ml outside the body. 34 ml of it "
                                                        "touched the skin: check the edge."));
        table.cutMl = 0;
        table.metalMl = 2.7;
        QCOMPARE(segment::tableText(table),
                 std::string("Table and holder hidden: 884 ml outside the body. Metal outside "
                             "the body is kept, with what it touches: 3 ml."));
        table.metalMl = 0;
        table.parts = 2;
        QCOMPARE(segment::tableText(table), std::string("Table and holder hidden: 884 ml outside the body. 2 separate "
                                                        "parts are kept."));
    }

    void imagesSayByWhichRule() {
        const HiddenTable table = hidden(*onTable(3).volume);
        const QString expected = QString("%1 ml of %2 ml, rule 2, -250 HU, 3 mm, 10 mm")
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
        for (int last = 1; last <= steps; last += last < 10 ? 1 : steps / 10) {
            int told = 0;  // how often the calling thread asks hangs on what the others take
            const auto result = segment::hideTable(*patient, [&](double fraction, std::string_view step) {
                return fraction >= 0 && fraction <= 1 && !step.empty() && ++told < last;
            });
            const bool stopped = told == last;
            QVERIFY(stopped || last > 1);
            QVERIFY(told <= last);
            QCOMPARE(!result && result.error().kind == ErrorKind::cancelled, stopped);
        }
    }
};

QTEST_APPLESS_MAIN(TableFactsTest)
#include "table_facts_test.moc"
