#include "dicom/source/packed_object.h"

#include <algorithm>
#include <span>
#include <utility>

#include "render/base/errors.h"
#include "render/base/free_memory.h"
#include "render/base/unpacked_file.h"

namespace pdr::dicom {

namespace {

constexpr std::size_t kPreamble = 128, kHead = kPreamble + 4;  ///< "DICM" stands behind the preamble
constexpr std::uint64_t kMostTimes = 200;

bool beginsAsDicom(std::span<const std::uint8_t> head) {
    return std::ranges::equal(head.subspan(kPreamble), std::string_view("DICM"));
}

}  // namespace

Result<NamedBytes> openPacked(const std::filesystem::path& file) {
    UnpackedFile packed({file}, 0, true);
    std::vector<std::uint8_t> bytes(kHead);
    if (!packed.read(bytes) || !beginsAsDicom(bytes))
        return NamedBytes{file};
    std::error_code failure;
    const std::uint64_t most = std::min(kMostTimes * std::filesystem::file_size(file, failure), freeBytes() / 2);
    for (std::size_t used = bytes.size();;) {
        bytes.resize(std::max<std::size_t>(2 * used, 1 << 16));
        const Result<std::size_t> count = packed.readSome(std::span(bytes).subspan(used));
        if (!count)
            return count.error();
        used += *count;
        if (*count == 0) {
            bytes.resize(used);
            return NamedBytes{file, std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes))};
        }
        if (used > most)
            return Error{phrase("it unpacks to more than %1", bytesText(most)), file.string(),
                         phrase("Unpack it, and open the folder."), ErrorKind::refused};
        bytes.resize(used);
    }
}

}  // namespace pdr::dicom
