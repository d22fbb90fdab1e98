/// Figures of render nodes, computed from their counters.

#include <QTest>

#include "app/presenters/node_figures.h"

namespace pdr::app {

static nodes::NodeStatus node(nodes::NodeId id, double work, double busySeconds,
                              nodes::NodeState state = nodes::NodeState::ready) {
    nodes::NodeStatus status;
    status.id = id;
    status.state = state;
    status.work.work = work;
    status.work.busySeconds = busySeconds;
    status.work.workPerSecond = 400;
    return status;
}

class TestNodeFigures : public QObject {
    Q_OBJECT

  private slots:
    void sharesAreOfTheImageInHand();
    void aNodeWithWorkRenders();
    void efficiencyIsTheBusyPartOfAWindow();
    void whatIsCountedAnewBeginsAnew();
    void everyStateHasItsOwn();
};

static bool near(double a, double b) {
    return std::fabs(a - b) < 1e-9;
}

void TestNodeFigures::sharesAreOfTheImageInHand() {
    NodeFigures figures;
    figures.follow({node(1, 0, 0), node(2, 0, 0)}, {7, 100, 0}, 0);
    std::vector<nodes::NodeStatus> now{node(1, 100, 0), node(2, 300, 0)};
    figures.follow(now, {7, 100, 600}, 1);
    QVERIFY(near(figures.rowOf(now[0]).share, 0.1) && near(figures.rowOf(now[1]).share, 0.3));
    figures.follow(now, {8, 100, 600}, 2);
    QCOMPARE(figures.rowOf(now[0]).share, 0.0);
    now = {node(1, 150, 0), node(2, 300, 0)};
    figures.follow(now, {8, 100, 650}, 3);
    QVERIFY(near(figures.rowOf(now[0]).share, 0.5) && figures.rowOf(now[1]).share == 0);
    figures.follow(now, {8, 400, 650, Purpose::finalRender}, 4);  // the number is another image's by chance
    QCOMPARE(figures.rowOf(now[0]).share, 0.0);
}

void TestNodeFigures::aNodeWithWorkRenders() {
    NodeFigures figures;
    figures.follow({node(1, 0, 0)}, {7, 100, 0}, 0);
    const nodes::NodeStatus now = node(1, 900, 1);
    figures.follow({now}, {7, 100, 0}, NodeFigures::kWindow);
    QCOMPARE(figures.rowOf(now).state, ui::NodeState::rendering);
    QCOMPARE(figures.rowOf(now).iterationsPerSecond, 4.0);
    figures.follow({now}, {7, 100, 0}, 2 * NodeFigures::kWindow);
    QCOMPARE(figures.rowOf(now).state, ui::NodeState::ready);
    QCOMPARE(figures.rowOf(now).iterationsPerSecond, 0.0);
    QCOMPARE(figures.rowOf(now).efficiency, 0.0);
}

void TestNodeFigures::efficiencyIsTheBusyPartOfAWindow() {
    NodeFigures figures;
    figures.follow({node(1, 0, 10)}, {7, 100, 0}, 100);
    const nodes::NodeStatus now = node(1, 900, 10 + 0.75 * NodeFigures::kWindow);
    figures.follow({now}, {7, 100, 0}, 100 + NodeFigures::kWindow);
    QVERIFY(near(figures.rowOf(now).efficiency, 0.75));
    const nodes::NodeStatus boasts = node(1, 1900, 99);
    figures.follow({boasts}, {7, 100, 0}, 100 + 2 * NodeFigures::kWindow);
    QCOMPARE(figures.rowOf(boasts).efficiency, 1.0);
}

/// A node's counters restart when it reconnects after a lost connection.
void TestNodeFigures::whatIsCountedAnewBeginsAnew() {
    NodeFigures figures;
    figures.follow({node(1, 500, 9)}, {7, 100, 0}, 0);
    figures.follow({node(1, 500, 9)}, {8, 100, 0}, 1);
    const nodes::NodeStatus again = node(1, 50, 0.1);
    figures.follow({again}, {8, 100, 50}, 2);
    QVERIFY(near(figures.rowOf(again).share, 0.5));
}

void TestNodeFigures::everyStateHasItsOwn() {
    const NodeFigures figures;
    QSet<int> states;
    for (const auto state :
         {nodes::NodeState::dialling, nodes::NodeState::greeting, nodes::NodeState::waiting, nodes::NodeState::sending,
          nodes::NodeState::ready, nodes::NodeState::suspect, nodes::NodeState::paused, nodes::NodeState::draining,
          nodes::NodeState::refused, nodes::NodeState::lost})
        states << int(figures.rowOf(node(1, 0, 0, state)).state);
    QCOMPARE(states.size(), 10);
    nodes::NodeStatus other = node(1, 0, 0, nodes::NodeState::quarantined);
    QCOMPARE(figures.rowOf(other).state, ui::NodeState::refused);
    QVERIFY(figures.rowOf(other).sameBits);
    other.otherBits = true;
    QVERIFY(!figures.rowOf(other).sameBits);
}

}  // namespace pdr::app

QTEST_APPLESS_MAIN(pdr::app::TestNodeFigures)
#include "node_figures_test.moc"
