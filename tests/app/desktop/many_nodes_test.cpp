/// Many nodes at once: the window's thread stays free, counted in its own processor time, so that a busy machine
/// changes nothing.

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <memory>
#include <vector>

#include "app/coordinator/reference_bits.h"
#include "app/presenters/nodes_presenter.h"
#include "app/remote/certificates.h"
#include "app/remote/dial.h"
#include "app/remote/listener.h"
#include "render/tiles/reference_tiles.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/event_times.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/network/taken_port.h"
#include "ui/nodes/nodes_panel.h"
#include "ui/text/to_qt.h"
#include "ui/theme/theme.h"

namespace pdr::app {

static wire::Hello greeting(int number, const wire::Hash& bits) {
    wire::Hello hello;
    hello.program = "test";
    hello.name = "node " + std::to_string(number);
    hello.bits = bits;
    hello.boot[0] = std::byte(number);
    hello.device = "cpu";
    return hello;
}

/// Nodes that take the scan and never say that they have it, on a thread of their own.
class Crowd : public QObject {
    Q_OBJECT

  public:
    Crowd(int count, const remote::Address& address, remote::Identity identity)
        : address_(address), identity_(std::move(identity)), bits_(nodes::bitsOf(*referenceTiles(*makeCpuDevice(1)))) {
        moveToThread(&thread_);
        thread_.start();
        QMetaObject::invokeMethod(this, [this, count] {
            for (int i = 0; i < count; ++i)
                dial(i);
        });
    }
    ~Crowd() override {
        QMetaObject::invokeMethod(
            this, [this] { qDeleteAll(children()); }, Qt::BlockingQueuedConnection);
        thread_.quit();
        thread_.wait();
    }

  private:
    void dial(int number) {
        auto* dial = new remote::Dial(address_, identity_, {}, this);
        connect(dial, &remote::Dial::connected, this, [this, number](remote::Channel* channel) {
            channel->setParent(this);
            connect(channel, &remote::Channel::received, this,
                    [channel](const wire::Message& message) { answer(*channel, message); });
            connect(channel, &remote::Channel::closed, this,
                    [this, number] { this->dial(number); });  // it was too slow
            channel->send(greeting(number, bits_));
        });
        connect(dial, &remote::Dial::failed, this, [this, number] { this->dial(number); });
    }
    static void answer(remote::Channel& channel, const wire::Message& message) {
        if (std::holds_alternative<wire::Welcome>(message))
            channel.setAdmitted();
        if (const auto* ping = std::get_if<wire::Ping>(&message))
            channel.send(wire::Pong{ping->number});
        if (const auto* order = std::get_if<wire::SceneOrder>(&message))
            channel.send(wire::Need{order->volume.content, 0});
    }

    remote::Address address_;
    remote::Identity identity_;
    wire::Hash bits_;
    QThread thread_;
};

class TestManyNodes : public QObject {
    Q_OBJECT

  private slots:
    void sixtyFourLeaveTheWindowFree();
    void whoMakesOtherBitsIsRefusedAndSaid();
};

static test::TimedApplication& application() {
    return *static_cast<test::TimedApplication*>(qApp);
}

void TestManyNodes::sixtyFourLeaveTheWindowFree() {
    constexpr int kNodes = 64;
    constexpr double kMostMs = 50;
    const QTemporaryDir folder;
    const QString series = folder.filePath("series"), bundle = folder.filePath("bundle");
    QVERIFY(writePhantomSeries(ui::fromQt(series), "Head of a phantom"));
    QVERIFY(remote::makeCertificates(bundle));
    Trial trial;
    ui::NodesPanel& panel = test::the<ui::NodesPanel>(trial.desktop.window());
    panel.parentWidget()->show();
    trial.openAndWait(series);
    const quint16 port = test::freePort();
    emit panel.bundleRequested(bundle);
    emit panel.listenRequested(port);
    application().times.clear();
    QElapsedTimer clock;
    clock.start();
    const Crowd crowd(kNodes, {"127.0.0.1", port}, *remote::readIdentity(bundle, remote::Role::node));
    const auto named = [&] {
        return std::ranges::count_if(trial.desktop.presenter<NodesPresenter>().job().rows(),
                                     [](const ui::NodeRow& row) { return !row.name.isEmpty(); });
    };
    QTRY_COMPARE_WITH_TIMEOUT(named(), kNodes, test::kPatience);
    qInfo("%d nodes are known after %.2f s", kNodes, double(clock.elapsed()) / 1000);
    QTest::qWait(3000);  // of updates
    const test::TimedApplication& app = application();
    const double p99 = app.at(0.99, &test::EventTime::processorMs);
    qInfo("%zu events, processor time p99 %.2f ms, most %.2f ms; by the clock p99 %.2f ms", app.times.size(), p99,
          app.at(1, &test::EventTime::processorMs), app.at(0.99, &test::EventTime::wallMs));
    QVERIFY2(p99 <= kMostMs, app.longest(8).c_str());
    QTRY_COMPARE_WITH_TIMEOUT(panel.table().model()->rowCount(), kNodes, test::kPatience);
}

void TestManyNodes::whoMakesOtherBitsIsRefusedAndSaid() {
    remote::Listener node({remote::Role::node, std::nullopt});
    QVERIFY(node.listen({"127.0.0.1", 0}));
    connect(&node, &remote::Listener::connected, &node,
            [](remote::Channel* channel) { channel->send(greeting(1, wire::Hash{})); });
    Trial trial;
    ui::NodesPanel& panel = test::the<ui::NodesPanel>(trial.desktop.window());
    emit panel.addRequested(node.address().text());
    const auto rows = [&] { return trial.desktop.presenter<NodesPresenter>().job().rows(); };
    QTRY_COMPARE_WITH_TIMEOUT(rows().value(0).state, ui::NodeState::refused, test::kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!rows()[0].sameBits && rows()[0].name == "node 1", test::kPatience);
    const QString said = panel.table().model()->index(0, ui::NodesModel::state).data().toString();
    QVERIFY2(said.contains("last bits"), qPrintable(said));
    QVERIFY(trial.desktop.window().message().isHidden());
}

}  // namespace pdr::app

int main(int argc, char** argv) {
    pdr::test::TimedApplication application(argc, argv);
    pdr::ui::applyTheme(application, pdr::ui::ThemeChoice::dark);
    pdr::app::TestManyNodes test;
    return QTest::qExec(&test, argc, argv);
}

#include "many_nodes_test.moc"
