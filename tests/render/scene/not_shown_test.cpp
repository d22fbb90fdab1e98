#include <QTest>

#include "render/scene/not_shown.h"
#include "render/scene/part_styles.h"
#include "tests/support/scenes/part_scenes.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

/// A scene whose map has so many parts, "part 1" and so on, and is shown as `styles` say.
Scene parted(int count, const PartStyles& styles) {
    Scene scene;
    scene.volume = test::makeVolume({4, 4, 4}, dvec3(1), [](int, int, int) { return 20; });
    scene.transferFunction = {4, {{.hu = 0, .opacity = 0}, {.hu = 30, .opacity = 1}}};
    auto map = std::make_shared<LabelMap>(*test::labelled(*scene.volume, count, [](ivec3 at) { return at.x; }));
    for (int n = 0; n < count; ++n)
        map->parts[std::size_t(n)].name = standardName(n + 1);
    return withParts(std::move(scene), std::move(map), styles);
}

PartStyles hidden(const std::vector<std::string>& names) {
    PartStyles styles;
    for (const std::string& name : names)
        styles.styles.push_back({.part = name, .state = PartState::hidden});
    return styles;
}

}  // namespace

/// An image says what of the patient it leaves out.
class NotShownTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsShownIsNotNamed() {
        QCOMPARE(notShown(parted(3, {})), Text());
        QCOMPARE(notShown(parted(3, {.inColour = true})), Text());
    }

    void hiddenPartsAndGhostsAreNamed() {
        QCOMPARE(notShown(parted(3, hidden({"part 2"}))), Text("Hidden: part 2."));
        PartStyles styles = hidden({"part 1"});
        styles.rest = PartState::ghost;
        styles.styles.push_back({.part = "part 3", .state = PartState::ghost});
        const Text said = notShown(parted(3, styles));
        QCOMPARE(said, Text("Hidden: part 1. Ghost: rest of the body, part 3."));
        QCOMPARE(said.kind(), Text::Kind::pattern);  // it can be translated
    }

    /// Parts that are as empty as the rest have no curve of their own.
    void partsAreHiddenWithTheRest() {
        PartStyles styles = hidden({"part 1", "part 2"});
        styles.rest = PartState::hidden;
        QCOMPARE(notShown(parted(3, styles)), Text("Hidden: rest of the body, part 1, part 2."));
    }

    void manyAreCounted() {
        QCOMPARE(notShown(parted(6, hidden({"part 1", "part 2", "part 3", "part 4", "part 5"}))),
                 Text("Hidden: part 1, part 2, part 3, part 4, part 5."));
        QCOMPARE(notShown(parted(6, hidden({"part 1", "part 2", "part 3", "part 4", "part 5", "part 6"}))),
                 Text("Hidden: part 1, part 2, part 3, part 4 and 2 more."));
    }

    void oneNameIsSaidOnce() {
        Scene scene = parted(3, hidden({"part 1", "part 2"}));
        auto map = std::make_shared<LabelMap>(*scene.parts.map);
        map->parts[1].name = "part 1";
        scene.parts.map = map;
        QCOMPARE(notShown(scene), Text("Hidden: part 1."));
    }

    void whatTheMaskHidesComesFirst() {
        Scene scene = parted(3, hidden({"part 2"}));
        const MaskGrid grid{scene.volume->size(), ivec3(0)};
        scene.mask = maskOf(grid, "Peeled.", [](dvec3) { return std::int16_t(kSeen); });
        QCOMPARE(notShown(scene), Text("Peeled. Hidden: part 2."));
        scene.parts = {};
        QCOMPARE(notShown(scene), Text("Peeled."));
    }

    /// It shows no curve, and so hides no part.
    void theMaximumHidesNone() {
        Scene scene = parted(3, hidden({"part 2"}));
        scene.model = Model::maximumIntensity;
        QVERIFY(scene.parts.map && notShown(scene).empty());
    }
};

QTEST_APPLESS_MAIN(NotShownTest)
#include "not_shown_test.moc"
