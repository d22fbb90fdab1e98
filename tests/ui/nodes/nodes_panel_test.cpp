/// The panel of remote nodes: what it shows, and what it asks for.

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "tests/support/desktop/named_widget.h"
#include "tests/support/desktop/node_rows.h"
#include "ui/nodes/node_address.h"
#include "ui/nodes/node_text.h"
#include "ui/nodes/nodes_panel.h"
#include "ui/theme/theme.h"

namespace pdr::ui {

using test::node, test::nodes;

class TestNodesPanel : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { applyTheme(*qApp, ThemeChoice::dark); }
    void everyFigureHasItsCell();
    void whatIsNotKnownIsEmpty();
    void statesAreWordsWithTheirReason();
    void updatesKeepTheSelectionAndTheOrder();
    void anUpdateThatChangesNothingIsNone();
    void addressesAreUnderstood_data();
    void addressesAreUnderstood();
    void whatIsNoAddressIsToldBelow_data();
    void whatIsNoAddressIsToldBelow();
    void nodesAreAddedPausedAndRemoved();
    void keysPauseAndRemove();
    void aPortIsListenedOn();
    void certificatesAreSaidAndTakenBack();
    void allIsCheckedOnRequest();
    void settersAreSilent();
    void theLastLineSaysHowWorkIsSplit();
};

static QString cell(NodesPanel& panel, int row, int column, int role = Qt::DisplayRole) {
    return panel.table().model()->index(row, column).data(role).toString();
}

static QString said(const NodesPanel& panel, const QString& name) {
    const auto& label = test::named<QLabel>(panel, name);
    return label.isHidden() ? QString() : label.text();
}

static QPushButton& button(const QWidget& panel, const QString& text) {
    for (QPushButton* one : panel.findChildren<QPushButton*>())
        if (one->text() == text)
            return *one;
    qFatal("there is no button %s", qPrintable(text));
}

void TestNodesPanel::everyFigureHasItsCell() {
    NodesPanel panel;
    panel.setNodes({node(7)});
    QStringList cells;
    for (int column = 0; column < NodesModel::kColumns; ++column)
        cells << cell(panel, 0, column);
    QCOMPARE(cells, QStringList({"gpu-7 (10.0.0.7:4743)", "Rendering", "cpu, 16 threads", "2.50", "97 %", "13 %",
                                 "3.3 ms", "256.0 MB", "1.5 MB", "3"}));
    QCOMPARE(cell(panel, 0, NodesModel::faults, Qt::ToolTipRole), "connections lost: 1, results that never came: 2");
    QCOMPARE(cell(panel, 0, NodesModel::node, Qt::AccessibleTextRole),
             "gpu-7 (10.0.0.7:4743), Rendering, cpu, 16 threads, 2.50 iterations/s, 13 % of the image's samples, "
             "connections lost: 1, results that never came: 2");
    for (int column = 0; column < NodesModel::kColumns; ++column)
        for (const int role : {int(Qt::DisplayRole), int(Qt::ToolTipRole)})
            QVERIFY(!panel.table().model()->headerData(column, Qt::Horizontal, role).toString().isEmpty());
}

void TestNodesPanel::whatIsNotKnownIsEmpty() {
    NodesPanel panel;
    NodeRow dialled;
    dialled.address = "gpu-07:4743";
    panel.setNodes({dialled});
    QCOMPARE(cell(panel, 0, NodesModel::node), "gpu-07:4743");
    QCOMPARE(cell(panel, 0, NodesModel::state), "Dialling");
    for (int column = NodesModel::device; column < NodesModel::kColumns; ++column)
        QCOMPARE(cell(panel, 0, column), QString());
}

void TestNodesPanel::statesAreWordsWithTheirReason() {
    NodeRow row = node(1, NodeState::sendingScan);
    row.scanSent = 0.449;
    QCOMPARE(nodeStateText(row), "Sending the scan, 45 %");
    row.state = NodeState::lost;
    row.reason = "the connection was cut";
    QCOMPARE(nodeStateText(row), QString::fromUtf8("\u26A0 Lost: the connection was cut"));
    row.reason.clear();
    QSet<QString> words;
    for (int state = 0; state <= int(NodeState::refused); ++state) {
        row.state = NodeState(state);
        words << nodeStateText(row);
    }
    QCOMPARE(words.size(), 11);
}

void TestNodesPanel::updatesKeepTheSelectionAndTheOrder() {
    NodesPanel panel;
    panel.setNodes(nodes(5));
    panel.table().selectRow(2);
    QList<NodeRow> later{node(9), node(5), node(3, NodeState::lost), node(1)};
    panel.setNodes(later);
    QStringList shown;
    for (int row = 0; row < panel.table().model()->rowCount(); ++row)
        shown << cell(panel, row, NodesModel::node).section(' ', 0, 0);
    QCOMPARE(shown, QStringList({"gpu-1", "gpu-3", "gpu-5", "gpu-9"}));
    const QModelIndexList selected = panel.table().selectionModel()->selectedRows();
    QCOMPARE(selected.size(), 1);
    QVERIFY(cell(panel, selected[0].row(), NodesModel::state).contains("Lost"));
    panel.setNodes({node(1)});
    QVERIFY(!panel.table().selectionModel()->hasSelection());
    QVERIFY(!button(panel, "Remove").isEnabled() && !button(panel, "Pause").isEnabled());
}

