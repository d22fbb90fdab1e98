#include <QTest>

#include <atomic>
#include <thread>

#include "app/node/exit_codes.h"
#include "tests/support/network/acted_node.h"
#include "tests/support/network/later_version.h"
#include "tests/support/network/one_link.h"
#include "tests/support/network/shared_image.h"

using namespace pdr;
using namespace pdr::test;
using node::ExitCode;
using wire::Versions;

namespace {

wire::Hello helloOf(const Versions& versions) {
    wire::Hello hello = ActedNode::helloOfThisMachine();
    hello.versions = versions;
    return hello;
}

Versions versionsOf(const QList<int>& ends) {
    return {std::uint16_t(ends[0]), std::uint16_t(ends[1])};
}

}  // namespace

/// Coordinators and nodes of different releases.
class VersionSkewTest : public QObject {
    Q_OBJECT

  private slots:
    void highestCommonVersionIsSpoken_data() {
        QTest::addColumn<QList<int>>("coordinator");
        QTest::addColumn<QList<int>>("node");
        QTest::addColumn<int>("common");  // 0: none
        QTest::addColumn<bool>("nodeDials");
        for (const bool nodeDials : {true, false}) {
            const auto row = [&](const char* name, const QList<int>& coordinator, const QList<int>& node, int common) {
                QTest::addRow("%s, %s", name, nodeDials ? "node dials" : "node waits")
                    << coordinator << node << common << nodeDials;
            };
            row("the same", {1, 1}, {1, 1}, 1);
            row("a node of later ones only", {1, 1}, {2, 3}, 0);
            row("a node of earlier ones only", {3, 4}, {1, 2}, 0);
            row("a node of later ones too", {1, 2}, {2, 9}, 2);
            row("a node of earlier ones too", {2, 5}, {1, 3}, 3);
            row("a node of all", {3, 4}, {1, 65535}, 4);
            row("a coordinator of all", {1, 65535}, {3, 4}, 4);
        }
    }
    void highestCommonVersionIsSpoken() {
        QFETCH(const QList<int>, coordinator);
        QFETCH(const QList<int>, node);
        QFETCH(const int, common);
        QFETCH(const bool, nodeDials);
        OneLink link;
        link.coordinator.versions = versionsOf(coordinator);
        const wire::Hello hello = helloOf(versionsOf(node));
        const auto acted =
            nodeDials ? std::make_unique<ActedNode>(link.port(), hello) : std::make_unique<ActedNode>(hello);
        if (!nodeDials)
            link.dialNode(acted->port());
        QTRY_VERIFY_WITH_TIMEOUT(acted->isWelcome() || acted->isOver(), kPatience);
        QCOMPARE(acted->isWelcome(), common > 0);
        QCOMPARE(link.hasJoined, common > 0);
        QCOMPARE(link.pool->workers().size(), std::size_t(common > 0));
        if (common > 0) {
            QCOMPARE(link.pool->workers()[0].isDeep, common >= 2);  // version 1 has leases of one block only
            QCOMPARE(int(acted->heard<wire::Welcome>().at(0).version), common);
            return;
        }
        const auto refused = acted->heard<wire::Refused>();
        QCOMPARE(refused.size(), std::size_t(1));
        QVERIFY(refused[0].why == wire::Refused::Why::version);
        QTRY_VERIFY_WITH_TIMEOUT(link.reason && link.reason->contains("another version of the protocol"), kPatience);
        QVERIFY(link.link->isRefused());
    }

    void nodeOfLaterVersionsIsNotDialledAgain() {
        NodeTrial trial;
        const ActedNode later(helloOf({3, 4}));
        QVERIFY(bool(trial.nodes.add(QString("localhost:%1").arg(later.port()))));
        const auto& known = trial.nodes.nodes();
        QTRY_VERIFY_WITH_TIMEOUT(!known.empty() && known[0].state == nodes::NodeState::refused, kPatience);
        QVERIFY(known[0].reason.find("another version of the protocol") != std::string::npos);
    }

    void programThatDialsALaterCoordinatorEnds() {
        OneLink later;
        later.coordinator.versions = {3, 4};
        NodeProcess program({"--coordinator", QString("localhost:%1").arg(later.port())});
        QTRY_VERIFY_WITH_TIMEOUT(later.reason, kPatience);
        QCOMPARE(program.code(), int(ExitCode::protocol));
    }

    /// The program keeps waiting after a refusal, since another coordinator may dial it next.
    void programThatWaitsGoesOnWaiting() {
        NodeProcess program;
        const auto port = quint16(program.address().section(':', -1).toInt());
        OneLink later;
        later.coordinator.versions = {3, 4};
        later.dialNode(port);
        QTRY_VERIFY_WITH_TIMEOUT(later.reason, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(program.log().contains("another version of the protocol"), kPatience);
        OneLink same;
        same.dialNode(port);
        QTRY_VERIFY_WITH_TIMEOUT(same.hasJoined, kPatience);
    }

    void programTakesNoVersionThatItDidNotOffer() {
        remote::Listener coordinator(OneLink::kCoordinator);
        QVERIFY(bool(coordinator.listen({"127.0.0.1", 0})));
        connect(&coordinator, &remote::Listener::connected, this, [](remote::Channel* channel) {
            connect(channel, &remote::Channel::received, channel, [channel](const wire::Message& message) {
                if (std::holds_alternative<wire::Hello>(message))
                    channel->send(wire::Welcome{.version = 3});
            });
        });
        NodeProcess program({"--coordinator", QString("localhost:%1").arg(coordinator.address().port)});
        const auto says = [&program](const char* words) { return program.log().contains(words); };
        QTRY_VERIFY_WITH_TIMEOUT(says("it was not offered") || says("works for"), kPatience);
        QVERIFY(!says("works for"));
        QCOMPARE(program.code(), int(ExitCode::protocol));
    }

    /// Both programs skip what they do not know, and the image is the same.
    void laterVersionsMaySayMore() {
        Scene scene = tissueScene();
        scene.film = {122, 90};
        const std::vector<std::uint32_t> orders{2, 62, 64};
        const FilmContent alone = imageAlone(scene, orders);
        NodeProcess program;
        LaterVersion later(quint16(program.address().section(':', -1).toInt()));
        NodeTrial trial;
        QVERIFY(bool(trial.nodes.add(QString("localhost:%1").arg(later.port()))));
        const auto& known = trial.nodes.nodes();
        QTRY_VERIFY_WITH_TIMEOUT(
            !known.empty() && (known[0].state == nodes::NodeState::ready || !known[0].reason.empty()), kPatience);
        QVERIFY2(known[0].state == nodes::NodeState::ready, known[0].reason.c_str());
        std::atomic<bool> over = false;
        FilmContent image;
        std::jthread renderer([&] {
            image = trial.image(scene, orders, 1);
            over = true;
        });
        QTRY_VERIFY_WITH_TIMEOUT(over, kPatience);
        QVERIFY(sameBits(image, alone));
        QVERIFY(trial.workOfNodes() > 0 && later.messages() > 4);
        QCOMPARE(known.at(0).losses, 0u);
    }
};

QTEST_GUILESS_MAIN(VersionSkewTest)
#include "version_skew_test.moc"
