#include "render/base/plain_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "render/base/errors.h"

namespace pdr {
namespace {

/// A file descriptor that is closed at the end of its scope.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    ~Descriptor() {
        if (number_ >= 0)
            ::close(number_);
    }
    Descriptor& operator=(Descriptor&&) = delete;

    int number() const { return number_; }

  private:
    int number_;
};

Error cannotBeRead(const std::filesystem::path& path) {
    const int reason = errno;
    const Text hint = reason == ENOENT || reason == ENOTDIR ? phrase("Check the path.")
                      : reason == EMFILE || reason == ENFILE
                          ? phrase("Close other programs, or raise the limit of open files (ulimit -n).")
                          : phrase("Check that you may read it.");
    return {phrase("the file cannot be read (%1)", std::string(std::strerror(reason))), path.string(), hint};
}

/// Checks that `mode` is that of a plain file. Errors: it is a folder, or neither.
Result<void> checkKind(mode_t mode, const std::filesystem::path& path) {
    if (S_ISREG(mode))
        return {};
    if (S_ISDIR(mode))
        return Error{phrase("this is a folder, not a file"), path.string(), phrase("Give a file."), ErrorKind::refused};
    return Error{phrase("this is no plain file"), path.string(), phrase("Give a file, no pipe and no device."),
                 ErrorKind::refused};
}

Result<Descriptor> openPlainFile(const std::filesystem::path& path) {
    struct stat facts {};
    if (::stat(path.c_str(), &facts) != 0)
        return cannotBeRead(path);
    if (auto ok = checkKind(facts.st_mode, path); !ok)  // opening a device can have effects: a tape may wind
        return ok.error();
    Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (file.number() < 0 || ::fstat(file.number(), &facts) != 0)
        return cannotBeRead(path);
    if (auto ok = checkKind(facts.st_mode, path); !ok)  // another file may have replaced it since
        return ok.error();
    return file;
}

}  // namespace

Result<void> checkPlainFile(const std::filesystem::path& path) {
    const auto file = openPlainFile(path);
    return file ? Result<void>() : file.error();
}

/// Reads in pieces: the size that the system states may be outdated or 0.
Result<std::string> readPlainFile(const std::filesystem::path& path, std::uint64_t mostBytes) {
    constexpr std::size_t kPiece = 64 << 10;
    const auto file = openPlainFile(path);
    if (!file)
        return file.error();
    std::string bytes;
    for (;;) {
        const std::size_t before = bytes.size();
        bytes.resize(before + kPiece);
        const ssize_t count = ::read(file->number(), bytes.data() + before, kPiece);
        if (count < 0 && errno != EINTR)
            return cannotBeRead(path);
        bytes.resize(before + std::size_t(std::max<ssize_t>(count, 0)));
        if (bytes.size() > mostBytes)
            return Error{phrase("the file is larger than %1", bytesText(mostBytes)), path.string(), "",
                         ErrorKind::refused};
        if (count == 0)
            return bytes;
    }
}

}  // namespace pdr
