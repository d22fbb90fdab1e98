#pragma once
/// Options of `pdrender-cli slice`.

#include <QStringList>

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "render/base/result.h"
#include "render/slice/slice_stack.h"
#include "render/slice/window_presets.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

/// Windows that differ from scan to scan.
enum class ScanWindow {
    usual,  ///< the file's own, or else soft tissue, or of values that are no HU their whole range
    file,   ///< the file's own
    whole   ///< wholeRange()
};

struct SliceOptions {
    std::filesystem::path path;  ///< a DICOM folder or a scene file
    std::string seriesUid;       ///< empty: the first series that can be loaded
    AnatomicalPlane plane = AnatomicalPlane::axial;
    std::optional<std::uint64_t> index;  ///< number of the slice, from 0
    std::optional<double> atMm;          ///< place across the slices; with neither, the middle slice is taken
    std::variant<ScanWindow, GreyWindow> window = ScanWindow::usual;
    bool hasPreset = false;                      ///< whether `window` is one of windowPresets(), which are in HU
    std::vector<std::filesystem::path> outputs;  ///< at least one; each .png or .exr
    ui::Annotate annotate = ui::Annotate::sides;
    bool help = false;
};

/// Parses the arguments after the word `slice`. Errors are usage errors and name the option in `where`.
Result<SliceOptions> sliceOptions(const QStringList& arguments);

/// Returns the text for --help.
std::string sliceHelp();

}  // namespace pdr::app
