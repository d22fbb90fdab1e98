#pragma once
/// Measures the error of an image against its rendering time, compared with a reference of many more samples.

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "app/cli/accuracy/accuracy_curve.h"
#include "app/cli/accuracy/accuracy_ways.h"
#include "app/cli/accuracy/kept_film.h"
#include "render/device/device.h"

namespace pdr::app {

struct AccuracyPlan {
    double seconds;  ///< rendering time for each way
    Display display;
    std::filesystem::path folder;  ///< existing folder for images; empty: none are saved
    std::string device = {};       ///< name of the device, written into the images
};

/// Callback that receives the progress in [0, 1] and the name of the current step.
using AccuracyProgress = std::function<void(double, const std::string&)>;

/// Renders `way` for at most plan.seconds and compares it with `reference`: the image as it is and, if the way has no
/// bias and its images have noise, also denoised. If the way has a bias, measures it too. After a stop request, ends
/// with the current step. Errors: those of the device and of files.
Result<std::vector<AccuracyCurve>> measureAccuracy(const AccuracyWay& way, const Film& reference,
                                                   const AccuracyPlan& plan, Device& device,
                                                   const std::stop_token& stop, const AccuracyProgress& progress);

/// Returns `scene` as references are rendered: without known bias and with the next seed.
Scene referenceScene(Scene scene);
/// Renders a film of `scene` with as many samples as fit into `seconds` of rendering time in all, at least 2. Continues
/// from `before` if it is not null, whose rendering time counts.
Result<KeptFilm> referenceFor(const Scene& scene, double seconds, const std::optional<KeptFilm>& before, Device& device,
                              const std::stop_token& stop, const AccuracyProgress& progress);

}  // namespace pdr::app
