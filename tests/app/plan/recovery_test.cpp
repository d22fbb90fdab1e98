/// Plans that outlive a killed program: the newest is there, whole, for whoever opens its scan.

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <fstream>
#include <random>
#include <thread>

#include "app/plan/recovery.h"
#include "tests/support/scenes/scenes.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const Volume> scan(int hu = 40) {
    return test::makeVolume({6, 5, 4}, dvec3(1, 1, 2), [hu](int i, int j, int k) { return hu + i + 10 * j + 100 * k; });
}

/// Returns a plan with so many measurements.
Plan planWith(int measurements) {
    Plan plan;
    plan.image.look.transferFunction.nodes = {{0, 0}};
    for (int i = 1; i <= measurements; ++i)
        plan.measurements.push_back(
            {std::uint64_t(i), MeasureKind::distance, {}, {measure::typedPlace({1, 2, 3}), {}}});
    return plan;
}

constexpr const char* kKeeper = "--keep-until-killed";  ///< argument of this program, before a folder and a file

/// Keeps ever larger plans until it is killed, and writes the size of each that is kept to `done`.
[[noreturn]] void keepUntilKilled(const fs::path& folder, int done) {
    const auto volume = scan();
    KeptPlan kept(folder);
    for (int count = 1;; ++count)
        if (!kept.keep(planWith(count), volume) || ::write(done, &count, sizeof count) != sizeof count)
            ::_exit(1);
}

/// Lets a process of its own keep plans, kills it after `after`, and returns the size of the last plan of which it knew
/// that it is kept; 0: none.
int lastKeptBeforeKill(const fs::path& folder, std::chrono::microseconds after) {
    int pipe[2];
    if (::pipe(pipe) != 0)
        qFatal("no pipe");
    const pid_t child = ::fork();
    if (child == 0) {  // a program of its own: oneTBB's threads would be missing in a mere copy of this one
        ::execl("/proc/self/exe", "recovery_test", kKeeper, folder.c_str(), std::to_string(pipe[1]).c_str(), nullptr);
        ::_exit(1);
    }
    ::close(pipe[1]);
    int count = 0, last = 0;
    while (last == 0 && ::read(pipe[0], &count, sizeof count) == sizeof count)
        last = count;  // it has begun
    std::this_thread::sleep_for(after);
    ::kill(child, SIGKILL);
    while (::read(pipe[0], &count, sizeof count) == sizeof count)
        last = count;
    ::close(pipe[0]);
    ::waitpid(child, nullptr, 0);
    return last;
}

void writeText(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

mode_t modeOf(const fs::path& file) {
    struct stat facts {};
    return ::stat(file.c_str(), &facts) == 0 ? facts.st_mode & 0777 : 0;
}

}  // namespace

class RecoveryTest : public QObject {
    Q_OBJECT

  private slots:
    /// The pipe tells what was kept before the kill. The plan that was being written may be there already.
    void aKilledProgramLosesNothingThatWasKept() {
        std::mt19937 random(20261126);
        for (int round = 0; round < 100; ++round) {
            QTemporaryDir folder;
            const fs::path plans = ui::fromQt(folder.filePath("plans"));
            const int last = lastKeptBeforeKill(plans, std::chrono::microseconds(random() % 20000));
            QVERIFY(last > 0);
            const LostPlans lost = lostPlans(plans);
            QVERIFY2(lost.problems.empty(), lost.problems.empty() ? "" : lost.problems[0].text().c_str());
            QCOMPARE(lost.plans.size(), std::size_t(1));
            const int there = int(lost.plans[0].saved.plan.measurements.size());
            QVERIFY2(there == last || there == last + 1, qPrintable(QString("%1 of %2").arg(there).arg(last)));
            QVERIFY(lostPlanOf(lost.plans, *scan()) == &lost.plans[0]);
            QVERIFY(!lostPlanOf(lost.plans, *scan(41)));
        }
    }

