#include "render/base/replacing_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>

namespace pdr {
namespace {

Error writeError(const std::filesystem::path& path, int code) {
    const std::string what = "the file could not be written (" + std::string(std::strerror(code)) + ")";
    if (code == ENOSPC || code == EDQUOT || code == EFBIG)
        return {what, path.string(), "Make room there, or choose another place."};
    if (code == ENOENT)
        return {what, path.string(), "Create the folder first, or choose another place."};
    return {what, path.string(), "Choose a folder that you may write to."};
}

/// A name in the same folder, since a rename cannot leave the file system.
std::filesystem::path temporaryBeside(const std::filesystem::path& path) {
    static std::atomic<unsigned> counter = 0;
    const std::string name = ".pdr-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".part";
    return path.parent_path() / name;
}

}  // namespace

Result<ReplacingFile> ReplacingFile::open(const std::filesystem::path& path) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    if (std::filesystem::is_directory(status))
        return Error{"this is a folder, a file name is needed", path.string(), "Add a name such as picture.png."};
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        return Error{"this is no plain file", path.string(), "Choose another name."};
    std::filesystem::path temporary = temporaryBeside(path);
    std::FILE* stream = std::fopen(temporary.c_str(), "wbx");
    if (!stream)
        return writeError(path, errno);
    return ReplacingFile(path, std::move(temporary), stream);
}

ReplacingFile::~ReplacingFile() {
    stream_.reset();
    std::error_code ignored;
    if (!temporary_.empty())
        std::filesystem::remove(temporary_, ignored);
}

bool ReplacingFile::remember(bool ok) {
    if (!ok && failure_ == 0)
        failure_ = errno;
    return failure_ == 0;
}

bool ReplacingFile::write(const void* bytes, std::size_t count) {
    return failure_ == 0 && remember(std::fwrite(bytes, 1, count, stream_.get()) == count);
}

bool ReplacingFile::seek(std::uint64_t position) {
    return failure_ == 0 && remember(::fseeko(stream_.get(), off_t(position), SEEK_SET) == 0);
}

std::uint64_t ReplacingFile::position() {
    return std::uint64_t(::ftello(stream_.get()));
}

Result<void> ReplacingFile::state() const {
    if (failure_ != 0)
        return writeError(path_, failure_);
    return {};
}

Result<void> ReplacingFile::commit() {
    if (failure_ == 0)
        remember(std::fflush(stream_.get()) == 0) && remember(::fsync(::fileno(stream_.get())) == 0);
    if (failure_ == 0)
        remember(std::fclose(stream_.release()) == 0);
    if (failure_ == 0)
        remember(std::rename(temporary_.c_str(), path_.c_str()) == 0);
    if (failure_ == 0)
        temporary_.clear();
    return state();
}

}  // namespace pdr
