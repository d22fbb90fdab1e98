#pragma once
/// The one final render: samples until a stop, the measure of its bias, and files, on the thread that asks for it. The
/// window and `pdrender-cli render` make their images here, so that the same scene, samples and display are the same
/// bits.

#include <functional>
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

namespace pdr::app {

/// What is to be made.
struct FinalOrder {
    Scene scene;      ///< which has passed Scene::check(); its film has the size
    Display display;  ///< of PNG files; smoothed: denoised where that is known to be better
    Stops stops;
    WhenStopped whenStopped = WhenStopped::keep;
    Paths outputs;  ///< each .png or .exr
    /// What is painted over PNG files, of an image as good as that; empty: nothing.
    std::function<PaintOver(const ShownStatus&)> painter;
};

/// Who is told of its steps; each of them is there.
struct FinalSteps {
    std::function<Result<void>()> beforeSamples;  ///< the device holds the scene; an error ends it
    BatchRender::Report report;
    std::function<void()> afterSamples;  ///< what follows takes a fraction of the time
};

struct FinalImage {
    BatchResult result;
    std::vector<Bias> biases;
    /// Where denoising was wanted: why an image is not denoised, or its error is not known, as a sentence; null:
    /// neither.
    const char* denoisingNote = nullptr;
    WrittenFiles written;
    std::optional<Error> biasUnknown;  ///< why it could not be measured; the files are there all the same
};

/// Errors: those of the device and of `steps`; a stop before the first sample, or before the end where samples are
/// discarded then. Files that cannot be written are no error: FinalImage::written says so.
Result<FinalImage> renderFinal(const FinalOrder& order, Device& device, const FinalSteps& steps,
                               const std::stop_token& stop);

}  // namespace pdr::app
