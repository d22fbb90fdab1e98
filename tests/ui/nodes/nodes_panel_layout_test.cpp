/// The panel of remote nodes in windows of all sizes: what is visible and reachable, and the cost of updating many
/// nodes.

#include <QAbstractButton>
#include <QScrollBar>
#include <QTest>
#include <algorithm>

#include "tests/support/desktop/contrast.h"
#include "tests/support/desktop/named_widget.h"
#include "tests/support/desktop/node_rows.h"
#include "tests/support/desktop/the.h"
#include "tests/support/desktop/whole_window.h"
#include "tests/support/processor_time.h"
#include "ui/accuracy/effect_costs.h"
#include "ui/nodes/nodes_panel.h"
#include "ui/window/main_window.h"

namespace pdr::ui {

using test::node, test::nodes;

class TestNodesPanelLayout : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { applyTheme(*qApp, ThemeChoice::dark); }
    void everyControlIsNamedAndReached();
    void itsTextStandsOut_data();
    void itsTextStandsOut();
    void itFitsIntoSmallWindows_data();
    void itFitsIntoSmallWindows();
    void itLeavesTheImageItsPart();
    void sixtyFourNodesTenTimesASecondCostNext();
};

void TestNodesPanelLayout::everyControlIsNamedAndReached() {
    NodesPanel panel;
    panel.resize(900, 200);
    panel.setNodes(nodes(2));
    panel.setBundle("/somewhere");
    panel.table().selectRow(0);
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    QSet<QWidget*> wanted, reached;
    for (QWidget* control : panel.findChildren<QWidget*>())
        if (control->focusPolicy() & Qt::TabFocus && control->isVisible() && !control->focusProxy() &&
            !control->objectName().startsWith("qt_") && !qobject_cast<QScrollBar*>(control)) {
            const auto* push = qobject_cast<QAbstractButton*>(control);
            QVERIFY2(!control->accessibleName().isEmpty() || (push && !push->text().isEmpty()),
                     control->metaObject()->className());
            wanted << control;
        }
    for (int i = 0; i < 20; ++i) {
        QTest::keyClick(qApp->focusWidget() ? qApp->focusWidget() : &panel, Qt::Key_Tab);
        reached << qApp->focusWidget();
    }
    QVERIFY2(reached.contains(wanted), qPrintable(QString("%1 of %2").arg(reached.size()).arg(wanted.size())));
}

void TestNodesPanelLayout::itsTextStandsOut_data() {
    QTest::addColumn<ThemeChoice>("choice");
    QTest::newRow("dark") << ThemeChoice::dark;
    QTest::newRow("light") << ThemeChoice::light;
}

/// Every text in the table has the palette's colour and none of its own.
void TestNodesPanelLayout::itsTextStandsOut() {
    QFETCH(ThemeChoice, choice);
    applyTheme(*qApp, choice);
    NodesPanel panel;
    panel.resize(900, 200);
    panel.setNodes({node(1), node(2, NodeState::lost), node(3, NodeState::refused)});
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    for (const int row : {0, 1, 2})
        QVERIFY(!panel.table().model()->index(row, 1).data(Qt::ForegroundRole).isValid());
    const QImage image = panel.grab().toImage();
    const QColor ground = image.pixelColor(panel.table().mapTo(&panel, QPoint(4, panel.table().height() - 4)));
    QVERIFY(test::contrast(panel.table().palette().color(QPalette::Text), ground) >= 4.5);
    QVERIFY(test::contrast(panel.palette().color(QPalette::PlaceholderText), image.pixelColor(1, 1)) >= 4.5);
    applyTheme(*qApp, ThemeChoice::dark);
}

void TestNodesPanelLayout::itFitsIntoSmallWindows_data() {
    QTest::addColumn<QSize>("size");
    for (const QSize size : {QSize(640, 480), QSize(800, 600), QSize(1024, 768), QSize(3840, 2160)})
        QTest::addRow("%d x %d", size.width(), size.height()) << size;
}

