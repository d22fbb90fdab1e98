#pragma once
/// Writes ZIP archives for tests.

#include <zip.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pdr::test {

struct ZipMember {
    std::string name, bytes;
    bool isLink = false;
    std::string password = {};  ///< empty: not encrypted
};

/// Writes `members` in their order; returns the archive's path.
inline std::filesystem::path writeZip(const std::filesystem::path& archive, const std::vector<ZipMember>& members) {
    zip_t* made = zip_open(archive.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    for (const ZipMember& member : members) {
        zip_source_t* bytes = zip_source_buffer(made, member.bytes.data(), member.bytes.size(), 0);
        const auto index = zip_uint64_t(zip_file_add(made, member.name.c_str(), bytes, 0));
        constexpr zip_uint32_t kLink = 0120777u << 16;
        if (member.isLink)
            zip_file_set_external_attributes(made, index, 0, ZIP_OPSYS_UNIX, kLink);
        if (!member.password.empty())
            zip_file_set_encryption(made, index, ZIP_EM_TRAD_PKWARE, member.password.c_str());
    }
    zip_close(made);
    return archive;
}

}  // namespace pdr::test
