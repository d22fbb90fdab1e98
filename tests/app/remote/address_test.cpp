/// What counts as an address.

#include <QTest>

#include "app/remote/address.h"

using namespace pdr;
using namespace pdr::remote;

class AddressTest : public QObject {
    Q_OBJECT

  private slots:
    void addressesAreRead_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("host");
        QTest::addColumn<int>("port");
        QTest::addRow("name") << "gpu-07.example.org"
                              << "gpu-07.example.org" << 4743;
        QTest::addRow("name and port") << "gpu-07:80"
                                       << "gpu-07" << 80;
        QTest::addRow("IPv4") << "192.0.2.7"
                              << "192.0.2.7" << 4743;
        QTest::addRow("IPv4 and port") << "192.0.2.7:65535"
                                       << "192.0.2.7" << 65535;
        QTest::addRow("IPv6 in brackets") << "[::1]"
                                          << "::1" << 4743;
        QTest::addRow("IPv6 and port") << "[2001:db8::7]:1"
                                       << "2001:db8::7" << 1;
        QTest::addRow("IPv6") << "2001:db8::7"
                              << "2001:db8::7" << 4743;
    }
    void addressesAreRead() {
        QFETCH(QString, text);
        QFETCH(QString, host);
        QFETCH(int, port);
        const auto address = parseAddress(text);
        QVERIFY2(address, address ? "" : address.error().text().c_str());
        QCOMPARE(address->host, host);
        QCOMPARE(int(address->port), port);
        QVERIFY(*parseAddress(address->text()) == *address);
        QVERIFY(*parseListening(text) == *address);
    }

    void othersAreRefused_data() {
        QTest::addColumn<QString>("text");
        for (const char* text :
             {"",          ":4743", "host:",     "host:0",   "host:65536", "host:-1", "host:+5", "host:4x",
              "host: 5",   "[::1",  "[::1]4743", "[host]:5", "[]:5",       "::1]",    "a b",     "http://host",
              "user@host", "1:2:3", "[::1]:",    "[::1]:0",  "h\u00f6st",  "[host"})
            QTest::addRow("'%s'", text) << QString(text);
    }
    void othersAreRefused() {
        QFETCH(QString, text);
        const auto address = parseAddress(text);
        QVERIFY(!address);
        QVERIFY(!address.error().what.empty() && !address.error().hint.empty());
    }

    void aPortAloneListensEverywhere() {
        QVERIFY((*parseListening("4743") == Address{"", 4743}));
        QVERIFY((*parseListening("0") == Address{"", 0}));
        QVERIFY((*parseListening("localhost:0") == Address{"localhost", 0}));
        QVERIFY(!parseListening("65536") && !parseListening(""));
        QVERIFY(!Address{}.isLoopback());
    }

    void loopbackIsThisMachineOnly() {
        for (const char* host : {"localhost", "LocalHost", "127.0.0.1", "127.9.9.9", "::1", "::ffff:127.0.0.1"})
            QVERIFY2(Address{host}.isLoopback(), host);
        for (const char* host :
             {"0.0.0.0", "::", "128.0.0.1", "192.0.2.7", "localhost.example.org", "127.0.0.1.nip.io"})
            QVERIFY2(!Address{host}.isLoopback(), host);
    }
};

QTEST_APPLESS_MAIN(AddressTest)
#include "address_test.moc"
