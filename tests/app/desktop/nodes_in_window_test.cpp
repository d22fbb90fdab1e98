/// Real render nodes and the window, on this machine: they come and go, the image goes on, and the scan does not stay
/// with them.

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <set>

#include "app/presenters/nodes_presenter.h"
#include "app/presenters/saving_presenter.h"
#include "app/rendering/image_saver.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/named_widget.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/network/node_process.h"
#include "tests/support/network/process_memory.h"
#include "tests/support/network/taken_port.h"
#include "ui/nodes/nodes_panel.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

using ui::NodeState;

static QStringList dialling(quint16 port, const QString& name = "node") {
    return {"--coordinator", QString("127.0.0.1:%1").arg(port), "--name", name};
}

class TestNodesInWindow : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void nodesDialInAndTheImageGoesOnWithoutThem();
    void aNodeThatIsAddedIsDialledUntilItAnswers();
    void aPausedNodeRestsAndGoesOn();
    void aNodeThatStandsStillHoldsNobodyUp();
    void theUserMaySayHowTheyShareTheWork();
    void whatIsWrongIsToldInThePanel();
    void theyAreWantedTheNextTime();
    void nothingOfTheScanStaysWithThem();
    void theWindowClosesWithNodesConnected();

  private:
    QTemporaryDir folder_;
    QString series_;
};

void TestNodesInWindow::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "ZZCANARY");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

struct NodesTrial : Trial {
    ui::NodesPanel& panel() { return test::the<ui::NodesPanel>(desktop.window()); }
    DesktopNodes& nodes() { return desktop.presenter<NodesPresenter>().job(); }

    void listen(quint16 port) {
        test::named<QSpinBox>(panel(), "Port").setValue(port);
        test::named<QCheckBox>(panel(), "Listen on port").setChecked(true);
    }
    int count(NodeState state) { return int(std::ranges::count(nodes().rows(), state, &ui::NodeRow::state)); }
    void waitForMore(std::uint64_t samples) {
        const std::uint64_t enough = frames.back()->status.samplesPerPixel + samples;
        QTRY_VERIFY_WITH_TIMEOUT(frames.back()->status.samplesPerPixel >= enough, test::kPatience);
    }
    bool neverFellBack() const {
        for (std::size_t i = 1; i < frames.size(); ++i)
            if (frames[i]->revision == frames[i - 1]->revision && !frames[i]->coarse && !frames[i - 1]->coarse &&
                frames[i]->status.samplesPerPixel < frames[i - 1]->status.samplesPerPixel)
                return false;
        return true;
    }
    QString events() {
        QStringList texts;
        for (const ui::PlotEvent& event : nodes().events())
            texts << event.text;
        return texts.join('\n');
    }
};

void TestNodesInWindow::nodesDialInAndTheImageGoesOnWithoutThem() {
    NodesTrial trial;
    trial.openAndWait(series_);
    const quint16 port = test::freePort();
    trial.listen(port);
    test::NodeProcess one(dialling(port, "one"));
    const test::NodeProcess two(dialling(port, "two"));
    QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::rendering), 2, test::kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(std::ranges::all_of(trial.nodes().rows(), [](const auto& row) { return row.share > 0; }),
                             test::kPatience);
    QCOMPARE(trial.panel().table().model()->rowCount(), 2);
    const QString first = trial.panel().table().model()->index(0, 0).data().toString();
    QVERIFY2(first.startsWith("one (127.0.0.1:") || first.startsWith("two (127.0.0.1:"), qPrintable(first));
    const QString lastLine = test::named<QLabel>(trial.panel(), "How the work is split").text();
    QVERIFY2(lastLine.startsWith("Tiles: ") && lastLine.endsWith("All nodes compute the same bits as this machine"),
             qPrintable(lastLine));
    QSignalSpy saved(&trial.desktop.presenter<SavingPresenter>().saver(), &ImageSaver::saved);
    trial.desktop.presenter<SavingPresenter>().save(trial.folder.filePath("image.png"), ui::Annotate::none);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, test::kPatience);
    const QString checks = QImage(trial.folder.filePath("image.png")).text("pdrender/nodes");
    QVERIFY2(checks.contains("tiles of render nodes were rendered twice"), qPrintable(checks));
    one.signal(SIGKILL);
    QTRY_COMPARE_WITH_TIMEOUT(trial.nodes().rows().size(), 1, test::kPatience);
    QTRY_VERIFY2_WITH_TIMEOUT(trial.events().contains("one was"), qPrintable(trial.events()), test::kPatience);
    trial.waitForMore(3);
    QVERIFY(trial.neverFellBack());
    QVERIFY(trial.desktop.window().message().isHidden());  // a kink in the curve, no box
}

