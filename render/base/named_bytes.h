#pragma once
/// Bytes and the name by which messages call them: those of a file, or of one that was unpacked from an archive.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "render/base/result.h"

namespace pdr {

/// The content of a file, on the disk or in memory.
struct NamedBytes {
    std::filesystem::path name;  ///< unique in its source; the path of a file
    /// The bytes, which nobody changes any more; null: they are those of the file `name`.
    std::shared_ptr<const std::vector<std::uint8_t>> memory{};
};

/// Returns the bytes of the file of a name; an error says why there are none.
using OpenBytes = std::function<Result<NamedBytes>(const std::filesystem::path& name)>;

/// Returns the bytes of a file of the disk, which is not opened yet.
inline Result<NamedBytes> onDisk(const std::filesystem::path& file) {
    return NamedBytes{file};
}

}  // namespace pdr
