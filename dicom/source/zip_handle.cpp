#include "dicom/source/zip_handle.h"

#include <sys/stat.h>
#include <zip.h>

#include "render/base/plain_file.h"

namespace pdr::dicom {

namespace {

Error damagedArchive(const std::string& why) {
    return {phrase("the archive is damaged, or no ZIP archive (%1)", why), "", phrase("Copy the file again."),
            ErrorKind::refused};
}

Error damagedEntry(const std::string& why) {
    return {phrase("it cannot be unpacked (%1)", why), "", "", ErrorKind::refused};
}

struct CloseFile {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

bool isLink(zip* archive, std::uint64_t index) {
    zip_uint8_t system = 0;
    zip_uint32_t attributes = 0;
    return zip_file_get_external_attributes(archive, index, 0, &system, &attributes) == 0 && system == ZIP_OPSYS_UNIX &&
           S_ISLNK(attributes >> 16);
}

}  // namespace

void ZipHandle::Close::operator()(zip* archive) const {
    zip_discard(archive);
}

Result<ZipHandle> ZipHandle::open(const std::filesystem::path& archive) {
    if (auto plain = checkPlainFile(archive); !plain)
        return plain.error();
    int code = 0;
    if (zip* opened = zip_open(archive.c_str(), ZIP_RDONLY, &code))
        return ZipHandle(opened);
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    Error damaged = damagedArchive(zip_error_strerror(&error));
    zip_error_fini(&error);
    return damaged.in(archive.string());
}

std::uint64_t ZipHandle::count() const {
    return std::uint64_t(zip_get_num_entries(archive_.get(), 0));
}

Result<ZipEntry> ZipHandle::entry(std::uint64_t index) const {
    zip_stat_t facts;
    constexpr zip_uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_ENCRYPTION_METHOD;
    if (zip_stat_index(archive_.get(), index, 0, &facts) != 0 || (facts.valid & kNeeded) != kNeeded)
        return damagedArchive(zip_strerror(archive_.get()));
    return ZipEntry{index, facts.name, facts.size, isLink(archive_.get(), index),
                    facts.encryption_method != ZIP_EM_NONE};
}

Result<std::vector<std::uint8_t>> ZipHandle::read(const ZipEntry& entry) const {
    const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen_index(archive_.get(), entry.index, 0));
    if (!file)
        return damagedEntry(zip_strerror(archive_.get()));
    std::vector<std::uint8_t> bytes(entry.bytes);
    std::size_t used = 0;
    zip_int64_t count = 1;
    while (used < bytes.size() && count > 0) {
        count = zip_fread(file.get(), bytes.data() + used, bytes.size() - used);
        used += count > 0 ? std::size_t(count) : 0;
    }
    // The checksum is compared where nothing follows
    char surplus;
    const zip_int64_t more = count < 0 ? -1 : zip_fread(file.get(), &surplus, 1);
    if (more < 0)
        return damagedEntry(zip_file_strerror(file.get()));
    if (used < bytes.size() || more > 0)
        return damagedEntry("another length than stated");
    return bytes;
}

}  // namespace pdr::dicom