void TestNodesPanel::anUpdateThatChangesNothingIsNone() {
    NodesModel model;
    model.setNodes(nodes(8));
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    model.setNodes(nodes(8));
    QCOMPARE(changed.size(), 0);
    QList<NodeRow> later = nodes(8);
    later[3].latencyMs = 9;
    model.setNodes(later);
    QCOMPARE(changed.size(), 1);
    QCOMPARE(changed[0][0].toModelIndex().row(), 3);
    QCOMPARE(changed[0][1].toModelIndex().row(), 3);
}

void TestNodesPanel::addressesAreUnderstood_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("address");
    QTest::newRow("host") << "gpu-07"
                          << "gpu-07:4743";
    QTest::newRow("host and port") << " gpu-07.clinic.example:9000 "
                                   << "gpu-07.clinic.example:9000";
    QTest::newRow("capitals") << "GPU-07"
                              << "gpu-07:4743";
    QTest::newRow("four bytes") << "10.0.0.7:1"
                                << "10.0.0.7:1";
    QTest::newRow("sixteen bytes") << "[fe80::1]"
                                   << "[fe80::1]:4743";
    QTest::newRow("sixteen bytes and a port") << "[::1]:65535"
                                              << "[::1]:65535";
    QTest::newRow("sixteen bytes without brackets") << "::1"
                                                    << "[::1]:4743";
}

void TestNodesPanel::addressesAreUnderstood() {
    QFETCH(QString, typed);
    QFETCH(QString, address);
    QCOMPARE(readAddress(typed).problem, QString());
    QCOMPARE(readAddress(typed).address, address);
}

void TestNodesPanel::whatIsNoAddressIsToldBelow_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("nothing") << ""
                             << "Type the address";
    QTest::newRow("spaces") << "   "
                            << "Type the address";
    QTest::newRow("port 0") << "gpu-07:0"
                            << "\"0\" is no port";
    QTest::newRow("port too large") << "gpu-07:65536"
                                    << "\"65536\" is no port";
    QTest::newRow("port in words") << "gpu-07:http"
                                   << "\"http\" is no port";
    QTest::newRow("no port") << "gpu-07:"
                             << "is no port";
    QTest::newRow("a link") << "http://gpu-07"
                            << "without slashes";
    QTest::newRow("two hosts") << "gpu-07 gpu-08"
                               << "is no host";
    QTest::newRow("only a port") << ":4743"
                                 << "is no host";
    QTest::newRow("somebody") << "me@gpu-07"
                              << "is no host";
    QTest::newRow("brackets missing") << "fe80::1::4743"
                                      << "stands in brackets";
    QTest::newRow("bracket open") << "[fe80::1"
                                  << "is no host";
}

void TestNodesPanel::whatIsNoAddressIsToldBelow() {
    QFETCH(QString, typed);
    QFETCH(QString, sentence);
    NodesPanel panel;
    QSignalSpy added(&panel, &NodesPanel::addRequested);
    auto& field = test::named<QLineEdit>(panel, "Address of a node");
    field.setText(typed);
    test::named<QPushButton>(panel, "Add the node").click();
    QVERIFY(added.isEmpty());
    QVERIFY2(said(panel, "What could not be done").contains(sentence), qPrintable(readAddress(typed).problem));
    QCOMPARE(field.text(), typed);  // to be mended
    QTest::keyClicks(&field, "x");
    QCOMPARE(said(panel, "What could not be done"), QString());
}

void TestNodesPanel::nodesAreAddedPausedAndRemoved() {
    NodesPanel panel;
    QSignalSpy added(&panel, &NodesPanel::addRequested), removed(&panel, &NodesPanel::removeRequested);
    QSignalSpy paused(&panel, &NodesPanel::pauseRequested);
    auto& field = test::named<QLineEdit>(panel, "Address of a node");
    QTest::keyClicks(&field, "gpu-07");
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(added.value(0).value(0).toString(), "gpu-07:4743");
    QVERIFY(field.text().isEmpty() && added.size() == 1);

    panel.setNodes({node(1), node(2, NodeState::paused), node(3)});
    panel.table().selectRow(0);
    button(panel, "Pause").click();
    QCOMPARE(paused.takeFirst(), QVariantList({quint64(1), true}));
    panel.table().selectRow(1);
    button(panel, "Continue").click();
    QCOMPARE(paused.takeFirst(), QVariantList({quint64(2), false}));
    panel.table().selectAll();
    button(panel, "Pause").click();
    QCOMPARE(paused.size(), 3);
    QVERIFY(std::ranges::all_of(paused, [](const QVariantList& one) { return one[1].toBool(); }));
    panel.table().selectRow(2);
    button(panel, "Remove").click();
    QCOMPARE(removed.value(0).value(0).toULongLong(), 3ULL);
    QCOMPARE(panel.table().model()->rowCount(), 3);  // it shows what is, not what was asked for
}

