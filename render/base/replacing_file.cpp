#include "render/base/replacing_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <random>
#include <string>

#include "render/base/abandoned_parts.h"

namespace pdr {
namespace {

namespace fs = std::filesystem;

Error writeError(const fs::path& path, int code) {
    const Text what = phrase("the file could not be written (%1)", std::string(std::strerror(code)));
    if (code == ENOSPC || code == EDQUOT || code == EFBIG)
        return {what, path.string(), phrase("Make room there, or choose another place.")};
    if (code == ENAMETOOLONG)
        return {what, path.string(), phrase("Choose a shorter name.")};
    if (code == ENOENT)
        return {what, path.string(), phrase("Create the folder first, or choose another place.")};
    return {what, path.string(), phrase("Choose a folder that you may write to.")};
}

fs::path folderOf(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : ".";
}

/// Returns `path`, or its target if it is a symbolic link: a rename would replace the link itself.
Result<fs::path> behindLinks(const fs::path& path) {
    constexpr int kLinks = 40;  // as many as the kernel follows
    fs::path place = path;
    std::error_code failed;
    for (int i = 0; i < kLinks; ++i) {
        const fs::path target = fs::read_symlink(place, failed);
        if (failed)
            return place;  // no link, or nothing there
        place = folderOf(place) / target;
    }
    return Error{phrase("the symbolic links here lead in a circle"), path.string(), phrase("Choose another name.")};
}

/// Checks in advance for what rename() would refuse at the end, and for what it would replace without asking.
Result<void> checkReplaceable(const fs::path& path, const fs::path& place) {
    struct stat file {
    }, folder{};
    if (::lstat(place.c_str(), &file) != 0)
        return errno == ENAMETOOLONG ? writeError(path, errno) : Result<void>();
    if (S_ISDIR(file.st_mode))
        return Error{phrase("this is a folder, a file name is needed"), path.string(),
                     phrase("Choose another name, or one within it.")};
    if (!S_ISREG(file.st_mode))
        return Error{phrase("this is no plain file"), path.string(), phrase("Choose another name.")};
    if (::faccessat(AT_FDCWD, place.c_str(), W_OK, AT_EACCESS) != 0)
        return Error{phrase("this file may not be written"), path.string(),
                     phrase("Change its permissions, or choose another name.")};
    const uid_t user = ::geteuid();
    const bool sticky = ::stat(folderOf(place).c_str(), &folder) == 0 && (folder.st_mode & S_ISVTX) != 0;
    if (sticky && user != 0 && user != file.st_uid && user != folder.st_uid)
        return Error{phrase("this file belongs to another user, and in this folder only they may replace it"),
                     path.string(), phrase("Choose another name.")};
    return {};
}

/// Returns a name in the same folder, since a rename cannot leave the file system. The name is random: a process number
/// is not unique across containers, and others could take a name that they can predict.
fs::path temporaryBeside(const fs::path& place) {
    constexpr char kLetters[] = "0123456789abcdefghijklmnopqrstuv";
    std::random_device random;
    std::string name(kPartStart);
    for (int i = 0; i < 16; ++i)
        name += kLetters[random() % 32];
    return place.parent_path() / name.append(kPartEnd);
}

/// Gives `descriptor` the group of an older file at `place` and returns the older file's mode; nothing if there is
/// none. If the group cannot be kept, it gets no rights.
std::optional<mode_t> keptMode(int descriptor, const fs::path& place) {
    struct stat old {};
    if (::stat(place.c_str(), &old) != 0)
        return std::nullopt;
    const bool groupKept = ::fchown(descriptor, uid_t(-1), old.st_gid) == 0;
    return old.st_mode & (groupKept ? 0777 : 0707);
}

}  // namespace

Result<ReplacingFile> ReplacingFile::open(const fs::path& path, FileAccess access) {
    const auto place = behindLinks(path);
    if (!place)
        return place.error();
    if (auto ok = checkReplaceable(path, *place); !ok)
        return ok.error();
    removeAbandonedParts(folderOf(*place));
    fs::path temporary = temporaryBeside(*place);
    std::error_code ignored;
    const bool open = access == FileAccess::everybody && !fs::exists(*place, ignored);
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, open ? 0666 : 0600);
    if (descriptor < 0)
        return writeError(path, errno);
    claimPart(descriptor);
    ReplacingFile file(path, *place, std::move(temporary), ::fdopen(descriptor, "wb"));
    if (!file.stream_)
        return writeError(path, errno);
    file.mode_ = keptMode(descriptor, *place);
    return file;
}

ReplacingFile::~ReplacingFile() {
    stream_.reset();
    std::error_code ignored;
    if (!temporary_.empty())
        fs::remove(temporary_, ignored);
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
    if (failure_ == 0 && mode_)
        ::fchmod(::fileno(stream_.get()), *mode_);  // failure is ignored: some disks have no modes
    if (failure_ == 0)
        remember(std::fclose(stream_.release()) == 0);
    if (failure_ == 0)
        remember(std::rename(temporary_.c_str(), place_.c_str()) == 0);
    if (failure_ == 0)
        temporary_.clear();
    return state();
}

Result<void> writeWhole(std::string_view text, const fs::path& path, FileAccess access) {
    auto file = ReplacingFile::open(path, access);
    if (!file)
        return file.error();
    file->write(text.data(), text.size());
    return file->commit();
}

}  // namespace pdr
