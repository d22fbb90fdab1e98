/// Parts of the scan in a document: where they come from is a step to undo, and their voxels arrive later.

#include <QTest>

#include "app/document/part_edits.h"
#include "tests/support/desktop/told_document.h"

namespace pdr::app {
namespace {

const PartSources kVessels{.vessels = 1}, kFile{.labels = "0123"};

std::shared_ptr<const ScanParts> someParts(const Volume& volume) {
    LabelMap map;
    map.geometry = volume.geometry();
    map.labels.assign(volume.voxels().size(), 0);
    map.labels[3] = 1;
    map.labels[5] = 2;
    map.parts = {{"vessels", {200, 40, 40}}, {"liver", {40, 200, 40}}};
    return std::make_shared<const ScanParts>(
        ScanParts{std::make_shared<const LabelMap>(std::move(map)), {{"a rule", true, 1}, {"a file", false, 2}}});
}

/// A document with parts, and what it wanted to have made.
struct Parted : Told {
    std::vector<PartSources> wanted;
    std::shared_ptr<const ScanParts> parts = someParts(*document.scan());
    PartEdits edits{document};

    Parted() {
        QObject::connect(&document, &Document::partsWanted,
                         [this](const PartSources& sources) { wanted.push_back(sources); });
    }
};

}  // namespace

class DocumentPartsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Parts that look as all tissue does change nothing in the image, which goes on.
    void addingPartsKeepsTheImage() {
        Parted told;
        Document& document = told.document;
        const std::size_t scenes = told.scenes.size();
        told.edits.setParts(kVessels, told.parts);
        QVERIFY(document.scanParts() == told.parts && document.plan().partSources == kVessels);
        QCOMPARE(told.scenes.size(), scenes);
        QVERIFY(has(told.reports.back(), Changes::partSources) && told.wanted.empty());
        QCOMPARE(document.undoText(), Text(phrase("Undo adding parts")));
        document.undo();
        QVERIFY(!document.scanParts() && !document.canUndo());
        document.redo();
        QVERIFY(document.scanParts() == told.parts && told.wanted.empty());
        told.edits.setParts({}, nullptr);
        QCOMPARE(document.undoText(), Text(phrase("Undo removing parts")));
        QVERIFY(!document.scanParts());
    }

    /// Who looks for vessels again finds the same ones.
    void theSamePartsAgainKeepTheImage() {
        Parted told;
        told.edits.setParts(kVessels, told.parts);
        told.edits.setState({2}, PartState::hidden);
        const std::size_t scenes = told.scenes.size();
        const Text undo = told.document.undoText();
        told.edits.setParts(kVessels, told.parts);
        QCOMPARE(told.scenes.size(), scenes);
        QCOMPARE(told.document.undoText(), undo);
        const auto others = someParts(*told.document.scan());
        told.edits.setParts(kVessels, others);
        QVERIFY(told.document.scene().parts.map == others->map && told.scenes.size() == scenes + 1);
    }

    void eachEditOfAPartIsOneStep() {
        Parted told;
        Document& document = told.document;
        told.edits.setParts(kVessels, told.parts);
        told.edits.setState({0, 2}, PartState::hidden);
        QVERIFY(document.scene().parts.map == told.parts->map && bool(document.scene().check()));
        QCOMPARE(document.scene().parts.curves.size(), std::size_t(1));  // the liver is as empty as the rest
        QCOMPARE(document.undoText(), Text(phrase("Undo changing how a part is shown")));
        told.edits.setColour({1}, vec3(0.5f));
        told.edits.setLook({1}, 1);
        const PartStyle vessels = styleOf(document.setup().look.parts, "vessels");
        QVERIFY(vessels.look == "second" && !vessels.colour);
        QVERIFY(vessels.transferFunction == document.looks()[1].look.transferFunction);
        QCOMPARE(document.look(), -1);
        document.undo();
        QVERIFY(styleOf(document.setup().look.parts, "vessels").colour == vec3(0.5f));
        document.undo();
        document.undo();
        QVERIFY(document.setup().look.parts.empty() && !document.scene().parts.map && document.look() == 0);
        told.edits.setLook({1}, 1);
        told.edits.setLook({1}, -1);
        QVERIFY(document.setup().look.parts.empty());
    }

    void editsWithoutPartsDoNothing() {
        Parted told;
        told.edits.setState({0, 1}, PartState::hidden);
        QVERIFY(!told.document.canUndo());
        told.edits.setParts(kVessels, told.parts);
        told.edits.setState({3, -1}, PartState::hidden);
        QVERIFY(told.document.setup().look.parts.empty());
    }

    /// A plan that is opened names parts, which are made beside the image.
    void aPlanWantsItsParts() {
        Parted told;
        Document& document = told.document;
        Plan plan = document.plan();
        plan.partSources = kVessels;
        plan.image.look.parts.rest = PartState::ghost;
        document.edit(plan);
        QCOMPARE(told.wanted, std::vector{kVessels});
        QVERIFY(document.scene().maskAwaited && !document.scene().parts.map);
        document.takeParts(kFile, told.parts);  // of another plan
        QVERIFY(!document.scanParts());
        document.takeParts(kVessels, told.parts);
        QVERIFY(document.scene().parts.map == told.parts->map && !document.scene().maskAwaited);
        QVERIFY(has(told.reports.back(), Changes::mask));
        document.undo();
        QVERIFY(!document.canUndo() && !document.scene().parts.map);
    }

    void withoutThemThePlanStays() {
        Parted told;
        Document& document = told.document;
        Plan plan = document.plan();
        plan.partSources = {.labels = "0123", .vessels = 1};
        plan.image.look.parts.rest = PartState::ghost;
        document.edit(plan);
        told.edits.dropLabels();
        QVERIFY(document.plan().partSources == kVessels && told.wanted.back() == kVessels);
        told.edits.keepParts();
        QVERIFY(document.plan().partSources.empty() && !document.scene().maskAwaited);
        QVERIFY(document.setup().look.parts.rest == PartState::ghost);
        document.undo();
        QVERIFY(!document.canUndo());
    }

    void theyGoWithTheirScan() {
        Parted told;
        told.edits.setParts(kVessels, told.parts);
        told.edits.setState({2}, PartState::hidden);
        told.document.open(cube());
        QVERIFY(!told.document.scanParts() && told.document.plan().partSources.empty());
        QVERIFY(!told.document.scene().parts.map && told.wanted.empty());
        told.scenes.clear();
        QCOMPARE(told.parts.use_count(), 1L);
        QCOMPARE(told.parts->map.use_count(), 1L);
        told.document.close();
        told.edits.setParts(kVessels, told.parts);
        told.document.takeParts(kVessels, told.parts);
        QVERIFY(!told.document.scanParts());
    }
};

}  // namespace pdr::app

QTEST_APPLESS_MAIN(pdr::app::DocumentPartsTest)
#include "document_parts_test.moc"
