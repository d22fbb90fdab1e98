/// Texts that rooms without Qt produce exist in every language of the window: notes, refusals, findings, errors.

#include <QTest>

#include <algorithm>
#include <set>

#include "app/plan/plan_file.h"
#include "app/wire/map_reader.h"
#include "app/wire/map_writer.h"
#include "dicom/import.h"
#include "dicom/read/refusal.h"
#include "dicom/stack/stack_geometry.h"
#include "dicom/stack/stack_notes.h"
#include "render/accuracy/effect_cost_text.h"
#include "render/base/errors.h"
#include "render/film/health_text.h"
#include "render/prepare/needs.h"
#include "render/scene/image_setup.h"
#include "render/segment/body_parts.h"
#include "render/segment/hidden_table.h"
#include "render/timing/split_choice.h"
#include "tests/support/dicom/slice_folder.h"
#include "tests/support/scenes/scenes.h"
#include "ui/text/language.h"
#include "ui/text/room_text.h"

namespace pdr {
namespace {

using dicom::SliceHeader;
using dicom::SlicePlane;

SlicePlane planeAt(const char* name, double z) {
    return {name, {512, 512}, dvec3(0, 0, z), dvec3(1, 0, 0), dvec3(0, 1, 0), dvec2(0.5, 0.7)};
}

/// Adds the reasons of stacks that are not even.
void addVerdicts(std::vector<Text>& texts) {
    const auto add = [&](std::vector<SlicePlane> slices) {
        texts.push_back(dicom::analyseStack(slices).verdict.reason);
    };
    const auto with = [](const auto& change) {
        std::vector<SlicePlane> slices{planeAt("a.dcm", 0), planeAt("b.dcm", 5), planeAt("c.dcm", 10)};
        change(slices[1]);
        return slices;
    };
    add({planeAt("a.dcm", 0)});
    add({planeAt("a.dcm", 0), planeAt("b.dcm", 5.5), planeAt("c.dcm", 20)});
    add(with([](SlicePlane& slice) { slice.size.x = 256; }));
    add(with([](SlicePlane& slice) { slice.position.reset(); }));
    add(with([](SlicePlane& slice) { slice.spacingMm = dvec2(0, 1); }));
    add(with([](SlicePlane& slice) { slice.columnDirection = dvec3(1, 0, 0); }));
    add(with([](SlicePlane& slice) { slice.rowDirection = dvec3(0, 0, 1); }));
    add(with([](SlicePlane& slice) { slice.position->x = 3; }));
    add({planeAt("a.dcm", 0), planeAt("b.dcm", 0.01), planeAt("c.dcm", 10)});
    std::vector<SlicePlane> tilted = with([](SlicePlane&) {});
    for (int k = 0; k < 3; ++k)
        tilted[std::size_t(k)].position->y = k;
    texts.push_back(dicom::analyseStack(tilted).verdict.notes.at(0).text);
    for (int k = 0; k < 3; ++k)
        tilted[std::size_t(k)].position->y = 5 * k;
    add(tilted);
}

/// Adds the reasons of images that are no slices.
void addRefusals(std::vector<Text>& texts) {
    const auto add = [&](const auto& change) {
        SliceHeader header;
        header.series.modality = "CT";
        header.transferSyntaxUid = "1.2.840.10008.1.2.1";
        header.pixelBytes = 8;
        header.columns = header.rows = 2;
        header.format = {16, 16, 15, false, 1, "MONOCHROME2"};
        change(header);
        if (const auto refusal = dicom::refuseSlice(header))
            texts.push_back(refusal->reason);
    };
    add([](SliceHeader& header) { header.pixelBytes = 0; });
    add([](SliceHeader& header) { header.pixelBytes = 0, header.series.modality = "SR"; });
    add([](SliceHeader& header) { header.series.modality.clear(); });
    add([](SliceHeader& header) { header.series.modality = "MR"; });
    add([](SliceHeader& header) { header.imageType = "ORIGINAL\\PRIMARY\\LOCALIZER"; });
    add([](SliceHeader& header) { header.format.photometric = "RGB"; });
    add([](SliceHeader& header) { header.transferSyntaxUid = "1.2.840.10008.1.2.4.90"; });
    add([](SliceHeader& header) { header.frames = 7; });
    add([](SliceHeader& header) { header.frames = 0, header.hasFrameGroups = true; });
    add([](SliceHeader& header) { header.hasPixelsTwice = true; });
    add([](SliceHeader& header) { header.columns = 0; });
    add([](SliceHeader& header) { header.format.bitsStored = 17; });
    add([](SliceHeader& header) { header.pixelBytes = 6; });
    add([](SliceHeader& header) { header.meaning.rescaleIsBroken = true; });
}

/// Adds the notes on stacks that load all the same.
void addNotes(std::vector<Text>& texts) {
    for (const std::size_t odd : {std::size_t(1), std::size_t(2)}) {
        std::vector<SliceHeader> headers(3);
        for (std::size_t k = 0; k < 3; ++k) {
            headers[k].instanceNumber = int(k) + 1 + (k == 2 ? int(odd) : 0);
            headers[k].meaning.slope = 1;
            if (k >= odd)
                headers[k].meaning.intercept = 0;
            headers[k].meaning.unit = k == 0 ? "OD" : "HU";
            headers[k].frameOfReferenceUid = std::to_string(k);
            headers[k].isLossy = k < odd;
            headers[k].lossyRatio = 8.5;
        }
        std::vector<const SliceHeader*> slices;
        for (const SliceHeader& header : headers)
            slices.push_back(&header);
        for (const dicom::Note& note :
             dicom::notesOn(slices, {}, odd == 1 ? std::set<int>{1, 2, 4} : std::set<int>{1, 2, 5}))
            texts.push_back(note.text);
    }
}

void addFindings(std::vector<Text>& texts) {
    segment::HiddenTable table;
    table.undecided = phrase("nothing is as thick as 20 mm");
    texts.push_back(segment::tableText(table));
    table = {};
    table.body = std::make_shared<const Volume>(VolumeGeometry::aligned({1, 1, 1}, dvec3(1), dvec3(0)), Voxels(1, 0));
    table.hiddenMl = 16800;
    table.cutMl = 33.7;
    table.parts = 2;
    table.metalMl = 0.5;
    texts.push_back(segment::tableText(table));
}

/// Adds the texts on parts of a volume of air, which has none, and of one that is all bone.
void addParts(std::vector<Text>& texts) {
    for (const int hu : {-1000, 40, 1200}) {
        const auto volume = test::makeVolume({24, 24, 24}, dvec3(2), [&](int i, int j, int k) {
            return i % 23 && j % 23 && k % 23 ? hu + (i + j + k) % 2 : -1000;
        });
        const segment::BodyParts parts(volume);
        for (const segment::PartMask& mask : {parts.peeled(7.5, volume->geometry(), noProgress),
                                              parts.lungs(segment::Use::shown, volume->geometry(), noProgress),
                                              parts.bones(segment::Use::shown, volume->geometry(), noProgress),
                                              parts.bones(segment::Use::hidden, volume->geometry(), noProgress)})
            texts.push_back(mask ? (*mask)->hidden() : mask.error().text());
    }
}

void addErrors(std::vector<Text>& texts) {
    texts.push_back(notEnoughMemory(phrase("to decode it"), "", "").what);
    texts.push_back(memoryTooSmall("cuda", 3'000'000'000, 20'000'000).what);
    ImageSetup setup;
    setup.stops = 100;
    texts.push_back(check(setup).error().what);
    for (const char* json : {"[", "{}", R"({"format": "x"})", R"({"format": "pdrender-plan", "version": 2})",
                             R"({"format": "pdrender-plan", "version": 1, "look": {}})"})
        texts.push_back(app::planFromText(json, "plan.json").error().what);
}

/// Adds the reasons why effects are simulated or left out, in scenes that have all of them, some and none.
void addEffects(std::vector<Text>& texts) {
    const auto add = [&](const Scene& scene) {
        for (const Effect& effect : needs(scene)) {
            texts.push_back(effect.name);
            texts.push_back(effect.reason);
        }
    };
    Scene scene = test::plainScene(test::bumpyVolume({20, 20, 20}, dvec3(1), 1), 0.3f);
    for (const Model model : kModels) {
        scene.model = model;
        for (const float amount : {0.0f, 0.6f}) {
            scene.gradientFactor = scene.phaseG = amount;
            scene.camera.apertureMm = double(amount);
            scene.environment.radiance = vec3(amount);
            scene.lights.resize(amount > 0 ? 1 : 0);
            if (amount > 0)
                scene.lights.push_back(SphereLight{.radiusMm = 2, .visible = true});
            add(scene);
        }
    }
}

void addFigures(std::vector<Text>& texts) {
    for (const double high : {-0.1, 0.1, 0.3}) {
        texts.push_back(costText({high - 0.2, high - 0.1, high}));
        texts.push_back(shareText({high - 0.2, high - 0.1, high}));
    }
    texts.push_back(levelsText(Foretold{25.6, 24.9, 26.3}));
    texts.push_back(timeLeftText({0.55, 0.48, 0.63}));
    texts.push_back(timeLeftText({12.5, 10.5, 15.5}));
    Health health;
    for (FaultCount& fault : health.faults)
        fault.count = 3;
    for (const Text& line : healthLines(health))
        texts.push_back(line);
}

/// Adds the reasons of splitting work, from one node to many, and from fast ones to slow.
void addSplits(std::vector<Text>& texts) {
    SplitFacts facts{1e6, 64, 1, 1e-8, 1e-3, 1e-3, 0, 200};
    const auto add = [&] { texts.push_back(chooseSplit(facts).reason); };
    add();
    facts.nodes = 4;
    add();
    facts.samples = 1024;
    add();
    facts.pixels = 1e3;
    add();
    facts.samples = 128;
    add();
    facts.bytesPerSecond = 1e3;
    add();
}

/// Adds the reasons that a node reports over the wire.
void addReasonsOfNodes(std::vector<Text>& texts) {
    for (const Text& reason : {notEnoughMemory(phrase("for the scene: %1", bytesText(13'370'000)), "", "").what,
                               memoryTooSmall("cuda", 3'000'000'000, 20'000'000).text()}) {
        wire::MapWriter writer;
        writer.phrase(1, 2, reason);
        const wire::Bytes map = writer.finish();
        wire::MapReader reader(map);
        texts.emplace_back();
        reader.phrase(1, 2, texts.back());
    }
}

std::vector<Text> everything() {
    std::vector<Text> texts;
    addVerdicts(texts);
    addRefusals(texts);
    addNotes(texts);
    addFindings(texts);
    addParts(texts);
    addErrors(texts);
    addEffects(texts);
    addFigures(texts);
    addSplits(texts);
    addReasonsOfNodes(texts);
    return texts;
}

/// Collects the names and numbers that a text is made of, at any depth.
void collect(const Text& text, QStringList& names) {
    if (text.kind() == Text::Kind::words && !text.empty())
        names << QString::fromStdString(text);
    if (text.kind() == Text::Kind::number)
        names << ui::localNumber(text);
    for (const Text& argument : text.arguments())
        collect(argument, names);
}

bool hasWords(const std::string& text) {
    return std::ranges::count_if(text, [](unsigned char c) { return std::isalpha(c); }) > 2;
}

/// Returns whether a text has no words that would be the same in every language.
bool isTranslated(const Text& text) {
    if (text.kind() == Text::Kind::pattern &&
        ui::inWords(text.pattern().c_str()) == QString::fromStdString(text.pattern()) && hasWords(text.pattern()))
        return false;
    return std::ranges::all_of(text.arguments(), isTranslated);
}

}  // namespace

class SentencesTest : public QObject {
    Q_OBJECT

  private slots:
    void cleanup() { ui::speak(*QCoreApplication::instance(), "en"); }

    void theWindowSaysInEnglishWhatTheRoomSays() {
        ui::speak(*QCoreApplication::instance(), "en");
        const std::vector<Text> texts = everything();
        QVERIFY(texts.size() > 40);
        for (const Text& text : texts) {
            QVERIFY(!text.empty());
            QCOMPARE(ui::inWords(text), QString::fromStdString(text));
        }
    }

    void everySentenceIsSaidInTheWindowsLanguage_data() {
        QTest::addColumn<QString>("language");
        QTest::newRow("de") << "de";
        QTest::newRow("es") << "es";
    }

    void everySentenceIsSaidInTheWindowsLanguage() {
        QFETCH(QString, language);
        ui::speak(*QCoreApplication::instance(), language);
        for (const Text& text : everything()) {
            const QString said = ui::inWords(text);
            QVERIFY2(said != QString::fromStdString(text) || !hasWords(text), text.c_str());
            QVERIFY2(isTranslated(text), text.c_str());
            QStringList names;
            collect(text, names);
            for (const QString& name : names)
                QVERIFY2(said.contains(name), qPrintable(said + ": " + name));
            QVERIFY2(ui::sentence(text).endsWith('.'), text.c_str());
        }
    }

    void everyStepIsSaidInTheWindowsLanguage_data() { everySentenceIsSaidInTheWindowsLanguage_data(); }
    void everyStepIsSaidInTheWindowsLanguage() {
        QFETCH(QString, language);
        std::set<std::string> steps;
        const Progress listening = [&](double, std::string_view step) { return steps.insert(std::string(step)), true; };
        const test::SliceFolder folder;
        folder.addStack(3);
        const auto scan = dicom::scanFolder(folder.path(), listening);
        QVERIFY(scan && dicom::loadSeries(scan->series.at(0), dicom::Padding::maskAsAir, listening));
        const auto volume = test::makeVolume({24, 24, 24}, dvec3(2), [](int, int, int) { return 40; });
        QVERIFY(bool(segment::hideTable(*volume, listening)));
        (void)segment::BodyParts(volume).lungs(segment::Use::shown, volume->geometry(), listening);
        QVERIFY(steps.size() >= 6);
        ui::speak(*QCoreApplication::instance(), language);
        for (const std::string& step : steps)
            QVERIFY2(ui::inWords(step) != QString::fromStdString(step), step.c_str());
    }

    void namesStayAsTheyAre() {
        ui::speak(*QCoreApplication::instance(), "de");
        const Text text = phrase("%1 is one slice; a volume needs at least two", std::string("position"));
        QVERIFY(ui::inWords(text).startsWith("position "));
        QCOMPARE(ui::inWords(phrase("%1 %2", std::string("%2"), fixedNumber(1.5, 1))), QString("%2 1,5"));
    }

    void sentencesKeepTheirForm() {
        ui::speak(*QCoreApplication::instance(), "de");
        const Text text = joined(Text::sentence(phrase("the file cannot be opened")), phrase("Try again."));
        QCOMPARE(ui::inWords(text), QString("Die Datei kann nicht geöffnet werden. Noch einmal versuchen."));
        QVERIFY(!isTranslated(phrase("a sentence that nobody has translated")));
    }
};

}  // namespace pdr

QTEST_GUILESS_MAIN(pdr::SentencesTest)
#include "sentences_test.moc"
