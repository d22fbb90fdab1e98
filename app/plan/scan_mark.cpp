#include "app/plan/scan_mark.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "app/wire/content_hash.h"

namespace pdr::app {
namespace {

constexpr char kDigits[] = "0123456789abcdef";
constexpr std::size_t kSliceDigits = 16;

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

/// Returns the hash of the size, the place and the voxels.
std::string hashOf(const Volume& volume, const std::string& salt) {
    const VolumeGeometry& geometry = volume.geometry();
    wire::ContentHash hash(std::as_bytes(std::span(salt)));
    for (int axis = 0; axis < 3; ++axis)
        add(hash, geometry.size[axis]);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            add(hash, std::llround(geometry.patientFromIndex[column][row] * 1e6));
    hash.add(std::as_bytes(volume.voxels()));
    return hexadecimal(hash.finish());
}

/// Returns kSliceDigits digits for each slice.
std::string sliceHashesOf(const Volume& volume, const std::string& salt) {
    const ivec3 size = volume.size();
    const std::size_t voxels = std::size_t(size.x) * std::size_t(size.y), slices = std::size_t(size.z);
    std::string hashes(slices * kSliceDigits, '0');
    tbb::parallel_for(std::size_t(0), slices, [&](std::size_t k) {
        const auto slice = std::as_bytes(volume.voxels().subspan(k * voxels, voxels));
        const auto bytes = wire::contentHash(std::as_bytes(std::span(salt)), slice);
        std::ranges::copy(hexadecimal(std::span(bytes).first(kSliceDigits / 2)),
                          hashes.begin() + std::ptrdiff_t(k * kSliceDigits));
    });
    return hashes;
}

/// Returns the numbers, from 1, of the slices that are not those of `mark`, whose scan has the same size.
std::vector<std::size_t> otherSlices(const ScanMark& mark, const Volume& volume) {
    const std::string found = sliceHashesOf(volume, mark.salt);
    std::vector<std::size_t> others;
    for (std::size_t at = 0; at < found.size(); at += kSliceDigits)
        if (found.compare(at, kSliceDigits, mark.sliceHashes, at, kSliceDigits) != 0)
            others.push_back(at / kSliceDigits + 1);
    return others;
}

/// Says in what a scan differs that has the size of the plan's, but another hash.
Text whatDiffers(const ScanMark& mark, const Volume& volume) {
    const std::size_t slices = std::size_t(volume.size().z);
    const bool known = mark.sliceHashes.size() == slices * kSliceDigits;
    const std::vector<std::size_t> others = known ? otherSlices(mark, volume) : std::vector<std::size_t>();
    if (!known || others.size() == slices)
        return phrase("this is another scan: it has the size of the plan's, but other voxels");
    if (others.empty())
        return phrase("the plan was made on the same voxels at another place of the patient");
    const std::size_t first = others.front(), last = others.back();
    if (others.size() == 1)
        return phrase("the voxels of slice %1 are not those that the plan was made on", first);
    if (last - first + 1 == others.size())
        return phrase("the voxels of slices %1 to %2 are not those that the plan was made on", first, last);
    return phrase("the voxels of %1 slices between %2 and %3 are not those that the plan was made on", others.size(),
                  first, last);
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
    return {.salt = salt,
            .hash = hashOf(volume, salt),
            .sliceHashes = sliceHashesOf(volume, salt),
            .size = volume.size(),
            .spacingMm = volume.geometry().spacingMm(),
            .holes = holesOf(volume)};
}

Result<void> checkIsScanOf(const ScanMark& mark, const Volume& volume) {
    const ivec3 size = volume.geometry().size;
    const auto refused = [](const Text& what) {
        return Error{what, "", phrase("Open the series on which the plan was made."), ErrorKind::refused};
    };
    if (size != mark.size)
        return refused(phrase("this is another scan: %1 voxels, and the plan was made on %2", sizeText(size),
                              sizeText(mark.size)));
    if (hashOf(volume, mark.salt) == mark.hash)
        return {};
    if (mark.importRule != kImportRule)
        return refused(
            phrase("the plan was made by a version that reads scans by rule %1, and this one reads by rule %2",
                   mark.importRule, kImportRule));
    return refused(whatDiffers(mark, volume));
}

}  // namespace pdr::app