    void aRunThatGoesOnIsLeftAlone() {
        QTemporaryDir folder;
        const fs::path plans = ui::fromQt(folder.filePath("plans"));
        QVERIFY(lostPlans(plans).plans.empty());  // nor is there a folder
        KeptPlan kept(plans);
        QVERIFY(kept.keep(planWith(1), scan()));
        QVERIFY(lostPlans(plans).plans.empty());
        kept.discard();
        QVERIFY(QDir(folder.filePath("plans")).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
        QVERIFY(kept.keep(planWith(2), scan()));  // and again
        QVERIFY(!QDir(folder.filePath("plans")).isEmpty());
    }

    void nothingIsLeftOfARunThatEnds() {
        QTemporaryDir folder;
        const fs::path plans = ui::fromQt(folder.filePath("plans"));
        {
            KeptPlan kept(plans);
            QVERIFY(kept.keep(planWith(1), scan()));
        }
        QVERIFY(QDir(folder.filePath("plans")).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
    }

    void onlyTheOwnerReadsIt() {
        QTemporaryDir folder;
        const fs::path plans = ui::fromQt(folder.filePath("state/plans"));
        KeptPlan kept(plans);
        QVERIFY(kept.keep(planWith(1), scan()));
        QCOMPARE(modeOf(plans), mode_t(0700));
        for (const fs::directory_entry& file : fs::directory_iterator(plans))
            QCOMPARE(modeOf(file.path()), mode_t(0600));
    }

    void theNewestComesFirstAndOldOnesGo() {
        QTemporaryDir folder;
        const fs::path plans = ui::fromQt(folder.path());
        const auto now = fs::file_time_type::clock::now();
        const auto leave = [&](const char* name, int measurements, std::chrono::hours ago) {
            const fs::path file = plans / name;
            QVERIFY(writePlan({markOf(*scan(), newSalt()), planWith(measurements)}, file));
            fs::last_write_time(file, now - ago);
        };
        leave("a.plan.json", 1, std::chrono::hours(48));
        leave("b.plan.json", 2, std::chrono::hours(1));
        leave("c.plan.json", 3, kLostPlansStay + std::chrono::hours(1));
        leave("d.plan.json", 4, kLostPlansStay - std::chrono::hours(1));
        const LostPlans lost = lostPlans(plans);
        QCOMPARE(lost.plans.size(), std::size_t(3));
        QCOMPARE(lostPlanOf(lost.plans, *scan())->saved.plan.measurements.size(), std::size_t(2));
        QCOMPARE(lost.plans.back().saved.plan.measurements.size(), std::size_t(4));
        QVERIFY(!fs::exists(plans / "c.plan.json"));
        for (const LostPlan& plan : lost.plans)
            removeLost(plan.file);
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void aDamagedFileIsNamedAndHidesNoOther() {
        QTemporaryDir folder;
        const fs::path plans = ui::fromQt(folder.path());
        writeText(plans / "a.plan.json", "{\"format\": \"pdrender-plan\", \"vers");
        QVERIFY(writePlan({markOf(*scan(), newSalt()), planWith(1)}, plans / "b.plan.json"));
        const LostPlans lost = lostPlans(plans);
        QCOMPARE(lost.plans.size(), std::size_t(1));
        QCOMPARE(lost.problems.size(), std::size_t(1));
        QVERIFY(lost.problems[0].text().find("a.plan.json") != std::string::npos);
    }

    void whereNothingCanBeKeptItSaysSo() {
        QTemporaryDir folder;
        const fs::path file = ui::fromQt(folder.filePath("file"));
        writeText(file, "no folder");
        KeptPlan kept(file / "plans");
        const Result<void> ok = kept.keep(planWith(1), scan());
        QVERIFY(!ok);
        QVERIFY(ok.error().text().find(file.string()) != std::string::npos);
    }
};

}  // namespace pdr::app

int main(int argc, char** argv) {
    using namespace pdr::app;
    if (argc == 4 && std::string_view(argv[1]) == kKeeper)
        keepUntilKilled(argv[2], std::atoi(argv[3]));
    const QCoreApplication application(argc, argv);
    RecoveryTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "recovery_test.moc"