void TestNodesPanel::keysPauseAndRemove() {
    NodesPanel panel;
    QSignalSpy removed(&panel, &NodesPanel::removeRequested), paused(&panel, &NodesPanel::pauseRequested);
    panel.setNodes(nodes(2));
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    panel.table().setFocus();
    QTest::keyClick(&panel.table(), Qt::Key_Down);
    QTest::keyClick(&panel.table(), Qt::Key_Space);
    QTest::keyClick(&panel.table(), Qt::Key_Delete);
    QCOMPARE(paused.size(), 1);
    QCOMPARE(removed.size(), 1);
    QCOMPARE(paused[0][0], removed[0][0]);
}

void TestNodesPanel::aPortIsListenedOn() {
    NodesPanel panel;
    std::vector<std::optional<quint16>> asked;
    connect(&panel, &NodesPanel::listenRequested, &panel, [&](std::optional<quint16> port) { asked.push_back(port); });
    auto& port = test::named<QSpinBox>(panel, "Port");
    port.setValue(9000);
    QVERIFY(asked.empty());
    auto& listens = test::named<QCheckBox>(panel, "Listen on port");
    listens.click();
    port.setValue(9001);
    listens.click();
    QVERIFY(asked == (std::vector<std::optional<quint16>>{9000, 9001, std::nullopt}));
    panel.setProblem("Port 9000 is in use.");
    QCOMPARE(said(panel, "What could not be done"), "Port 9000 is in use.");
    listens.click();
    QCOMPARE(said(panel, "What could not be done"), QString());
}

void TestNodesPanel::certificatesAreSaidAndTakenBack() {
    NodesPanel panel;
    QSignalSpy asked(&panel, &NodesPanel::bundleRequested);
    auto& without = test::named<QToolButton>(panel, "Without certificates");
    QVERIFY(said(panel, "Connection security").contains("to this machine only"));
    QVERIFY(without.isHidden());
    panel.setBundle("/etc/pdrender/desktop");
    QVERIFY(said(panel, "Connection security").contains("/etc/pdrender/desktop"));
    QVERIFY(!without.isHidden() && asked.isEmpty());
    without.click();
    QCOMPARE(asked.size(), 1);
    QCOMPARE(asked[0][0].toString(), QString());
}

void TestNodesPanel::allIsCheckedOnRequest() {
    NodesPanel panel;
    QSignalSpy asked(&panel, &NodesPanel::checksAllRequested);
    auto& all = test::named<QCheckBox>(panel, "Check all");
    for (const bool wanted : {true, false}) {
        all.click();
        QCOMPARE(asked.takeFirst()[0].toBool(), wanted);
    }
}

void TestNodesPanel::settersAreSilent() {
    NodesPanel panel;
    QSignalSpy added(&panel, &NodesPanel::addRequested), removed(&panel, &NodesPanel::removeRequested);
    QSignalSpy paused(&panel, &NodesPanel::pauseRequested), bundle(&panel, &NodesPanel::bundleRequested);
    int listened = 0;
    connect(&panel, &NodesPanel::listenRequested, &panel, [&] { ++listened; });
    connect(&panel, &NodesPanel::splitRequested, &panel, [&] { ++listened; });
    connect(&panel, &NodesPanel::checksAllRequested, &panel, [&] { ++listened; });
    panel.setNodes(nodes(3));
    panel.setNodes({});
    panel.setListening(9000);
    panel.setListening(std::nullopt);
    panel.setBundle("/somewhere");
    panel.setBundle({});
    panel.setSplit("Tiles: an iteration takes 0.4 s");
    panel.setWantedSplit(Split::tiles);
    panel.setChecksAll(true);
    panel.setProblem("Nothing works.");
    QCOMPARE(added.size() + removed.size() + paused.size() + bundle.size() + listened, 0);
    QCOMPARE(test::named<QSpinBox>(panel, "Port").value(), 9000);
}

void TestNodesPanel::theLastLineSaysHowWorkIsSplit() {
    NodesPanel panel;
    QVERIFY(said(panel, "How the work is split").startsWith("No render nodes"));
    panel.setNodes(nodes(3));
    panel.setSplit("Tiles: an iteration takes 0.4 s");
    const QString wanted =
        QString::fromUtf8("Tiles: an iteration takes 0.4 s · All nodes compute the same bits as this machine");
    QCOMPARE(said(panel, "How the work is split"), wanted);
    QCOMPARE(test::named<QLabel>(panel, "How the work is split").toolTip(), wanted);
    panel.setChecks("2.1 % of 4096 tiles were rendered twice");
    QVERIFY(said(panel, "How the work is split").contains("0.4 s · 2.1 % of 4096 tiles were rendered twice · All"));
    QList<NodeRow> mixed = nodes(3);
    mixed[1].sameBits = false;
    panel.setNodes(mixed);
    QVERIFY(said(panel, "How the work is split").endsWith("1 node runs a different build and was excluded"));
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestNodesPanel)
#include "nodes_panel_test.moc"
