#pragma once
/// Compressed CT slices, and damage to their pixel data as a bad sector, a lost packet or a cosmic ray causes it.

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpeg/djrplol.h>
#include <dcmtk/dcmjpeg/djrploss.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <dcmtk/dcmjpls/djrparam.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "dicom/read/codecs.h"
#include "dicom/read/pixels.h"
#include "tests/support/dicom/slice_file.h"

namespace pdr::test {

/// Makes a noisy disc of tissue with bone in air, 12 bits unsigned, which compresses like a CT slice.
inline SliceFile tissueSlice(ivec2 size, unsigned seed) {
    SliceFile slice{.size = size, .isSigned = false, .bitsStored = 12};
    std::mt19937 random(seed);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const double r = std::hypot(x - size.x * 0.5, y - size.y * 0.5) / (0.5 * size.x);
            const int tissue = r > 0.95 ? 0 : r > 0.8 ? 1900 : 1060;
            const int noise = int(random() % 41 + random() % 41) - 40;
            slice.raw.push_back(std::uint16_t(r > 0.95 ? 0 : tissue + noise));
        }
    return slice;
}

inline std::unique_ptr<DcmRepresentationParameter> parametersOf(E_TransferSyntax coding) {
    switch (coding) {
        case EXS_JPEGProcess14:
            return std::make_unique<DJ_RPLossless>(6, 0);
        case EXS_JPEGProcess14SV1:
            return std::make_unique<DJ_RPLossless>(1, 0);
        case EXS_JPEGProcess1:
        case EXS_JPEGProcess2_4:
        case EXS_JPEGProcess6_8:
        case EXS_JPEGProcess10_12:
            return std::make_unique<DJ_RPLossy>(95);
        case EXS_JPEGLSLossless:
            return std::make_unique<DJLSRepresentationParameter>(0, OFTrue);
        case EXS_JPEGLSLossy:
            return std::make_unique<DJLSRepresentationParameter>(2, OFFalse);
        default:
            return {};
    }
}

/// Writes a compressed slice. False: the toolkit has no encoder for `coding`, or the file cannot be written.
inline bool writeCompressedSlice(const std::filesystem::path& file, const SliceFile& slice, E_TransferSyntax coding) {
    dicom::prepareToolkit();
    static const bool once = [] {
        DcmRLEEncoderRegistration::registerCodecs();
        DJEncoderRegistration::registerCodecs(ECC_lossyYCbCr, EUC_never);
        DJLSEncoderRegistration::registerCodecs();
        return true;
    }();
    (void)once;
    writeSliceFile(file, slice);
    DcmFileFormat content;
    if (content.loadFile(file.c_str()).bad())
        return false;
    const auto parameters = parametersOf(coding);
    return content.getDataset()->chooseRepresentation(coding, parameters.get()).good() &&
           content.saveFile(file.c_str(), coding).good();
}

inline std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

/// Range of the fragments of the compressed image in a file: behind the offset table, before the last delimiter.
struct StreamRange {
    std::size_t first = 0, last = 0;
};

inline StreamRange streamRange(const std::string& file) {
    // PixelData, its VR, an undefined length, and the first item.
    const std::size_t start = file.rfind(std::string("\xFF\xFF\xFF\xFF\xFE\xFF\x00\xE0", 8));
    const std::size_t close = file.rfind(std::string("\xFE\xFF\xDD\xE0", 4));
    if (start == std::string::npos || close == std::string::npos ||
        file.substr(start - 8, 4) != "\xE0\x7F\x10" + std::string(1, '\0'))
        return {};
    const std::size_t table = start + 8;
    const auto length = std::uint8_t(file[table]) | std::size_t(std::uint8_t(file[table + 1])) << 8;
    return {table + 4 + length + 8, close};
}

inline std::string withZeroRun(std::string file, StreamRange range, std::size_t count, std::mt19937& random) {
    const std::size_t at = range.first + random() % (range.last - range.first - count);
    return file.replace(at, count, count, '\0');
}

inline std::string withBitFlips(std::string file, StreamRange range, int count, std::mt19937& random) {
    for (int i = 0; i < count; ++i)
        file[range.first + random() % (range.last - range.first)] ^= char(1u << random() % 8);
    return file;
}

enum class Outcome { refused, unchanged, silent };

/// Returns what the import makes of a damaged file, compared with `sound`, the HU of the sound file.
inline Outcome outcomeOf(const std::filesystem::path& file, const std::vector<std::int16_t>& sound) {
    const auto slice = dicom::decodeSlice({file}, dicom::Padding::keep);
    if (!slice)
        return Outcome::refused;
    return slice->hu == sound ? Outcome::unchanged : Outcome::silent;
}

}  // namespace pdr::test
