#pragma once
/// The places that a scan can be opened from: a folder or an archive of DICOM and volume files, or one volume file.
/// Window and command line open scans through this code.

#include <filesystem>
#include <stop_token>
#include <vector>

#include "dicom/import.h"
#include "dicom/read/pixels.h"
#include "dicom/series.h"
#include "render/base/progress.h"
#include "render/base/result.h"

namespace pdr::app {

/// Returns whether `path` is a file that scanPlace() opens by itself: one that ends in one of kScanEndings. Any other
/// file stands for its folder, or is no scan. False for folders.
bool isScanFile(const std::filesystem::path& path);

/// Lists the series of a folder, of an archive, or the one of a volume file. In a folder or an archive each volume file
/// is an entry, numbered by name; in place of a UID it has its path as seen from there ("left/head.nii.gz"). Errors:
/// those of dicom::scanFolder(), dicom::openArchive(), dicom::scanSource() and gridSeries().
Result<dicom::ScanResult> scanPlace(const std::filesystem::path& path, const Progress& progress);

/// Reads the voxels of `series`, which comes from scanPlace(); see dicom::loadSeries().
Result<Volume> loadVoxels(const dicom::Series& series, dicom::Padding padding, const Progress& progress,
                          std::vector<dicom::Note>* notes = nullptr, const dicom::OnArrival& onArrival = {});

/// Decodes one slice of `series`, which comes from scanPlace(); see dicom::decodeSlice() and decodeGridSlice().
Result<dicom::DecodedSlice> decodeSliceOf(const dicom::Series& series, const dicom::SliceRef& slice,
                                          const std::stop_token& stop);

}  // namespace pdr::app
