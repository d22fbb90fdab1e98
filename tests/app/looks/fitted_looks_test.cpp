/// Looks by name: which one a changed look was, also where names begin alike.

#include <QTest>

#include "app/looks/fitted_looks.h"

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
    ImageSetup setup;
    setup.look = looks[1].look;
    setup = looks.named(setup, "Bone");
    QCOMPARE(lookTitle(setup), std::string("Bones alone"));
    QVERIFY(!setup.lookChanged);
    setup.look.phaseG = 0.9f;
    QCOMPARE(lookTitle(looks.named(setup, "Bone")), std::string("Bone (changed)"));
    setup.lookName = "Bone";
    QCOMPARE(looks.indexOf(setup), -1);
}

void TestFittedLooks::aLookIsChangedOnce() {
    const FittedLooks looks = bones();
    ImageSetup setup;
    for (int i = 1; i <= 2; ++i) {
        setup.look.phaseG = 0.5f + 0.1f * float(i);
        setup = looks.named(setup, i == 1 ? "Bone" : setup.lookName);
        QVERIFY(setup.lookChanged);
        QCOMPARE(setup.lookName, std::string("Bone"));
        QCOMPARE(lookTitle(setup), std::string("Bone (changed)"));
    }
}

void TestFittedLooks::theBeginningIsTheLookOfThatNameAlone() {
    const FittedLooks looks = bones();
    ImageSetup setup;
    for (int i = 0; looks.holds(i); ++i) {
        setup.lookName = looks[i].name;
        for (const bool changed : {false, true}) {
            setup.lookChanged = changed;
            QCOMPARE(looks.beginningOf(setup), &looks[i]);
        }
    }
    QVERIFY(!looks.lookCalled("Bones"));
    QVERIFY(!looks.lookCalled("Bone beside contrast"));
    QVERIFY(!looks.lookCalled(""));
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
