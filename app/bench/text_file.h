#pragma once
/// Writer of result files that appear whole or not at all.

#include <filesystem>
#include <string>

#include "render/base/replacing_file.h"

namespace pdr::bench {

inline Result<void> writeText(const std::filesystem::path& path, const std::string& text) {
    Result<ReplacingFile> file = ReplacingFile::open(path);
    if (!file)
        return file.error();
    file->write(text.data(), text.size());
    return file->commit();
}

}  // namespace pdr::bench
