#include <QTemporaryDir>
#include <QTest>

#include "app/remote/certificates.h"
#include "tests/support/network/shared_image.h"
#include "tests/support/network/two_networks.h"

using namespace pdr;
using namespace pdr::test;

/// A node on another machine, as far as the system's own network can tell, and a cable that comes loose.
class CutCableTest : public QObject {
    Q_OBJECT

    TwoNetworks networks_;
    QTemporaryDir folder_;
    FilmContent alone_;

    QString bundle(const char* role) const { return folder_.filePath(QString("bundle/") + role); }
    QStringList optionsOf(bool nodeDials, quint16 port) const {
        const QString where = nodeDials ? TwoNetworks::kHere : TwoNetworks::kThere;
        return {nodeDials ? "--coordinator" : "--listen", QString("%1:%2").arg(where).arg(port), "--bundle",
                bundle("node")};
    }
    /// Returns whether no node can take samples: each has connected too late or has gone.
    static bool noneIsReady(const NodeTrial& trial) {
        return std::ranges::none_of(trial.pool->workers(),
                                    [](const WorkerStatus& one) { return one.state == WorkerState::ready; });
    }

  private slots:
    void initTestCase() {
        if (const QString why = networks_.make(); !why.isEmpty())
            QSKIP(qPrintable(why));
        if (!networks_.limitRate("50mbit"))
            qInfo("the cable is as fast as it can be: there is no tc here, or it cannot limit rates");
        QVERIFY(bool(remote::makeCertificates(folder_.filePath("bundle"))));
        alone_ = imageAlone(sharedScene(), kSharedOrders);
    }

    void looseCableCostsNoPixel_data() {
        QTest::addColumn<bool>("nodeDials");
        QTest::addColumn<bool>("untilItIsLost");  // or only until it is silent
        for (const bool nodeDials : {true, false})
            for (const bool lost : {true, false})
                QTest::addRow("%s, %s", nodeDials ? "node dials" : "node waits", lost ? "lost" : "silent")
                    << nodeDials << lost;
    }
    void looseCableCostsNoPixel() {
        QFETCH(const bool, nodeDials);
        QFETCH(const bool, untilItIsLost);
        NodeTrial trial;
        trial.pool->setOwnHelps(false);  // as long as somebody else can
        trial.nodes.setBundle(bundle("coordinator"));
        const auto listens = nodeDials ? trial.nodes.listen(TwoNetworks::kHere + ":0") : remote::Address{};
        QVERIFY2(bool(listens), listens ? "" : listens.error().text().c_str());
        const NodeProcess node(optionsOf(nodeDials, nodeDials ? listens->port : 4743), networks_.enterThere());
        if (!nodeDials)
            QVERIFY(bool(trial.nodes.add(TwoNetworks::kThere)));
        const auto film = *startFilm(*trial.device, sharedScene());
        trial.awaitReady(1);
        QVERIFY(film->accumulate(2, {}));
        QVERIFY(trial.workOfNodes() > 0);
        QVERIFY(networks_.setLink(false));
        QVERIFY(film->accumulate(62, {}));
        QTRY_VERIFY_WITH_TIMEOUT(untilItIsLost ? trial.pool->workers().empty() : noneIsReady(trial), kPatience);
        QVERIFY(networks_.setLink(true));
        trial.awaitReady(1);
        QVERIFY(film->accumulate(64, {}));
        QVERIFY(sameBits((*film->film())->content(), alone_));
        if (untilItIsLost)  // it works again; what was only silent may still be lost now
            QVERIFY(trial.workOfNodes() > 0);
    }
};

QTEST_GUILESS_MAIN(CutCableTest)
#include "cut_cable_test.moc"
