#include "app/film_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "render/base/errors.h"
#include "render/film/moments.h"

namespace pdr::app {
namespace {

std::uint64_t left(std::uint64_t limit, std::uint64_t used) {
    return limit > used ? limit - used : 0;
}

/// The first number of a file, or `otherwise`: "max" is no number.
std::uint64_t numberIn(const std::string& path, std::uint64_t otherwise) {
    std::uint64_t number = 0;
    return std::ifstream(path) >> number ? number : otherwise;
}

std::uint64_t freeOfMachine() {
    std::ifstream file("/proc/meminfo");
    for (std::string word; file >> word;)
        if (std::uint64_t kilobytes = 0; word == "MemAvailable:" && file >> kilobytes)
            return kilobytes * 1024;
    return kNoMemoryLimit;
}

/// The number behind `name` in a file of names and numbers; 0 where there is none.
std::uint64_t numberOf(const char* name, const std::string& path) {
    std::ifstream file(path);
    std::uint64_t number = 0;
    for (std::string word; file >> word >> number;)
        if (word == name)
            return number;
    return 0;
}

/// Files that were read lie in the group's memory too, until somebody needs it.
std::uint64_t freeOfGroup(const std::string& folder, const char* limitName, const char* usedName, const char* cached) {
    const std::uint64_t limit = numberIn(folder + limitName, kNoMemoryLimit);
    if (limit == kNoMemoryLimit)
        return kNoMemoryLimit;
    return left(limit, left(numberIn(folder + usedName, 0), numberOf(cached, folder + "memory.stat")));
}

std::uint64_t freeOfGroup() {
    return std::min(
        freeOfGroup("/sys/fs/cgroup/", "memory.max", "memory.current", "inactive_file"),
        freeOfGroup("/sys/fs/cgroup/memory/", "memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"));
}

std::uint64_t freeOfProcess() {
    rlimit limit{};
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return kNoMemoryLimit;
    return left(limit.rlim_cur, numberIn("/proc/self/statm", 0) * std::uint64_t(::sysconf(_SC_PAGESIZE)));
}

}  // namespace

std::uint64_t filmBytes(ivec2 size, const DeviceInfo& device) {
    constexpr std::uint64_t kPicture = 4, kFilm = sizeof(PixelSums) + sizeof(Moments);
    return std::uint64_t(size.x) * std::uint64_t(size.y) * ((device.hostMemory ? 2 : 1) * kFilm + kPicture);
}

std::uint64_t freeBytes() {
    return std::min({freeOfMachine(), freeOfGroup(), freeOfProcess()});
}

Result<void> checkFilmFits(ivec2 size, const DeviceInfo& device, const std::string& hint) {
    const std::uint64_t needed = filmBytes(size, device), free = freeBytes();
    if (needed <= free)
        return {};
    return Error{"a picture of " + std::to_string(size.x) + " x " + std::to_string(size.y) + " pixels needs " +
                     bytesText(needed) + " of memory, " + bytesText(free) + " are free",
                 "", hint, ErrorKind::memory};
}

}  // namespace pdr::app
