#include "render/base/abandoned_parts.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <ctime>
#include <string>
#include <system_error>

namespace pdr {
namespace {

/// Age from which an unclaimed file counts as abandoned. Before, its program may not have claimed it yet.
constexpr std::time_t kAbandonedAfter = 3600;  // [s]

bool isPart(const std::string& name) {
    return name.starts_with(kPartStart) && name.ends_with(kPartEnd);
}

bool isAbandoned(int descriptor) {
    struct stat facts {};
    return ::fstat(descriptor, &facts) == 0 && S_ISREG(facts.st_mode) && facts.st_uid == ::geteuid() &&
           std::time(nullptr) - facts.st_mtime > kAbandonedAfter && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

}  // namespace

void claimPart(int descriptor) {
    ::flock(descriptor, LOCK_EX | LOCK_NB);
}

void removeAbandonedParts(const std::filesystem::path& folder) {
    std::error_code failure;
    for (std::filesystem::directory_iterator entry(folder, failure), end; !failure && entry != end;
         entry.increment(failure)) {
        if (!isPart(entry->path().filename().string()))
            continue;
        const int part = ::open(entry->path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (part < 0)
            continue;
        if (isAbandoned(part))
            ::unlink(entry->path().c_str());
        ::close(part);
    }
}

}  // namespace pdr
