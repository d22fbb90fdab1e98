#pragma once
/// Limits on the memory of this program that its control groups set (cgroup v1 and v2).

#include <cstdint>
#include <limits>
#include <string>

namespace pdr {

inline constexpr std::uint64_t kNoMemoryLimit = std::numeric_limits<std::uint64_t>::max();

/// Returns the bytes that the control groups of this process leave free: the least over its group and all groups above,
/// as Slurm, systemd and containers nest them. Cached files that may be dropped count as free. Returns kNoMemoryLimit
/// if no group sets a limit or none can be read.
///   memberships  a file like /proc/self/cgroup, "0::/job_7/step_0" (man 7 cgroups)
///   mounts       a file like /proc/self/mountinfo (man 5 proc), which lists the folders of the groups
std::uint64_t freeBytesOfGroups(const std::string& memberships = "/proc/self/cgroup",
                                const std::string& mounts = "/proc/self/mountinfo");

}  // namespace pdr
