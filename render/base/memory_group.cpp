#include "render/base/memory_group.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

namespace pdr {
namespace {

namespace fs = std::filesystem;

/// A mounted tree of groups that may limit memory.
struct GroupTree {
    bool isV2 = false;
    fs::path root;   ///< the group that is mounted
    fs::path place;  ///< where it is mounted
};

/// Names of the files in a group's folder, which depend on the version.
struct GroupFiles {
    std::vector<const char*> limits;
    const char* used;
    const char* cached;  ///< name of a line in memory.stat
};

const GroupFiles& filesOf(bool isV2) {
    // Above memory.high a program is not killed, but slowed down to a standstill.
    static const GroupFiles v2{{"memory.max", "memory.high"}, "memory.current", "inactive_file"};
    static const GroupFiles v1{{"memory.limit_in_bytes"}, "memory.usage_in_bytes", "total_inactive_file"};
    return isV2 ? v2 : v1;
}

bool contains(const std::string& listed, const std::string& word) {
    return ("," + listed + ",").find("," + word + ",") != std::string::npos;
}

/// Returns `text` with escapes such as "\040" replaced by the characters that they stand for.
std::string unescaped(const std::string& text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string digits = text[i] == '\\' ? text.substr(i + 1, 3) : "";
        if (digits.size() == 3 && digits.find_first_not_of("01234567") == std::string::npos) {
            plain += char(std::stoi(digits, nullptr, 8));
            i += 3;
        } else {
            plain += text[i];
        }
    }
    return plain;
}

/// Returns the tree of groups in a line of mountinfo, "31 23 0:35 / /sys/fs/cgroup/memory rw shared:9 - cgroup cgroup
/// rw,memory"; nothing if the line mounts none that limits memory.
std::optional<GroupTree> treeIn(const std::string& mount) {
    const std::size_t dash = mount.find(" - ");
    if (dash == std::string::npos)
        return {};
    std::istringstream first(mount.substr(0, dash)), second(mount.substr(dash + 3));
    std::string skipped, root, place, type, source, options;
    first >> skipped >> skipped >> skipped >> root >> place;
    second >> type >> source >> options;
    if (type != "cgroup2" && !(type == "cgroup" && contains(options, "memory")))
        return {};
    return GroupTree{type == "cgroup2", unescaped(root), unescaped(place)};
}

/// Returns the path of this process's group in the hierarchy of a version; nothing if it is in none.
std::optional<fs::path> membership(const std::string& memberships, bool isV2) {
    std::ifstream file(memberships);
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos)
            continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        if (isV2 ? line.starts_with("0::") : contains(controllers, "memory"))
            return line.substr(second + 1);
    }
    return {};
}

/// Returns the first number of a file, or `otherwise` if there is none: "max" is not a number.
std::uint64_t numberIn(const fs::path& path, std::uint64_t otherwise) {
    std::uint64_t number = 0;
    return std::ifstream(path) >> number ? number : otherwise;
}

/// Returns the number behind `name` in a file of names and numbers; 0 if there is none.
std::uint64_t numberOf(const std::string& name, const fs::path& path) {
    std::ifstream file(path);
    std::uint64_t number = 0;
    for (std::string word; file >> word >> number;)
        if (word == name)
            return number;
    return 0;
}

std::uint64_t left(std::uint64_t limit, std::uint64_t used) {
    return limit > used ? limit - used : 0;
}

std::uint64_t freeOf(const fs::path& group, const GroupFiles& files) {
    std::uint64_t limit = kNoMemoryLimit;
    for (const char* name : files.limits)
        limit = std::min(limit, numberIn(group / name, kNoMemoryLimit));
    if (limit == kNoMemoryLimit)
        return kNoMemoryLimit;
    const std::uint64_t used = numberIn(group / files.used, 0);
    return left(limit, left(used, numberOf(files.cached, group / "memory.stat")));
}

/// Returns the least number of bytes that are free in the group at `path` and in all mounted groups above. If `path` is
/// not below the mounted group, as in some containers, only the mounted group counts.
std::uint64_t freeOf(const GroupTree& tree, const fs::path& path) {
    const GroupFiles& files = filesOf(tree.isV2);
    std::uint64_t free = freeOf(tree.place, files);
    const fs::path below = path.lexically_relative(tree.root);
    if (below.empty() || below == "." || *below.begin() == "..")
        return free;
    fs::path group = tree.place;
    for (const fs::path& part : below) {
        group /= part;
        free = std::min(free, freeOf(group, files));
    }
    return free;
}

}  // namespace

std::uint64_t freeBytesOfGroups(const std::string& memberships, const std::string& mounts) {
    std::uint64_t free = kNoMemoryLimit;
    std::ifstream file(mounts);
    for (std::string line; std::getline(file, line);)
        if (const std::optional<GroupTree> tree = treeIn(line))
            if (const std::optional<fs::path> path = membership(memberships, tree->isV2))
                free = std::min(free, freeOf(*tree, *path));
    return free;
}

}  // namespace pdr
