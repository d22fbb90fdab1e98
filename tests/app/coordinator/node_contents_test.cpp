/// What a scene takes of a node's memory, and whether that is asked for before.

#include <QFile>
#include <QTest>

#include "app/node/node_contents.h"
#include "app/wire/content.h"
#include "tests/support/scenes/part_scenes.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;
using namespace pdr::test;

namespace {

const nodes::ContentKey kKey{std::byte{3}};

wire::Hash hashOf(const std::shared_ptr<const void>&, std::span<const std::byte> bytes) {
    return wire::contentHash(kKey, bytes);
}

/// 64 MiB of voxels.
nodes::OutgoingScene largeScene() {
    const auto volume = std::make_shared<const Volume>(VolumeGeometry{{256, 256, 512}, dmat4(1.0)},
                                                       Voxels(std::size_t(256) * 256 * 512, 7));
    return *nodes::outgoingScene(5, plainScene(volume, 0.05f), hashOf);
}

/// A line of /proc/self/status, in bytes.
double ofMemory(const QByteArray& name) {
    QFile file("/proc/self/status");
    if (file.open(QIODevice::ReadOnly))
        for (const QByteArray& line : file.readAll().split('\n'))
            if (line.startsWith(name))
                return 1024 * line.simplified().split(' ').value(1).toDouble();
    return -1;
}

bool resetPeak() {
    QFile file("/proc/self/clear_refs");
    return file.open(QIODevice::WriteOnly) && file.write("5") == 1;
}

}  // namespace

class NodeContentsTest : public QObject {
    Q_OBJECT

  private slots:
    void noMoreIsTakenThanIsAskedFor() {
#ifdef __SANITIZE_ADDRESS__
        QSKIP("the address sanitizer has memory of its own");
#endif
        const nodes::OutgoingScene going = largeScene();
        const nodes::Content& voxels = going.contents.at(0);
        node::NodeContents contents(kKey);
        QVERIFY(bool(contents.order(going.order)));
        if (!resetPeak())
            QSKIP("the system does not let the peak be measured");
        const double before = ofMemory("VmRSS:");
        for (std::uint32_t i = 0; i < wire::chunksOf(voxels.bytes.size()); ++i)
            QVERIFY(bool(contents.add(wire::packChunk(voxels.hash, voxels.bytes, i))));
        QVERIFY(!contents.need() && bool(contents.scene()));
        const double taken = (ofMemory("VmHWM:") - before) / double(voxels.bytes.size());
        qInfo("a scene takes %.2f times its voxels at the most, %.2f are asked for", taken,
              node::NodeContents::kSceneOverhead);
        QVERIFY(taken > 1 && taken < node::NodeContents::kSceneOverhead);
    }

    /// Labels stay while the scene changes, and come anew where their voxels lie elsewhere.
    void labelsAreThoseOfTheirVolume() {
        const auto sceneWith = [](double spacing) {
            Scene scene = plainScene(makeVolume(ivec3(8), dvec3(spacing), [](int i, int, int) { return i; }), 1);
            scene.parts = {anyParts(*scene.volume, 2, 3), {{2, {3, {{.hu = 0, .opacity = 1}}}}}};
            return scene;
        };
        node::NodeContents contents(kKey);
        for (const double spacing : {1.0, 1.0, 2.0}) {
            const Scene scene = sceneWith(spacing);
            const nodes::OutgoingScene going = *nodes::outgoingScene(5, scene, hashOf);
            QVERIFY(bool(contents.order(going.order)));
            while (const auto need = contents.need())
                for (const nodes::Content& one : going.contents)
                    if (one.hash == need->content)
                        QVERIFY(bool(contents.add(wire::packChunk(one.hash, one.bytes, 0))));
            const Result<Scene> made = contents.scene();
            QVERIFY2(made, made ? "" : made.error().text().c_str());
            QVERIFY(made->parts.map->labels == scene.parts.map->labels);
        }
    }

    void sceneThatDoesNotFitIsRefused_data() {
        QTest::addColumn<double>("free");  // times what the voxels are
        QTest::addColumn<bool>("fits");
        QTest::newRow("half") << 0.5 << false;
        QTest::newRow("once") << 1.0 << false;
        QTest::newRow("nearly what it takes") << 0.99 * node::NodeContents::kSceneOverhead << false;
        QTest::newRow("what it takes") << 1.01 * node::NodeContents::kSceneOverhead << true;
    }
    void sceneThatDoesNotFitIsRefused() {
        QFETCH(const double, free);
        QFETCH(const bool, fits);
        const nodes::OutgoingScene going = largeScene();
        const auto bytes = std::uint64_t(free * double(going.contents.at(0).bytes.size()));
        for (const bool hasOthers : {false, true}) {
            node::NodeContents contents(kKey, [=] { return node::MemoryLeft{bytes, hasOthers}; });
            const Result<void> ordered = contents.order(going.order);
            QCOMPARE(bool(ordered), fits);
            QCOMPARE(contents.need().has_value(), fits);
            QCOMPARE(contents.promised() > 0, fits);
            contents.settle();
            QCOMPARE(contents.promised(), std::uint64_t(0));
            const std::string what = fits ? "" : ordered.error().what;
            QVERIFY2(fits || what.find("not enough memory for the scene") != std::string::npos, what.c_str());
            QCOMPARE(what.find("others use this render node") != std::string::npos, !fits && hasOthers);
        }
    }
};

QTEST_APPLESS_MAIN(NodeContentsTest)
#include "node_contents_test.moc"
