#pragma once
/// Scene files: JSON, "format": "pdrender-scene", "version": 1; every field is described in fields/ and in
/// resources/manual/scene-file.md.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/scene/fit_view.h"
#include "render/scene/parts_source.h"
#include "render/scene/scene.h"
#include "render/scene/table.h"
#include "render/segment/hidden_table.h"
#include "render/volume/raw_file.h"
#include "render/volume/reconstruction.h"

namespace pdr {

/// Where the voxels of a scene come from: a DICOM folder or a raw file.
struct VolumeSource {
    std::filesystem::path dicomFolder;           ///< empty for a raw file
    std::string seriesUid;                       ///< empty: the first loadable series
    RawFile raw;                                 ///< its path is empty for a DICOM folder
    std::optional<std::pair<int, int>> clampHu;  ///< voxels are clamped to [first, second]; in [-32768, 32767]
    Table table = Table::shown;
    Reconstruction reconstruction = Reconstruction::linear;
    bool operator==(const VolumeSource&) const = default;
};

/// A scene whose voxels (scene.volume is null), label map (scene.parts.map is null) and environment image are still to
/// be loaded.
struct SceneFile {
    VolumeSource source;
    PartsSource parts;                       ///< where the label map comes from; not given: there are no parts
    std::filesystem::path environmentImage;  ///< path of the environment image; empty: none
    std::string environmentField;            ///< path of the field that names the image: "lights[1].image"
    Scene scene;
};

/// Reads a scene file. Relative paths in it are taken from the file's folder. Unknown, missing or out-of-range fields
/// are errors that name the field and its range.
Result<SceneFile> readSceneFile(const std::filesystem::path& path);

/// Reads a scene from a text; `where` is used in error texts, relative paths are taken from `folder`.
Result<SceneFile> sceneFromText(std::string_view text, const std::string& where, const std::filesystem::path& folder);
/// Returns the text that sceneFromText() reads as an equal scene, to the bit, except for revision and look name, which
/// files do not hold, and the materials of parts that come from nowhere. Paths are written as they are.
std::string sceneText(const SceneFile& file);
/// Returns a camera as scene files write it, on one line.
std::string cameraText(const Camera& camera);

/// The voxels that a scene shows, and the scan that they come from.
struct WantedVolume {
    std::shared_ptr<const Volume> volume;  ///< the volume to render, without the table where that is hidden
    Framed framed;                         ///< content to fill a view with: the body where the table is hidden
    std::shared_ptr<const Volume> scan;    ///< all voxels that were read
    segment::HiddenTable table;            ///< the hidden table of `scan`; empty where the table is shown
};

/// Prepares `volume` as `source` specifies: clamps it, hides its table, then reconstructs it. Error: cancelled().
Result<WantedVolume> asWanted(Volume volume, const VolumeSource& source, const Progress& progress);

/// Loads the voxels of a raw file and prepares them as `source` specifies. Errors: those of loadRaw(), with the field's
/// name added.
Result<WantedVolume> fetchRawVolume(const VolumeSource& source, const Progress& progress = noProgress);

}  // namespace pdr
