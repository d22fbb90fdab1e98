/// One render node and several programs that use it at once.

#include <QProcess>
#include <QTest>

#include <ctime>
#include <future>

#include "tests/support/exr_channels.h"
#include "tests/support/network/process_memory.h"
#include "tests/support/network/shared_image.h"
#include "tests/support/scenes/ball_scene.h"

using namespace pdr;
using namespace pdr::test;

namespace {

/// A row of voxels that stands nowhere else.
constexpr int kRow = 32;

std::int16_t markOf(int i, int step) {
    return std::int16_t(1000 + (i * step) % 997);
}

std::string rowOf(int step) {
    std::string row;
    for (int i = 0; i < kRow; ++i) {
        const std::int16_t hu = markOf(i, step);
        row.append(reinterpret_cast<const char*>(&hu), sizeof hu);
    }
    return row;
}

/// Gives the ball's scene a volume of such rows.
void mark(const BallScene& ball, int step) {
    QByteArray voxels;
    for (int row = 0; row < kRow * kRow; ++row)
        voxels += QByteArray::fromStdString(rowOf(step));
    BallScene::write(ball.at("ball.raw"), voxels);
}

Scene marked(int step) {
    return plainScene(makeVolume({kRow, 30, 31}, {1, 1, 1}, [=](int i, int, int) { return markOf(i, step); }), 0.05f);
}

/// Returns the processor time of a program [s].
double processorTimeOf(qint64 process) {
    clockid_t clock;
    timespec time;
    if (clock_getcpuclockid(pid_t(process), &clock) != 0 || clock_gettime(clock, &time) != 0)
        qFatal("the processor time of a program is not known");
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

QStringList listening(int coordinators) {
    return {"--listen", "127.0.0.1:0", "--name", "alpha", "--coordinators", QString::number(coordinators)};
}

/// A program that only checks what the node sends.
struct User : NodeTrial {
    explicit User(const NodeProcess& node) {
        pool->setOwnHelps(false);
        add(node);
    }
    nodes::NodeStatus status() const {
        const std::vector<nodes::NodeStatus> all = nodes.look();
        return all.empty() ? nodes::NodeStatus() : all[0];
    }
    /// Takes samples of `scene` on a thread until it is stopped.
    std::jthread render(const Scene& scene) const {
        return std::jthread([this, scene](const std::stop_token& stop) {
            const auto film = *startFilm(*device, scene);
            awaitReady(1);
            while (!stop.stop_requested())
                (void)film->accumulate(100'000, stop);
        });
    }
    void leave() { nodes.remove(status().id); }
};

bool isAt(const User& user, int place) {
    const nodes::NodeStatus status = user.status();
    return status.state == nodes::NodeState::waiting &&
           status.reason == "number " + std::to_string(place) + " in the line, since others use this render node";
}

}  // namespace

class SharedNodeTest : public QObject {
    Q_OBJECT

  private slots:
    void imagesHaveTheBitsOfAlone() {
        NodeProcess process(listening(3));
        std::vector<std::future<bool>> images;
        std::vector<std::unique_ptr<User>> users;
        for (std::uint64_t i = 0; i < 3; ++i) {
            users.push_back(std::make_unique<User>(process));
            images.push_back(std::async(std::launch::async, [&user = *users.back(), i] {
                Scene scene = sharedScene(i + 1);
                scene.volume = bumpyVolume({40, 31, 37}, {0.9, 1.1, 1.3}, int(i) + 5);
                return sameBits(user.image(scene, kSharedOrders, 1), imageAlone(scene, kSharedOrders));
            }));
        }
        for (auto& image : images)
            QVERIFY(image.get());
        for (const auto& user : users)
            QVERIFY(user->workOfNodes() > 0);
    }

    void programsShareIt() {
        const BallScene ball;
        NodeProcess process(listening(2));
        const auto options = [&](const QString& file, const QString& size) {
            return QStringList{"render",    ball.scene(), "-o",       ball.at(file), "--size",    size,
                               "--samples", "256",        "--device", "cpu",         "--threads", "1"};
        };
        const QStringList help{"--node", process.address(), "--nodes-only", "--await", "1"};
        std::array<QProcess, 2> programs;
        const std::array<QString, 2> sizes{"96x80", "60x44"};
        for (int i = 0; i < 2; ++i)
            programs[i].start(PDR_BINARY_DIR "/bin/pdrender-cli", options(QString("%1.exr").arg(i), sizes[i]) + help);
        for (int i = 0; i < 2; ++i) {
            QVERIFY(programs[i].waitForFinished(kPatience));
            const QByteArray said = programs[i].readAllStandardError();
            QVERIFY2(programs[i].exitCode() == 0 && said.contains("node alpha (cpu, 1 thread) is there"), said);
            QVERIFY2(said.contains("node alpha: ") && !said.contains("took no part"), said);
            QCOMPARE(BallScene::run(options("alone.exr", sizes[i])).code, 0);
            const std::vector<float> alone = exrValues(ball.at("alone.exr").toStdString());
            QVERIFY(!alone.empty() && exrValues(ball.at(QString("%1.exr").arg(i)).toStdString()) == alone);
        }
    }

    /// All samples cost the same, so that they count processor time; the leases of one program are smaller.
    void sharesAreEqual() {
        NodeProcess process(listening(2));
        User large(process), small(process);
        Scene scene = plainScene(makeVolume(ivec3(48), dvec3(1), [](int, int, int) { return 500; }), 0.3f);
        scene.camera.fovDegrees = 5;
        scene.revision = 1;
        scene.film = {400, 296};
        std::jthread one = large.render(scene);
        scene.film = {48, 36};
        scene.revision = 2;
        std::jthread other = small.render(scene);
        const auto isTrusted = [](const User& user) {
            const std::vector<WorkerStatus> workers = user.pool->workers();
            return !workers.empty() && workers[0].isProved;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isTrusted(large) && isTrusted(small), kPatience);
        const double start = processorTimeOf(process.id()), had = large.workOfNodes(), had2 = small.workOfNodes();
        QTRY_VERIFY_WITH_TIMEOUT(processorTimeOf(process.id()) > start + 5, kPatience);
        const double ratio = (small.workOfNodes() - had2) / (large.workOfNodes() - had);
        qInfo("work of the small image to that of the large one: %.3f", ratio);
        QVERIFY2(ratio > 0.8 && ratio < 1.25, qPrintable(QString::number(ratio)));
        one.request_stop();
        other.request_stop();
    }

    void scanIsGoneWithItsProgram() {
        NodeProcess process(listening(2));
        if (!timesInMemoryOf(process.id(), "x"))
            QSKIP("the memory of another program cannot be read here");
        const auto times = [&](int step) { return *timesInMemoryOf(process.id(), rowOf(step)); };
        User stays(process);
        (void)stays.image(marked(7919), {64}, 1);
        {
            User goes(process);
            (void)goes.image(marked(6271), {64}, 1);
            QVERIFY(times(6271) > 0);
        }
        QTRY_COMPARE_WITH_TIMEOUT(times(6271), 0, kPatience);
        QVERIFY(times(7919) > 0);
        QVERIFY(sameBits(stays.image(marked(7919), {64}), imageAlone(marked(7919), {64})));
    }

    /// A program that is killed may only have lost its connection: its scan stays for a minute, or until its place is
    /// needed. What others render is not touched.
    void scanOfAKilledProgramIsGone() {
        NodeProcess process(listening(2));
        if (!timesInMemoryOf(process.id(), "x"))
            QSKIP("the memory of another program cannot be read here");
        const auto times = [&](int step) { return *timesInMemoryOf(process.id(), rowOf(step)); };
        const BallScene ball;
        mark(ball, 6271);
        QProcess killed;
        killed.start(PDR_BINARY_DIR "/bin/pdrender-cli",
                     {"render", ball.scene(), "-o", ball.at("a.exr"), "--samples", "100000000", "--device", "cpu",
                      "--threads", "1", "--node", process.address(), "--nodes-only"});
        QTRY_VERIFY_WITH_TIMEOUT(times(6271) > 0, kPatience);
        User stays(process);
        auto image = std::async(std::launch::async, [&] { return stays.image(marked(7919), {2, 62, 256}, 1); });
        QTRY_VERIFY_WITH_TIMEOUT(stays.workOfNodes() > 0, kPatience);
        killed.kill();
        QVERIFY(killed.waitForFinished(kPatience));
        QVERIFY(sameBits(image.get(), imageAlone(marked(7919), {2, 62, 256})));
        QTRY_VERIFY_WITH_TIMEOUT(process.log().contains("the connection has ended"), kPatience);
        const User next(process);
        (void)next.image(sharedScene(), {1}, 1);
        QCOMPARE(times(6271), 0);
        QVERIFY(times(7919) > 0);
    }

    void thoseWhoComeLaterWaitInLine() {
        NodeProcess process(listening(1));
        User first(process);
        (void)first.image(sharedScene(1), {1}, 1);
        User second(process);
        auto image = std::async(std::launch::async, [&] { return second.image(sharedScene(2), kSharedOrders, 1); });
        QTRY_VERIFY_WITH_TIMEOUT(isAt(second, 1), kPatience);
        User third(process);
        const auto film = *startFilm(*third.device, sharedScene(3));
        QTRY_VERIFY_WITH_TIMEOUT(isAt(third, 2), kPatience);
        first.leave();
        QVERIFY(sameBits(image.get(), imageAlone(sharedScene(2), kSharedOrders)));
        QCOMPARE(second.status().state, nodes::NodeState::ready);
        QVERIFY(second.status().reason.empty());
        QTRY_VERIFY_WITH_TIMEOUT(isAt(third, 1), kPatience);
        QVERIFY(bool(second.device->unload()));  // its scan is closed: it needs no place
        QTRY_COMPARE_WITH_TIMEOUT(third.status().state, nodes::NodeState::ready, kPatience);
    }

    void whoLeavesTheLineIsNotWaitedFor() {
        NodeProcess process(listening(1));
        User first(process);
        (void)first.image(sharedScene(1), {1}, 1);
        User second(process), third(process);
        const auto film = *startFilm(*second.device, sharedScene(2));
        QTRY_VERIFY_WITH_TIMEOUT(isAt(second, 1), kPatience);
        const auto other = *startFilm(*third.device, sharedScene(3));
        QTRY_VERIFY_WITH_TIMEOUT(isAt(third, 2), kPatience);
        second.leave();
        QTRY_VERIFY_WITH_TIMEOUT(isAt(third, 1), kPatience);
        first.leave();
        QTRY_COMPARE_WITH_TIMEOUT(third.status().state, nodes::NodeState::ready, kPatience);
    }

    void theCommandLineSaysThatItWaits() {
        NodeProcess process(listening(1));
        User first(process);
        (void)first.image(sharedScene(1), {1}, 1);
        const BallScene ball;
        const ProgramRun run =
            BallScene::run({"render", ball.scene(), "-o", ball.at("a.exr"), "--samples", "64", "--device", "cpu",
                            "--node", process.address(), "--await", "1", "--await-seconds", "3"});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("node alpha: number 1 in the line, since others use this render node"), run.err);
        QVERIFY2(run.err.contains("0 of 1 render nodes are ready after 3 s"), run.err);
    }
};

QTEST_GUILESS_MAIN(SharedNodeTest)
#include "shared_node_test.moc"
