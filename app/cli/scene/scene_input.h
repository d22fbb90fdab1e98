#pragma once
/// Input of the commands that render: a DICOM folder or a scene file, and options for its appearance.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/parts/part_looks.h"
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
    std::string seriesUid;             ///< empty: the first series that can be loaded
    std::optional<NamedLook> look;     ///< absent: the first that suits a folder, the file's own for a scene
    std::optional<StandardView> view;  ///< absent: firstView() for a folder, the file's own camera for a scene
    std::optional<ivec2> size;         ///< absent: 1024 x 1024 for a folder, the file's own film for a scene
    std::optional<Table> table;        ///< absent: hidden for a folder, as the file says for a scene
    std::optional<Visible> parts;      ///< shown and hidden parts; absent: as the look or the scene file says
    std::optional<double> peelMm;      ///< absent: as the look or the scene file says
    PartLooks partLooks;               ///< parts of the patient with looks of their own
    bool ctDenoised = false;  ///< the image shows the scan with less noise, also where the scene does not say so
    std::optional<double> exposure;
    std::optional<ToneCurve> toneCurve;  ///< absent: the look's
    bool autoExposure = false;           ///< true: set from the tissue of a small image, as in the window
    std::optional<std::uint64_t> seed;
    std::optional<Model> model;
    std::optional<Estimator> estimator;
    std::optional<double> apertureMm;
    std::optional<ivec2> focusAt;  ///< pixel that shows the tissue to focus on
};

/// A scene with its voxels, and how to show it.
struct LoadedScene {
    Scene scene;
    Display display;
    std::vector<std::string> notes;               ///< notes on the import of the voxels and on hidden tissue
    std::vector<std::filesystem::path> files;     ///< files that it was read from, except those of a DICOM folder
    ClipBox uncut;                                ///< box of the scene without a cut
    std::shared_ptr<const dicom::Series> series;  ///< series that the voxels come from; null for a raw file
};

/// Loads the scene and its voxels. Errors: those of scene files, looks and the import; nothing under the pixel to focus
/// on; a requested part of the body that cannot be told from the rest; a scan that cannot be denoised.
Result<LoadedScene> loadScene(const SceneInput& input, const Progress& progress);
/// Calls loadScene() with a progress line, and writes the notes to standard error.
Result<LoadedScene> loadSceneShown(const SceneInput& input);
/// Replaces the voxels that the image shows by denoised ones if the scene wants that. Parts of the body are found in
/// the scan itself before. Errors: those of ctDenoised().
Result<void> denoiseCt(LoadedScene& work, const Progress& progress);
/// Writes the notes to standard error.
void tellNotes(const LoadedScene& loaded);

}  // namespace pdr::app
