#pragma once
/// A volume in one file that is no DICOM: NIfTI, NRRD or MetaImage. The header is read first and says what the samples
/// are; then they come one after the other as they are stored: CT for the
/// renderer, or labels.
///
/// The readers take the grid, the samples and nothing else. What describes the scan or its patient (NIfTI: descrip,
/// aux_file, db_name, intent_name and extensions; NRRD: content and comments; MetaImage: Comment and Name) is not kept.

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "render/base/named_bytes.h"
#include "render/base/result.h"
#include "render/base/unpacked_file.h"
#include "render/volume/file/sample_type.h"
#include "render/volume/volume.h"

namespace pdr {

/// The header of a volume file.
struct GridFile {
    std::filesystem::path file;      ///< the file that was asked for
    std::filesystem::path dataFile;  ///< the file of the samples: the same, or the one beside it that it names
    OpenBytes open = onDisk;         ///< the way to the bytes of both
    std::uint64_t start = 0;         ///< where the samples, or the packed stream that holds them, begin [bytes]
    std::uint64_t skip = 0;          ///< what the packed stream holds before the first sample [bytes]
    bool isPacked = false;           ///< whether gzip or zlib has packed the samples
    SampleType type = SampleType::int16;
    bool isBigEndian = false;
    double slope = 1, intercept = 0;  ///< value = sample * slope + intercept
    /// The grid in the patient as the file states it: it may be mirrored or sheared.
    VolumeGeometry geometry;
    /// What NRRD writes as "key:=value": names of segments among others. For label maps; not for the screen.
    std::map<std::string, std::string> pairs;
};

/// Returns whether the ending of `file` is one of kScanEndings (scan_endings.h), but .zip.
bool isGridFile(const std::filesystem::path& file);

/// Reads the header of `file`, whose ending says its format. Errors: the file cannot be read, is damaged, or shorter
/// than its samples; it does not say how it lies in the patient, or says it in two ways that differ by more than 0.1
/// mm; it has more or fewer than three dimensions, colours, or samples of a type or coding that is not read. No memory
/// is taken for samples. `open`: the way to the bytes of the file, and of one beside it.
Result<GridFile> readGridFile(const std::filesystem::path& file, const OpenBytes& open = onDisk);

/// The samples of a volume file as they are stored, x fastest, then y, then z, without slope and intercept. Needs 100
/// kB whatever the file holds, beside what GridFile::open takes.
class GridSamples {
  public:
    explicit GridSamples(const GridFile& file);

    /// Fills `samples` with the next ones, of which there must be as many. Errors: those of UnpackedFile::read(); with
    /// the last sample also a checksum that is wrong.
    Result<void> read(std::span<double> samples);

  private:
    const SampleType type_;
    const bool isBigEndian_;
    const Result<NamedBytes> source_;
    UnpackedFile bytes_;
    Result<void> placed_;
    std::size_t left_;  ///< samples that were not read yet
};

}  // namespace pdr
