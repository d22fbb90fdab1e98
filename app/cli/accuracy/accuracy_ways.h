#pragma once
/// What a scene can be made into, and how: all that a report of its accuracy compares.

#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace pdr::app {

/// A way to make a picture: the scene, changed.
struct AccuracyWay {
    std::string name;
    std::string bias;  ///< what never averages out, a phrase; empty: nothing
    Scene scene;
};

/// Estimators, orders of work and filters that `scene` allows on a device of that name; itself first. All would make
/// one picture, were it not for their bias.
std::vector<AccuracyWay> accuracyWays(const Scene& scene, const std::string& device);

/// Other pictures of the same anatomy, each with a truth of its own: the other models, and slices put between those of
/// the scan where none are. Exact, in our order of work.
std::vector<AccuracyWay> otherPictures(const Scene& scene);

}  // namespace pdr::app
