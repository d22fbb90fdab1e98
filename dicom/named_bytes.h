#pragma once
/// The bytes of one DICOM object and the name by which messages call it.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace pdr::dicom {

/// One DICOM object, in a file or in memory.
struct NamedBytes {
    std::filesystem::path name;  ///< unique in its source; the path of a file
    /// The bytes, which nobody changes any more; null: they are those of the file `name`.
    std::shared_ptr<const std::vector<std::uint8_t>> memory{};
};

}  // namespace pdr::dicom
