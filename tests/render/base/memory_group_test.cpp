#include <QtTest>

#include <sys/resource.h>
#include <unistd.h>
#include <QTemporaryDir>

#include <filesystem>
#include <fstream>

#include "render/base/free_memory.h"

using namespace pdr;

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMega = 1'000'000;

}  // namespace

/// Trees of groups as the system shows them, in a folder of their own.
class MemoryGroupTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;
    fs::path place() const { return fs::path(folder_->path().toStdString()); }
    void put(const fs::path& file, const std::string& text) const {
        fs::create_directories((place() / file).parent_path());
        std::ofstream(place() / file) << text;
    }
    void addV2(const fs::path& group, const std::string& max, std::uint64_t used, std::uint64_t cached = 0) const {
        put(group / "memory.max", max + "\n");
        put(group / "memory.current", std::to_string(used) + "\n");
        put(group / "memory.stat", "anon 5\ninactive_file " + std::to_string(cached) + "\nactive_file 7\n");
    }
    void addV1(const fs::path& group, std::uint64_t limit, std::uint64_t used, std::uint64_t cached = 0) const {
        put(group / "memory.limit_in_bytes", std::to_string(limit) + "\n");
        put(group / "memory.usage_in_bytes", std::to_string(used) + "\n");
        put(group / "memory.stat", "inactive_file 1\ntotal_inactive_file " + std::to_string(cached) + "\n");
    }
    /// `mounted`: the group that is mounted at `at`.
    std::uint64_t free(const std::string& membership, const std::string& type, const std::string& options,
                       const std::string& at = "groups", const std::string& mounted = "/") const {
        put("cgroup", "7:cpu,cpuacct:/elsewhere\n" + membership + "\n");
        put("mountinfo", "27 1 254:0 / / rw,relatime shared:1 - ext4 /dev/vda rw\n31 27 0:35 " + mounted + " " +
                             (place() / at).string() + " rw,nosuid shared:9 master:2 - " + type + " cgroup " + options +
                             "\n");
        return freeBytesOfGroups((place() / "cgroup").string(), (place() / "mountinfo").string());
    }
    std::uint64_t freeV2(const std::string& group) const { return free("0::" + group, "cgroup2", "rw,nsdelegate"); }
    std::uint64_t freeV1(const std::string& group) const { return free("4:memory:" + group, "cgroup", "rw,memory"); }

  private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void whereNothingIsSaidNothingIsLimited() {
        QCOMPARE(freeBytesOfGroups("/none", "/none"), kNoMemoryLimit);
        QCOMPARE(freeV2("/"), kNoMemoryLimit);
        addV2("groups/job", "max", 5 * kMega);
        QCOMPARE(freeV2("/job"), kNoMemoryLimit);
    }

    void theGroupOfAContainerIsTheMountedOne() {
        addV2("groups", "100000000", 30 * kMega, 10 * kMega);
        QCOMPARE(freeV2("/"), 80 * kMega);
        addV1("groups", 90 * kMega, 30 * kMega, 10 * kMega);
        QCOMPARE(freeV1("/"), 70 * kMega);
    }

    void nestedGroupsAreFollowed() {
        addV2("groups/slurm/job_7", "400000000", 100 * kMega);
        addV2("groups/slurm/job_7/step_0/task_0", "max", 90 * kMega);
        QCOMPARE(freeV2("/slurm/job_7/step_0/task_0"), 300 * kMega);
        QCOMPARE(freeV2("/slurm/job_7"), 300 * kMega);
        QCOMPARE(freeV2("/slurm"), kNoMemoryLimit);
        addV1("groups/slurm/uid_1/job_7", 200 * kMega, 60 * kMega, 10 * kMega);
        QCOMPARE(freeV1("/slurm/uid_1/job_7/step_0"), 150 * kMega);
    }

    void theTightestOfTheGroupsAboveCounts() {
        addV2("groups/user.slice", "500000000", 480 * kMega);
        addV2("groups/user.slice/app.scope", "400000000", 100 * kMega);
        QCOMPARE(freeV2("/user.slice/app.scope"), 20 * kMega);
    }

    void aGroupThatIsFullLeavesNothing() {
        addV2("groups/job", "100000000", 120 * kMega);
        QCOMPARE(freeV2("/job"), std::uint64_t(0));
    }

    /// Above it systemd's MemoryHigh slows a program down until it seems to stand still.
    void theHighMarkIsALimitToo() {
        addV2("groups/job", "max", 30 * kMega);
        put("groups/job/memory.high", "100000000\n");
        QCOMPARE(freeV2("/job"), 70 * kMega);
    }

    /// Docker without a namespace of groups: the path is the host's, and so is the group that is mounted.
    void aPathIsReadFromTheMountedGroupOn() {
        addV1("groups", 100 * kMega, 10 * kMega);
        addV1("groups/inner", 50 * kMega, 10 * kMega);
        QCOMPARE(free("4:memory:/docker/ab/inner", "cgroup", "rw,memory", "groups", "/docker/ab"), 40 * kMega);
        QCOMPARE(free("4:memory:/docker/ab", "cgroup", "rw,memory", "groups", "/docker/ab"), 90 * kMega);
        QCOMPARE(free("4:memory:/elsewhere", "cgroup", "rw,memory", "groups", "/docker/ab"), 90 * kMega);
        QCOMPARE(free("0::/../other", "cgroup2", "rw"), kNoMemoryLimit);
    }

    void placesWithSpacesAreFound() {
        addV2("two words/job", "100000000", 10 * kMega);
        put("cgroup", "0::/job\n");
        std::string at = (place() / "two words").string();
        at.replace(at.find(' '), 1, "\\040");
        put("mountinfo", "31 27 0:35 / " + at + " rw - cgroup2 cgroup rw\n");
        QCOMPARE(freeBytesOfGroups((place() / "cgroup").string(), (place() / "mountinfo").string()), 90 * kMega);
    }

    /// The hierarchies of other controllers, and of memory in the other version, limit nothing.
    void onlyTheHierarchyOfMemoryCounts() {
        addV1("groups/job", 100 * kMega, 10 * kMega);
        QCOMPARE(free("4:cpu:/job", "cgroup", "rw,cpu"), kNoMemoryLimit);
        QCOMPARE(free("0::/job\n4:cpu,memory:/job", "cgroup", "rw,cpu,memory"), 90 * kMega);
    }

    void theOwnLimitOfTheProgramCounts() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("sanitizers take the address space");
#endif
        rlimit before{};
        QCOMPARE(::getrlimit(RLIMIT_AS, &before), 0);
        std::uint64_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlimit tight{rlim_t(pages * std::uint64_t(::sysconf(_SC_PAGESIZE)) + 50 * kMega), before.rlim_max};
        QCOMPARE(::setrlimit(RLIMIT_AS, &tight), 0);
        const std::uint64_t free = freeBytes();
        QCOMPARE(::setrlimit(RLIMIT_AS, &before), 0);
        QVERIFY2(free > 0 && free <= 50 * kMega, std::to_string(free).c_str());
    }
};

QTEST_APPLESS_MAIN(MemoryGroupTest)
#include "memory_group_test.moc"
