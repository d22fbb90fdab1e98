/// Looks by name: which one a changed look was, also where names begin alike.

#include <QTest>

#include "app/changed_look.h"
#include "app/fitted_looks.h"

namespace pdr::app {

class TestFittedLooks : public QObject {
    Q_OBJECT

  private slots:
    void aChangedLookIsKnownByItsName();
    void aLookIsChangedOnce();
    void theBeginningIsTheLookOfThatNameAlone();
    void aBrightnessOfTheUserStays();
};

static FittedLooks bones() {
    std::vector<NamedLook> looks(3);
    looks[0].name = "Bone";
    looks[1].name = "Bones alone";
    looks[2].name = "Mine";
    looks[0].group = looks[1].group = LookGroup::bones;
    looks[0].look.phaseG = 0.1f;
    looks[1].look.phaseG = 0.2f;
    looks[2].look.phaseG = 0.3f;
    return FittedLooks(looks);
}

void TestFittedLooks::aChangedLookIsKnownByItsName() {
    const FittedLooks looks = bones();
    PictureSetup setup;
    setup.look = looks[1].look;
    QCOMPARE(looks.nameOf(setup, "Bone"), std::string("Bones alone"));
    setup.look.phaseG = 0.9f;
    QCOMPARE(looks.nameOf(setup, "Bone"), std::string("Bone (changed)"));
    setup.lookName = "Bone";
    QCOMPARE(looks.indexOf(setup), -1);
}

void TestFittedLooks::aLookIsChangedOnce() {
    QCOMPARE(changedName("Bone"), std::string("Bone (changed)"));
    QCOMPARE(changedName(changedName("Bone")), std::string("Bone (changed)"));
    QCOMPARE(unchangedName("Bone (changed)"), std::string("Bone"));
    QCOMPARE(unchangedName("Bone"), std::string("Bone"));
}

void TestFittedLooks::theBeginningIsTheLookOfThatNameAlone() {
    const FittedLooks looks = bones();
    for (int i = 0; looks.holds(i); ++i) {
        QCOMPARE(looks.beginningOf(looks[i].name), &looks[i]);
        QCOMPARE(looks.beginningOf(changedName(looks[i].name)), &looks[i]);
    }
    QVERIFY(!looks.beginningOf("Bones"));
    QVERIFY(!looks.beginningOf("Bone beside contrast"));
    QVERIFY(!looks.beginningOf(""));
}

void TestFittedLooks::aBrightnessOfTheUserStays() {
    FittedLooks looks = bones();
    QVERIFY(looks.suggestStops(0, 1.5) && !looks.suggestStops(0, 2) && !looks.suggestStops(2, 1));
    QCOMPARE(looks.stops(0), 1.5);
    QCOMPARE(looks.stops(2), 0.0);
    looks.fitTo({});
    QCOMPARE(looks.stops(0), 0.0);
}

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::TestFittedLooks)
#include "fitted_looks_test.moc"