/// Controls are not cut off, and the tool tip shows the text that is.
void TestNodesPanelLayout::itFitsIntoSmallWindows() {
    QFETCH(QSize, size);
    NodesPanel panel;
    panel.resize(size.width(), int(0.22 * size.height()));
    panel.setNodes(nodes(12));
    panel.setBundle("/a/folder/with/a/very/long/name/that/nobody/could/read/in/a/small/window/at/all");
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    QCOMPARE(panel.width(), size.width());
    for (const QAbstractButton* control : panel.findChildren<QAbstractButton*>())
        if (control->isVisible() && !control->objectName().startsWith("qt_") && !control->text().isEmpty())
            QVERIFY2(control->width() >= control->minimumSizeHint().width(), qPrintable(control->text()));
    QVERIFY(!panel.table().horizontalScrollBar()->isVisible() || size.width() < 800);
    for (const char* name : {"Connection security", "How the work is split"}) {
        const auto& line = test::named<QLabel>(panel, name);
        QVERIFY(line.width() <= panel.width() && line.toolTip() == line.text());
    }
}

void TestNodesPanelLayout::itLeavesTheImageItsPart() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    window.resize(1024, 768);
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    window.accuracyStatus().setRemarks({"a remark"});
    window.viewport().setFocus();
    QVERIFY(!test::the<NodesPanel>(window).isVisible());
    QTest::keyClick(&window, Qt::Key_F12);
    test::the<NodesPanel>(window).setNodes(nodes(8));
    QVERIFY(test::the<NodesPanel>(window).isVisible());
    QTRY_VERIFY2(window.viewport().height() >= 0.55 * window.height(),
                 qPrintable(QString::number(window.viewport().height())));
    QVERIFY(test::the<NodesPanel>(window).table().viewport()->height() >=
            2 * test::the<NodesPanel>(window).table().rowHeight(0));
    window.resize(800, 600);
    QCoreApplication::processEvents();
    QCOMPARE(window.size(), QSize(800, 600));
    QTest::keyClick(&window, Qt::Key_F6);
    QVERIFY(test::the<EffectCosts>(window).isVisible() && !test::the<NodesPanel>(window).isVisible());
    QTest::keyClick(&window, Qt::Key_F12);
    QVERIFY(!test::the<EffectCosts>(window).isVisible() && test::the<NodesPanel>(window).isVisible());
    QTest::keyClick(&window, Qt::Key_F12);
    QVERIFY(!test::the<NodesPanel>(window).isVisible());
}

/// Measures the time on the window's thread, including repainting, when all rows change each time. A machine may be
/// slow: the bar is 2.6 times what the panel alone takes to paint, 2 ms where that takes 0.77 ms.
void TestNodesPanelLayout::sixtyFourNodesTenTimesASecondCostNext() {
    NodesPanel panel;
    panel.resize(1000, 200);
    QList<NodeRow> rows = nodes(64);
    panel.setNodes(rows);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    panel.table().selectRow(3);
    constexpr double kMost = 2.6;
    double best = 1e9;  // best of some rounds: other processes evict the caches
    for (int round = 0; round < 20 && best >= kMost; ++round) {
        std::vector<double> updated, painted;
        for (int i = 0; i < 300; ++i) {
            for (NodeRow& row : rows) {
                row.iterationsPerSecond = 2 + 0.01 * (i % 100);
                row.bytesReceived += 100'000;
                row.latencyMs = 1 + i % 7;
            }
            const test::ProcessorTime time;
            panel.setNodes(rows);
            QCoreApplication::processEvents();
            updated.push_back(1000 * time.seconds());
            const test::ProcessorTime alone;
            panel.repaint();
            painted.push_back(1000 * alone.seconds());
        }
        std::ranges::sort(updated);
        std::ranges::sort(painted);
        const double p99 = updated[updated.size() * 99 / 100], median = painted[painted.size() / 2];
        qInfo("an update of 64 nodes and its painting: p99 %.2f ms (median %.2f); painting alone: %.2f", p99,
              updated[updated.size() / 2], median);
        best = std::min(best, p99 / median);
    }
#if !defined(__SANITIZE_ADDRESS__)  // which takes three times as long
    QVERIFY2(best < kMost, qPrintable(QString::number(best)));
#endif
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestNodesPanelLayout)
#include "nodes_panel_layout_test.moc"
