#pragma once
/// A slice as an image file: PNG through a window, OpenEXR with its HU, or other values. Nothing about the patient is
/// in either, unless `paintOver` paints it.

#include <filesystem>
#include <string>

#include "render/base/result.h"
#include "render/film/file/image_file.h"
#include "render/slice/grey_window.h"
#include "render/slice/reslice.h"

namespace pdr::app {

/// What is known of a slice beside its pixels.
struct SliceFacts {
    std::string plane;    ///< "axial"
    std::string remarks;  ///< remarks on the import of the voxels (Volume::remarks())
};

/// Returns "50/350", "LINEAR_EXACT 500/1000", ...: the function, unless it is linear, centre and width [HU, or the unit
/// of the values].
std::string windowText(const GreyWindow& window);

/// Writes `slice` in the format of the file's ending. `window`, of voxels, and `paintOver` are for PNG files. Errors:
/// those of writePng() and writeExr().
Result<void> writeSlice(const SliceImage& slice, const SliceFacts& facts, const GreyWindow& window,
                        const PaintOver& paintOver, const std::filesystem::path& file);

}  // namespace pdr::app
