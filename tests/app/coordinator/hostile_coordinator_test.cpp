/// Coordinators that do harm, or try to: a node parts with them, and the next one gets its image.

#include <QFile>
#include <QTest>
#include <functional>

#include "tests/support/network/acted_coordinator.h"
#include "tests/support/network/shared_image.h"

using namespace pdr;
using namespace pdr::test;

namespace {

/// What a node does about it.
enum class Answer { parts, refusesScene, givesBack, goesOn };

using Deed = std::function<void(ActedCoordinator&)>;

nodes::OutgoingScene goodScene() {
    static const nodes::ContentKey kKey{std::byte{1}};
    static const nodes::OutgoingScene scene = *nodes::outgoingScene(
        1, sharedScene(1),
        [](const auto&, std::span<const std::byte> bytes) { return wire::contentHash(kKey, bytes); });
    return scene;
}

void order(ActedCoordinator& coordinator, const nodes::OutgoingScene& scene) {
    coordinator.say(scene.order);
    for (const nodes::Content& content : scene.contents)
        coordinator.send(content);
}

Deed saying(std::vector<wire::Message> messages) {
    return [messages](ActedCoordinator& coordinator) {
        for (const wire::Message& message : messages)
            coordinator.say(message);
    };
}

/// Orders the good scene after `change`.
Deed ordering(const std::function<void(nodes::OutgoingScene&)>& change) {
    return [change](ActedCoordinator& coordinator) {
        nodes::OutgoingScene scene = goodScene();
        change(scene);
        order(coordinator, scene);
    };
}

/// Returns a lease of the good scene's first cell.
wire::Lease leaseOf(std::uint64_t number) {
    wire::Lease lease;
    lease.number = number;
    lease.revision = 1;
    lease.tile = {0, 0, 16, 16};
    lease.samples = {0, 2};
    return lease;
}

/// Orders the good scene, then gives leases out.
Deed leasing(const std::vector<wire::Lease>& leases) {
    return [leases](ActedCoordinator& coordinator) {
        order(coordinator, goodScene());
        for (const wire::Lease& lease : leases)
            coordinator.say(lease);
    };
}

std::vector<wire::Lease> manyLeases() {
    std::vector<wire::Lease> all;
    for (std::uint64_t number = 1; number <= 100; ++number)
        all.push_back(leaseOf(number));
    return all;
}

wire::Lease changed(const std::function<void(wire::Lease&)>& change) {
    wire::Lease lease = leaseOf(1);
    change(lease);
    return lease;
}

/// Returns the most memory that a process has had [MB].
double peakOf(qint64 process) {
    QFile status(QString("/proc/%1/status").arg(process));
    if (!status.open(QIODevice::ReadOnly))
        return 0;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("VmHWM:"))
            return line.mid(6).trimmed().split(' ').first().toDouble() / 1024;
    return 0;
}

}  // namespace

Q_DECLARE_METATYPE(Deed)

class HostileCoordinatorTest : public QObject {
    Q_OBJECT

    NodeProcess node_;

    quint16 port() const { return quint16(node_.address().section(':', -1).toInt()); }

    /// Dials until the node has parted with the one before.
    std::unique_ptr<ActedCoordinator> welcomed() const {
        for (;;) {
            auto coordinator = std::make_unique<ActedCoordinator>(port());
            while (!coordinator->hasNode() && !coordinator->isOver())
                QTest::qWait(2);
            if (coordinator->hasNode())
                return coordinator;
        }
    }

