/// Any exception of a device becomes an error text for the user, and the next scene is rendered.

#include <QTest>
#include <new>
#include <stdexcept>
#include <system_error>

#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/screen.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

Scene someScene(std::uint64_t revision) {
    Scene scene = test::plainScene(test::bumpyVolume({20, 20, 20}, dvec3(1), 3), 1);
    scene.film = {12, 8};
    scene.revision = revision;
    return scene;
}

void throwSomething(int what) {
    if (what == 0)
        throw std::bad_alloc();
    if (what == 1)
        throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again), "a thread");
    throw 7;
}

}  // namespace

class ExceptionsTest : public QObject {
    Q_OBJECT

  private slots:
    void aThrowingDeviceIsAFailureInWords_data() {
        QTest::addColumn<QString>("verb");
        QTest::addColumn<int>("what");
        QTest::addColumn<QString>("words");
        for (const char* verb : {"upload", "film", "accumulate", "resolve", "readback"})
            for (int what = 0; what < 3; ++what) {
                const char* names[] = {"no memory", "no thread", "something"};
                const char* words[] = {"memory", "a thread", "unknown"};
                QTest::newRow(qPrintable(QString("%1, %2").arg(verb, names[what]))) << verb << what << words[what];
            }
    }

    void aThrowingDeviceIsAFailureInWords() {
        QFETCH(QString, verb);
        QFETCH(int, what);
        QFETCH(QString, words);
        std::atomic<bool> throws = true;
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->before = [&](const std::string& called) {
            if (throws && called == verb.toStdString())
                throwSomething(what);
        };
        test::Screen screen;
        Session session(test::failing(mishaps), screen.sink());
        session.submit(someScene(1), false);
        const auto failed = screen.await([](const Frame& frame) { return !frame.error.empty(); });
        QVERIFY(failed && failed->revision == 1);
        QVERIFY2(QString::fromStdString(failed->error).contains(words), failed->error.c_str());
        throws = false;
        session.submit(someScene(2), false);
        QVERIFY(screen.await([](const Frame& frame) { return frame.revision == 2 && frame.error.empty(); }));
    }

    void aDeviceThatThrowsIsLeftForTheFallback() {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->before = [](const std::string& verb) {
            if (verb == "resolve")
                throw std::bad_alloc();
        };
        test::Screen screen;
        Session session(test::failing(mishaps), screen.sink(), [] { return makeCpuDevice(1); });
        session.submit(someScene(1), false);
        QVERIFY(screen.await([](const Frame& frame) { return frame.device == "cpu"; }));
        QCOMPARE(screen.notices().size(), std::size_t(1));
    }

    void aFallbackThatThrowsIsAFailureInWords() {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->gone = true;
        test::Screen screen;
        Session session(test::failing(mishaps), screen.sink(),
                        []() -> Result<std::unique_ptr<Device>> { throw std::bad_alloc(); });
        session.submit(someScene(1), false);
        const auto failed = screen.await([](const Frame& frame) { return !frame.error.empty(); });
        QVERIFY(failed && failed->error.find("memory") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(ExceptionsTest)
#include "exceptions_test.moc"
