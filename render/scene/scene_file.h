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

/// A scene whose voxels are still to be fetched (scene.volume is null), and so is a picture of its surroundings.
struct SceneFile {
    VolumeSource source;
    std::filesystem::path environmentImage;  ///< empty: none
    std::string environmentField;            ///< where the file names it: "lights[1].image"
    Scene scene;
};

/// Relative paths in the file are taken from the file's folder. Unknown, missing or out-of-range fields are errors that
/// name the field and its range.
Result<SceneFile> readSceneFile(const std::filesystem::path& path);

/// The same of a text; `where` is used in error texts, relative paths are taken from `folder`.
Result<SceneFile> sceneFromText(std::string_view text, const std::string& where, const std::filesystem::path& folder);
/// The text that sceneFromText() reads as an equal scene, to the bit; without revision and look, which files do not
/// hold. Paths are written as they are.
std::string sceneText(const SceneFile& file);
/// A camera as it stands in scene files, on one line.
std::string cameraText(const Camera& camera);

/// The voxels that a scene shows, and what they came from.
struct WantedVolume {
    std::shared_ptr<const Volume> volume;  ///< without the table where that is hidden
    Framed framed;                         ///< what a view should be filled with: the body where the table is hidden
    std::shared_ptr<const Volume> scan;    ///< all voxels that were read
    segment::HiddenTable table;            ///< of them; nothing where it is not to be hidden
};

/// `volume` as `source` wants it: clamped, without its table, and then reconstructed. Error: cancelled().
Result<WantedVolume> asWanted(Volume volume, const VolumeSource& source, const Progress& progress);

/// The voxels of a raw file, as `source` wants them. Errors: those of loadRaw(), the field named beside the file.
Result<WantedVolume> fetchRawVolume(const VolumeSource& source, const Progress& progress = noProgress);

}  // namespace pdr