  private slots:
    void harmIsBounded_data() {
        QTest::addColumn<Deed>("deed");
        QTest::addColumn<int>("answer");
        const auto row = [](const char* name, const Deed& deed, Answer answer) {
            QTest::newRow(name) << deed << int(answer);
        };
        row("a chunk that nobody asked for", saying({wire::Chunk{}}), Answer::parts);
        row("what nodes say", saying({wire::SceneReady{1}}), Answer::parts);
        row("another introduction", saying({wire::Hello{}}), Answer::parts);
        row("a lease of no scene", saying({leaseOf(1)}), Answer::givesBack);
        row("a lease twice", leasing({leaseOf(1), leaseOf(1)}), Answer::parts);
        row("a lease of sums that it never had", leasing({changed([](auto& lease) {
                lease.samples = {2, 3};
                lease.kept = wire::Hash();
            })}),
            Answer::givesBack);
        row("a hundred leases", leasing(manyLeases()), Answer::parts);
        row("a lease outside the film", leasing({changed([](auto& lease) {
                lease.tile = {4096, 4096, 4112, 4112};
            })}),
            Answer::parts);
        row("a lease of the last samples", leasing({changed([](auto& lease) {
                lease.samples = {0xffffffc0u, 64};
            })}),
            Answer::goesOn);
        row("a lease that takes hours, then nothing", leasing({changed([](auto& lease) {
                lease.tile = {0, 0, 122, 90};
                lease.samples = {0, 1 << 16};
            })}),
            Answer::goesOn);
        row("more voxels than any memory holds", ordering([](auto& scene) {
                scene.order.volume.size = {2048, 2048, 2047};
            }),
            Answer::parts);
        row("voxels of no size", ordering([](auto& scene) { scene.order.volume.size = {0, 4, 4}; }), Answer::parts);
        row("a place that is no number", ordering([](auto& scene) { scene.order.volume.patientFromIndex[0] = NAN; }),
            Answer::parts);
        row("a text that is no scene", ordering([](auto& scene) { scene.order.text = "{"; }), Answer::refusesScene);
        row("a text of brackets", ordering([](auto& scene) { scene.order.text = std::string(1 << 20, '['); }),
            Answer::refusesScene);
        row("a text that reads a file", ordering([](auto& scene) {
                scene.order.text.replace(0, 1, R"({"volume": {"raw": "/etc/passwd", "size": [1, 1, 1]},)");
            }),
            Answer::refusesScene);
        row("other voxels than announced", ordering([](auto& scene) {
                for (nodes::Content& content : scene.contents)
                    if (content.hash == scene.order.volume.content) {
                        content.hash[0] ^= std::byte{1};
                        scene.order.volume.content = content.hash;
                        return;
                    }
            }),
            Answer::parts);
        row(
            "scenes without end",
            [](ActedCoordinator& coordinator) {
                nodes::OutgoingScene scene = goodScene();
                scene.order.text.resize(1 << 18, ' ');
                for (std::uint64_t revision = 1; revision <= 200; ++revision) {
                    scene.order.revision = revision;
                    coordinator.say(scene.order);
                }
            },
            Answer::goesOn);
        row(
            "to forget, again and again",
            [](ActedCoordinator& coordinator) {
                order(coordinator, goodScene());
                for (int i = 0; i < 1000; ++i)
                    coordinator.say(wire::Forget{});
            },
            Answer::goesOn);
    }
    void harmIsBounded() {
        QFETCH(const Deed, deed);
        QFETCH(const int, answer);
        {
            const std::unique_ptr<ActedCoordinator> hostile = welcomed();
            deed(*hostile);
            const auto hasAnswered = [&] {
                switch (Answer(answer)) {
                    case Answer::parts:
                        return hostile->isOver();
                    case Answer::refusesScene:
                        return !hostile->heard<wire::SceneRefused>().empty();
                    case Answer::givesBack:
                        return !hostile->heard<wire::Abandoned>().empty();
                    case Answer::goesOn:
                        return hostile->waits() == 0 || hostile->isOver();
                }
                return false;
            };
            QTRY_VERIFY_WITH_TIMEOUT(hasAnswered(), kPatience);
        }
        const std::unique_ptr<ActedCoordinator> next = welcomed();
        order(*next, goodScene());
        QTRY_VERIFY_WITH_TIMEOUT(!next->heard<wire::SceneReady>().empty(), kPatience);
        next->say(leaseOf(1));
        QTRY_VERIFY_WITH_TIMEOUT(!next->heard<wire::Result>().empty(), kPatience);
        QVERIFY2(peakOf(node_.id()) < 400, qPrintable(QString::number(peakOf(node_.id()))));
    }

    void imageAfterwardsIsRight() {
        const FilmContent alone = imageAlone(sharedScene(), kSharedOrders);
        NodeTrial honest;
        honest.add(node_);
        QVERIFY(sameBits(honest.image(sharedScene(), kSharedOrders, 1), alone));
        QVERIFY(honest.workOfNodes() > 0);
    }
};

QTEST_GUILESS_MAIN(HostileCoordinatorTest)
#include "hostile_coordinator_test.moc"
