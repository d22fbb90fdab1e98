#pragma once
/// Limits that a control group of the system (cgroup v1 and v2) sets to the memory of this program.

#include <cstdint>
#include <limits>
#include <string>

namespace pdr {

inline constexpr std::uint64_t kNoMemoryLimit = std::numeric_limits<std::uint64_t>::max();

/// Bytes that the control groups of this process leave free: the least over the group it is in and all above it, as
/// Slurm, systemd and containers nest them. Files that were read and may be dropped count as free. kNoMemoryLimit where
/// no group sets a limit or none can be read.
///   memberships  a file as /proc/self/cgroup, "0::/job_7/step_0" (man 7 cgroups)
///   mounts       a file as /proc/self/mountinfo (man 5 proc), which tells where the groups' folders are
std::uint64_t freeBytesOfGroups(const std::string& memberships = "/proc/self/cgroup",
                                const std::string& mounts = "/proc/self/mountinfo");

}  // namespace pdr
