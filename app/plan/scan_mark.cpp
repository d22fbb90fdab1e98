#include "app/plan/scan_mark.h"

#include <cmath>
#include <cstring>
#include <random>
#include <span>

#include "app/wire/content_hash.h"

namespace pdr::app {
namespace {

constexpr char kDigits[] = "0123456789abcdef";

std::string hexadecimal(std::span<const std::byte> bytes) {
    std::string text;
    for (const std::byte byte : bytes)
        text += {kDigits[std::size_t(byte) >> 4], kDigits[std::size_t(byte) & 15]};
    return text;
}

/// Adds whole numbers in the order of their bytes on all machines, the lowest first.
void add(wire::ContentHash& hash, std::int64_t number) {
    std::byte bytes[8];
    for (int i = 0; i < 8; ++i)
        bytes[i] = std::byte(std::uint64_t(number) >> (8 * i));
    hash.add(bytes);
}

std::string sizeText(ivec3 size) {
    return std::to_string(size.x) + " x " + std::to_string(size.y) + " x " + std::to_string(size.z);
}

}  // namespace

std::string newSalt() {
    std::random_device random;
    std::string salt;
    while (salt.size() < 32)
        salt += kDigits[random() % 16];
    return salt;
}

ScanMark markOf(const Volume& volume, const std::string& salt) {
    const VolumeGeometry& geometry = volume.geometry();
    wire::ContentHash hash(std::as_bytes(std::span(salt)));
    for (int axis = 0; axis < 3; ++axis)
        add(hash, geometry.size[axis]);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            add(hash, std::llround(geometry.patientFromIndex[column][row] * 1e6));
    hash.add(std::as_bytes(std::span(volume.voxels())));
    const auto bytes = hash.finish();
    return {salt, hexadecimal(bytes), geometry.size, geometry.spacingMm(), kImportRule};
}

Result<void> checkIsScanOf(const ScanMark& mark, const Volume& volume) {
    const ivec3 size = volume.geometry().size;
    const auto refused = [](const Text& what) {
        return Error{what, "", phrase("Open the series on which the plan was made."), ErrorKind::refused};
    };
    if (size != mark.size)
        return refused(phrase("this is another scan: %1 voxels, and the plan was made on %2", sizeText(size),
                              sizeText(mark.size)));
    if (markOf(volume, mark.salt).hash == mark.hash)
        return {};
    if (mark.importRule != kImportRule)
        return refused(
            phrase("the plan was made by a version that reads scans by rule %1, and this one reads by rule %2",
                   mark.importRule, kImportRule));
    return refused(phrase("this is another scan: it has the size of the plan's, but other voxels"));
}

}  // namespace pdr::app