void TestNodesInWindow::aNodeThatIsAddedIsDialledUntilItAnswers() {
    NodesTrial trial;
    trial.openAndWait(series_);
    const QString address = QString("127.0.0.1:%1").arg(test::freePort());
    emit trial.panel().addRequested(address);
    QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::dialling), 1, test::kPatience);
    trial.waitForMore(1);
    {
        const test::NodeProcess node({"--listen", address});
        QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::rendering), 1, test::kPatience);
    }
    QTRY_VERIFY_WITH_TIMEOUT(trial.count(NodeState::rendering) == 0 && trial.nodes().rows()[0].faults.lost == 1,
                             test::kPatience);
    const test::NodeProcess again({"--listen", address});
    QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::rendering), 1, test::kPatience);
    trial.waitForMore(2);
    QVERIFY(trial.neverFellBack());
    emit trial.panel().removeRequested(trial.nodes().rows()[0].id);
    QTRY_VERIFY_WITH_TIMEOUT(trial.nodes().rows().isEmpty(), test::kPatience);
    trial.waitForMore(2);
    QVERIFY(trial.neverFellBack());
}

void TestNodesInWindow::aPausedNodeRestsAndGoesOn() {
    NodesTrial trial;
    trial.openAndWait(series_);
    const quint16 port = test::freePort();
    trial.listen(port);
    const test::NodeProcess node(dialling(port));
    QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::rendering), 1, test::kPatience);
    const quint64 id = trial.nodes().rows()[0].id;
    emit trial.panel().pauseRequested(id, true);
    QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::paused), 1, test::kPatience);
    trial.waitForMore(2);
    emit trial.panel().pauseRequested(id, false);
    QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::rendering), 1, test::kPatience);
    QVERIFY(trial.neverFellBack());
}

/// A hanging node stops neither the image nor the window, which closes at the end.
void TestNodesInWindow::aNodeThatStandsStillHoldsNobodyUp() {
    const quint16 port = test::freePort();
    test::NodeProcess node(dialling(port));
    NodesTrial trial;
    trial.openAndWait(series_);
    trial.listen(port);
    QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::rendering), 1, test::kPatience);
    node.signal(SIGSTOP);
    QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::suspect), 1, test::kPatience);
    trial.waitForMore(3);
    QVERIFY(trial.neverFellBack());
    QVERIFY(!trial.events().contains("was lost"));  // it may come back
    node.signal(SIGCONT);
    QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::rendering), 1, test::kPatience);
    node.signal(SIGSTOP);
}

void TestNodesInWindow::theUserMaySayHowTheyShareTheWork() {
    NodesTrial trial;
    trial.openAndWait(series_);
    const quint16 port = test::freePort();
    trial.listen(port);
    const test::NodeProcess node(dialling(port));
    QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::rendering), 1, test::kPatience);
    auto& box = test::named<QComboBox>(trial.panel(), "How nodes share the work");
    for (const auto& [entry, said] : {std::pair(2, "Samples: chosen by hand"), std::pair(1, "Tiles: chosen by hand")}) {
        box.setCurrentIndex(entry);
        emit box.activated(entry);
        QTRY_COMPARE_WITH_TIMEOUT(trial.nodes().splitText(), QString(said), test::kPatience);
    }
    box.setCurrentIndex(0);
    emit box.activated(0);
    QTRY_VERIFY_WITH_TIMEOUT(!trial.nodes().splitText().contains("by hand"), test::kPatience);
    QVERIFY(trial.neverFellBack());
}

void TestNodesInWindow::whatIsWrongIsToldInThePanel() {
    NodesTrial trial;
    const auto said = [&] { return test::named<QLabel>(trial.panel(), "What could not be done").text(); };
    emit trial.panel().addRequested("192.0.2.7:4743");  // needs certificates
    QTRY_VERIFY_WITH_TIMEOUT(!said().isEmpty(), test::kPatience);
    QVERIFY2(said().contains("192.0.2.7"), qPrintable(said()));
    QCOMPARE(trial.count(NodeState::refused), 1);
    emit trial.panel().addRequested("192.0.2.7:4743");
    QCOMPARE(said(), QString("192.0.2.7:4743 is in the list already."));
    const test::TakenPort other;
    trial.listen(other.number());
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains(QString::number(other.number())), qPrintable(said()), test::kPatience);
    QVERIFY(trial.desktop.window().message().isHidden());
}

