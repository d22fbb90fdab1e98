/// What the error plot is told of nodes that come and go.

#include <QTest>

#include "app/presenters/node_events.h"

namespace pdr::app {

using ui::NodeState;

static ui::NodeRow node(quint64 id, NodeState state, const QString& reason = {}) {
    ui::NodeRow row;
    row.id = id;
    row.name = QString("gpu-%1").arg(id);
    row.state = state;
    row.reason = reason;
    return row;
}

class TestNodeEvents : public QObject {
    Q_OBJECT

  private slots:
    void comingAndGoingAreTold();
    void fallingSilentAloneIsNotTold();
    void theReasonOfGoingIsTold_data();
    void theReasonOfGoingIsTold();
    void anotherImageHasItsOwn();
    void oldOnesGoWhenThereAreMany();
};

void TestNodeEvents::comingAndGoingAreTold() {
    NodeEvents events;
    events.follow({node(1, NodeState::dialling), node(2, NodeState::ready)}, 7, 1);
    events.follow({node(1, NodeState::sendingScan), node(2, NodeState::rendering)}, 7, 2);
    events.follow({node(1, NodeState::rendering), node(2, NodeState::lost, "the connection was cut")}, 7, 3);
    events.follow({node(2, NodeState::rendering)}, 7, 4);
    const ui::PlotEvents wanted{{1, "gpu-2 joined", true},
                                {3, "gpu-1 joined", true},
                                {3, "gpu-2 was lost: the connection was cut", false},
                                {4, "gpu-2 joined", true},
                                {4, "gpu-1 was removed", false}};
    QVERIFY(events.events() == wanted);
}

void TestNodeEvents::fallingSilentAloneIsNotTold() {
    NodeEvents events;
    for (const NodeState state : {NodeState::rendering, NodeState::suspect, NodeState::ready, NodeState::rendering})
        events.follow({node(1, state)}, 7, 1);
    QCOMPARE(events.events().size(), std::size_t(1));
}

void TestNodeEvents::theReasonOfGoingIsTold_data() {
    QTest::addColumn<int>("state");
    QTest::addColumn<QString>("text");
    QTest::newRow("paused") << int(NodeState::paused) << "gpu-1 was paused";
    QTest::newRow("leaving") << int(NodeState::draining) << "gpu-1 leaves";
    QTest::newRow("in line") << int(NodeState::waiting) << "gpu-1 works for others";
    QTest::newRow("lost") << int(NodeState::lost) << "gpu-1 was lost";
    QTest::newRow("dialled again") << int(NodeState::dialling) << "gpu-1 was lost";
    QTest::newRow("refused") << int(NodeState::refused) << "gpu-1 was lost";
    QTest::newRow("without the scan") << int(NodeState::sendingScan) << "gpu-1 waits for the scan";
}

void TestNodeEvents::theReasonOfGoingIsTold() {
    QFETCH(int, state);
    QFETCH(QString, text);
    NodeEvents events;
    events.follow({node(1, NodeState::rendering)}, 7, 1);
    events.follow({node(1, NodeState(state))}, 7, 2);
    QCOMPARE(events.events().back().text, text);
    QVERIFY(!events.events().back().joined);
}

/// A node that takes part in an image from its beginning has not joined it.
void TestNodeEvents::anotherImageHasItsOwn() {
    NodeEvents events;
    events.follow({node(1, NodeState::rendering)}, 7, 1);
    events.follow({node(1, NodeState::rendering)}, 8, 0);
    QVERIFY(events.events().empty());
    events.follow({node(1, NodeState::lost)}, 8, 0.5);
    QCOMPARE(events.events().size(), std::size_t(1));
}

void TestNodeEvents::oldOnesGoWhenThereAreMany() {
    NodeEvents events;
    for (int i = 0; i < 300; ++i)
        events.follow({node(1, i % 2 ? NodeState::lost : NodeState::ready)}, 7, i);
    QCOMPARE(events.events().size(), NodeEvents::kMost);
    QCOMPARE(events.events().back().seconds, 299.0);
}

}  // namespace pdr::app

QTEST_APPLESS_MAIN(pdr::app::TestNodeEvents)
#include "node_events_test.moc"
