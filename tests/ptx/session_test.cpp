/// The window's render thread with the CUDA device: what is chosen while an image is rendered, and what fails.

#include <QTest>

#include <future>

#include "tests/ptx/runtime/runtime.h"
#include "tests/ptx/small_scenes.h"
#include "tests/support/devices/screen.h"

using namespace pdr;

namespace {

const DeviceOpener kCpu = [] { return makeCpuDevice(1); };
const DeviceOpener kCuda = [] { return openDevice("cuda"); };

Scene scene() {
    return test::sceneOf(kSurface | kEnvironment);
}

auto samplesOn(const std::string& device, std::uint64_t least) {
    return [=](const Frame& frame) { return frame.device == device && frame.status.samplesPerPixel >= least; };
}

/// Returns the film of the image.
Film filmOf(Session& session) {
    auto film = std::make_shared<std::promise<Film>>();
    auto future = film->get_future();
    session.requestSnapshot(scene().revision, [film](const Result<FilmView>& view) { film->set_value(view->film); });
    return future.get();
}

/// Returns whether `film` is, bit by bit, that of its samples taken on the CPU.
bool neverInterrupted(const Film& film) {
    const auto all = test::shot(**kCpu(), scene(), std::uint32_t(film.samplesPerPixel()));
    return film.samplesPerPixel() > 0 && all && sameBits(all->content(), film.content());
}

/// Lets no call of the runtime succeed any more.
void loseTheGpu() {
    ptx::Runtime::get().call("test", [](ptx::Runtime&) { return cudaErrorLaunchFailure; });
}

}  // namespace

class SessionTest : public QObject {
    Q_OBJECT

  private slots:
    void anotherDeviceGoesOnFromTheSamples() {
        test::Screen screen;
        Session session(*kCuda(), screen.sink(), kCpu);
        session.submit(scene(), false);
        session.goOn();
        QVERIFY(screen.await(samplesOn("cuda", 5)));
        std::uint64_t before = 0;
        for (const DeviceOpener& device : {kCpu, kCuda, kCpu, kCuda}) {
            session.setDevice(device);
            const Film film = filmOf(session);
            QVERIFY(film.samplesPerPixel() >= before);
            before = film.samplesPerPixel();
        }
        QVERIFY(screen.await(samplesOn("cuda", before + 3)));
        QVERIFY(neverInterrupted(filmOf(session)));
        QVERIFY(screen.notices().empty());
    }

    /// The last test: no GPU works in this process after it.
    void aLostGpuIsToldAndTheImageGoesOn() {
        test::Screen screen;
        Session session(*kCuda(), screen.sink(), kCpu);
        session.submit(scene(), false);
        session.goOn();
        QVERIFY(screen.await(samplesOn("cuda", 5)));
        loseTheGpu();
        QVERIFY(screen.await(samplesOn("cpu", 5)));
        QVERIFY(neverInterrupted(filmOf(session)));
        QCOMPARE(screen.notices().size(), std::size_t(1));
        const QString notice = QString::fromStdString(screen.notices().front());
        QVERIFY2(notice.startsWith("The GPU cuda stopped answering: ") && notice.contains("the GPU was lost (") &&
                     notice.contains("Start the program again to use the GPU") &&
                     notice.endsWith("Rendering continues on the CPU."),
                 qPrintable(notice));
        // Choosing it again says the same, and the image stays where it is
        session.setDevice(kCuda);
        const std::uint64_t before = filmOf(session).samplesPerPixel();
        QVERIFY(screen.await(samplesOn("cpu", before + 3)));
        QTRY_COMPARE(screen.notices().size(), std::size_t(2));
        QVERIFY(screen.notices().back().find("Start the program again to use the GPU") != std::string::npos);
        QVERIFY(neverInterrupted(filmOf(session)));
    }
};

QTEST_GUILESS_MAIN(SessionTest)
#include "session_test.moc"
