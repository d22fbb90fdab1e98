#include "app/bench/trackers/scenes.h"

#include "render/volume/phantom.h"

namespace pdr::bench {

namespace {

/// Converts an intensity of Exposure Render, which runs from 0 to 1 over 12-bit CT, to HU.
float huOfIntensity(float intensity) {
    return -1024 + 4095 * intensity;
}

TransferFunction bone() {
    return {31,
            {{.hu = huOfIntensity(0.23597f), .opacity = 0},
             {.hu = huOfIntensity(0.288538f), .opacity = 0.0179028f},
             {.hu = huOfIntensity(0.288578f), .opacity = 0.563502f},
             {.hu = huOfIntensity(0.35417f), .opacity = 1}}};
}

TransferFunction skinAndBone() {
    return {1,
            {{.hu = -600, .opacity = 0},
             {.hu = -300, .opacity = 0.3f},
             {.hu = 0, .opacity = 0.15f},
             {.hu = 150, .opacity = 0.05f},
             {.hu = 300, .opacity = 0.8f},
             {.hu = 700, .opacity = 1}}};
}

TransferFunction soft() {
    return {5,
            {{.hu = -150, .opacity = 0},
             {.hu = 0, .opacity = 0.1f},
             {.hu = 80, .opacity = 0.4f},
             {.hu = 300, .opacity = 1}}};
}

}  // namespace

/// Radius of what the image shows: the head fills the height of the image, and rays beside it pass through the air that
/// surrounds it in a scan.
constexpr double kHeadRadiusMm = 150;

std::vector<NamedScene> headScenes() {
    Scene scene;
    scene.volume = std::make_shared<Volume>(headPhantom());
    const VolumeGeometry& geometry = scene.volume->geometry();
    scene.camera = standardView(StandardView::anterior, geometry.centreMm(), kHeadRadiusMm, 1);
    std::vector<NamedScene> scenes;
    const auto add = [&](const char* name, TransferFunction function) {
        scene.transferFunction = std::move(function);
        scenes.push_back({name, scene});
    };
    add("head phantom, bone, 31/mm", bone());
    add("head phantom, skin and bone, 1/mm", skinAndBone());
    add("head phantom, soft tissue, 5/mm", soft());
    return scenes;
}

}  // namespace pdr::bench