void TestNodesInWindow::theyAreWantedTheNextTime() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("settings.ini");
    const quint16 port = test::freePort();
    const QString address = QString("127.0.0.1:%1").arg(test::freePort());
    {
        Desktop desktop(*bundledLooks(), makeCpuDevice(1), file, 1);
        emit test::the<ui::NodesPanel>(desktop.window()).addRequested(address);
        emit test::the<ui::NodesPanel>(desktop.window()).addRequested("127.0.0.1:1");
        emit test::the<ui::NodesPanel>(desktop.window()).listenRequested(port);
        emit test::the<ui::NodesPanel>(desktop.window())
            .removeRequested(desktop.presenter<NodesPresenter>().job().rows()[1].id);
        emit test::the<ui::NodesPanel>(desktop.window()).splitRequested(Split::samples);
        emit test::the<ui::NodesPanel>(desktop.window()).checksAllRequested(true);
    }
    Desktop desktop(*bundledLooks(), makeCpuDevice(1), file, 1);
    QCOMPARE(desktop.presenter<NodesPresenter>().job().addresses(), QStringList{address});
    QCOMPARE(desktop.presenter<NodesPresenter>().job().port(), std::optional(port));
    QVERIFY(test::named<QCheckBox>(test::the<ui::NodesPanel>(desktop.window()), "Listen on port").isChecked());
    QCOMPARE(test::named<QSpinBox>(test::the<ui::NodesPanel>(desktop.window()), "Port").value(), int(port));
    QVERIFY(desktop.presenter<NodesPresenter>().job().wantedSplit() == Split::samples);
    QVERIFY(desktop.presenter<NodesPresenter>().job().checksAll());
    QCOMPARE(
        test::named<QComboBox>(test::the<ui::NodesPanel>(desktop.window()), "How nodes share the work").currentText(),
        QString("Always samples"));
}

/// Some of its voxels as they lie in memory: enough not to be there by chance.
static QByteArray someVoxels(const Volume& volume) {
    const std::span<const std::int16_t> voxels = volume.voxels();
    const std::size_t middle = voxels.size() / 2;
    std::size_t best = middle, most = 0;
    for (std::size_t at = middle; at + 24 < std::min(voxels.size(), middle + 20'000); ++at) {
        const std::set<std::int16_t> values(voxels.begin() + std::ptrdiff_t(at),
                                            voxels.begin() + std::ptrdiff_t(at + 24));
        if (values.size() > most) {
            most = values.size();
            best = at;
        }
    }
    return {reinterpret_cast<const char*>(&voxels[best]), 48};
}

void TestNodesInWindow::nothingOfTheScanStaysWithThem() {
    NodesTrial trial;
    trial.openAndWait(series_);
    const quint16 port = test::freePort();
    trial.listen(port);
    const test::NodeProcess node(dialling(port));
    QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::rendering), 1, test::kPatience);
    const QByteArray voxels = someVoxels(*trial.desktop.document().scene().volume);
    const std::optional<int> there = test::timesInMemoryOf(node.id(), voxels.toStdString());
    if (!there)
        QSKIP("the memory of another program cannot be read here");
    QVERIFY(*there > 0);
    QCOMPARE(test::timesInMemoryOf(node.id(), "ZZCANARY"), std::optional(0));
    trial.desktop.bridge().clear();
    QTRY_COMPARE_WITH_TIMEOUT(test::timesInMemoryOf(node.id(), voxels.toStdString()), std::optional(0),
                              test::kPatience);
    QCOMPARE(trial.nodes().rows().size(), 1);  // it stays connected
}

void TestNodesInWindow::theWindowClosesWithNodesConnected() {
    const quint16 port = test::freePort();
    const test::NodeProcess node(dialling(port));
    QByteArray voxels;
    {
        NodesTrial trial;
        trial.openAndWait(series_);
        trial.listen(port);
        QTRY_COMPARE_WITH_TIMEOUT(trial.count(NodeState::rendering), 1, test::kPatience);
        voxels = someVoxels(*trial.desktop.document().scene().volume);
    }
    if (!test::timesInMemoryOf(node.id(), voxels.toStdString()))
        QSKIP("the memory of another program cannot be read here");
    QTRY_COMPARE_WITH_TIMEOUT(test::timesInMemoryOf(node.id(), voxels.toStdString()), std::optional(0),
                              test::kPatience);
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestNodesInWindow)
#include "nodes_in_window_test.moc"
