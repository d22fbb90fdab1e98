#pragma once
/// What the commands render: a DICOM folder or a scene file, and how it was asked to look.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dicom/series.h"
#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/film/display.h"
#include "render/scene/camera.h"
#include "render/scene/named_look.h"
#include "render/scene/scene.h"
#include "render/scene/table.h"
#include "render/scene/visible.h"

namespace pdr::app {

struct SceneInput {
    std::filesystem::path path;        ///< a DICOM folder or a scene file
    std::string seriesUid;             ///< empty: the first that can be loaded
    std::optional<NamedLook> look;     ///< absent: the first that suits a folder, the file's own for a scene
    std::optional<StandardView> view;  ///< absent: firstView() for a folder, the file's own camera for a scene
    std::optional<ivec2> size;         ///< absent: 1024 x 1024 for a folder, the file's own film for a scene
    std::optional<Table> table;        ///< absent: hidden for a folder, as the file says for a scene
    std::optional<BodyPart> part;      ///< absent: as the look says, or the scene file
    std::optional<double> peelMm;      ///< likewise
    std::optional<double> exposure;
    bool autoExposure = false;  ///< as the window sets it: by the tissue of a small image
    std::optional<std::uint64_t> seed;
    std::optional<Model> model;
    std::optional<Estimator> estimator;
    std::optional<double> apertureMm;
    std::optional<ivec2> focusAt;  ///< the pixel that shows what is to be sharp
};

/// A scene with its voxels, and how to show it.
struct LoadedScene {
    Scene scene;
    Display display;
    std::vector<std::string> notes;               ///< on the import of the voxels and what is hidden of them
    std::vector<std::filesystem::path> files;     ///< that it was read from, but those of a DICOM folder
    ClipBox uncut;                                ///< what a cut cuts from
    std::shared_ptr<const dicom::Series> series;  ///< whose voxels they are; null: a raw file's
};

/// Errors: those of scene files, looks and the import, nothing under the pixel to focus on, and
/// a part of the body that was asked for and cannot be told from the rest.
Result<LoadedScene> loadScene(const SceneInput& input, const Progress& progress);
/// The same with a progress line and the notes on standard error.
Result<LoadedScene> loadSceneShown(const SceneInput& input);
/// Says the notes on standard error.
void tellNotes(const LoadedScene& loaded);

}  // namespace pdr::app
