#include <QTest>

#include <algorithm>
#include <cstring>

#include "app/coordinator/scene_order.h"
#include "app/wire/content_hash.h"
#include "tests/support/scenes/masks.h"
#include "tests/support/scenes/part_scenes.h"
#include "tests/support/scenes/tissue_scene.h"

using namespace pdr;
using namespace pdr::nodes;

namespace {

wire::Hash hashOf(const std::shared_ptr<const void>&, std::span<const std::byte> bytes) {
    return wire::contentHash(std::array{std::byte{7}}, bytes);
}

Scene fullScene() {
    Scene scene = test::tissueScene();
    auto sky = std::make_shared<EnvironmentImage>();
    sky->size = {4, 2};
    sky->texels.assign(8, vec3(0.5f, 0.25f, 1));
    scene.environment.image = sky;
    const MaskGrid grid = MaskGrid::over(scene.volume->geometry());
    scene.mask = maskOf(grid, "Peeled 7 mm: skin is not shown.",
                        [](dvec3 place) { return std::int16_t(place.x > 20 ? kSeen : 0); });
    scene.clip.planes = {{{1, 2, 3}, {0, 1, 0}}};
    auto parts = std::make_shared<LabelMap>(*test::anyParts(*scene.volume, 2, 3));
    parts->parts[0].name = "ZZCANARY";
    scene.parts = {parts, {{1, {0.7f, {{.hu = 100, .opacity = 0}, {.hu = 400, .opacity = 1}}}, 3.5f}}};
    scene.lookName = "ZZCANARY";
    scene.revision = 99;
    return scene;
}

SceneContents contentsOf(const OutgoingScene& going) {
    const auto bytesOf = [&](const wire::Hash& hash) {
        return std::ranges::find(going.contents, hash, &Content::hash)->bytes;
    };
    SceneContents contents{*volumeFrom(going.order.volume, bytesOf(going.order.volume.content)), {}, {}};
    contents.mask = *maskFrom(*going.order.mask, bytesOf(going.order.mask->content));
    contents.labels = *labelsFrom(going.order.volume, bytesOf(going.order.labels->content));
    contents.environment = *environmentFrom(*going.order.environment, bytesOf(going.order.environment->content));
    return contents;
}

}  // namespace

/// Scenes on their way to nodes.
class SceneOrderTest : public QObject {
    Q_OBJECT

  private slots:
    void arrivesToTheLastBit() {
        const Scene scene = fullScene();
        const auto going = *outgoingScene(5, scene, hashOf);
        const SceneContents contents = contentsOf(going);
        Scene there = *sceneFrom(going.order, contents);
        QCOMPARE(there.revision, 5u);
        QVERIFY(std::ranges::equal(there.volume->voxels(), scene.volume->voxels()));
        QVERIFY(there.volume->geometry().patientFromIndex == scene.volume->geometry().patientFromIndex);
        QVERIFY(there.mask->weights() == scene.mask->weights() && there.mask->grid() == scene.mask->grid());
        QVERIFY(there.environment.image->texels == scene.environment.image->texels);
        QVERIFY(there.parts.map->labels == scene.parts.map->labels && there.parts.curves == scene.parts.curves);
        there.revision = scene.revision;
        const FilmContent here = test::render(scene, 3).content(), other = test::render(there, 3).content();
        QVERIFY(sameBits(here, other));
    }

    void wantsWhatItNames() {
        const auto going = *outgoingScene(5, fullScene(), hashOf);
        const auto wanted = wantedContents(going.order);
        QCOMPARE(wanted.size(), going.contents.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            QCOMPARE(wanted[i].hash, going.contents[i].hash);
            QCOMPARE(wanted[i].bytes, going.contents[i].bytes.size());
        }
    }

    void holdsNothingOfAPatient() {
        const auto going = *outgoingScene(5, fullScene(), hashOf);
        QVERIFY(going.order.text.find("ZZCANARY") == std::string::npos);
        QVERIFY(going.order.text.find("Peeled") == std::string::npos);
        QVERIFY(contentsOf(going).mask->hidden().empty());
        QVERIFY(contentsOf(going).labels->parts.empty());
        QVERIFY(contentsOf(going).volume->remarks().empty());
    }

    void sceneThatTextsDoNotHoldStaysHere() {
        Scene scene = fullScene();
        scene.unshadowed = true;
        QVERIFY(!outgoingScene(5, scene, hashOf));
    }

    void whatDoesNotFitIsRefused() {
        const auto going = *outgoingScene(5, fullScene(), hashOf);
        const SceneContents contents = contentsOf(going);
        const std::vector<std::byte> few(100);
        QVERIFY(!volumeFrom(going.order.volume, few));
        QVERIFY(!maskFrom(*going.order.mask, few));
        QVERIFY(!environmentFrom(*going.order.environment, few));
        QVERIFY(!labelsFrom(going.order.volume, few));
        wire::SceneOrder order = going.order;
        order.volume.patientFromIndex.fill(0);
        QVERIFY(!volumeFrom(order.volume, going.contents[0].bytes));
        order = going.order;
        order.text = "{}";
        QVERIFY(!sceneFrom(order, contents));
        std::vector<std::byte> wrong(going.contents[1].bytes.size(), std::byte{0x7f});
        QVERIFY(!maskFrom(*going.order.mask, wrong));
        SceneContents other = contents;
        other.mask = std::make_shared<Mask>(MaskGrid{{8, 8, 8}, {0, 0, 0}},
                                            HugePageVector<std::int16_t>(512, std::int16_t(1)), "");
        QVERIFY(!sceneFrom(going.order, other));
        other = contents;
        other.labels = test::anyParts(*test::makeVolume(ivec3(8), dvec3(1), [](int, int, int) { return 0; }), 2, 3);
        QVERIFY(!sceneFrom(going.order, other));
    }
};

QTEST_APPLESS_MAIN(SceneOrderTest)
#include "scene_order_test.moc"
