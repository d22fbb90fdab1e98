#pragma once
/// The final render: takes samples until a stop, measures the bias, and writes files, on the calling thread. The window
/// and `pdrender-cli render` share this code, so the same scene, samples and display give the same bits.

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/output/image_files.h"
#include "app/output/provenance.h"
#include "render/device/device.h"
#include "render/film/error/shown_status.h"
#include "render/film/file/image_file.h"
#include "render/scene/scene.h"
#include "render/session/batch_render.h"
#include "render/tiles/node_checks.h"

namespace pdr::app {

/// A film and how it was taken.
struct TakenFilm {
    std::shared_ptr<const Film> film;  ///< never null
    BatchResult result;
    double biasSeconds = 0;  ///< rendering time that measuring the bias may take
    NodeChecks checks = {};  ///< what was checked of the samples of render nodes
};

/// A request for a final render.
struct FinalOrder {
    Scene scene;      ///< has passed Scene::check(); its film sets the size
    Display display;  ///< display of PNG files; `denoised`: the denoised image if that is known to be better
    Stops stops;
    WhenStopped whenStopped = WhenStopped::keep;
    Paths outputs;  ///< file names, each ".png" or ".exr"
    /// Returns what is painted over PNG files, given how good the image is; empty: nothing is.
    std::function<PaintOver(const ShownStatus&)> painter;
    /// A film of the scene from elsewhere, of which the images are made; none: it is taken.
    std::optional<TakenFilm> taken = std::nullopt;
};

/// Callbacks for the steps of a final render. All of them must be set.
struct FinalSteps {
    std::function<Result<void>()> beforeSamples;  ///< called when the device holds the scene; an error ends the render
    BatchRender::Report report;
    /// Called after the last sample; the remaining steps take a fraction of the time. Returns what was checked of the
    /// samples of render nodes.
    std::function<NodeChecks()> afterSamples;
};

struct FinalImage {
    BatchResult result;
    std::vector<Bias> biases;
    /// If denoising was requested: why the image is not denoised, or why its error is not known, as a sentence; null if
    /// neither applies.
    const char* denoisingNote = nullptr;
    WrittenFiles written;
    NodeChecks checks;
    std::optional<Error> biasUnknown;  ///< why the bias could not be measured; the files are written all the same
};

/// Renders `order` and writes its files. Errors: those of the device and of `steps`; a stop before the first sample,
/// or, with WhenStopped::discard, any stop. Files that cannot be written are no error: FinalImage::written reports
/// them.
Result<FinalImage> renderFinal(const FinalOrder& order, Device& device, const FinalSteps& steps,
                               const std::stop_token& stop);

}  // namespace pdr::app
