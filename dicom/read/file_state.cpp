#include "dicom/read/file_state.h"

#include <sys/stat.h>

namespace pdr::dicom {

FileState stateOf(const std::filesystem::path& file) {
    struct stat facts {};
    if (::stat(file.c_str(), &facts) != 0)
        return {};
    const auto nanoseconds = [](const timespec& at) { return std::int64_t(at.tv_sec) * 1'000'000'000 + at.tv_nsec; };
    return {facts.st_dev, facts.st_ino, facts.st_size, nanoseconds(facts.st_mtim), nanoseconds(facts.st_ctim)};
}

}  // namespace pdr::dicom
