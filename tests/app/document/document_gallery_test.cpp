/// What choosing a look does to the document, and what a volume does to the looks.

#include <QTest>

#include "tests/support/desktop/told_document.h"

namespace pdr::app {

namespace {

/// "first" goes with any scan, "cut" brings a cut and another model, "contrast" is drawn for blood of 400 HU.
std::vector<NamedLook> looks() {
    std::vector<NamedLook> looks = twoLooks();
    looks[0].suits.contrast = false;
    looks[1].name = "cut";
    looks[1].model = Model::multipleScattering;
    looks[1].cut = CutHint{CutHint::Plane::coronal, 0.25f};
    looks[0].group = looks[1].group = LookGroup::bones;
    looks.push_back(looks[0]);
    looks[2].name = "contrast";
    looks[2].suits.contrast = true;
    looks[2].bloodHu = 400.0f;
    looks[2].look.transferFunction.nodes = {{0, 0}, {400, 1}, {2000, 1}};
    return looks;
}

}  // namespace

class TestDocumentGallery : public QObject {
    Q_OBJECT

  private slots:
    void aLookBringsItsModelAndItsCutInOneStep();
    void theCutOfALookGoesWithIt();
    void theFirstLookThatMakesSenseIsShown();
    void contrastLiesWhereTheBloodIs();
    void theBrightnessIsSuggestedOnce();
    void otherLooksLeaveTheImageAsItIs();
};

void TestDocumentGallery::aLookBringsItsModelAndItsCutInOneStep() {
    Document document(looks());
    document.open(cube());
    const ImageSetup before = document.setup();
    document.chooseLook(1);
    QCOMPARE(document.look(), 1);
    QVERIFY(document.scene().model == Model::multipleScattering);
    QCOMPARE(document.scene().clip.planes.size(), std::size_t(1));
    document.undo();
    QVERIFY(document.setup() == before && !document.canUndo());
}

void TestDocumentGallery::theCutOfALookGoesWithIt() {
    Document document(looks());
    document.open(cube());
    document.chooseLook(1);
    document.chooseLook(0);
    QVERIFY(document.setup().clip.empty());
    ImageSetup own = document.setup();
    own.clip.planes = {{{0, 100, 200}, {1, 0, 0}}};
    document.setSetup(own);
    document.chooseLook(1);
    QVERIFY(document.setup().clip == own.clip);  // the user's own stays, alone
    document.chooseLook(0);
    QVERIFY(document.setup().clip == own.clip);
    own.clip = {};
    document.setSetup(own);
    document.chooseLook(1);
    document.open(cube());  // another series: cut through its own body
    QCOMPARE(document.setup().clip.planes.size(), std::size_t(1));
}

void TestDocumentGallery::theFirstLookThatMakesSenseIsShown() {
    Document document(looks());
    segment::HiddenTable table;
    table.bodyBox = cube()->geometry();
    document.open(cube(), table, segment::Findings{400, 3000, 0, 300.0f});
    QCOMPARE(document.look(), 1);
    QVERIFY(!document.looks().whyUnsuited(0).empty() && document.looks().whyUnsuited(2).empty());
    document.open(cube(), table, segment::Findings{});
    QCOMPARE(document.look(), 1);  // which makes sense here, too
    document.chooseLook(0);
    document.open(cube(), table, segment::Findings{});
    QCOMPARE(document.look(), 0);
}

void TestDocumentGallery::contrastLiesWhereTheBloodIs() {
    Document document(looks());
    segment::HiddenTable table;
    table.bodyBox = cube()->geometry();
    document.open(cube(), table, segment::Findings{400, 3000, 0, 300.0f});
    QCOMPARE(document.looks()[2].look.transferFunction.nodes[1].hu, 300.0f);
    document.chooseLook(2);
    QCOMPARE(document.scene().transferFunction.nodes[1].hu, 300.0f);
    document.open(cube(), table, segment::Findings{400, 3000, 0, 500.0f});
    QCOMPARE(document.look(), 2);
    QCOMPARE(document.scene().transferFunction.nodes[1].hu, 500.0f);
}

void TestDocumentGallery::theBrightnessIsSuggestedOnce() {
    Document document(looks());
    document.suggestBrightness(0, 1);  // of no volume
    document.open(cube());
    document.suggestBrightness(0, 1.5);
    QCOMPARE(document.setup().stops, 1.5);
    QVERIFY(!document.canUndo());
    document.suggestBrightness(0, -1);
    QCOMPARE(document.setup().stops, 1.5);
    document.suggestBrightness(1, -0.5);
    QCOMPARE(document.setup().stops, 1.5);  // another look's
    document.chooseLook(1);
    QCOMPARE(document.setup().stops, -0.5);
    document.open(cube());
    document.setView(StandardView::left);
    document.suggestBrightness(1, 0.7);
    document.undo();
    QCOMPARE(document.setup().stops, 0.7);  // nobody chose another
    document.open(cube());
    document.setBrightness(0.3);
    document.suggestBrightness(1, 2);
    QCOMPARE(document.setup().stops, 0.3);  // the hand was sooner
}

void TestDocumentGallery::otherLooksLeaveTheImageAsItIs() {
    Document document(looks());
    document.open(cube());
    const Scene before = document.scene();
    std::vector<NamedLook> more = looks();
    more.push_back(more[0]);
    more.back().name = "mine";
    document.setLooks(more);
    QVERIFY(document.scene() == before);
    QCOMPARE(document.looks().fitted().size(), std::size_t(4));
    document.setLooks({more[1]});
    QVERIFY(document.scene() == before);
    QCOMPARE(document.look(), -1);
}

}  // namespace pdr::app

QTEST_APPLESS_MAIN(pdr::app::TestDocumentGallery)
#include "document_gallery_test.moc"
