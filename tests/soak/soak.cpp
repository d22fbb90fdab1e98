/// Render nodes under everything that goes wrong, for a long time: every 200 ms something happens to one of eight nodes
/// or to its network, as a seed says, while images are made one after the other; each must be the one made alone.
///   soak [--minutes M] [--nodes N] [--seed N]
/// Prints a table at the end: images, wrong ones, the longest, what was done to nodes, and how this program's memory
/// grew after the first minute. Exit code 1: an image was wrong, or memory grew.

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QTimer>
#include <array>
#include <atomic>
#include <cstdio>
#include <mutex>
#include <random>
#include <thread>

#include "tests/support/network/fault_proxy.h"
#include "tests/support/network/shared_image.h"

namespace pdr::test {
namespace {

const std::vector<std::uint32_t> kOrders{1, 7, 56, 64, 40};

enum class Blow { kill, stop, blackHole, reset, halfClose, pieces, duplicate, stall, slow };
constexpr std::array kBlows{"killed",        "stopped for 5 s", "black hole", "reset",          "half closed",
                            "1-byte pieces", "bytes twice",     "5 s stall",  "100 kB a second"};

Scene soakScene(int number) {
    Scene scene = tissueScene();
    scene.film = {122, 90};
    scene.camera.eyeMm.x += 5 * (number % 4);
    scene.revision = std::uint64_t(number);
    return scene;
}

/// A node and its bad network.
struct Victim {
    std::unique_ptr<NodeProcess> process;
    std::unique_ptr<FaultProxy> proxy;
    nodes::NodeId id = 0;
    qint64 mendAt = 0;  ///< ms; 0: nothing is wrong
};

long residentKilobytes() {
    QFile status("/proc/self/status");
    if (!status.open(QIODevice::ReadOnly))
        return 0;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("VmRSS:"))
            return line.simplified().split(' ').value(1).toLong();
    return 0;
}

class Soak {
  public:
    Soak(int nodes, unsigned seed) : random_(seed), victims_(std::size_t(nodes)) {
        for (Victim& victim : victims_)
            begin(victim);
        clock_.start();
    }

    void strike() {
        mend();
        Victim& victim = victims_[random_() % victims_.size()];
        if (victim.mendAt != 0)
            return;
        const auto blow = Blow(random_() % kBlows.size());
        ++blows_[std::size_t(blow)];
        NetworkFault bad;
        switch (blow) {
            case Blow::kill:
                trial_.nodes.remove(victim.id);
                begin(victim);
                return;
            case Blow::reset:
                return victim.proxy->reset();
            case Blow::halfClose:
                return victim.proxy->end(random_() % 2 == 0 ? Direction::toClient : Direction::toServer);
            case Blow::stop:
                victim.process->signal(SIGSTOP);
                break;
            case Blow::blackHole:
                bad.blackHole = true;
                break;
            case Blow::pieces:
                bad.mostPiece = 1;
                break;
            case Blow::duplicate:
                bad.duplicate = victim.proxy->passed(Direction::toClient) + 1000;
                break;
            case Blow::stall:
                bad.stall = true;
                break;
            case Blow::slow:
                bad.bytesPerSecond = 100'000;
                break;
        }
        victim.proxy->set(Direction::toClient, bad);
        victim.proxy->set(Direction::toServer, blow == Blow::duplicate ? NetworkFault{} : bad);
        victim.mendAt = clock_.elapsed() + 5000;
    }

    void render(const std::atomic<bool>& over) {
        std::vector<FilmContent> truths;
        for (int number = 0; number < 4; ++number)
            truths.push_back(imageAlone(soakScene(number), kOrders));
        while (!over) {
            QElapsedTimer took;
            took.start();
            const FilmContent image = trial_.image(soakScene(images_), kOrders);
            wrong_ += sameBits(image, truths[std::size_t(images_ % 4)]) ? 0 : 1;
            longest_ = std::max(longest_, took.elapsed());
            ++images_;
        }
    }

    void noteMemory() {
        const long now = residentKilobytes();
        if (clock_.elapsed() > 60'000) {
            if (firstMemory_ == 0)
                firstMemory_ = now;
            lastMemory_ = now;
        }
    }

    /// The table; whether all is well.
    bool tell() const {
        std::printf("%-28s %lld\n", "minutes", clock_.elapsed() / 60'000);
        std::printf("%-28s %d\n%-28s %d\n%-28s %.1f s\n", "pictures", images_.load(), "wrong pictures", wrong_.load(),
                    "longest picture", double(longest_) / 1000);
        for (std::size_t i = 0; i < kBlows.size(); ++i)
            std::printf("%-28s %d\n", kBlows[i], blows_[i]);
        const double mega = double(lastMemory_ - firstMemory_) / 1000;
        std::printf("%-28s %ld MB, then %+.1f MB\n", "memory after a minute", firstMemory_ / 1000, mega);
        return wrong_ == 0 && images_ > 0 && mega < 32;
    }

  private:
    void begin(Victim& victim) {
        victim.process = std::make_unique<NodeProcess>();
        victim.proxy =
            std::make_unique<FaultProxy>(quint16(victim.process->address().section(':', -1).toInt()), random_());
        const auto added = trial_.nodes.add(QString("localhost:%1").arg(victim.proxy->port()));
        if (!added)
            qFatal("%s", added.error().text().c_str());
        victim.id = *added;
    }

    void mend() {
        for (Victim& victim : victims_)
            if (victim.mendAt != 0 && clock_.elapsed() >= victim.mendAt) {
                victim.process->signal(SIGCONT);
                victim.proxy->set(Direction::toClient, {});
                victim.proxy->set(Direction::toServer, {});
                victim.mendAt = 0;
            }
    }

    std::mt19937 random_;
    NodeTrial trial_;
    std::vector<Victim> victims_;
    QElapsedTimer clock_;
    std::array<int, kBlows.size()> blows_{};
    std::atomic<int> images_ = 0, wrong_ = 0;
    qint64 longest_ = 0;
    long firstMemory_ = 0, lastMemory_ = 0;
};

int run() {
    QCommandLineParser parser;
    parser.addOptions({{"minutes", "", "M", "30"}, {"nodes", "", "N", "8"}, {"seed", "", "N", "1"}});
    parser.process(*QCoreApplication::instance());
    Soak soak(parser.value("nodes").toInt(), parser.value("seed").toUInt());
    std::atomic<bool> over = false;
    std::jthread renderer([&] { soak.render(over); });
    QTimer striking, remembering;
    QObject::connect(&striking, &QTimer::timeout, [&] { soak.strike(); });
    QObject::connect(&remembering, &QTimer::timeout, [&] { soak.noteMemory(); });
    QTimer::singleShot(int(parser.value("minutes").toDouble() * 60'000), QCoreApplication::instance(),
                       &QCoreApplication::quit);
    striking.start(200);
    remembering.start(1000);
    QCoreApplication::exec();
    striking.stop();
    over = true;
    renderer.join();
    return soak.tell() ? 0 : 1;
}

}  // namespace
}  // namespace pdr::test

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    return pdr::test::run();
}
