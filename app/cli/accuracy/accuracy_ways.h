#pragma once
/// Variants of a scene that an accuracy report compares.

#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace pdr::app {

/// A way to render an image: a variant of the scene.
struct AccuracyWay {
    std::string name;
    std::string bias;  ///< phrase that names the bias; empty if there is none
    Scene scene;
};

/// Returns the scene itself, first, and its variants with the other estimators, schedules and filters that it allows on
/// a device of that name. Except for their bias, all give the same image.
std::vector<AccuracyWay> accuracyWays(const Scene& scene, const std::string& device);

/// Returns other images of the same anatomy, each with a reference of its own: those of the other models, and one with
/// slices interpolated between those of the scan if there are none yet. They are rendered without known bias, see
/// exactly().
std::vector<AccuracyWay> otherImages(const Scene& scene);

}  // namespace pdr::app
